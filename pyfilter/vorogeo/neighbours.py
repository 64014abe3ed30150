"""Neighbours by geodesic distance: all pairs within a radius, and the nearest of a set."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from . import _arguments as check
from . import _core
from ._output import require_memory
from .matrices import Matrices
from .points import Points
from .progress import ProgressFunction, reporter
from .results import SparseDistances

_ENTRY_BYTES = 28  # while the matrix is assembled; 12 in the result
_SAMPLES = 16


class Neighbours(Matrices):
    """The methods of `GeodesicIndex` for neighbours; `exact` and `dtype` are as for `Matrices`."""

    __slots__ = ()

    def pairs_within(
        self,
        points: Points,
        radius: float,
        others: Points | None = None,
        as_arrays: bool = False,
        max_bytes: int | None = None,
        progress: ProgressFunction | bool | None = None,
        exact: bool = False,
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
        exact, dtype
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
        rows, reach, limit = self._rows("points", points), check.length("radius", radius), check.byte_limit(max_bytes)
        columns = rows if others is None else self._rows("others", others)
        entry = check.real_type(dtype)
        with reporter(progress) as report:
            if others is None:
                found = _core.pairs_within(self._handle, _core.Points(*rows), reach, exact, limit, report)
            else:
                found = _core.pairs_within_others(
                    self._handle, _core.Points(*rows), _core.Points(*columns), reach, exact, limit, report
                )
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
        found = _core.pairs_within_others(
            self._handle, _core.Points(*some), _core.Points(*columns), reach, False, 0, None
        )
        return int(_ENTRY_BYTES * found[2].size * count / chosen.size)

    def nearest(
        self,
        points: Points,
        queries: Points,
        k: int = 1,
        progress: ProgressFunction | bool | None = None,
        exact: bool = False,
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
        exact, dtype
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
        chosen, asked = self._rows("points", points), self._rows("queries", queries)
        count, size = check.integer("k", k, 1, 2**31 - 1), len(asked[0])
        require_memory(f"The result of {size} x {count} neighbours", 24.0 * size * count, None, "lower k.")
        with reporter(progress) as report:
            positions, distances = _core.nearest(
                self._handle, _core.Points(*chosen), _core.Points(*asked), count, exact, report
            )
        return distances.reshape(-1, count).astype(entry, copy=False), positions.reshape(-1, count)
