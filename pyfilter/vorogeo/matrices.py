"""Many distances in one call: pairs, matrices, fields of many sources, and neighbours."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as check
from . import _core
from ._output import Output, matrix, require_memory
from .errors import InvalidInput
from .progress import ProgressFunction, reporter

if TYPE_CHECKING:
    from .index import IndexStatistics

_METHODS = ("auto", "pairs", "fields")
_ENTRY_BYTES = 28  # while the matrix is put together; 12 in the end
_SAMPLES = 16


class SparseDistances(NamedTuple):
    """A sparse matrix in compressed rows: row i holds the entries indptr[i] to indptr[i + 1].

    Attributes
    ----------
    data : ndarray of float64, shape (entries,)
        Distances.
    indices : ndarray of int32, shape (entries,)
        Columns, ascending within a row.
    indptr : ndarray of int64, shape (rows + 1,)
        Where the rows begin.
    shape : (int, int)
        Rows and columns.
    """

    data: NDArray[np.float64]
    indices: NDArray[np.int32]
    indptr: NDArray[np.int64]
    shape: tuple[int, int]


class Matrices:
    """The methods of `GeodesicIndex` that answer many questions in one call."""

    __slots__ = ()

    _handle: _core.Index
    _statistics: IndexStatistics

    def _ids(self, name: str, value: ArrayLike) -> NDArray[np.int32]:
        return check.id_list(name, value, self._statistics.vertices)

    def distances(
        self, sources: ArrayLike, targets: ArrayLike, progress: ProgressFunction | bool | None = None
    ) -> NDArray[np.float64]:
        """Distances of k pairs of vertices, on all threads; the values of `distance`.

        Parameters
        ----------
        sources, targets : array_like of int, shape (k,)
            Vertex ids; no pair at all is allowed.
        progress : callable or bool, optional
            As for the constructor.

        Returns
        -------
        ndarray of float64, shape (k,)
            Infinity between components.

        Raises
        ------
        InvalidInput
            (a ValueError) If an id is no integer or out of range, or if the lengths differ.
        Cancelled
            If `progress` returned False.
        """
        first, second = self._ids("sources", sources), self._ids("targets", targets)
        if first.shape != second.shape:
            raise InvalidInput(f"There are {first.size} sources and {second.size} targets; pairs need as many of both.")
        with reporter(progress) as report:
            return _core.pair_distances(self._handle, first, second, report)

    def distance_matrix(
        self,
        points: ArrayLike,
        others: ArrayLike | None = None,
        method: str = "auto",
        out: Output = None,
        max_bytes: int | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> NDArray[np.float64]:
        """Distances between all points, or from all points to all others.

        Parameters
        ----------
        points : array_like of int, shape (k,)
            Vertex ids of the rows, and of the columns if there are no `others`; may be empty or repeat.
        others : array_like of int, shape (m,), optional
            Vertex ids of the columns.
        method : {"auto", "pairs", "fields"}
            "pairs": the values of `distance`. "fields": read from a `distance_field` of each point; without `others`,
            of the point with the smaller id, so that the matrix is symmetric. Both approximate one number. "auto":
            what is faster for this size.
        out : str, path or ndarray, optional
            A file to write as .npy, which appears whole or not at all, or an array of float64 and the shape of the
            result. For a file the result is mapped, so that it may be larger than the memory.
        max_bytes : int, optional
            What the result may take in memory; None is what is available. `vorogeo.matrix_bytes` says it beforehand.
        progress : callable or bool, optional
            As for the constructor.

        Returns
        -------
        ndarray of float64, shape (k, k) or (k, m)
            Infinity between components. Without `others` symmetric to the last bit with a zero diagonal.

        Raises
        ------
        InvalidInput
            (a ValueError) If an argument has a wrong shape, type or range.
        NotEnoughMemory
            (a MemoryError) If the result does not fit; nothing was computed.
        Cancelled
            If `progress` returned False.

        Notes
        -----
        Complexity: k (k - 1) / 2 distances (k m with `others`), or as many fields as the shorter list is long.
        """
        how = check.choice("method", method, _METHODS)
        rows = self._ids("points", points)
        columns = rows if others is None else self._ids("others", others)
        with matrix(rows.size, columns.size, out, max_bytes) as result, reporter(progress) as report:
            if result.size == 0:
                pass
            elif others is None:
                _core.fill_square_matrix(self._handle, rows, how, result, report)
            else:
                _core.fill_matrix(self._handle, rows, columns, how, result, report)
        return _reopened(result, out)

    def fields(
        self,
        sources: ArrayLike,
        max_distance: float | None = None,
        out: Output = None,
        max_bytes: int | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> NDArray[np.float64]:
        """The distance field of each source on its own; `distance_field` is that of the nearest of several.

        Parameters
        ----------
        sources : array_like of int, shape (k,)
            Vertex ids; may be empty.
        max_distance : float, optional
            Distances above it become infinity; None for no limit.
        out, max_bytes, progress
            As for `distance_matrix`.

        Returns
        -------
        ndarray of float64, shape (k, n)
            Infinity where no path leads.

        Raises
        ------
        InvalidInput, NotEnoughMemory, Cancelled
            As for `distance_matrix`.
        """
        ids, limit = self._ids("sources", sources), check.max_distance(max_distance)
        with (
            matrix(ids.size, self._statistics.vertices, out, max_bytes) as result,
            reporter(progress) as report,
        ):
            if result.size:
                _core.fill_fields(self._handle, ids, limit, result, report)
        return _reopened(result, out)

    def pairs_within(
        self,
        points: ArrayLike,
        radius: float,
        others: ArrayLike | None = None,
        as_arrays: bool = False,
        max_bytes: int | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> Any:
        """All pairs of points at most a radius apart, as a sparse matrix.

        Parameters
        ----------
        points : array_like of int, shape (k,)
            Vertex ids of the rows, and of the columns if there are no `others`.
        radius : float
            In the unit of the vertices, 0 or more.
        others : array_like of int, shape (m,), optional
            Vertex ids of the columns.
        as_arrays : bool, default False
            Whether to return `SparseDistances` even if scipy is installed.
        max_bytes : int, optional
            What may be taken; None is what is available. `pairs_within_bytes` estimates it.
        progress : callable or bool, optional
            As for the constructor.

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
        Complexity: for each point a field bounded by the radius. Values are those of `fields`; without `others` that
        of the point with the smaller id.
        """
        rows, reach, limit = self._ids("points", points), check.length("radius", radius), check.byte_limit(max_bytes)
        columns = rows if others is None else self._ids("others", others)
        with reporter(progress) as report:
            if others is None:
                found = _core.pairs_within(self._handle, rows, reach, limit, report)
            else:
                found = _core.pairs_within_others(self._handle, rows, columns, reach, limit, report)
        sparse = SparseDistances(found[2], found[1], found[0], (rows.size, columns.size))
        if as_arrays:
            return sparse
        try:
            from scipy.sparse import csr_array
        except ImportError:
            return sparse
        return csr_array(sparse[:3], shape=sparse.shape)

    def pairs_within_bytes(self, points: ArrayLike, radius: float, others: ArrayLike | None = None) -> int:
        """Memory that `pairs_within` will take, extrapolated from 16 of the points; in bytes."""
        rows = self._ids("points", points)
        columns = rows if others is None else self._ids("others", others)
        if rows.size == 0 or columns.size == 0:
            return 0
        some = rows[np.unique(np.linspace(0, rows.size - 1, _SAMPLES).astype(int))]
        found = self.pairs_within(some, radius, others=columns, as_arrays=True)
        return int(_ENTRY_BYTES * found.data.size * rows.size / some.size)

    def nearest(
        self, points: ArrayLike, queries: ArrayLike, k: int = 1, progress: ProgressFunction | bool | None = None
    ) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """The k nearest of a set of points, for each query point.

        Parameters
        ----------
        points : array_like of int, shape (m,)
            Vertex ids of the set.
        queries : array_like of int, shape (q,)
            Vertex ids.
        k : int, default 1
            How many of the set; may be more than it has.
        progress : callable or bool, optional
            As for the constructor.

        Returns
        -------
        distances : ndarray of float64, shape (q, k)
            Nearest first; infinity where fewer can be reached.
        positions : ndarray of int32, shape (q, k)
            Places in `points`, of equally near ones the first; -1 where fewer can be reached.

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
        chosen, asked = self._ids("points", points), self._ids("queries", queries)
        count = check.integer("k", k, 1, 2**31 - 1)
        require_memory(f"The result of {asked.size} x {count} neighbours", 24.0 * asked.size * count, None, "lower k.")
        with reporter(progress) as report:
            positions, distances = _core.nearest(self._handle, chosen, asked, count, report)
        return distances.reshape(-1, count), positions.reshape(-1, count)


def _reopened(result: NDArray[np.float64], out: Output) -> NDArray[np.float64]:
    """The result, mapped anew if it went to a file: under its final name and read-only."""
    if out is None or isinstance(out, np.ndarray) or result.size == 0:
        return result
    mapped: NDArray[np.float64] = np.load(check.file_path(out), mmap_mode="r")
    return mapped
