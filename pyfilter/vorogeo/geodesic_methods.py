"""Geodesic methods of the literature on numpy arrays, to compare with and to choose from."""

from __future__ import annotations

import time
import warnings
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Annotated, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as check
from . import _core
from ._records import doc, documented
from .errors import InvalidInput
from .mesh_input import MeshInput
from .metrics import Metric
from .progress import ProgressFunction, reporter


class MethodWarning(UserWarning):
    """A method that will be slow, or inaccurate, on this mesh."""


@documented
class MethodOption(NamedTuple):
    """A number that a method takes."""

    standard: Annotated[float, "The default."]
    least: Annotated[float, "The least that it may be."]
    greatest: Annotated[float, "And the greatest."]
    whole: Annotated[bool, "Only whole numbers."]
    meaning: Annotated[str, "One line."]


@documented
class MethodClaims(NamedTuple):
    """What the literature claims of a method, in short phrases."""

    sources: Annotated[str, '"MSAD": many sources in one field; "SSSD": two points without a field.']
    reuse: Annotated[str, "What is prepared once and serves all sources."]
    bound: Annotated[str, "Of the error."]
    metrics: Annotated[str, "Other than the lengths of the mesh."]
    growth: Annotated[str, "Of the time, with the number n of vertices."]


@documented
@dataclass(frozen=True)
class MethodInfo:
    """What is known of a method before it runs."""

    name: str = doc("By which it is chosen.")
    title: str = doc("For people.")
    paper: str = doc("Where it was published.")
    options: Mapping[str, MethodOption] = doc("Keywords that it takes.")
    claims: MethodClaims = doc("What the literature says of it.")
    exact: bool = doc("Whether its distances are exact up to rounding.")
    has_pairs: bool = doc("Whether two points cost it less than a field.")


def _described() -> Iterator[MethodInfo]:
    for name, title, paper, options, claims, exact, has_pairs in _core.describe_methods():
        own = {key: MethodOption(*option) for key, option in options.items()}
        yield MethodInfo(name, title, paper, own, MethodClaims(*claims), exact, has_pairs)


#: All methods by their names, in the order in which they are offered; read-only.
methods: Mapping[str, MethodInfo] = MappingProxyType({info.name: info for info in _described()})


class GeodesicMethod:
    """A method that has been prepared for a mesh, for fields from many sources.

    Parameters
    ----------
    vertices, faces
        As for `Surface`: shapes (n, 3) and (m, 3).
    method : str
        One of `methods`.
    metric : EdgeLengths, VertexCost or VertexTensor, optional
        What paths cost; None is their length in space.
    progress : callable or bool, optional
        Progress of the preparation, as for `Surface`.
    **options : float
        Options of the method (``methods[method].options``), such as ``eps=1e-3`` for "ammp".

    Attributes
    ----------
    info : MethodInfo
        What is known of the method.
    seconds : float
        Wall time of the preparation.

    Notes
    -----
    One call at a time: an object belongs to one thread.
    """

    def __init__(
        self,
        vertices: Any,
        faces: Any = None,
        method: str = "vorogeo",
        *,
        metric: Metric | None = None,
        progress: ProgressFunction | bool | None = None,
        **options: float,
    ) -> None:
        if not isinstance(method, str) or method not in methods:
            raise InvalidInput(f"method: {method!r} is not known; give one of {', '.join(map(repr, methods))}.")
        self.info = methods[method]
        given = MeshInput.read(vertices, faces, metric=metric)
        self._vertex_count = len(given.vertices)
        wanted = "a number (methods[method].options says which)"
        values = {name: check.real(name, value, wanted) for name, value in options.items()}
        mesh = given.core_mesh()
        warning = mesh.method_warning(method)
        if warning:
            warnings.warn(warning, MethodWarning, stacklevel=2)
        start = time.perf_counter()
        with reporter(progress) as report:
            self._method = mesh.prepare_method(method, values, report)
        self.seconds = time.perf_counter() - start

    def distance_field(self, sources: ArrayLike) -> NDArray[np.float64]:
        """Distance of every vertex from its nearest source; the sources are one or more vertex ids.

        float64 of shape (n,), in the unit of the vertices; infinity where no path leads.
        """
        return self._method.field(check.source_ids(sources, self._vertex_count))

    def distance(self, source: int, target: int) -> float:
        """Distance of two vertices, read from a field unless the method has a faster way (``info.has_pairs``)."""
        ends = [
            check.integer(name, value, 0, self._vertex_count - 1)
            for name, value in (("source", source), ("target", target))
        ]
        return self._method.pair(*ends)

    @property
    def bytes(self) -> int:
        """Memory held beside the mesh, including the scratch memory of the last field."""
        return self._method.bytes()


def distance_field(
    vertices: Any,
    faces: Any,
    sources: ArrayLike,
    method: str,
    *,
    metric: Metric | None = None,
    **options: float,
) -> NDArray[np.float64]:
    """Distance of every vertex from its nearest source, by a method of the literature, to compare with.

    As `GeodesicMethod.distance_field`, with the arguments of that class. This function prepares the method at each
    call, while an object of that class keeps what it has prepared.
    """
    return GeodesicMethod(vertices, faces, method, metric=metric, progress=None, **options).distance_field(sources)
