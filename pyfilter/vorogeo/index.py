"""The geodesic index on numpy arrays: built once per mesh, then queried for distances."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as check
from . import _core, metrics
from ._serial import loaded, saved
from .gaps import GapLimit, gap_limit
from .masks import face_mask, without_masked
from .metrics import Metric, MetricLengths
from .progress import ProgressFunction, reporter
from .queries import Queries
from .results import IndexStatistics


class GeodesicIndex(Queries):
    """Index of a triangle mesh for geodesic distances.

    Distances are lengths of shortest paths over the surface, in the unit of the vertices; infinity where no path
    exists. The index is immutable and may be used by several threads at once; long computations release the GIL. It
    can be pickled, and works in processes that were forked, spawned or served.

    Parameters
    ----------
    vertices : array_like, shape (n, 3)
        Finite positions; any real type and layout. None is possible with the metric `EdgeLengths`.
    faces : array_like of int, shape (m, 3)
        Vertex ids of the triangles, 0 to n - 1.
    patches : (int, int), optional
        Numbers of patches: of the mesh, and of smaller ones in each of these. 0 (None for both): chosen from n.
    delta : float, default 0
        Average relative error that pruning of the graph may add, in [0, 1). 0 loses nothing; a value above 0 selects
        the form of a graph.
    threads : int, optional
        Threads of the build and of each field; None is one per core. The results do not depend on it. Reading the
        mesh, the first percent of a build, takes all cores in any case.
    seed : int, default 0
        Seed of the random numbers that place the patches, 0 to 2**64 - 1.
    progress : callable or bool, optional
        Called as ``progress(fraction, text)`` from this thread, with a fraction in [0, 1] that never decreases; a
        result of False cancels. True shows a tqdm bar.
    memory_budget : int, optional
        MiB that the index may take; None is 4096, or any with `file`, whose tables are not counted. It consists of
        tables if they fit, otherwise of a pruned graph, which is smaller and slower; `statistics.form` says which.
    metric : EdgeLengths, VertexCost, VertexTensor, FaceCost or FaceTensor, optional
        What paths cost; None is their length in space. All distances, radii and areas are then in its unit.
    mask : array_like of bool, shape (m,) or (n,), optional
        Which faces belong to the surface, or which vertices (then the faces all of whose vertices do; if there are as
        many faces as vertices, a mask is one of faces). Distances neither cross nor see the others; vertices
        without a face are unreachable. Results refer to all vertices and faces.
    gap, bridge_folds : float and bool, optional
        Borders up to `gap` apart that face each other (`bridge_folds`: or do not), and equal positions, are joined in
        the mesh that is measured on (``docs/gaps.md``). Not together with a metric.
    file : str or path, optional
        Where the index is built (``docs/index-file.md``): its tables go there as they are filled and are mapped, so
        that it may be larger than the memory. If the file has the index of this mesh, it is loaded; if a build was
        stopped, by whatever, this one goes on where that was.

    Raises
    ------
    InvalidInput
        (a ValueError) If an argument has a wrong shape, type or range, naming the element, or if the index does
        not fit the memory budget, naming the smallest budget that is enough.
    Cancelled
        If `progress` returned False.
    MemoryError
        If the index does not fit into memory.
    IndexFileError
        (an OSError) If `file` cannot be written (a full disk is noticed before the long part), or belongs to another
        mesh or other options, or another process is writing it.

    Warns
    -----
    UserWarning
        Before a build that is expected to take more than a second and more than 200 exact fields of this mesh.

    Examples
    --------
    >>> index = vorogeo.GeodesicIndex(vertices, faces)
    >>> index.distance(0, 17)
    >>> index.distance_field([0, 17])
    """

    __slots__ = (
        "__weakref__", "_faces", "_gap", "_handle", "_mask", "_metric", "_paths", "_statistics", "_threads", "_vertices"
    )  # fmt: skip

    _handle: _core.Index
    _statistics: IndexStatistics
    _mask: NDArray[np.bool_] | None
    _metric: Metric | None
    _gap: GapLimit
    _threads: int

    def __init__(
        self,
        vertices: ArrayLike | None,
        faces: ArrayLike,
        patches: tuple[int, int] | None = None,
        delta: float = 0.0,
        threads: int | None = None,
        seed: int = 0,
        progress: ProgressFunction | bool | None = None,
        memory_budget: int | None = None,
        mask: ArrayLike | None = None,
        metric: Metric | None = None,
        gap: float = 0.0,
        bridge_folds: bool = False,
        file: str | os.PathLike[str] | None = None,
    ) -> None:
        points = check.kept(metrics.positions(vertices, faces, metric), vertices)
        triangles = check.kept(check.faces(faces, len(points)), faces)
        kept = face_mask(mask, triangles, len(points))
        n1, n2 = check.patches(patches)
        delta = check.delta(delta)
        workers = check.threads(threads)
        seed = check.integer("seed", seed, 0, 2**64 - 1)
        budget = check.memory_budget(memory_budget)
        surface = without_masked(triangles, kept)
        lengths = metrics.lengths(metric, points, surface)
        sides = metrics.core_sides(lengths)
        bridged = gap_limit(gap, bridge_folds)
        path = None if file is None else check.file_path(file)
        options = n1, n2, delta, workers, seed, budget
        with reporter(progress) as report:
            handle = _core.Index.build(points, surface, sides, *options, *bridged, path, report)
        self._adopt(handle, points, triangles, kept, metric, lengths, bridged, workers)

    @classmethod
    def load(
        cls,
        file: str | os.PathLike[str],
        vertices: ArrayLike | None,
        faces: ArrayLike,
        threads: int | None = None,
        mask: ArrayLike | None = None,
        metric: Metric | None = None,
        gap: float = 0.0,
        bridge_folds: bool = False,
        mapped: bool = True,
    ) -> GeodesicIndex:
        """Read an index that was saved for exactly this mesh.

        Parameters
        ----------
        file : str or path
            A file written by `save`.
        vertices : array_like, shape (n, 3)
            Positions of the mesh that the index was built for.
        faces : array_like of int, shape (m, 3)
            Its triangles.
        threads : int, optional
            Threads of each field; None is one per core.
        mask, metric, gap, bridge_folds
            Those that the index was built with: an index of others is refused.
        mapped : bool, default True
            Leave the large tables in the file: all processes that load it share that memory. It may be removed or
            replaced (`save` does so) while it is used, but not be written to or cut in place, which ends the
            process. False: copy them, for files that others may change.

        Raises
        ------
        IndexFileError
            (an OSError) If the file is missing, truncated, damaged, of another version or of another mesh.
        InvalidInput
            (a ValueError) If an argument has a wrong shape, type or range.
        """
        path = check.file_path(file)
        points = check.kept(metrics.positions(vertices, faces, metric), vertices)
        triangles = check.kept(check.faces(faces, len(points)), faces)
        workers = check.threads(threads)
        kept = face_mask(mask, triangles, len(points))
        surface = without_masked(triangles, kept)
        lengths = metrics.lengths(metric, points, surface)
        sides = metrics.core_sides(lengths)
        bridged = gap_limit(gap, bridge_folds)
        handle = _core.Index.load(path, points, surface, sides, workers, *bridged, bool(mapped))
        return cls.__new__(cls)._adopt(handle, points, triangles, kept, metric, lengths, bridged, workers)

    def _adopt(
        self,
        handle: _core.Index,
        vertices: NDArray[np.float64],
        faces: NDArray[np.int32],
        mask: NDArray[np.bool_] | None,
        metric: Metric | None,
        lengths: MetricLengths | None,
        gap: GapLimit,
        threads: int,
    ) -> GeodesicIndex:
        self._handle = handle
        self._paths = _core.Paths(handle)
        of_metric = (0, 0) if lengths is None else (lengths.shortened_edges, lengths.split_faces)
        self._statistics = IndexStatistics(
            **handle.statistics(), shortened_edges=of_metric[0], split_faces=of_metric[1]
        )
        self._vertices, self._faces, self._mask = vertices, faces, mask
        self._metric, self._gap, self._threads = metric, gap, threads
        return self

    def __copy__(self) -> GeodesicIndex:
        return self  # immutable

    def __deepcopy__(self, memo: dict[int, Any]) -> GeodesicIndex:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        mesh = self._vertices, self._faces, self._mask, self._metric, self._gap
        return _restored, (type(self), saved(self._handle), *mesh, self._threads)

    @property
    def mask(self) -> NDArray[np.bool_] | None:
        """Which faces belong to the surface, of shape (m,), read-only; None if all do."""
        return self._mask

    @property
    def metric(self) -> Metric | None:
        """What paths cost; None is their length in space."""
        return self._metric

    @property
    def gap(self) -> float:
        """The width up to which gaps are bridged."""
        return self._gap[0]

    def save(self, file: str | os.PathLike[str]) -> None:
        """Write the index, without the mesh, to a file.

        An old file of this name stays until the new one is complete; a symbolic link is followed.

        Raises
        ------
        IndexFileError
            (an OSError) If it cannot be written: a full disk, no permission, a folder, a device or a pipe.
        """
        self._handle.save(check.file_path(file))

    def face_patches(self, layer: int) -> NDArray[np.int32]:
        """Patch of each face, numbered from 0.

        Parameters
        ----------
        layer : {1, 2}
            The large or the small patches.

        Returns
        -------
        ndarray of int32, shape (m,)
            -1 for a face that is left out (a vertex twice, or a repetition of an earlier face).

        Raises
        ------
        InvalidInput
            (a ValueError) For another layer.
        """
        return self._handle.face_patches(check.integer("layer", layer, 1, 2))

    @property
    def statistics(self) -> IndexStatistics:
        """What the index holds and what it cost."""
        return self._statistics

    def __repr__(self) -> str:
        s = self._statistics
        return (
            f"GeodesicIndex({s.vertices} vertices, {s.faces} faces, patches ({s.first_layer_patches}, "
            f"{s.second_layer_patches}), {s.form}, delta {s.delta:g}, {s.bytes / 2**20:.1f} MiB)"
        )


def _restored(
    cls: type[GeodesicIndex],
    contents: NDArray[np.uint8],
    vertices: NDArray[np.float64],
    faces: NDArray[np.int32],
    mask: NDArray[np.bool_] | None,
    metric: Metric | None,
    gap: GapLimit,
    threads: int,
) -> GeodesicIndex:
    """The index that pickle took apart."""
    surface = without_masked(faces, mask)
    lengths = metrics.lengths(metric, vertices, surface)
    handle = loaded(contents, vertices, surface, metrics.core_sides(lengths), threads, gap)
    return cls.__new__(cls)._adopt(handle, vertices, faces, mask, metric, lengths, gap, threads)
