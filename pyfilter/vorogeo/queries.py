"""The two questions asked most: the distance of two points, and the field of distances from some."""

from __future__ import annotations

from typing import Any, Literal, cast, overload

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _arguments as check
from .errors import InvalidInput
from .neighbours import Neighbours
from .points import EdgeCurve, Points, Sources, SurfacePoints, holds
from .surface_tasks import SurfaceTasks


class Queries(Neighbours, SurfaceTasks):
    """The methods of `GeodesicIndex` for two points and for fields, with those of all other tasks."""

    __slots__ = ()

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
        count = self._vertex_count
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
        exact: bool = False,
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
        exact: bool = False,
        dtype: DTypeLike = np.float64,
    ) -> tuple[NDArray[Any], NDArray[np.int32]]: ...
    def distance_field(
        self,
        sources: Sources,
        max_distance: float | None = None,
        *,
        offsets: ArrayLike | None = None,
        return_labels: bool = False,
        exact: bool = False,
        dtype: DTypeLike = np.float64,
    ) -> NDArray[Any] | tuple[NDArray[Any], NDArray[np.int32]]:
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
        exact : bool, default False
            Exact propagation instead of the index: slower, but without errors. A curve is still points along it.
        dtype : {float64, float32}
            Of the distances.

        Returns
        -------
        distance : ndarray, shape (n,)
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
        limit, entry = check.max_distance(max_distance), check.real_type(dtype)
        plain = not exact and not holds(sources, (SurfacePoints, EdgeCurve))
        if plain and offsets is None and not return_labels:
            ids = check.source_ids(cast(ArrayLike, sources), self._vertex_count)
            return self._handle.distance_field(ids, limit).astype(entry, copy=False)
        distance, label = self._labelled_field(sources, offsets, limit, exact)
        distance = distance.astype(entry, copy=False)
        return (distance, label) if return_labels else distance
