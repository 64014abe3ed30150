"""Geodesic methods of the literature on numpy arrays, to compare with and to choose from."""

from __future__ import annotations

import time
import warnings
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as check
from . import _core, metrics
from .errors import InvalidInput
from .metrics import Metric
from .progress import ProgressFunction, reporter


class MethodWarning(UserWarning):
    """A method that will be slow, or inaccurate, on this mesh."""


class MethodOption(NamedTuple):
    """A number that a method takes.

    Attributes
    ----------
    standard : float
        The default.
    least, greatest : float
        The range.
    whole : bool
        Only whole numbers.
    meaning : str
        One line.
    """

    standard: float
    least: float
    greatest: float
    whole: bool
    meaning: str


class MethodClaims(NamedTuple):
    """What the literature claims of a method, in short phrases.

    Attributes
    ----------
    sources : str
        "MSAD": many sources in one field; "SSSD": two points without a field.
    reuse : str
        What is prepared once and serves all sources.
    bound : str
        Of the error.
    metrics : str
        Other than the lengths of the mesh.
    growth : str
        Of the time, with the number n of vertices.
    """

    sources: str
    reuse: str
    bound: str
    metrics: str
    growth: str


@dataclass(frozen=True)
class MethodInfo:
    """What is known of a method before it runs.

    Attributes
    ----------
    name, title, paper : str
        The name by which it is chosen, a title for people, and where it was published.
    options : dict of str to MethodOption
        Keywords that it takes.
    claims : MethodClaims
        What the literature says of it.
    exact : bool
        Whether its distances are exact up to rounding.
    has_pairs : bool
        Whether two points cost it less than a field.
    """

    name: str
    title: str
    paper: str
    options: Mapping[str, MethodOption]
    claims: MethodClaims
    exact: bool
    has_pairs: bool


def _described() -> dict[str, MethodInfo]:
    return {
        row["name"]: MethodInfo(
            row["name"],
            row["title"],
            row["paper"],
            {name: MethodOption(*rest) for name, *rest in row["options"]},
            MethodClaims(*row["claims"]),
            row["exact"],
            row["has_pairs"],
        )
        for row in _core.describe_methods()
    }


class Methods(Mapping[str, MethodInfo]):
    """All methods by their names, in the order in which they are offered; read-only."""

    def __init__(self, rows: dict[str, MethodInfo]) -> None:
        self._rows = rows

    def __getitem__(self, name: str) -> MethodInfo:
        return self._rows[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._rows)

    def __len__(self) -> int:
        return len(self._rows)

    def __repr__(self) -> str:
        return f"Methods({list(self._rows)})"


methods = Methods(_described())

#: What a method is for, instead of its name in the literature.
_BY_PURPOSE = {"exact": "mmp", "quick": "gsp", "index": "vorogeo"}


class GeodesicMethod:
    """A method that has been prepared for a mesh, for fields from many sources.

    Parameters
    ----------
    vertices : array_like, shape (n, 3)
        Finite positions; any real type and layout.
    faces : array_like of int, shape (m, 3)
        Vertex ids of the triangles, 0 to n - 1.
    method : str
        One of `methods`, or "exact", "quick" or "index", as for `distance_field`.
    metric : EdgeLengths, VertexCost or VertexTensor, optional
        What paths cost; None is their length in space.
    progress : callable, bool or None
        Told (fraction, text) during preparation; a result of False cancels. True: a tqdm bar.
    **options : float
        Options of the method (``methods[method].options``).

    Attributes
    ----------
    info : MethodInfo
        What is known of the method.
    seconds : float
        Wall time of the preparation.

    Raises
    ------
    InvalidInput
        (a ValueError) If an argument cannot be used; the message names it and what to give.

    Notes
    -----
    One call at a time: an object belongs to one thread.
    """

    def __init__(
        self,
        vertices: ArrayLike | None,
        faces: ArrayLike,
        method: str = "vorogeo",
        *,
        metric: Metric | None = None,
        progress: ProgressFunction | bool | None = None,
        **options: float,
    ) -> None:
        method = _BY_PURPOSE.get(method, method) if isinstance(method, str) else method
        if not isinstance(method, str) or method not in methods:
            raise InvalidInput(f"method: {method!r} is not known; give one of {', '.join(map(repr, methods))}.")
        self.info = methods[method]
        points = metrics.positions(vertices, faces, metric)
        triangles = check.faces(faces, len(points))
        sides = metrics.sides(metric, points, triangles)
        self._vertex_count = len(points)
        wanted = "a number (methods[method].options says which)"
        values = {name: check.real(name, value, wanted) for name, value in options.items()}
        warning = _core.method_warning(method, points, triangles, sides)
        if warning:
            warnings.warn(warning, MethodWarning, stacklevel=2)
        start = time.perf_counter()
        with reporter(progress) as report:
            self._method = _core.Method.prepare(method, points, triangles, sides, values, report)
        self.seconds = time.perf_counter() - start

    def distance_field(self, sources: ArrayLike) -> NDArray[np.float64]:
        """Distance of every vertex from its nearest source.

        Parameters
        ----------
        sources : int or array_like of int, shape (k,), k >= 1
            Vertex ids.

        Returns
        -------
        ndarray of float64, shape (n,)
            In the unit of the vertices; infinity where no path leads.
        """
        return self._method.field(check.source_ids(sources, self._vertex_count))

    def distance(self, source: int, target: int) -> float:
        """Distance of two vertices; without a faster method (``info.has_pairs``) taken from a field."""
        ends = [
            check.integer(name, value, 0, self._vertex_count - 1)
            for name, value in (("source", source), ("target", target))
        ]
        return self._method.pair(*ends)

    @property
    def bytes(self) -> int:
        """Memory held beside the mesh, with the scratch memory of the last field."""
        return self._method.bytes()


def distance_field(
    vertices: ArrayLike | None,
    faces: ArrayLike,
    sources: ArrayLike,
    method: str = "mmp",
    *,
    metric: Metric | None = None,
    **options: float,
) -> NDArray[np.float64]:
    """Distance of every vertex from its nearest source, by a method of choice.

    Parameters
    ----------
    vertices, faces, sources
        As for `exact_distance_field`.
    method : str
        One of `methods`, or "exact", "quick" or "index" for what this project takes for that: "mmp", "gsp", "vorogeo".
    metric : EdgeLengths, VertexCost or VertexTensor, optional
        What paths cost; None is their length in space.
    **options : float
        Options of the method, such as ``eps=1e-3`` for "ammp".

    Returns
    -------
    ndarray of float64, shape (n,)
        In the unit of the vertices; infinity where no path leads.

    Raises
    ------
    InvalidInput
        (a ValueError) If an argument cannot be used; the message names it and what to give.

    Notes
    -----
    Prepares the method each time; `GeodesicMethod` keeps what it has prepared.
    """
    return GeodesicMethod(vertices, faces, method, metric=metric, progress=None, **options).distance_field(sources)
