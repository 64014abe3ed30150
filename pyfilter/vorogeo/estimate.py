"""What an index would cost, before it is built."""

from __future__ import annotations

from dataclasses import dataclass

from numpy.typing import ArrayLike

from . import _arguments as check
from . import _core
from .mesh_input import MeshInput
from .metrics import Metric
from .progress import ProgressFunction, reporter


@dataclass(frozen=True)
class IndexEstimate:
    """What an index of a mesh would cost, and what it would save, on this machine with nothing else to do.

    Attributes
    ----------
    build_seconds : float
        Of the build, on the threads asked for.
    core_seconds : float
        The same as work of one core.
    bytes : int
        Memory that the index would hold.
    form : str
        'tables' or 'graph', as for `IndexStatistics`.
    field_seconds : float
        Of a field from the index.
    exact_field_seconds : float
        Of an exact field, without an index.
    """

    build_seconds: float
    core_seconds: float
    bytes: int
    form: str
    field_seconds: float
    exact_field_seconds: float


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

    Parameters
    ----------
    vertices : array_like, shape (n, 3)
        Finite positions.
    faces : array_like of int, shape (m, 3)
        Vertex ids of the triangles.
    threads, memory_budget, mask, metric, progress
        As for `GeodesicIndex`.

    Returns
    -------
    IndexEstimate
        Within a factor of about two.

    Raises
    ------
    InvalidInput
        (a ValueError) If an argument has a wrong shape, type or range, or the mesh has no face.
    Cancelled
        If `progress` returned False.
    """
    given = MeshInput.read(vertices, faces, mask, metric)
    workers, budget = check.threads(threads), check.memory_budget(memory_budget)
    with reporter(progress) as report:
        return IndexEstimate(**_core.estimate(*given.core_mesh, workers, budget, report))
