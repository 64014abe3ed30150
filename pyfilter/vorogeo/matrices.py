"""Many distances in one call: pairs, matrices, fields of many sources."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from . import _arguments as check
from . import _core
from . import points as point_lists
from ._output import Output, matrix, releasing
from .errors import InvalidInput
from .on_mesh import OnMesh
from .points import Points, Rows
from .progress import ProgressFunction, reporter

_METHODS = ("automatic", "pairs", "fields")


class Matrices(OnMesh):
    """The methods of `GeodesicIndex` for matrices of distances.

    Points are vertex ids, `SurfacePoints` or lists of both, possibly empty; ``k`` is how many there are. With
    ``exact=True`` distances come from exact propagation instead of the index: slower, but without errors. `dtype`,
    float64 or float32, is the type of the result: float32 takes half the memory and rounds to 6e-8 of a distance.
    """

    __slots__ = ()

    _handle: _core.Index
    _paths: _core.Paths

    def _rows(self, name: str, value: Points) -> Rows:
        return point_lists.rows(name, value, self._vertex_count)

    def distances(
        self,
        sources: Points,
        targets: Points,
        progress: ProgressFunction | bool | None = None,
        exact: bool = False,
        dtype: DTypeLike = np.float64,
    ) -> NDArray[Any]:
        """Distances of k pairs of points, on all threads; the same values as by `distance`.

        Parameters
        ----------
        sources, targets : k points each
            May be empty.
        progress : callable or bool, optional
            As for the constructor.
        exact : bool
            Lengths of exact paths (`exact_path`), one for each pair.
        dtype
            As for the class.

        Returns
        -------
        ndarray, shape (k,)
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
        entry = check.real_type(dtype)
        ends = _core.Points(*first), _core.Points(*second)
        with reporter(progress) as report:
            found = (
                self._paths.paths(*ends, True, True, report)[0]
                if exact
                else _core.pair_distances(self._handle, *ends, report)
            )
        return found.astype(entry, copy=False)

    def distance_matrix(
        self,
        points: Points,
        others: Points | None = None,
        method: str = "automatic",
        out: Output = None,
        max_bytes: int | None = None,
        progress: ProgressFunction | bool | None = None,
        exact: bool = False,
        dtype: DTypeLike | None = None,
    ) -> NDArray[Any]:
        """Distances between all points, or from all points to all others.

        Parameters
        ----------
        points : k points
            Of the rows, and of the columns if there are no `others`; may repeat.
        others : m points, optional
            Of the columns.
        method : {"automatic", "pairs", "fields"}
            "pairs": the values of `distance`. "fields": read from the field of each point; without `others`, from that
            of one point of each pair, so that the matrix is symmetric. Both approximate the same distances; for points
            in faces "pairs" is more accurate. "automatic": whichever should be faster for this size.
        out : str, path or ndarray, optional
            A file to write as .npy, or an array of float64 or float32 and the shape of the result. A file is mapped, so
            it may be larger than the memory; its space is reserved first, and an old file stays until it is complete.
        max_bytes : int, optional
            Memory that the result may take; None: what is available. `vorogeo.matrix_bytes` says how much it takes.
        progress : callable or bool, optional
            As for the constructor.
        exact : bool
            As for the class; `method` is then "fields".
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
        how = check.choice("method", "automatic" if method == "auto" else method, _METHODS)
        rows = self._rows("points", points)
        columns = rows if others is None else self._rows("others", others)
        with matrix(len(rows[0]), len(columns[0]), out, max_bytes, dtype) as result, reporter(progress) as told:
            report = releasing(result, told)
            first = _core.Points(*rows)
            if result.size == 0:
                pass
            elif others is None:
                _core.fill_square_matrix(self._handle, first, how, exact, result, report)
            else:
                _core.fill_matrix(self._handle, first, _core.Points(*columns), how, exact, result, report)
        return _reopened(result, out)

    def fields(
        self,
        sources: Points,
        max_distance: float | None = None,
        out: Output = None,
        max_bytes: int | None = None,
        progress: ProgressFunction | bool | None = None,
        exact: bool = False,
        dtype: DTypeLike | None = None,
    ) -> NDArray[Any]:
        """The distance field of each source on its own; `distance_field` is that from the nearest of several.

        Parameters
        ----------
        sources : k points
        max_distance : float, optional
            Distances above it become infinity; None for no limit.
        out, max_bytes, progress, exact, dtype
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
        rows, limit = self._rows("sources", sources), check.max_distance(max_distance)
        with (
            matrix(len(rows[0]), self._vertex_count, out, max_bytes, dtype) as result,
            reporter(progress) as told,
        ):
            if result.size:
                report = releasing(result, told)
                _core.fill_fields(self._handle, _core.Points(*rows), limit, exact, result, report)
        return _reopened(result, out)


def _reopened(result: NDArray[Any], out: Output) -> NDArray[Any]:
    """The result; if it went to a file, that file mapped read-only under its final name."""
    if out is None or isinstance(out, np.ndarray) or result.size == 0:
        return result
    mapped: NDArray[Any] = np.load(check.file_path(out), mmap_mode="r")
    return mapped
