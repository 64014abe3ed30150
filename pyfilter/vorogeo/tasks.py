"""The mesh of a surface, how the core is asked about it, and tasks built on many distances."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar, TypeAlias, cast

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _arguments as check
from . import _core
from . import points as point_lists
from ._output import Output, matrix, releasing, reopened
from .errors import InvalidInput
from .mesh_input import MeshInput
from .metrics import Metric
from .points import EdgeCurve, Points, Rows, SurfacePoints, surface_points
from .progress import ProgressFunction, reporter
from .results import (
    Answered,
    Disk,
    Extent,
    FarthestSamples,
    GeodesicPath,
    Isolines,
    Polylines,
    RelaxedPoints,
    SparseDistances,
    VoronoiRegions,
)

Source: TypeAlias = ArrayLike | SurfacePoints | EdgeCurve | GeodesicPath
Sources: TypeAlias = Source | Sequence[Source]

#: Beyond it, a distance from the surface may be more than a float can hold.
_GREATEST_COORDINATE = 1e307
#: Points along the path of a band, at most: with more, the faces beside it take minutes.
_MOST_POINTS = 10**5
#: In the order of the numbers that the core has for them.
METHODS = ("automatic", "index", "exact", "quick")
_ENTRIES = ("automatic", "pairs", "fields")
_INTERPOLATIONS = ("linear", "distance")
_ENTRY_BYTES = 28  # of a sparse matrix while it is assembled; 12 in the result
_SAMPLES = 16


@dataclass(frozen=True, eq=False)
class Shared:
    """What copies of a surface share and pickle stores: its mesh, threads and MiB of an index, the core's surface."""

    given: MeshInput
    threads: int
    budget: int
    core: _core.Surface

    def __deepcopy__(self, memo: dict[int, Any]) -> Shared:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        # An array, which pickle can hand over without a copy.
        index = _in_a_file(_saved, self.core) if self.core.has_index() else None
        return _restored, (self.given, self.threads, self.budget, index)


def _in_a_file(use: Callable[[str, Any], Any], what: Any) -> Any:
    """The result of `use`, called with the name of a temporary file and `what`."""
    with tempfile.TemporaryDirectory(prefix="vorogeo-") as folder:
        return use(str(Path(folder) / "index.vgi"), what)


def _saved(file: str, core: _core.Surface) -> NDArray[np.uint8]:
    core.save(file)
    return np.fromfile(file, np.uint8)


def _restored(given: MeshInput, threads: int, budget: int, index: NDArray[np.uint8] | None) -> Shared:
    mesh = given.core_mesh()

    def loaded(file: str, contents: NDArray[np.uint8]) -> _core.Surface:
        contents.tofile(file)
        return mesh.load_index(file, threads, False)  # copied, as the file is deleted

    core = mesh.surface(threads, budget) if index is None else _in_a_file(loaded, index)
    return Shared(given, threads, budget, core)


