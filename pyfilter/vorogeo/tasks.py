"""Tasks built on many distances: matrices, neighbours, regions, samplings, lines, measures."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _arguments as check
from . import points as point_lists
from ._output import Output, matrix, releasing, require_memory
from .errors import InvalidInput
from .on_mesh import OnMesh
from .points import Points, Sources, surface_points
from .progress import ProgressFunction, reporter
from .results import (
    Answered,
    Disk,
    Extent,
    FarthestSamples,
    Isolines,
    Polylines,
    RelaxedPoints,
    SparseDistances,
    VoronoiRegions,
)

_ENTRIES = ("automatic", "pairs", "fields")
_INTERPOLATIONS = ("linear", "distance")
_ENTRY_BYTES = 28  # of a sparse matrix while it is assembled; 12 in the result
_SAMPLES = 16


class Tasks(OnMesh):
    """The tasks of `Surface`.

    What they have in common: points are vertex ids, `SurfacePoints` or lists of both. `method` is "automatic", "index"
    or "exact", as for `Surface`; None is what the class stands for. `progress` is as for `Surface.build_index`.
    `dtype`, float64 or float32, is the type of the result: float32 takes half the memory and rounds to 6e-8 of a
    distance. `max_bytes` is the memory that the result may take; None: what is available. Errors are `InvalidInput` (a
    ValueError that names the element) for arguments, `NotEnoughMemory` (a MemoryError) where the result does not fit,
    and `Cancelled` if `progress` returned False.
    """

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
        """Distances between all points, or from all points to all others.

        Parameters
        ----------
        points : k points
            Of the rows, and of the columns if there are no `others`; may repeat.
        others : m points, optional
            Of the columns.
        entries : {"automatic", "pairs", "fields"}
            How they are computed from an index. "pairs": the values of `distance`. "fields": read from the field of
            each point; without `others`, from that of one point of each pair, so that the matrix is symmetric. Both
            approximate the same distances; for points in faces "pairs" is more accurate. "automatic": whichever should
            be faster for this size.
        out : str, path or ndarray, optional
            A file to write as .npy, or an array of float64 or float32 and the shape of the result. A file is mapped, so
            it may be larger than the memory; its space is reserved first, and an old file stays until it is complete.
        method : str, optional
            As for all tasks; exact distances are read from fields.
        dtype : {float64, float32}, optional
            None is the type of an array `out`, else float64.
        max_bytes, progress
            As for all tasks; `vorogeo.matrix_bytes` says how much memory the result takes.

        Returns
        -------
        ndarray, shape (k, k) or (k, m)
            Infinity between components. Without `others` symmetric to the last bit with a zero diagonal.

        Raises
        ------
        FileError
            (an OSError) If the file cannot be written, such as on a full disk; as with the errors of all tasks, nothing
            was computed.
        InvalidInput
            Also if `out` does not name a plain file in an existing folder.

        Notes
        -----
        Complexity: k (k - 1) / 2 distances (k m with `others`), or as many fields as the shorter list is long.
        """
        how = check.choice("entries", entries, _ENTRIES)
        rows = self._rows("points", points)
        columns = None if others is None else self._rows("others", others)
        shape = len(rows[0]), len(rows[0] if columns is None else columns[0])
        with matrix(*shape, out, max_bytes, dtype) as result:
            self._fill(self._shared.core.fill_matrix, result, rows, columns, how, method=method, progress=progress)
        return _reopened(result, out)

    def _fill(
        self,
        question: Callable[..., Any],
        result: NDArray[Any],
        *arguments: Any,
        method: str | None,
        progress: ProgressFunction | bool | None,
    ) -> None:
        """Fill an array, if it has entries; a large file hands its pages back meanwhile."""
        by = self._method(method)
        with reporter(progress) as told:
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
    ) -> NDArray[Any]:
        """The distance field of each source on its own; `distance_field` is that from the nearest of several.

        Parameters
        ----------
        sources : k points
        max_distance : float, optional
            Distances above it become infinity; None for no limit.
        out, max_bytes, progress, method, dtype
            As for `distance_matrix`; so are the errors.

        Returns
        -------
        ndarray, shape (k, n)
            Infinity where there is no path.
        """
        rows, limit = self._rows("sources", sources), check.max_distance(max_distance)
        with matrix(len(rows[0]), len(self.vertices), out, max_bytes, dtype) as result:
            self._fill(self._shared.core.fill_fields, result, rows, limit, method=method, progress=progress)
        return _reopened(result, out)

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

        Parameters
        ----------
        points : k points
            Of the rows, and of the columns if there are no `others`.
        radius : float
            In the unit of the vertices, 0 or more.
        others : m points, optional
            Of the columns.
        as_arrays : bool, default False
            Whether to return `SparseDistances` even if scipy is installed.
        max_bytes, progress, method, dtype
            As for all tasks; `pairs_within_bytes` estimates the memory, and what does not fit is noticed as soon as so
            many pairs are found.

        Returns
        -------
        scipy.sparse.csr_array or SparseDistances, shape (k, k) or (k, m)
            Distances; those of 0 (repeated points) are stored as well. Without `others` symmetric to the last bit and
            without a diagonal. `SparseDistances` where scipy is not installed.

        Notes
        -----
        Complexity: for each point a field bounded by the radius. Values are those of `fields`; without `others`
        they are read from the field of one point of each pair.
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
    ) -> tuple[NDArray[Any], NDArray[np.int32]]:
        """The k nearest of a set of points, for each query point.

        Parameters
        ----------
        points : m points
            The set.
        queries : q points
        k : int, default 1
            Number of neighbours; may be larger than the set.
        progress, method, dtype
            As for all tasks.

        Returns
        -------
        distances : ndarray, shape (q, k)
            Nearest first; infinity where fewer can be reached.
        positions : ndarray of int32, shape (q, k)
            Positions in `points`, the first of equally near ones; -1 where fewer can be reached.

        Notes
        -----
        Complexity: as many fields as the shorter of `points` and `queries` is long.
        """
        entry = check.real_type(dtype)
        chosen, asked = self._rows("points", points), self._rows("queries", queries)
        count, size = check.integer("k", k, 1, 2**31 - 1), len(asked[0])
        require_memory(f"The result of {size} x {count} neighbours", 24.0 * size * count, None, "lower k.")
        positions, distances = self._ask(
            self._shared.core.nearest, chosen, asked, count, method=method, progress=progress
        )
        return distances.reshape(-1, count).astype(entry, copy=False), positions.reshape(-1, count)

    def voronoi(
        self, points: Points, method: str | None = None, progress: ProgressFunction | bool | None = None
    ) -> VoronoiRegions:
        """Geodesic Voronoi regions of points: the nearest point of every vertex and face, and the borders.

        Parameters
        ----------
        points : k points, k >= 1
            One that repeats an earlier one owns nothing.
        method, progress
            As for all tasks.

        Returns
        -------
        VoronoiRegions

        Notes
        -----
        Borders are exact on flat parts of the surface, given the distances of the vertices: in each face the difference
        of two squared distances is interpolated linearly. Complexity: a field for each point, bounded by the greatest
        distance of a vertex from its point.
        """
        chosen = self._rows("points", points, least=1)
        vertex_region, distance, face_region, area, ends, edges, sides = self._ask(
            self._shared.core.voronoi, chosen, method=method, progress=progress
        )
        return VoronoiRegions(vertex_region, distance, face_region, area, Polylines(ends, edges), sides)

    def isolines(self, field: ArrayLike, levels: ArrayLike, interpolation: str = "distance") -> Isolines:
        """Lines on which a field has given values.

        Parameters
        ----------
        field : array_like of float, shape (n,)
            Values of the vertices; faces with a value that is not finite hold no lines.
        levels : int or array_like of float, shape (l,)
            The values; an integer stands for that many, evenly spaced between the least and the greatest of the field.
        interpolation : {"distance", "linear"}
            "distance": along an edge, values vary like distances from a point in the plane, which is exact where the
            surface is flat; linear where they differ by more than the edge's length. "linear": for any field.

        Returns
        -------
        Isolines
            Edges join points of one level.
        """
        values = check.real_values("field", field)
        if len(values) != len(self.vertices):
            raise InvalidInput(
                f"field: has {len(values)} values; give one for each of the {len(self.vertices)} vertices."
            )
        how = check.choice("interpolation", interpolation, _INTERPOLATIONS)
        if isinstance(levels, (int, np.integer)):
            count = check.integer("levels", levels, 0, 2**31 - 1)
            finite = values[np.isfinite(values)]
            low, high = (float(finite.min()), float(finite.max())) if finite.size else (0.0, 0.0)
            chosen = np.linspace(low, high, count + 2)[1:-1]
        else:
            chosen = check.real_values("levels", levels)
        points, edges, level = self._shared.core.isolines(values, chosen, how)
        return Isolines(points, edges, chosen[level])

    def sample_farthest(
        self,
        count: int | None = None,
        radius: float = 0.0,
        start: Points = (),
        seed: int = 0,
        method: str | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> FarthestSamples:
        """Farthest point sampling: each sample is the vertex farthest from the previous ones.

        Parameters
        ----------
        count : int, optional
            Number of samples; fewer if there are not that many vertices.
        radius : float, default 0
            Stop as soon as every vertex is at most this far from a sample. Give this, `count`, or both.
        start : points, optional
            The first samples, anywhere on the surface; without them the first one is random.
        seed : int, default 0
            Of the random first sample.
        method, progress
            As for all tasks.

        Returns
        -------
        FarthestSamples
            Samples are at least the covering radius apart; every component gets one before any gets two.

        Notes
        -----
        Complexity: a field for each sample, bounded by the covering radius so far.
        """
        limit = 0 if count is None else check.integer("count", count, 1, 2**31 - 1)
        reach = check.length("radius", radius)
        if count is None and reach == 0:
            raise InvalidInput("Give a count of samples, or a covering radius above 0 at which to stop.")
        first, seed = self._rows("start", start), check.integer("seed", seed, 0, 2**64 - 1)
        rows, gaps, distance, covered = self._ask(
            self._shared.core.sample_farthest, limit, reach, first, seed, method=method, progress=progress
        )
        return FarthestSamples(rows[0], gaps, distance, covered, surface_points(rows))

    def sample_poisson_disk(
        self, radius: float, seed: int = 0, method: str | None = None, progress: ProgressFunction | bool | None = None
    ) -> NDArray[np.int32]:
        """Poisson-disk sampling: random vertices at least a radius apart, none of which could be added.

        Parameters
        ----------
        radius : float
            Least distance of two samples, above 0.
        seed : int, default 0
            Seed of the random numbers.
        method, progress
            As for all tasks.

        Returns
        -------
        ndarray of int32, shape (k,)
            Vertex ids. The result does not depend on the number of threads.

        Notes
        -----
        Complexity: a field for each sample, bounded by the radius.
        """
        reach = check.length("radius", radius)
        if not 0 < reach < np.inf:
            raise InvalidInput(f"radius: {reach} is out of range; give a finite length above 0.")
        seed = check.integer("seed", seed, 0, 2**64 - 1)
        (samples,) = self._ask(self._shared.core.sample_poisson_disk, reach, seed, method=method, progress=progress)
        found: NDArray[np.int32] = samples
        return found

    def disk(self, sources: Sources, radius: float, method: str | None = None) -> Disk:
        """Vertices and faces within a radius of the nearest source.

        Parameters
        ----------
        sources : k points, k >= 1
            Or an `EdgeCurve`, or a list that contains curves.
        radius : float
            0 or more.
        method : str, optional
            As for all tasks.

        Returns
        -------
        Disk
        """
        rows, _ = self._source_rows(sources)
        return Disk(*self._ask(self._shared.core.disk, rows, check.length("radius", radius), method=method))

    def eccentricity(
        self, points: Points, method: str | None = None, progress: ProgressFunction | bool | None = None
    ) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """The greatest distance from each point within its component, and the vertex at that distance.

        Parameters
        ----------
        points : k points
        method, progress
            As for all tasks.

        Returns
        -------
        distances : ndarray of float64, shape (k,)
        farthest : ndarray of int32, shape (k,)
        """
        chosen = self._rows("points", points)
        distances, farthest = self._ask(self._shared.core.eccentricity, chosen, method=method, progress=progress)
        return distances, farthest

    def extent(
        self,
        start: int | None = None,
        fields: int = 20,
        method: str | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> Extent:
        """Bounds of the geodesic diameter and radius of a component, its ends and its centre.

        Parameters
        ----------
        start : int, optional
            A vertex of the component; None is the component with the most vertices.
        fields : int, default 20
            Distance fields that may be computed, at least 2; more bring the bounds closer together.
        method, progress
            As for all tasks.

        Returns
        -------
        Extent

        Notes
        -----
        A double sweep, then vertices chosen by the bounds that the triangle inequality gives (Takes, Kosters 2011).
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

        Parameters
        ----------
        points : k points, k >= 1
            Anywhere on the surface; they move to vertices. A repeated point waits until the other one has moved.
        rounds : int, default 10
            At most this many; fewer if no point finds a better vertex.
        method, progress
            As for all tasks.

        Returns
        -------
        RelaxedPoints

        Notes
        -----
        A point moves only if that lowers the integral of squared geodesic distances over its region. Complexity: two
        fields for each point and round, bounded by the size of the regions.
        """
        chosen, limit = self._rows("points", points, least=1), check.integer("rounds", rounds, 0, 2**31 - 1)
        rows, energy = self._ask(self._shared.core.relax, chosen, limit, method=method, progress=progress)
        return RelaxedPoints(rows[0], energy, surface_points(rows))


def _reopened(result: NDArray[Any], out: Output) -> NDArray[Any]:
    """The result; if it went to a file, that file mapped read-only under its final name."""
    if out is None or isinstance(out, np.ndarray) or result.size == 0:
        return result
    mapped: NDArray[Any] = np.load(check.file_path(out), mmap_mode="r")
    return mapped
