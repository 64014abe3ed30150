"""Tasks built on many distances: matrices, neighbours, regions, samplings, lines, measures."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _arguments as check
from . import _core
from . import points as point_lists
from ._output import Output, matrix, releasing, require_memory
from .errors import InvalidInput
from .on_mesh import OnMesh
from .points import Points, Sources, surface_points
from .progress import ProgressFunction, reporter
from .results import (
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

    Points are vertex ids, `SurfacePoints` or lists of both; `progress` is as for `GeodesicIndex`; errors are
    `InvalidInput` for arguments and `Cancelled` if `progress` returned False. `method` is "automatic", "index" or
    "exact", as for `Surface`; None is what the class stands for. `dtype`, float64 or float32, is the type of the
    result: float32 takes half the memory and rounds to 6e-8 of a distance.
    """

    __slots__ = ()

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
        max_bytes : int, optional
            Memory that the result may take; None: what is available. `vorogeo.matrix_bytes` says how much it takes.
        progress : callable or bool, optional
            As for the constructor.
        method : str, optional
            As for the class; exact distances are read from fields.
        dtype : {float64, float32}, optional
            None is the type of an array `out`, else float64.

        Returns
        -------
        ndarray, shape (k, k) or (k, m)
            Infinity between components. Without `others` symmetric to the last bit with a zero diagonal.

        Raises
        ------
        InvalidInput
            (a ValueError) If an argument has a wrong shape, type or range, or `out` does not name a plain file in an
            existing folder.
        FileError
            (an OSError) If the file cannot be written, such as on a full disk; nothing was computed.
        NotEnoughMemory
            (a MemoryError) If the result does not fit; nothing was computed.
        Cancelled
            If `progress` returned False.

        Notes
        -----
        Complexity: k (k - 1) / 2 distances (k m with `others`), or as many fields as the shorter list is long.
        """
        how, by = check.choice("entries", entries, _ENTRIES), self._method(method)
        rows = point_lists.rows("points", points, self._vertex_count)
        columns = rows if others is None else point_lists.rows("others", others, self._vertex_count)
        with matrix(len(rows[0]), len(columns[0]), out, max_bytes, dtype) as result, reporter(progress) as told:
            report = releasing(result, told)
            first = _core.Points(*rows)
            if result.size == 0:
                pass
            elif others is None:
                self._note(_core.fill_square_matrix(self._handle, first, how, by, result, report))
            else:
                second = _core.Points(*columns)
                self._note(_core.fill_matrix(self._handle, first, second, how, by, result, report))
        return _reopened(result, out)

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
            As for `distance_matrix`.

        Returns
        -------
        ndarray, shape (k, n)
            Infinity where there is no path.

        Raises
        ------
        InvalidInput, FileError, NotEnoughMemory, Cancelled
            As for `distance_matrix`.
        """
        rows, limit = point_lists.rows("sources", sources, self._vertex_count), check.max_distance(max_distance)
        by = self._method(method)
        with (
            matrix(len(rows[0]), self._vertex_count, out, max_bytes, dtype) as result,
            reporter(progress) as told,
        ):
            if result.size:
                report = releasing(result, told)
                self._note(_core.fill_fields(self._handle, _core.Points(*rows), limit, by, result, report))
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
        max_bytes : int, optional
            Memory that may be used; None: what is available. `pairs_within_bytes` estimates it.
        progress : callable or bool, optional
            As for the constructor.
        method, dtype
            As for the class.

        Returns
        -------
        scipy.sparse.csr_array or SparseDistances, shape (k, k) or (k, m)
            Distances; those of 0 (repeated points) are stored as well. Without `others` symmetric to the last bit and
            without a diagonal. `SparseDistances` where scipy is not installed.

        Raises
        ------
        InvalidInput
            (a ValueError) If an id is out of range, or the radius negative or NaN.
        NotEnoughMemory
            (a MemoryError) As soon as the pairs found do not fit.
        Cancelled
            If `progress` returned False.

        Notes
        -----
        Complexity: for each point a field bounded by the radius. Values are those of `fields`; without `others`
        they are read from the field of one point of each pair.
        """
        rows, reach, limit = (
            point_lists.rows("points", points, self._vertex_count),
            check.length("radius", radius),
            check.byte_limit(max_bytes),
        )
        columns = rows if others is None else point_lists.rows("others", others, self._vertex_count)
        entry, by = check.real_type(dtype), self._method(method)
        with reporter(progress) as report:
            if others is None:
                found = _core.pairs_within(self._handle, _core.Points(*rows), reach, by, limit, report)
            else:
                found = _core.pairs_within_others(
                    self._handle, _core.Points(*rows), _core.Points(*columns), reach, by, limit, report
                )
        self._note(found[3])
        sparse = SparseDistances(
            found[2].astype(entry, copy=False), found[1], found[0], (len(rows[0]), len(columns[0]))
        )
        if as_arrays:
            return sparse
        try:
            from scipy.sparse import csr_array
        except ImportError:
            return sparse
        return csr_array(sparse[:3], shape=sparse.shape)

    def pairs_within_bytes(self, points: Points, radius: float, others: Points | None = None) -> int:
        """Memory that `pairs_within` will take, extrapolated from 16 of the points; in bytes."""
        rows = point_lists.rows("points", points, self._vertex_count)
        columns = rows if others is None else point_lists.rows("others", others, self._vertex_count)
        count = len(rows[0])
        if count == 0 or len(columns[0]) == 0:
            return 0
        chosen = np.unique(np.linspace(0, count - 1, _SAMPLES).astype(int))
        some = (
            rows[0][chosen],
            rows[1][chosen] if rows[1].size else rows[1],
            rows[2][chosen] if rows[1].size else rows[2],
        )
        reach = check.length("radius", radius)
        found = _core.pairs_within_others(
            self._handle, _core.Points(*some), _core.Points(*columns), reach, self._method(None), 0, None
        )
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
        progress : callable or bool, optional
            As for the constructor.
        method, dtype
            As for the class.

        Returns
        -------
        distances : ndarray, shape (q, k)
            Nearest first; infinity where fewer can be reached.
        positions : ndarray of int32, shape (q, k)
            Positions in `points`, the first of equally near ones; -1 where fewer can be reached.

        Raises
        ------
        InvalidInput
            (a ValueError) If an id or k is out of range.
        NotEnoughMemory
            (a MemoryError) If the result does not fit.
        Cancelled
            If `progress` returned False.

        Notes
        -----
        Complexity: as many fields as the shorter of `points` and `queries` is long.
        """
        entry = check.real_type(dtype)
        chosen, asked = (
            point_lists.rows("points", points, self._vertex_count),
            point_lists.rows("queries", queries, self._vertex_count),
        )
        count, size = check.integer("k", k, 1, 2**31 - 1), len(asked[0])
        require_memory(f"The result of {size} x {count} neighbours", 24.0 * size * count, None, "lower k.")
        by = self._method(method)
        with reporter(progress) as report:
            positions, distances, answered = _core.nearest(
                self._handle, _core.Points(*chosen), _core.Points(*asked), count, by, report
            )
        self._note(answered)
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
            As for the class.

        Returns
        -------
        VoronoiRegions

        Notes
        -----
        Borders are exact on flat parts of the surface, given the distances of the vertices: in each face the difference
        of two squared distances is interpolated linearly. Complexity: a field for each point, bounded by the greatest
        distance of a vertex from its point.
        """
        chosen = point_lists.some("points", points, self._vertex_count)
        with reporter(progress) as report:
            found = _core.voronoi(self._handle, chosen, self._method(method), report)
        self._note(found[7])
        borders = Polylines(found[4].reshape(-1, 3), found[5].reshape(-1, 2))
        return VoronoiRegions(*found[:4], borders, found[6].reshape(-1, 2))

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
        if values.size != self._vertex_count:
            raise InvalidInput(
                f"field: has {values.size} values; give one for each of the {self._vertex_count} vertices."
            )
        how = check.choice("interpolation", interpolation, _INTERPOLATIONS)
        if isinstance(levels, (int, np.integer)):
            count = check.integer("levels", levels, 0, 2**31 - 1)
            finite = values[np.isfinite(values)]
            low, high = (float(finite.min()), float(finite.max())) if finite.size else (0.0, 0.0)
            chosen = np.linspace(low, high, count + 2)[1:-1]
        else:
            chosen = check.real_values("levels", levels)
        points, edges, level = _core.isolines(self._handle, values, chosen, how)
        return Isolines(points.reshape(-1, 3), edges.reshape(-1, 2), chosen[level])

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
            As for the class.

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
        first = point_lists.given("start", start, self._vertex_count)
        seed = check.integer("seed", seed, 0, 2**64 - 1)
        with reporter(progress) as report:
            found = _core.sample_farthest(self._handle, limit, reach, first, seed, self._method(method), report)
        rows, gaps, distance, covered = found[:4]
        self._note(found[4])
        return FarthestSamples(rows[0], gaps, distance, covered, surface_points(*rows))

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
            As for the class.

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
        with reporter(progress) as report:
            samples, answered = _core.sample_poisson_disk(self._handle, reach, seed, self._method(method), report)
        self._note(answered)
        return samples

    def disk(self, sources: Sources, radius: float, method: str | None = None) -> Disk:
        """Vertices and faces within a radius of the nearest source.

        Parameters
        ----------
        sources : k points, k >= 1
            Or an `EdgeCurve`, or a list that contains curves.
        radius : float
            0 or more.
        method : str, optional
            As for the class.

        Returns
        -------
        Disk
        """
        rows, _ = self._source_rows(sources)
        reach, by = check.length("radius", radius), self._method(method)
        found = _core.disk(self._handle, _core.Points(*rows), reach, by)
        self._note(found[3])
        return Disk(*found[:3])

    def eccentricity(
        self, points: Points, method: str | None = None, progress: ProgressFunction | bool | None = None
    ) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """The greatest distance from each point within its component, and the vertex at that distance.

        Parameters
        ----------
        points : k points
        method, progress
            As for the class.

        Returns
        -------
        distances : ndarray of float64, shape (k,)
        farthest : ndarray of int32, shape (k,)
        """
        chosen = point_lists.given("points", points, self._vertex_count)
        with reporter(progress) as report:
            distances, farthest, answered = _core.eccentricity(self._handle, chosen, self._method(method), report)
        self._note(answered)
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
            As for the class.

        Returns
        -------
        Extent

        Notes
        -----
        A double sweep, then vertices chosen by the bounds that the triangle inequality gives (Takes, Kosters 2011).
        """
        last = max(self._vertex_count - 1, 0)
        first = -1 if start is None else check.integer("start", start, 0, last)
        limit = check.integer("fields", fields, 2, 2**31 - 1)
        with reporter(progress) as report:
            found = _core.extent(self._handle, first, limit, self._method(method), report)
        self._note(found[5])
        return Extent(*found[:5])

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
            As for the class.

        Returns
        -------
        RelaxedPoints

        Notes
        -----
        A point moves only if that lowers the integral of squared geodesic distances over its region. Complexity: two
        fields for each point and round, bounded by the size of the regions.
        """
        chosen = point_lists.some("points", points, self._vertex_count)
        limit = check.integer("rounds", rounds, 0, 2**31 - 1)
        with reporter(progress) as report:
            rows, energy, answered = _core.relax(self._handle, chosen, limit, self._method(method), report)
        self._note(answered)
        return RelaxedPoints(rows[0], energy, surface_points(*rows))


def _reopened(result: NDArray[Any], out: Output) -> NDArray[Any]:
    """The result; if it went to a file, that file mapped read-only under its final name."""
    if out is None or isinstance(out, np.ndarray) or result.size == 0:
        return result
    mapped: NDArray[Any] = np.load(check.file_path(out), mmap_mode="r")
    return mapped
