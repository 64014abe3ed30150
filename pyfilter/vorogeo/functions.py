"""Single answers on a mesh that is not kept: exact distances and paths, and what an index would cost."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _arguments as check
from .mesh_input import MeshInput
from .metrics import Metric
from .points import Points
from .progress import ProgressFunction, reporter
from .results import GeodesicPath, IndexEstimate
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
    """Exact distance of every vertex from its nearest source: a `Surface` asked once, by the method "exact".

    Parameters
    ----------
    vertices, faces, mask, metric, gap, bridge_folds, threads, dtype
        As for `Surface`: shapes (n, 3) and (m, 3). With values of faces, distances are not exact but close, and one
        thread does all.
    sources : int or array_like of int, shape (k,), k >= 1
        Vertex ids; repeated ones make no difference.
    max_distance : float, optional
        Distances above it are not computed and become infinity; None for no limit.

    Returns
    -------
    ndarray, shape (n,)
        Lengths of shortest paths over the surface, in the unit of the vertices or of the metric; infinity where there
        is none.

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
    """Exact shortest path between two points, or of each of k pairs: a `Surface` asked once.

    Parameters
    ----------
    vertices, faces, mask, metric, gap, bridge_folds
        As for `Surface`: shapes (n, 3) and (m, 3). With values of faces, the edges that a path crosses are found by
        points on edges, and its crossings are then moved to where it is shortest.
    source, target, progress
        As for `Surface.path`.

    Returns
    -------
    GeodesicPath, or list of k GeodesicPath
        `certified` says whether it is exact: with values of faces only of no path, and of one from a point to itself.

    Notes
    -----
    Without values of faces, each is found in a corridor of the mesh; where 100 pairs or more have one source, and with
    values of faces, by one propagation from each source, as far as its targets.
    """
    surface = Surface(vertices, faces, None, None, mask, metric, gap, bridge_folds)
    return surface.path(source, target, progress, method="exact")


def estimate(
    vertices: ArrayLike | None,
    faces: ArrayLike,
    threads: int | None = None,
    memory_budget: int | None = None,
    mask: ArrayLike | None = None,
    metric: Metric | None = None,
    progress: ProgressFunction | bool | None = None,
) -> IndexEstimate:
    """What an index would cost, from some of the work that its build does; takes a few percent of it.

    The result is right within a factor of about two. A mesh without a face is refused.

    Parameters
    ----------
    vertices, faces, threads, memory_budget, mask, metric, progress
        As for `Surface` and its questions: shapes (n, 3) and (m, 3).
    """
    given = MeshInput.read(vertices, faces, mask, metric)
    workers, budget = check.threads(threads), check.memory_budget(memory_budget)
    with reporter(progress) as report:
        return IndexEstimate(**given.core_mesh().estimate(workers, budget, report))
