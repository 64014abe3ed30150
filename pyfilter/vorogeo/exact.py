"""Exact geodesic distances and paths on numpy arrays, without an index."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _arguments as check
from .metrics import Metric
from .points import Points
from .progress import ProgressFunction
from .results import GeodesicPath
from .surface import Surface


def exact_distance_field(
    vertices: ArrayLike | None,
    faces: ArrayLike,
    sources: ArrayLike,
    max_distance: float | None = None,
    dtype: DTypeLike = np.float64,
    mask: ArrayLike | None = None,
    metric: Metric | None = None,
    gap: float = 0.0,
    bridge_folds: bool = False,
    threads: int | None = None,
) -> NDArray[Any]:
    """Exact distance of every vertex from its nearest source.

    Parameters
    ----------
    vertices : array_like, shape (n, 3)
        Finite positions; any real type and layout. None is possible with the metric `EdgeLengths`.
    faces : array_like of int, shape (m, 3)
        Vertex ids of the triangles, 0 to n - 1.
    sources : int or array_like of int, shape (k,), k >= 1
        Vertex ids; repeated ones make no difference.
    max_distance : float, optional
        Distances above it are not computed and become infinity; None for no limit.
    dtype : {float64, float32}
        Of the result.
    mask : array_like of bool, shape (m,) or (n,), optional
        Which faces or vertices belong to the surface, as for `GeodesicIndex`.
    metric : EdgeLengths, VertexCost, VertexTensor, FaceCost or FaceTensor, optional
        What paths cost; None is their length in space. With values of faces, distances are not exact but close.
    gap, bridge_folds
        Which gaps are bridged, as for `GeodesicIndex`.
    threads : int, optional
        That share the work on a mesh of some ten thousand faces or more; None for one per core. With another number,
        distances may differ in their last digits. With values of faces, one thread does all.

    Returns
    -------
    ndarray, shape (n,)
        Lengths of shortest paths over the surface, in the unit of the vertices or of the metric; infinity where there
        is none.

    Raises
    ------
    InvalidInput
        (a ValueError) If an argument has a wrong shape, type or range, naming the element.

    Notes
    -----
    Exact propagation of windows (Mitchell, Mount, Papadimitriou 1987). Releases the GIL; Ctrl-C stops it.
    """
    surface = Surface(vertices, faces, threads, None, mask, metric, gap, bridge_folds)
    # Also what an error calls them: the caller gave ids.
    ids = check.source_ids(sources, len(surface.vertices))
    return surface.distance_field(ids, max_distance, method="exact", dtype=dtype)


def exact_path(
    vertices: ArrayLike | None,
    faces: ArrayLike,
    source: Points,
    target: Points,
    metric: Metric | None = None,
    mask: ArrayLike | None = None,
    progress: ProgressFunction | bool | None = None,
    gap: float = 0.0,
    bridge_folds: bool = False,
) -> GeodesicPath | list[GeodesicPath]:
    """Exact shortest path between two points, or of each of k pairs, without an index.

    Without values of faces, each is found in a corridor of the mesh; where 100 pairs or more have one source, and with
    values of faces, by one propagation from each source, as far as its targets.

    Parameters
    ----------
    vertices, faces, mask, gap, bridge_folds
        As for `exact_distance_field`.
    source, target : a point, or k points
        Vertex ids, `SurfacePoints` or lists of both; one point goes with each of k.
    metric : EdgeLengths, VertexCost, VertexTensor, FaceCost or FaceTensor, optional
        What paths cost; None is their length in space. With values of faces, the edges that a path crosses are found by
        points on edges, and its crossings are then moved to where it is shortest.
    progress : callable or bool, optional
        As for `GeodesicIndex`.

    Returns
    -------
    GeodesicPath, or list of k GeodesicPath
        `certified` says whether it is exact: with values of faces only of no path, and of one from a point to itself.

    Raises
    ------
    InvalidInput
        (a ValueError) If an argument has a wrong shape, type or range, naming the element.
    """
    surface = Surface(vertices, faces, None, None, mask, metric, gap, bridge_folds)
    return surface.path(source, target, progress, method="exact")
