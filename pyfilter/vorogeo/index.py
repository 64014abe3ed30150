"""The geodesic index on numpy arrays: built once per mesh, then queried for distances."""

from __future__ import annotations

import os
from typing import Literal, cast, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as check
from . import _core
from .errors import InvalidInput
from .matrices import Matrices
from .points import EdgeCurve, Points, Sources, SurfacePoints, holds
from .progress import ProgressFunction, reporter
from .results import IndexStatistics
from .surface_tasks import SurfaceTasks


class GeodesicIndex(Matrices, SurfaceTasks):
    """Index of a triangle mesh for geodesic distances.

    Distances are lengths of shortest paths over the surface, in the unit of the vertices; infinity where no path
    exists. The index is immutable and may be used by several threads at once; long computations release the GIL.

    Parameters
    ----------
    vertices : array_like, shape (n, 3)
        Finite positions; any real type and layout.
    faces : array_like of int, shape (m, 3)
        Vertex ids of the triangles, 0 to n - 1.
    patches : (int, int), optional
        Numbers of patches: of the mesh, and of smaller ones in each of these. 0 (None for both): chosen from n.
    delta : float, default 0
        Average relative error that pruning of the graph may add, in [0, 1). 0 loses nothing; a value above 0 selects
        the form of a graph.
    threads : int, optional
        Threads of the build and of each field; None is one per core. The results do not depend on it.
    seed : int, default 0
        Seed of the random numbers that place the patches, 0 to 2**64 - 1.
    progress : callable or bool, optional
        Called as ``progress(fraction, text)`` from this thread, with a fraction in [0, 1] that never decreases; a
        result of False cancels. True shows a tqdm bar.
    memory_budget : int, optional
        MiB that the index may take; None is 4096. It consists of tables if they fit, otherwise of a pruned graph, which
        is smaller and slower; `statistics.form` says which.

    Raises
    ------
    InvalidInput
        (a ValueError) If an argument has a wrong shape, type or range, naming the element, or if the index does
        not fit the memory budget, naming the smallest budget that is enough.
    Cancelled
        If `progress` returned False.
    MemoryError
        If the index does not fit into memory.

    Examples
    --------
    >>> index = vorogeo.GeodesicIndex(vertices, faces)
    >>> index.distance(0, 17)
    >>> index.distance_field([0, 17])
    """

    __slots__ = ("__weakref__", "_handle", "_paths", "_statistics")

    _handle: _core.Index
    _statistics: IndexStatistics

    def __init__(
        self,
        vertices: ArrayLike,
        faces: ArrayLike,
        patches: tuple[int, int] | None = None,
        delta: float = 0.0,
        threads: int | None = None,
        seed: int = 0,
        progress: ProgressFunction | bool | None = None,
        memory_budget: int | None = None,
    ) -> None:
        points = check.vertices(vertices)
        triangles = check.faces(faces, len(points))
        n1, n2 = check.patches(patches)
        delta = check.delta(delta)
        workers = check.threads(threads)
        seed = check.integer("seed", seed, 0, 2**64 - 1)
        budget = 0 if memory_budget is None else check.integer("memory_budget", memory_budget, 1, 2**31 - 1)
        with reporter(progress) as report:
            handle = _core.Index.build(points, triangles, n1, n2, delta, workers, seed, budget, report)
        self._adopt(handle)

    @classmethod
    def load(
        cls, file: str | os.PathLike[str], vertices: ArrayLike, faces: ArrayLike, threads: int | None = None
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

        Raises
        ------
        IndexFileError
            (an OSError) If the file is missing, truncated, damaged, of another version or of another mesh.
        InvalidInput
            (a ValueError) If an argument has a wrong shape, type or range.
        """
        path = check.file_path(file)
        points = check.vertices(vertices)
        triangles = check.faces(faces, len(points))
        index = cls.__new__(cls)
        index._adopt(_core.Index.load(path, points, triangles, check.threads(threads)))
        return index

    def _adopt(self, handle: _core.Index) -> None:
        self._handle = handle
        self._paths = _core.Paths(handle)
        self._statistics = IndexStatistics(**handle.statistics())

    def save(self, file: str | os.PathLike[str]) -> None:
        """Write the index, without the mesh, to a file.

        An old file of this name stays until the new one is complete; a symbolic link is followed.

        Raises
        ------
        IndexFileError
            (an OSError) If it cannot be written: a full disk, no permission, a folder, a device or a pipe.
        """
        self._handle.save(check.file_path(file))

    @overload
    def distance(self, source: int | np.integer, target: int | np.integer) -> float: ...
    @overload
    def distance(self, source: Points, target: Points) -> float | NDArray[np.float64]: ...
    def distance(self, source: Points, target: Points) -> float | NDArray[np.float64]:
        """Distance between two points, or between the points of each of k pairs.

        Parameters
        ----------
        source, target : a point, or k points
            Vertex ids, 0 to n - 1, `SurfacePoints`, or lists of both; both single or both of the same length. With
            SurfacePoints the answer is the length of the refined path (`path`).

        Returns
        -------
        float, or ndarray of float64, shape (k,)
            In the unit of the vertices; infinity between components. Symmetric.

        Raises
        ------
        InvalidInput
            (a ValueError) If an id is not an integer or out of range, or if the lengths differ.
        """
        count = self._statistics.vertices
        if type(source) is int and type(target) is int and 0 <= source < count and 0 <= target < count:
            return self._handle.distance(source, target)
        if holds(source, SurfacePoints) or holds(target, SurfacePoints):
            found = self.path(source, target)
            return np.array([path.length for path in found]) if isinstance(found, list) else found.length
        sources = check.vertex_ids("source", cast(ArrayLike, source), count)
        targets = check.vertex_ids("target", cast(ArrayLike, target), count)
        if sources.shape != targets.shape:
            raise InvalidInput(
                f"source has shape {sources.shape} and target {targets.shape}; "
                "give two vertex ids, or two arrays of one length (distance_field goes from one vertex to all)."
            )
        if sources.ndim == 0:
            return self._handle.distance(int(sources), int(targets))
        return self._handle.distances(sources, targets)

    @overload
    def distance_field(
        self,
        sources: Sources,
        max_distance: float | None = None,
        *,
        offsets: ArrayLike | None = None,
        return_labels: Literal[False] = False,
    ) -> NDArray[np.float64]: ...
    @overload
    def distance_field(
        self,
        sources: Sources,
        max_distance: float | None = None,
        *,
        offsets: ArrayLike | None = None,
        return_labels: Literal[True],
    ) -> tuple[NDArray[np.float64], NDArray[np.int32]]: ...
    def distance_field(
        self,
        sources: Sources,
        max_distance: float | None = None,
        *,
        offsets: ArrayLike | None = None,
        return_labels: bool = False,
    ) -> NDArray[np.float64] | tuple[NDArray[np.float64], NDArray[np.int32]]:
        """Distance of every vertex from its nearest source.

        Parameters
        ----------
        sources : int, array_like of int of shape (k,), SurfacePoints, EdgeCurve, or a list of any of these
            Vertex ids, 0 to n - 1, points from `snap`, or curves, at least one; repeated ones make no difference. A
            curve is one source.
        max_distance : float, optional
            Distances above it become infinity; None for no limit.
        offsets : array_like, shape (k,), optional
            Lengths added to the distances from each source, 0 or more; the least sum is taken.
        return_labels : bool, default False
            Whether to return also the nearest source.

        Returns
        -------
        distance : ndarray of float64, shape (n,)
            In the unit of the vertices; infinity where no source can be reached.
        label : ndarray of int32, shape (n,)
            Only if `return_labels`: the position of the nearest source in `sources`, -1 where there is none. Of sources
            at nearly the same distance, any.

        Raises
        ------
        InvalidInput
            (a ValueError) If there is no source, an id is not an integer or out of range, an offset is negative or not
            finite, or the limit is negative.
        """
        limit = check.max_distance(max_distance)
        plain = not holds(sources, (SurfacePoints, EdgeCurve))
        if plain and offsets is None and not return_labels:
            return self._handle.distance_field(
                check.source_ids(cast(ArrayLike, sources), self._statistics.vertices), limit
            )
        distance, label = self._labelled_field(sources, offsets, limit)
        return (distance, label) if return_labels else distance

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
