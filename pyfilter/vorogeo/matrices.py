"""Many distances in one call: pairs, matrices, fields of many sources, and neighbours."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _arguments as check
from . import _core
from . import points as point_lists
from ._output import Output, matrix, require_memory
from .errors import InvalidInput
from .points import Points, Rows
from .progress import ProgressFunction, reporter
from .results import IndexStatistics, SparseDistances

_METHODS = ("auto", "pairs", "fields")
_ENTRY_BYTES = 28  # while the matrix is assembled; 12 in the result
_SAMPLES = 16


class Matrices:
    """The methods of `GeodesicIndex` that answer many queries in one call.

    Points are vertex ids, `SurfacePoints` or lists of both, possibly empty; ``k`` is how many there are.
    """

    __slots__ = ()

    _handle: _core.Index
    _statistics: IndexStatistics

    def _rows(self, name: str, value: Points) -> Rows:
        return point_lists.rows(name, value, self._statistics.vertices)

    def distances(
        self, sources: Points, targets: Points, progress: ProgressFunction | bool | None = None
    ) -> NDArray[np.float64]:
        """Distances of k pairs of points, on all threads; the same values as by `distance`.

        Parameters
        ----------
        sources, targets : k points each
            May be empty.
        progress : callable or bool, optional
            As for the constructor.

        Returns
        -------
        ndarray of float64, shape (k,)
            Infinity between components.

        Raises
        ------
        InvalidInput
            (a ValueError) If an id is not an integer or out of range, or if the lengths differ.
        Cancelled
            If `progress` returned False.
        """
        first, second = self._rows("sources", sources), self._rows("targets", targets)
        if len(first[0]) != len(second[0]):
            raise InvalidInput(
                f"There are {len(first[0])} sources and {len(second[0])} targets; pairs need as many of both."
            )
        with reporter(progress) as report:
            return _core.pair_distances(self._handle, _core.Points(*first), _core.Points(*second), report)

    def distance_matrix(
        self,
        points: Points,
        others: Points | None = None,
        method: str = "auto",
        out: Output = None,
        max_bytes: int | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> NDArray[np.float64]:
        """Distances between all points, or from all points to all others.

        Parameters
        ----------
        points : k points
            Of the rows, and of the columns if there are no `others`; may repeat.
        others : m points, optional
            Of the columns.
        method : {"auto", "pairs", "fields"}
            "pairs": the values of `distance`. "fields": read from the field of each point; without `others`, from that
            of one point of each pair, so that the matrix is symmetric. Both approximate the same distances; for points
            in faces "pairs" is more accurate. "auto": whichever should be faster for this size.
        out : str, path or ndarray, optional
            A file to write as .npy, or an array of float64 and the shape of the result. A file is mapped, so it may be
            larger than the memory; its space is reserved first, and an old file stays until the new one is complete.
        max_bytes : int, optional
            Memory that the result may take; None: what is available. `vorogeo.matrix_bytes` says how much it takes.
        progress : callable or bool, optional
            As for the constructor.

        Returns
        -------
        ndarray of float64, shape (k, k) or (k, m)
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
        how = check.choice("method", method, _METHODS)
        rows = self._rows("points", points)
        columns = rows if others is None else self._rows("others", others)
        with matrix(len(rows[0]), len(columns[0]), out, max_bytes) as result, reporter(progress) as report:
            if result.size == 0:
                pass
            elif others is None:
                _core.fill_square_matrix(self._handle, _core.Points(*rows), how, result, report)
            else:
                _core.fill_matrix(self._handle, _core.Points(*rows), _core.Points(*columns), how, result, report)
        return _reopened(result, out)

    def fields(
        self,
        sources: Points,
        max_distance: float | None = None,
        out: Output = None,
        max_bytes: int | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> NDArray[np.float64]:
        """The distance field of each source on its own; `distance_field` is that from the nearest of several.

        Parameters
        ----------
        sources : k points
        max_distance : float, optional
            Distances above it become infinity; None for no limit.
        out, max_bytes, progress
            As for `distance_matrix`.

        Returns
        -------
        ndarray of float64, shape (k, n)
            Infinity where there is no path.

        Raises
        ------
        InvalidInput, FileError, NotEnoughMemory, Cancelled
            As for `distance_matrix`.
        """
        rows, limit = self._rows("sources", sources), check.max_distance(max_distance)
        with (
            matrix(len(rows[0]), self._statistics.vertices, out, max_bytes) as result,
            reporter(progress) as report,
        ):
            if result.size:
                _core.fill_fields(self._handle, _core.Points(*rows), limit, result, report)
        return _reopened(result, out)

    def pairs_within(
        self,
        points: Points,
        radius: float,
        others: Points | None = None,
        as_arrays: bool = False,
        max_bytes: int | None = None,
        progress: ProgressFunction | bool | None = None,
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
        rows, reach, limit = self._rows("points", points), check.length("radius", radius), check.byte_limit(max_bytes)
        columns = rows if others is None else self._rows("others", others)
        with reporter(progress) as report:
            if others is None:
                found = _core.pairs_within(self._handle, _core.Points(*rows), reach, limit, report)
            else:
                found = _core.pairs_within_others(
                    self._handle, _core.Points(*rows), _core.Points(*columns), reach, limit, report
                )
        sparse = SparseDistances(found[2], found[1], found[0], (len(rows[0]), len(columns[0])))
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
        found = _core.pairs_within_others(self._handle, _core.Points(*some), _core.Points(*columns), reach, 0, None)
        return int(_ENTRY_BYTES * found[2].size * count / chosen.size)

    def nearest(
        self, points: Points, queries: Points, k: int = 1, progress: ProgressFunction | bool | None = None
    ) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
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

        Returns
        -------
        distances : ndarray of float64, shape (q, k)
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
        chosen, asked = self._rows("points", points), self._rows("queries", queries)
        count, size = check.integer("k", k, 1, 2**31 - 1), len(asked[0])
        require_memory(f"The result of {size} x {count} neighbours", 24.0 * size * count, None, "lower k.")
        with reporter(progress) as report:
            positions, distances = _core.nearest(
                self._handle, _core.Points(*chosen), _core.Points(*asked), count, report
            )
        return distances.reshape(-1, count), positions.reshape(-1, count)


def _reopened(result: NDArray[np.float64], out: Output) -> NDArray[np.float64]:
    """The result; if it went to a file, that file mapped read-only under its final name."""
    if out is None or isinstance(out, np.ndarray) or result.size == 0:
        return result
    mapped: NDArray[np.float64] = np.load(check.file_path(out), mmap_mode="r")
    return mapped
