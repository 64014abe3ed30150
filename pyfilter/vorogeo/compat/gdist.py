"""The functions of the package gdist, with its arguments, on all cores: ``from vorogeo.compat import gdist``.

Distances are exact, as there. Where gdist returns 1e100 or infinity for what lies beyond `max_distance`, depending on
the place, this is always infinity; what it leaves unchecked, such as ids out of range, is an error here.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import _arguments as check
from ..errors import InvalidInput
from ..surface import Surface, exact_distance_field


def compute_gdist(
    vertices: ArrayLike,
    triangles: ArrayLike,
    source_indices: ArrayLike | None = None,
    target_indices: ArrayLike | None = None,
    max_distance: float = 1e100,
    is_one_indexed: bool = False,
) -> NDArray[np.float64]:
    """Geodesic distance of the targets from the nearest source.

    Parameters
    ----------
    vertices : array_like, shape (n, 3)
    triangles : array_like of int, shape (m, 3)
        Vertex ids of the faces.
    source_indices : array_like of int, optional
        Vertex ids; None is vertex 0.
    target_indices : array_like of int, optional
        Vertex ids; None is all vertices.
    max_distance : float, default 1e100
        Without targets, what is farther away is infinite; with targets it has no effect, as in gdist.
    is_one_indexed : bool, default False
        Whether the ids in `triangles` (not those of sources and targets) begin with 1.

    Returns
    -------
    ndarray of float64
        A distance for each target; infinity where no path leads.
    """
    sources = [0] if source_indices is None else source_indices
    faces = _faces(triangles, is_one_indexed)
    limit = _limit(max_distance)
    if target_indices is None:
        return exact_distance_field(vertices, faces, sources, limit)
    field = exact_distance_field(vertices, faces, sources)
    found: NDArray[np.float64] = field[check.vertex_ids("target_indices", target_indices, len(field))]
    return found


def local_gdist_matrix(
    vertices: ArrayLike, triangles: ArrayLike, max_distance: float = 1e100, is_one_indexed: bool = False
) -> Any:
    """Geodesic distances of all pairs of vertices at most a distance apart.

    Parameters
    ----------
    vertices, triangles, is_one_indexed
        As for `compute_gdist`.
    max_distance : float, default 1e100
        Pairs that are farther apart are left out.

    Returns
    -------
    scipy.sparse.csc_matrix of float64, shape (n, n)
        Without entries for distances of 0 and where no path leads.

    Raises
    ------
    NotEnoughMemory
        (a MemoryError) If the pairs do not fit.
    """
    surface = Surface(vertices, _faces(triangles, is_one_indexed))
    return _pairs(surface, np.arange(len(surface.vertices)), max_distance)


def distance_matrix_of_selected_points(
    vertices: ArrayLike,
    triangles: ArrayLike,
    points: ArrayLike,
    max_distance: float = 1e100,
    is_one_indexed: bool = False,
) -> Any:
    """Geodesic distances of all pairs of chosen vertices at most a distance apart.

    Parameters
    ----------
    points : array_like of int
        Vertex ids.
    vertices, triangles, max_distance, is_one_indexed
        As for `local_gdist_matrix`.

    Returns
    -------
    scipy.sparse.csc_matrix of float64, shape (n, n)
        With entries in the rows and columns of the chosen vertices only.
    """
    surface = Surface(vertices, _faces(triangles, is_one_indexed))
    return _pairs(surface, np.unique(check.vertex_ids("points", points, len(surface.vertices))), max_distance)


def _pairs(surface: Surface, ids: NDArray[Any], max_distance: float) -> Any:
    try:
        from scipy.sparse import csc_matrix
    except ImportError:
        raise ImportError("The result is a matrix of scipy, which is not installed; run 'pip install scipy'.") from None
    found = surface.pairs_within(ids, _limit(max_distance), as_arrays=True, method="exact")
    real = np.isfinite(found.data) & (found.data > 0)
    rows = np.repeat(ids, np.diff(found.indptr))[real]
    count = len(surface.vertices)
    return csc_matrix((found.data[real], (rows, ids[found.indices[real]])), shape=(count, count))


def _faces(triangles: ArrayLike, is_one_indexed: bool) -> ArrayLike:
    """Vertex ids that begin with 0; gdist also takes whole numbers that are stored as reals."""
    wanted = "the vertex ids of the triangles as integers of shape (m, 3)"
    given = check.integers("triangles", check.numbers("triangles", triangles, wanted), wanted)
    if not is_one_indexed:
        return given
    if (given < 1).any():
        raise InvalidInput(f"triangles: names vertex {given.min()}, but ids begin with 1, as is_one_indexed says.")
    return given.astype(np.int64) - 1


def _limit(max_distance: float) -> float:
    """A limit; 1e100, which stands for none in gdist, is infinity."""
    reach = check.max_distance(max_distance)
    return math.inf if reach >= 1e100 else reach