class Tasks:
    """The part of `Surface` with its mesh, its tasks and how it asks the core; what tasks share is in its notes."""

    #: The method of a question that names none.
    _default_method: ClassVar[str] = "automatic"

    _shared: Shared
    last: Answered | None

    def _method(self, method: str | None, choices: tuple[str, ...] = METHODS[:3]) -> int:
        return check.choice("method", self._default_method if method is None else method, choices)

    def _core(self, to: bool) -> _core.Surface:
        """The core's surface for ways from points, or to them; these only differ in a metric that goes one way."""
        return self._shared.core.reversed() if to else self._shared.core

    def _ask(
        self,
        question: Callable[..., Any],
        *arguments: Any,
        method: str | None,
        progress: ProgressFunction | bool | None = None,
        choices: tuple[str, ...] = METHODS[:3],
    ) -> Any:
        """What the core answers to a question; what it says about the answer is noted in `last`."""
        how = self._method(method, choices)
        with reporter(progress) as report:
            *found, answered = question(*arguments, how, report)
        self.last = Answered(*answered)
        return found

    def _array(self, question: Callable[..., Any], *arguments: Any, **how: Any) -> NDArray[Any]:
        """As `_ask`, for a question whose answer is one array."""
        found: NDArray[Any]
        (found,) = self._ask(question, *arguments, **how)
        return found

    @property
    def vertices(self) -> NDArray[np.float64]:
        """Positions of the mesh, of shape (n, 3), read-only; NaN if it was given none."""
        return self._shared.given.vertices

    @property
    def faces(self) -> NDArray[np.int32]:
        """Triangles of the mesh as they were given, of shape (m, 3); read-only."""
        return self._shared.given.faces

    @property
    def mask(self) -> NDArray[np.bool_] | None:
        """Which faces belong to the surface, of shape (m,), read-only; None if all do."""
        return self._shared.given.mask

    @property
    def metric(self) -> Metric | None:
        """What paths cost; None is their length in space."""
        return self._shared.given.metric

    @property
    def gap(self) -> float:
        """The width up to which gaps are bridged."""
        return self._shared.given.gap[0]

    def snap(self, points: ArrayLike, max_distance: float | None = None) -> SurfacePoints:
        """Move points in space to the nearest points of the surface; the result has `snap_distance`.

        Parameters
        ----------
        points : array_like, shape (3,) or (k, 3)
            Finite positions, of at most 1e307.
        max_distance : float, optional
            How far a point may be from the surface, an error if it is farther; None for any distance.
        """
        positions = check.positions("points", points)
        too_far = np.abs(positions).max(axis=1, initial=0) > _GREATEST_COORDINATE
        if too_far.any():
            row = int(np.flatnonzero(too_far)[0])
            raise InvalidInput(
                f"points[{row}]: {positions[row].tolist()} is too far away for its distance to be a number; give "
                f"coordinates of at most {_GREATEST_COORDINATE:g}."
            )
        limit = check.max_distance(max_distance)
        found = SurfacePoints(*self._shared.core.mesh.snap(positions))
        distance = cast(NDArray[np.float64], found.snap_distance)
        if (distance > limit).any():
            row = int(np.flatnonzero(distance > limit)[0])
            raise InvalidInput(
                f"points[{row}]: is {distance[row]:g} away from the surface, more than max_distance {limit:g}; "
                "move the point or raise the limit."
            )
        return found

    def _rows(self, name: str, points: Any, least: int = 0) -> Rows:
        """Checked points as the core takes them."""
        return point_lists.rows(name, points, len(self.vertices), least)

    def _one_row(self, name: str, point: Points) -> Rows:
        row = self._rows(name, point)
        if len(row[0]) != 1:
            raise InvalidInput(f"{name}: has {len(row[0])} points; give one.")
        return row

    def _curve_rows(self, curve: Points | GeodesicPath) -> Rows:
        return self._rows("curve", curve.surface_points if isinstance(curve, GeodesicPath) else curve)

    def _line_rows(
        self, name: str, lines: GeodesicPath | Points | list[GeodesicPath | Points]
    ) -> tuple[Rows, NDArray[np.int32]]:
        """The points of one or several lines, and where each line begins and the last one ends."""
        several = isinstance(lines, list) and any(
            isinstance(line, GeodesicPath) or not point_lists.is_single(line) for line in lines
        )
        listed = cast(list[Any], lines if several else [lines])
        parts = [
            self._rows(f"{name}[{i}]", line.surface_points if isinstance(line, GeodesicPath) else line)
            for i, line in enumerate(listed)
        ]
        return point_lists.joined(parts), np.cumsum([0] + [len(part[0]) for part in parts], dtype=np.int32)

    def _source_rows(
        self, sources: Sources, list_name: str = "sources", spacing: float = 0.0
    ) -> tuple[Rows, NDArray[np.int32]]:
        """Sources as points, and for each point the position of its source in the list; a curve or path is one source.

        `spacing`: of the points along paths; 0 is a quarter of the typical edge.
        """
        curves = EdgeCurve, GeodesicPath
        if not point_lists.holds(sources, curves):
            found = self._rows(list_name, sources)
            number = np.arange(len(found[0]), dtype=np.int32)
        else:
            parts, numbers, places = [], [], 0
            for i, part in enumerate(cast(list[Any], [sources] if isinstance(sources, curves) else sources)):
                name = f"{list_name}[{i}]"
                is_line = isinstance(part, curves)
                parts.append(self._points_on(name, part, spacing) if is_line else self._rows(name, part))
                count = len(parts[-1][0])
                numbers.append(np.full(count, places) if is_line else places + np.arange(count))
                places += 1 if is_line else count
            found = point_lists.joined(parts)
            number = np.concatenate(numbers).astype(np.int32)
        if not len(found[0]):
            raise InvalidInput(f"{list_name}: is empty; give at least one vertex id, surface point or curve.")
        return found, number

    def _points_on(self, name: str, line: EdgeCurve | GeodesicPath, spacing: float) -> Rows:
        """Points along a curve, or the points of a path and others between them, at most `spacing` apart."""
        if isinstance(line, EdgeCurve):
            own = 0.0 if line.spacing is None else check.length(f"{name}.spacing", line.spacing)
            along_edges: Rows = self._shared.core.mesh.along_edges(line.edges(len(self.vertices), name), own)
            return along_edges
        if not len(line.points):
            raise InvalidInput(f"{name}: is a path without points, as none joins its ends; give another.")
        if spacing > 0 and line.length > spacing * _MOST_POINTS:
            raise InvalidInput(
                f"{name}: is a path of length {line.length:g}, too long for points {spacing:g} apart, which the width "
                "asks for; give a greater width, or fewer points along it (points_along)."
            )
        points: Rows
        (points,) = self._ask(
            self._shared.core.steps_along, self._rows(name, line.surface_points), spacing, method="exact"
        )
        return points

    def distance_matrix(
        self,
        points: Points,
        others: Points | None = None,
        entries: str = "automatic",
        out: Output = None,
        max_bytes: int | None = None,
        progress: ProgressFunction | bool | None = None,
        method: str | None = None,
        dtype: DTypeLike | None = None,
    ) -> NDArray[Any]:
        """Distances from all points to all, or to all others.

        Parameters
        ----------
        points : k points
            Points of the rows, and of the columns if there are no `others`; may repeat.
        others : m points, optional
            Points of the columns.
        entries : {"automatic", "pairs", "fields"}
            How they are computed from an index. "pairs": the values of `distance`. "fields": read from the field of
            each point; without `others`, from that of one point of each pair, so that the matrix is symmetric. Both
            approximate the same distances; for points in faces "pairs" is more accurate. "automatic": whichever should
            be faster for this size.
        out : str, path or ndarray, optional
            A file to write as .npy, or an array of float64 or float32 and the shape of the result. A file is mapped, so
            it may be larger than the memory; its space is reserved first, and an old file stays until it is complete.
        dtype : {float64, float32}, optional
            None is the type of an array `out`, else float64.

        Returns
        -------
        ndarray, shape (k, k) or (k, m)
            Infinity between components. Without `others` symmetric to the last bit with a zero diagonal, but not
            symmetric in a metric that goes one way.

        Raises
        ------
        FileError
            (an OSError) If the file cannot be written, such as on a full disk; as with the errors of all tasks, nothing
            was computed. InvalidInput if `out` does not name a plain file in an existing folder.

        Notes
        -----
        Complexity: k (k - 1) / 2 distances (k m with `others`), or as many fields as the shorter list is long. Exact
        distances are read from fields. `vorogeo.matrix_bytes` says how much memory the result takes.
        """
        how = check.choice("entries", entries, _ENTRIES)
        rows = self._rows("points", points)
        columns = None if others is None else self._rows("others", others)
        shape = len(rows[0]), len(rows[0] if columns is None else columns[0])
        with matrix(*shape, out, max_bytes, dtype) as result:
            self._fill(self._shared.core.fill_matrix, result, rows, columns, how, method=method, progress=progress)
        return reopened(result, out)

    def _fill(self, question: Callable[..., Any], result: NDArray[Any], *arguments: Any, **how: Any) -> None:
        """Fill an array, if it has entries; a large file hands its pages back meanwhile."""
        by = self._method(how["method"])
        with reporter(how["progress"]) as told:
            if result.size:
                (answered,) = question(*arguments, result, by, releasing(result, told))
                self.last = Answered(*answered)

    def fields(
        self,
        sources: Points,
        max_distance: float | None = None,
        out: Output = None,
        max_bytes: int | None = None,
        progress: ProgressFunction | bool | None = None,
        method: str | None = None,
        dtype: DTypeLike | None = None,
        to: bool = False,
    ) -> NDArray[Any]:
        """The distance field of each source on its own; `distance_field` is that from the nearest of several.

        Parameters
        ----------
        sources : k points
        max_distance : float, optional
            Distances above it become infinity; None for no limit.
        out, dtype
            As for `distance_matrix`; so are the errors.
        to
            As for `distance_field`.

        Returns
        -------
        ndarray, shape (k, n)
            Infinity where there is no path.
        """
        rows, limit = self._rows("sources", sources), check.max_distance(max_distance)
        with matrix(len(rows[0]), len(self.vertices), out, max_bytes, dtype) as result:
            self._fill(self._core(to).fill_fields, result, rows, limit, method=method, progress=progress)
        return reopened(result, out)

    def pairs_within(
        self,
        points: Points,
        radius: float,
        others: Points | None = None,
        as_arrays: bool = False,
        max_bytes: int | None = None,
        progress: ProgressFunction | bool | None = None,
        method: str | None = None,
        dtype: DTypeLike = np.float64,
    ) -> Any:
        """All pairs of points at most a radius apart, as a sparse matrix.

        Complexity: for each point a field bounded by the radius. Values are those of `fields`; without `others` they
        are read from the field of one point of each pair.

        Parameters
        ----------
        points, others
            As for `distance_matrix`.
        radius : float
            In the unit of the vertices, 0 or more.
        as_arrays : bool, default False
            Whether to return `SparseDistances` even if scipy is installed.
        max_bytes : int, optional
            `pairs_within_bytes` estimates what is needed; `NotEnoughMemory` is raised as soon as more pairs are found
            than fit.

        Returns
        -------
        scipy.sparse.csr_array or SparseDistances, shape (k, k) or (k, m)
            Distances from the row's point to the column's; those of 0 (repeated points) are stored as well. Without
            `others`, there is no diagonal, and it is symmetric to the last bit except in a metric that goes one way.
            `SparseDistances` where scipy is not installed.
        """
        rows = self._rows("points", points)
        columns = None if others is None else self._rows("others", others)
        reach, limit, entry = check.length("radius", radius), check.byte_limit(max_bytes), check.real_type(dtype)
        begin, places, distances = self._ask(
            self._shared.core.pairs_within, rows, columns, reach, limit, method=method, progress=progress
        )
        shape = len(rows[0]), len(rows[0] if columns is None else columns[0])
        sparse = SparseDistances(distances.astype(entry, copy=False), places, begin, shape)
        if as_arrays:
            return sparse
        try:
            from scipy.sparse import csr_array
        except ImportError:
            return sparse
        return csr_array(sparse[:3], shape=sparse.shape)

    def pairs_within_bytes(self, points: Points, radius: float, others: Points | None = None) -> int:
        """Memory that `pairs_within` will take, extrapolated from 16 of the points; in bytes."""
        rows = self._rows("points", points)
        columns = rows if others is None else self._rows("others", others)
        reach, count = check.length("radius", radius), len(rows[0])
        if count == 0 or len(columns[0]) == 0:
            return 0
        chosen = np.unique(np.linspace(0, count - 1, _SAMPLES).astype(int))
        some = point_lists.taken(rows, chosen)
        found = self._shared.core.pairs_within(some, columns, reach, 0, self._method(None), None)
        return int(_ENTRY_BYTES * found[2].size * count / chosen.size)

    def nearest(
        self,
        points: Points,
        queries: Points,
        k: int = 1,
        progress: ProgressFunction | bool | None = None,
        method: str | None = None,
        dtype: DTypeLike = np.float64,
        to: bool = False,
    ) -> tuple[NDArray[Any], NDArray[np.int32]]:
        """The k nearest of a set of points for each query point, by as many fields as the shorter list has points.

        Parameters
        ----------
        points : m points
            The set.
        queries : q points
        k : int, default 1
            Number of neighbours; may be larger than the set.
        to : bool, default False
            Whether distances are those to the set instead of from it.

        Returns
        -------
        distances : ndarray, shape (q, k)
            Nearest first; infinity where fewer can be reached.
        positions : ndarray of int32, shape (q, k)
            Positions in `points`, the first of equally near ones; -1 where fewer can be reached.
        """
        entry = check.real_type(dtype)
        chosen, asked = self._rows("points", points), self._rows("queries", queries)
        count, size = check.integer("k", k, 1, 2**31 - 1), len(asked[0])
        _core.require_memory(24.0 * size * count, 0, f"The result of {size} x {count} neighbours", "Lower k.")
        positions, distances = self._ask(self._core(to).nearest, chosen, asked, count, method=method, progress=progress)
        return distances.reshape(-1, count).astype(entry, copy=False), positions.reshape(-1, count)

    def voronoi(
        self,
        points: Points,
        method: str | None = None,
        progress: ProgressFunction | bool | None = None,
        to: bool = False,
    ) -> VoronoiRegions:
        """Geodesic Voronoi regions of points: the nearest point of every vertex and face, and the borders.

        Borders are exact on flat parts of the surface, given the distances of the vertices: in each face the difference
        of two squared distances is interpolated linearly. Complexity: a field for each point, bounded by the greatest
        distance of a vertex from its point. At least one point is given; one that repeats an earlier one owns nothing.
        In a metric that goes one way, a region holds what is nearest by the ways from its point or, with `to`, to it.
        """
        chosen = self._rows("points", points, least=1)
        vertex_region, distance, face_region, area, ends, edges, sides = self._ask(
            self._core(to).voronoi, chosen, method=method, progress=progress
        )
        return VoronoiRegions(vertex_region, distance, face_region, area, Polylines(ends, edges), sides)

    def isolines(
        self,
        field: ArrayLike,
        levels: ArrayLike,
        interpolation: str = "distance",
        progress: ProgressFunction | bool | None = None,
    ) -> Isolines:
        """Lines on which a field has given values; their edges join points of one level.

        Parameters
        ----------
        field : array_like of float, shape (n,)
            Values of the vertices; faces with a value that is not finite hold no lines.
        levels : int or array_like of float, shape (l,)
            The values; an integer stands for that many, evenly spaced between the least and the greatest of the field.
        interpolation : {"distance", "linear"}
            "distance": along an edge, values vary like distances from a point in the plane, which is exact where the
            surface is flat; linear where they differ by more than the edge's length. "linear": for any field.
        """
        values, chosen, how = self._levels(field, levels, interpolation)
        by = self._method("exact")  # nothing is asked, so that `last` stays
        with reporter(progress) as report:
            points, edges, level, _ = self._shared.core.isolines(values, chosen, how, by, report)
        return Isolines(points, edges, chosen[level])

    def _levels(
        self, field: ArrayLike, levels: ArrayLike, interpolation: str
    ) -> tuple[NDArray[np.float64], NDArray[np.float64], int]:
        """A checked field, the levels meant, and the number of the interpolation."""
        values = check.real_values("field", field)
        if len(values) != len(self.vertices):
            raise InvalidInput(
                f"field: has {len(values)} values; give one for each of the {len(self.vertices)} vertices."
            )
        how = check.choice("interpolation", interpolation, _INTERPOLATIONS)
        if not isinstance(levels, (int, np.integer)):
            return values, check.real_values("levels", levels), how
        count = check.integer("levels", levels, 0, 2**31 - 1)
        _core.require_memory(24.0 * count, 0, f"The list of {count} levels", "Give fewer levels.")
        finite = values[np.isfinite(values)]
        low, high = (float(finite.min()), float(finite.max())) if finite.size else (0.0, 0.0)
        return values, np.linspace(low, high, count + 2)[1:-1], how

    def sample_farthest(
        self,
        count: int | None = None,
        radius: float = 0.0,
        start: Points = (),
        seed: int = 0,
        method: str | None = None,
        progress: ProgressFunction | bool | None = None,
        to: bool = False,
    ) -> FarthestSamples:
        """Farthest point sampling: each sample is the vertex farthest from the previous ones.

        Samples are at least the covering radius apart; every component gets one before any gets two. Complexity: a
        field for each sample, bounded by the covering radius so far.

        Parameters
        ----------
        count : int, optional
            Number of samples; fewer if there are not that many vertices.
        radius : float, default 0
            Stop as soon as every vertex is at most this far from a sample. Give this, `count`, or both.
        start : points, optional
            The first samples, anywhere on the surface; without them the first one is random.
        seed : int, default 0
            Seed of the random first sample.
        to : bool, default False
            Whether distances are those to samples instead of from them.
        """
        limit = 0 if count is None else check.integer("count", count, 1, 2**31 - 1)
        reach = check.length("radius", radius)
        if count is None and reach == 0:
            raise InvalidInput("Give a count of samples, or a covering radius above 0 at which to stop.")
        first, seed = self._rows("start", start), check.integer("seed", seed, 0, 2**64 - 1)
        rows, gaps, distance, covered = self._ask(
            self._core(to).sample_farthest, limit, reach, first, seed, method=method, progress=progress
        )
        return FarthestSamples(rows[0], gaps, distance, covered, surface_points(rows))

    def sample_poisson_disk(
        self, radius: float, seed: int = 0, method: str | None = None, progress: ProgressFunction | bool | None = None
    ) -> NDArray[np.int32]:
        """Poisson-disk sampling: random vertices at least a radius apart, none of which could be added.

        Their ids, int32 of shape (k,), do not depend on the number of threads. Complexity: a field for each sample,
        bounded by the radius.

        Parameters
        ----------
        radius : float
            Least distance of two samples, above 0.
        seed : int, default 0
            Seed of the random numbers.
        """
        reach = check.length("radius", radius)
        if not 0 < reach < np.inf:
            raise InvalidInput(f"radius: {reach} is out of range; give a finite length above 0.")
        seed = check.integer("seed", seed, 0, 2**64 - 1)
        return self._array(self._shared.core.sample_poisson_disk, reach, seed, method=method, progress=progress)

    def disk(self, sources: Sources, radius: float, method: str | None = None, to: bool = False) -> Disk:
        """Vertices and faces within a radius of the nearest source.

        Parameters
        ----------
        sources : k points, k >= 1
            Or an `EdgeCurve` or a `GeodesicPath`, or a list that contains some.
        radius : float
            0 or more.
        to
            As for `distance_field`.
        """
        rows, _ = self._source_rows(sources)
        return Disk(*self._ask(self._core(to).disk, rows, check.length("radius", radius), method=method))

    def eccentricity(
        self,
        points: Points,
        method: str | None = None,
        progress: ProgressFunction | bool | None = None,
        to: bool = False,
    ) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """The greatest distance from each point (or `to` it) within its component, and the vertex at that distance.

        Returns
        -------
        distances : ndarray of float64, shape (k,)
        farthest : ndarray of int32, shape (k,)
        """
        chosen = self._rows("points", points)
        distances, farthest = self._ask(self._core(to).eccentricity, chosen, method=method, progress=progress)
        return distances, farthest

    def extent(
        self,
        start: int | None = None,
        fields: int = 20,
        method: str | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> Extent:
        """Bounds of the geodesic diameter and radius of a component, its ends and its centre.

        A double sweep, then vertices chosen by the bounds that the triangle inequality gives (Takes, Kosters 2011).

        Parameters
        ----------
        start : int, optional
            A vertex of the component; None is the component with the most vertices.
        fields : int, default 20
            Distance fields that may be computed, at least 2; more bring the bounds closer together.
        """
        first = -1 if start is None else check.integer("start", start, 0, max(len(self.vertices) - 1, 0))
        limit = check.integer("fields", fields, 2, 2**31 - 1)
        return Extent(*self._ask(self._shared.core.extent, first, limit, method=method, progress=progress))

    def relax(
        self,
        points: Points,
        rounds: int = 10,
        method: str | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> RelaxedPoints:
        """Lloyd relaxation: move points to the middle of their geodesic Voronoi regions, at vertices.

        All points move if that lowers the integral of squared geodesic distances over the surface, otherwise only those
        over whose region it falls. Complexity: one or two fields from all points for each round, for which `method` may
        be "quick".

        Parameters
        ----------
        points : k points, k >= 1
            Anywhere on the surface; they move to vertices. A repeated point waits until the other one has moved.
        rounds : int, default 10
            At most this many; fewer if no point finds a better vertex.
        """
        chosen, limit = self._rows("points", points, least=1), check.integer("rounds", rounds, 0, 2**31 - 1)
        rows, energy = self._ask(
            self._shared.core.relax, chosen, limit, method=method, progress=progress, choices=METHODS
        )
        return RelaxedPoints(rows[0], energy, surface_points(rows))


def paths_of(found: Any) -> list[GeodesicPath]:
    """Paths as the core returns them."""
    lengths, certified, begin, points, (vertices, faces, weights), over_gap = found
    return [
        GeodesicPath(
            points[a:b],
            float(length),
            vertices[a:b],
            SurfacePoints(faces[a:b], weights[a:b]),
            bool(proven),
            over_gap[a:b] > 0,
        )
        for length, proven, a, b in zip(lengths, certified, begin[:-1], begin[1:], strict=True)
    ]
