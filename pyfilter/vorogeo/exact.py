"""Exact geodesic distances on numpy arrays, without an index."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _arguments as check
from . import _core, metrics
from .masks import face_mask, without_masked
from .metrics import Metric


def exact_distance_field(
    vertices: ArrayLike | None,
    faces: ArrayLike,
    sources: ArrayLike,
    max_distance: float | None = None,
    dtype: DTypeLike = np.float64,
    mask: ArrayLike | None = None,
    metric: Metric | None = None,
) -> NDArray[Any]:
    """Exact distance of every vertex from its nearest source, on one thread.

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
    metric : EdgeLengths, VertexCost or VertexTensor, optional
        What paths cost; None is their length in space.

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
    points = metrics.positions(vertices, faces, metric)
    triangles = check.faces(faces, len(points))
    surface = without_masked(triangles, face_mask(mask, triangles, len(points)))
    ids = check.source_ids(sources, len(points))
    entry, limit = check.real_type(dtype), check.max_distance(max_distance)
    sides = metrics.sides(metric, points, surface)
    return _core.exact_distance_field(points, surface, sides, ids, limit).astype(entry, copy=False)
