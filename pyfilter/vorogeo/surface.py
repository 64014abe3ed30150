"""A mesh that answers at once, and builds an index when that pays."""

from __future__ import annotations

from typing import Any, Literal, overload

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _arguments as check
from . import _core, metrics
from . import points as point_lists
from .gaps import GapLimit, gap_limit
from .index import GeodesicIndex
from .masks import face_mask, without_masked
from .metrics import Metric, MetricLengths
from .on_mesh import OnMesh
from .paths import GeodesicPath, from_core
from .points import Points, Sources
from .progress import ProgressFunction, reporter
from .results import Answered

_METHODS = ("automatic", "index", "exact", "quick")


class Surface(OnMesh):
    """A triangle mesh for any number of questions: it reads the mesh once and chooses what answers.

    The first answers are exact, without an index. When they have taken as long as building one is estimated to take,
    the index is built and answers from then on; so the time of all answers together is at most about twice that of
    the better choice, however many questions come. `last` says what answered. May be used by several threads at once,
    and pickled, with the index that it has.

    Parameters
    ----------
    vertices : array_like, shape (n, 3)
        Finite positions; any real type and layout.
    faces : array_like of int, shape (m, 3)
        Vertex ids of the triangles, 0 to n - 1.
    threads, memory_budget, mask, metric, gap, bridge_folds
        As for `GeodesicIndex`, of an index that is built.

    Attributes
    ----------
    last : Answered or None
        What gave the last answer.

    Raises
    ------
    InvalidInput
        (a ValueError) If an argument has a wrong shape, type or range, naming the element.

    Notes
    -----
    `method` of each question is "automatic" (the above; on more than two million vertices, fields are quick where there
    is no index), "index" (built at once if there is none), "exact", or, for fields, "quick": an error of some tenths of
    a percent in a small part of the time.

    Examples
    --------
    >>> surface = vorogeo.Surface(vertices, faces)
    >>> surface.path(0, surface.snap([0.1, 0.2, 0.3])).length
    >>> surface.last.by
    'exact'
    """

    __slots__ = ("__weakref__", "_budget", "_faces", "_handle", "_of_index", "_threads", "_vertices", "last")

    def __init__(
        self,
        vertices: ArrayLike | None,
        faces: ArrayLike,
        threads: int | None = None,
        memory_budget: int | None = None,
        mask: ArrayLike | None = None,
        metric: Metric | None = None,
        gap: float = 0.0,
        bridge_folds: bool = False,
    ) -> None:
        points = check.kept(metrics.positions(vertices, faces, metric), vertices)
        triangles = check.kept(check.faces(faces, len(points)), faces)
        kept = face_mask(mask, triangles, len(points))
        workers, budget = check.threads(threads), check.memory_budget(memory_budget)
        lengths = metrics.lengths(metric, points, without_masked(triangles, kept))
        of_index = kept, metric, lengths, gap_limit(gap, bridge_folds)
        self._adopt(points, triangles, workers, budget, of_index, None)

    def _adopt(
        self,
        vertices: NDArray[np.float64],
        faces: NDArray[np.int32],
        threads: int,
        budget: int,
        of_index: tuple[NDArray[np.bool_] | None, Metric | None, MetricLengths | None, GapLimit],
        index: GeodesicIndex | None,
    ) -> Surface:
        self._vertices, self._faces, self._threads, self._budget = vertices, faces, threads, budget
        self._of_index = of_index
        mask, _, lengths, bridged = of_index
        sides = metrics.core_sides(lengths)
        held = None if index is None else index._handle
        surface = without_masked(faces, mask)
        self._handle = _core.Surface(vertices, surface, sides, threads, budget, *bridged, held)
        self.last: Answered | None = None
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        mesh = self._vertices, self._faces
        return _restored, (type(self), *mesh, self._threads, self._budget, self._of_index, self.index)

    @property
    def _points_on_mesh(self) -> _core.Surface:
        return self._handle

    @property
    def index(self) -> GeodesicIndex | None:
        """The index, once there is one: for all its other methods, and to save it."""
        handle = self._handle.index()
        return None if handle is None else self._index_of(handle)

    def _index_of(self, handle: _core.Index) -> GeodesicIndex:
        index = GeodesicIndex.__new__(GeodesicIndex)
        return index._adopt(handle, self._vertices, self._faces, *self._of_index, self._threads)

    def build_index(self, progress: ProgressFunction | bool | None = None) -> GeodesicIndex:
        """Build the index now, if there is none.

        Raises
        ------
        InvalidInput, Cancelled, MemoryError
            As for `GeodesicIndex`.
        """
        with reporter(progress) as report:
            handle = self._handle.build_index(report)
        return self._index_of(handle)

    @overload
    def distance_field(
        self,
        sources: Sources,
        max_distance: float | None = None,
        *,
        offsets: ArrayLike | None = None,
        return_labels: Literal[False] = False,
        method: str = "automatic",
        progress: ProgressFunction | bool | None = None,
        dtype: DTypeLike = np.float64,
    ) -> NDArray[Any]: ...
    @overload
    def distance_field(
        self,
        sources: Sources,
        max_distance: float | None = None,
        *,
        offsets: ArrayLike | None = None,
        return_labels: Literal[True],
        method: str = "automatic",
        progress: ProgressFunction | bool | None = None,
        dtype: DTypeLike = np.float64,
    ) -> tuple[NDArray[Any], NDArray[np.int32]]: ...
    def distance_field(
        self,
        sources: Sources,
        max_distance: float | None = None,
        *,
        offsets: ArrayLike | None = None,
        return_labels: bool = False,
        method: str = "automatic",
        progress: ProgressFunction | bool | None = None,
        dtype: DTypeLike = np.float64,
    ) -> NDArray[Any] | tuple[NDArray[Any], NDArray[np.int32]]:
        """Distance of every vertex from its nearest source.

        Parameters
        ----------
        sources, max_distance, offsets, return_labels, dtype
            As for `GeodesicIndex.distance_field`.
        method : {"automatic", "index", "exact", "quick"}
            As for the class.
        progress : callable or bool, optional
            As for `GeodesicIndex`.

        Returns
        -------
        distance, label
            As for `GeodesicIndex.distance_field`.

        Raises
        ------
        InvalidInput
            (a ValueError) As there, and for another method.
        Cancelled
            If `progress` returned False.
        """
        how, limit = check.choice("method", method, _METHODS), check.max_distance(max_distance)
        entry = check.real_type(dtype)
        rows, number = self._source_rows(sources)
        start = check.offsets(offsets, int(number[-1]) + 1)[number]
        with reporter(progress) as report:
            found, label, answered = self._handle.field(_core.Points(*rows), start, limit, how, report)
        self.last = Answered(*answered)
        distance = found.astype(entry, copy=False)
        return (distance, np.where(label < 0, np.int32(-1), number[label])) if return_labels else distance

    def distance(
        self,
        source: Points,
        target: Points,
        method: str = "automatic",
        progress: ProgressFunction | bool | None = None,
    ) -> Any:
        """Distance between two points, or between the points of each of k pairs.

        Parameters
        ----------
        source, target : a point, or k points
            Vertex ids, `SurfacePoints` or lists of both; both of the same length.
        method : {"automatic", "index", "exact"}
            As for the class.
        progress : callable or bool, optional
            As for `GeodesicIndex`.

        Returns
        -------
        float, or ndarray of float64, shape (k,)
            Infinity between components. Exact without an index, else as `GeodesicIndex.distance`.

        Raises
        ------
        InvalidInput
            (a ValueError) If an id or a face is out of range, or lengths differ.
        Cancelled
            If `progress` returned False.
        """
        how = check.choice("method", method, _METHODS[:3])
        ends = point_lists.pairs(source, target, self._vertex_count)
        with reporter(progress) as report:
            found, answered = self._handle.distances(*ends, how, report)
        self.last = Answered(*answered)
        return float(found[0]) if point_lists.is_pair(source, target) else found

    def path(
        self,
        source: Points,
        target: Points,
        method: str = "automatic",
        progress: ProgressFunction | bool | None = None,
    ) -> GeodesicPath | list[GeodesicPath]:
        """Shortest path between two points, or of each of k pairs: exact without an index, else the refined one.

        Parameters and errors are those of `distance`.

        Returns
        -------
        GeodesicPath, or list of k GeodesicPath
            As for `GeodesicIndex.path`; those without an index are certified.
        """
        return self._find_paths(source, target, method, False, progress)

    def exact_path(
        self,
        source: Points,
        target: Points,
        method: str = "automatic",
        progress: ProgressFunction | bool | None = None,
    ) -> GeodesicPath | list[GeodesicPath]:
        """Exact shortest path between two points, or of each of k pairs.

        Parameters and errors are those of `distance`; the index, where there is one, makes it faster.

        Returns
        -------
        GeodesicPath, or list of k GeodesicPath
            As for `GeodesicIndex.exact_path`.
        """
        return self._find_paths(source, target, method, True, progress)

    def _find_paths(
        self, source: Any, target: Any, method: str, exact: bool, progress: ProgressFunction | bool | None
    ) -> GeodesicPath | list[GeodesicPath]:
        how = check.choice("method", method, _METHODS[:3])
        ends = point_lists.pairs(source, target, self._vertex_count)
        with reporter(progress) as report:
            found, answered = self._handle.paths(*ends, how, exact, report)
        self.last = Answered(*answered)
        paths = from_core(found)
        return paths[0] if point_lists.is_pair(source, target) else paths

    def __repr__(self) -> str:
        held = "with an index" if self._handle.index() is not None else "no index yet"
        return f"Surface({len(self._vertices)} vertices, {len(self._faces)} faces, {held})"


def _restored(cls: type[Surface], *parts: Any) -> Surface:
    """The surface that pickle took apart."""
    return cls.__new__(cls)._adopt(*parts)
