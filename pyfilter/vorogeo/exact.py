"""Exact geodesic distances on numpy arrays, without an index."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as check
from . import _core


def exact_distance_field(
    vertices: ArrayLike, faces: ArrayLike, sources: ArrayLike, max_distance: float | None = None
) -> NDArray[np.float64]:
    """Exact distance of every vertex from its nearest source, on one thread.

    Parameters
    ----------
    vertices : array_like, shape (n, 3)
        Finite positions; any real type and layout.
    faces : array_like of int, shape (m, 3)
        Vertex ids of the triangles, 0 to n - 1.
    sources : int or array_like of int, shape (k,), k >= 1
        Vertex ids; repeated ones make no difference.
    max_distance : float, optional
        Distances above it are not computed and become infinity; None for no limit.

    Returns
    -------
    ndarray of float64, shape (n,)
        Lengths of shortest paths over the surface, in the unit of the vertices; infinity where there is none.

    Raises
    ------
    InvalidInput
        (a ValueError) If an argument has a wrong shape, type or range, naming the element.

    Notes
    -----
    Exact propagation of windows (Mitchell, Mount, Papadimitriou 1987). Releases the GIL; Ctrl-C stops it.
    """
    points = check.vertices(vertices)
    triangles = check.faces(faces, len(points))
    ids = check.source_ids(sources, len(points))
    return _core.exact_distance_field(points, triangles, ids, check.max_distance(max_distance))
