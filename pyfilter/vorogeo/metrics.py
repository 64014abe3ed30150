"""Metrics: what a path costs where it runs over a surface, instead of its length in space."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple, Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as check
from . import _core
from .errors import InvalidInput


class FaceSplits(NamedTuple):
    """Faces in parts, where a metric varies too much for one triangle.

    Attributes
    ----------
    middle_of : ndarray of int32, shape (k, 2)
        Of each vertex that is added behind the n given ones: the ends of the line whose middle it is.
    faces : ndarray of int32, shape (p, 3)
        All faces, the parts of a face in its place.
    given_face : ndarray of int32, shape (p,)
        Which face each is, or is a part of.
    lengths : ndarray of float64, shape (p, 3)
        Of the side opposite each corner.
    """

    middle_of: NDArray[np.int32]
    faces: NDArray[np.int32]
    given_face: NDArray[np.int32]
    lengths: NDArray[np.float64]


class MetricLengths(NamedTuple):
    """The lengths that a metric gives to the sides of faces.

    Attributes
    ----------
    lengths : ndarray of float64, shape (m, 3)
        Of the side opposite each corner; 0 in a face that names a vertex twice. In a face that is split, the longest
        side has the length of the other two together.
    shortened_edges : int
        Edges that would still be longer than the other two sides of a face together, after faces were split. No
        shortest path follows them, and they have the length of these two sides.
    split_faces : int
        Faces with a side that would be longer than the other two together. They are split in the middle of it, with the
        other face there, and so on for their parts.
    splits : FaceSplits or None
        What is measured on where faces are split, by its own `lengths`: the `lengths` of whole faces do not count then.
        Results refer to the vertices and faces that were given.
    points : int
        Points on each edge from which faces are crossed, where the two faces of an edge disagree; 0 in other metrics.
    """

    lengths: NDArray[np.float64]
    shortened_edges: int
    split_faces: int = 0
    splits: FaceSplits | None = None
    points: int = 0


@runtime_checkable
class Metric(Protocol):
    """What paths cost: EdgeLengths, VertexCost, VertexTensor, FaceCost or FaceTensor."""

    def edge_lengths(self, vertices: ArrayLike | None, faces: ArrayLike) -> MetricLengths:
        """The lengths of the sides of all faces."""


@dataclass(frozen=True, eq=False)
class EdgeLengths:
    """Edge lengths that were measured or computed elsewhere; solved exactly.

    Parameters
    ----------
    lengths : array_like, shape (m, 3)
        Length of the side opposite each corner of each face: column 0 is the side from corner 1 to corner 2. Both faces
        of an edge must agree, and no side may be longer than the other two together.

    Notes
    -----
    With it, ``vertices`` may be None: positions are only needed for points in space (`GeodesicIndex.snap`, lines).
    Points of paths are then NaN, but have their faces and weights.

    Examples
    --------
    >>> sides = np.linalg.norm(vertices[faces[:, [2, 0, 1]]] - vertices[faces[:, [1, 2, 0]]], axis=2)
    >>> vorogeo.GeodesicIndex(None, faces, metric=vorogeo.EdgeLengths(sides))
    """

    lengths: ArrayLike

    def __post_init__(self) -> None:
        wanted = "the length of the side opposite each corner, real numbers of shape (m, 3)"
        object.__setattr__(self, "lengths", own_array("EdgeLengths", self.lengths, 2, (3,), wanted))

    def edge_lengths(self, vertices: ArrayLike | None, faces: ArrayLike) -> MetricLengths:
        """The lengths that were given."""
        count, given = len(np.asarray(faces)), np.asarray(self.lengths)
        if len(given) != count:
            raise InvalidInput(f"EdgeLengths: has {len(given)} rows, but there are {count} faces; give one for each.")
        return MetricLengths(given, 0)


@dataclass(frozen=True, eq=False)
class VertexCost:
    """A cost for each vertex, linear over each face: the length of a path is the integral of the cost along it.

    Parameters
    ----------
    cost : array_like, shape (n,)
        Above 0: COST per unit of length, not speed. Where it is 2, paths count twice; on a map of speeds, give
        ``1 / speed``.

    Examples
    --------
    >>> vorogeo.exact_distance_field(vertices, faces, 0, metric=vorogeo.VertexCost(1 / speed))
    """

    cost: ArrayLike

    def __post_init__(self) -> None:
        wanted = "a number above 0 for each vertex, of shape (n,)"
        object.__setattr__(self, "cost", own_array("VertexCost", self.cost, 1, (), wanted))

    def edge_lengths(self, vertices: ArrayLike | None, faces: ArrayLike) -> MetricLengths:
        """The integrals of the cost along the edges.

        Raises
        ------
        InvalidInput
            (a ValueError) If a cost is not above 0 and finite, or their number is not that of the vertices.
        """
        points, triangles = arrays(self, vertices, faces)
        return _lengths(*_core.lengths_by_cost(points, triangles, np.asarray(self.cost)))


@dataclass(frozen=True, eq=False)
class VertexTensor:
    """A tensor G for each vertex, linear over each face: the squared length of a step v is v' G v.

    Parameters
    ----------
    tensors : array_like, shape (n, 3, 3)
        Symmetric, and positive on the planes of the faces: SQUARED LENGTH, not its inverse. The identity is the length
        in space; with ``I + 3 d d'`` steps along the unit vector d count twice. For speeds c along d and 1 across it,
        give ``I + (1 / c**2 - 1) d d'``, the inverse of the tensor of squared speeds.

    Examples
    --------
    >>> along = direction[:, :, None] * direction[:, None, :]  # unit vectors
    >>> vorogeo.GeodesicIndex(vertices, faces, metric=vorogeo.VertexTensor(np.eye(3) + 3 * along))
    """

    tensors: ArrayLike

    def __post_init__(self) -> None:
        wanted = "a symmetric 3 x 3 matrix for each vertex, of shape (n, 3, 3)"
        object.__setattr__(self, "tensors", own_array("VertexTensor", self.tensors, 3, (3, 3), wanted))

    def edge_lengths(self, vertices: ArrayLike | None, faces: ArrayLike) -> MetricLengths:
        """The integrals of the root of v' G v along the edges.

        Raises
        ------
        InvalidInput
            (a ValueError) If a tensor is not finite, symmetric and positive on the faces of its vertex.
        """
        points, triangles = arrays(self, vertices, faces)
        return _lengths(*_core.lengths_by_tensor(points, triangles, np.asarray(self.tensors).ravel()))


def slope_cost(
    vertices: ArrayLike, faces: ArrayLike, up: ArrayLike = (0.0, 0.0, 1.0), penalty: float = 1.0
) -> VertexCost:
    """A cost for terrain that grows with the slope: 1 on level ground, 1 + penalty on a wall.

    Parameters
    ----------
    vertices : array_like, shape (n, 3)
        Positions.
    faces : array_like of int, shape (m, 3)
        Triangles.
    up : array_like, shape (3,)
        The direction upwards, of any length.
    penalty : float, default 1
        At least 0; the cost is 1 + penalty sin(slope), with the slope between the normal and `up`.

    Returns
    -------
    VertexCost
        The same uphill, downhill and along the slope: metrics are symmetric.
    """
    points, triangles = _mesh(vertices, faces)
    towards = check.positions("up", up)
    if towards.shape != (1, 3):
        raise InvalidInput(f"up: has shape {np.shape(up)}; give one vector of three numbers.")
    x, y, z = towards[0].tolist()
    height = check.real("penalty", penalty, "a number of at least 0")
    return VertexCost(_core.slope_cost(points, triangles, x, y, z, height))


def curvature_tensor(vertices: ArrayLike, faces: ArrayLike, weight: float = 3.0) -> VertexTensor:
    """A tensor that makes one of the principal directions of a surface costlier.

    Parameters
    ----------
    vertices : array_like, shape (n, 3)
        Positions.
    faces : array_like of int, shape (m, 3)
        Triangles.
    weight : float, default 3
        Above 0, paths follow ridges, valleys and limbs: where the surface is curved in one direction only, a step in
        that direction counts ``sqrt(1 + weight)``. Below 0 it is the other direction that becomes costlier.

    Returns
    -------
    VertexTensor
        I + abs(weight) a d d', with a = (|k1| - |k2|) / (|k1| + |k2|) of the principal curvatures: lengths in space on
        planes and spheres.

    Notes
    -----
    Curvatures from the bends of edges (Cohen-Steiner, Morvan 2003), over a vertex and its neighbours.
    """
    points, triangles = _mesh(vertices, faces)
    found = _core.curvature_tensors(points, triangles, check.real("weight", weight, "a number"))
    return VertexTensor(found.reshape(-1, 3, 3))


def positions(vertices: ArrayLike | None, faces: ArrayLike, metric: Any) -> NDArray[np.float64]:
    """Checked positions; all NaN where none are given, which only edge lengths allow."""
    if vertices is not None:
        return check.vertices(vertices)
    if not isinstance(metric, EdgeLengths):
        raise InvalidInput("vertices: is None; give positions of shape (n, 3), or the metric EdgeLengths.")
    ids = check.unchecked_faces(faces)
    beyond = np.flatnonzero((ids == np.iinfo(np.int32).max).any(axis=1))
    if beyond.size:
        raise InvalidInput(f"faces[{beyond[0]}]: names a vertex beyond {np.iinfo(np.int32).max - 1}; give smaller ids.")
    return np.full((ids.max(initial=-1) + 1, 3), np.nan)


def lengths(metric: Any, vertices: NDArray[np.float64], faces: NDArray[np.int32]) -> MetricLengths | None:
    """What a metric makes of a mesh; None for lengths in space."""
    if metric is None:
        return None
    # A class has the method of its objects.
    if isinstance(metric, type) or not isinstance(metric, Metric):
        raise InvalidInput(
            f"metric: is a {type(metric).__name__}; give EdgeLengths, VertexCost, VertexTensor, FaceCost, FaceTensor, "
            "or None for lengths in space."
        )
    return metric.edge_lengths(vertices, faces)


CoreSides = tuple[NDArray[np.float64], int, FaceSplits | None]


def sides(metric: Any, vertices: NDArray[np.float64], faces: NDArray[np.int32]) -> CoreSides | None:
    """What the compiled core takes of a metric."""
    return core_sides(lengths(metric, vertices, faces))


def core_sides(found: MetricLengths | None) -> CoreSides | None:
    """These lengths, the number of points on each edge, and splits of faces."""
    return None if found is None else (found.lengths, found.points, found.splits)


def _lengths(sides: NDArray[np.float64], shortened: int, split: int, splits: Any) -> MetricLengths:
    """What the compiled core returns, in shape."""
    if splits is None:
        return MetricLengths(sides.reshape(-1, 3), shortened)
    ends, faces, given, lengths = splits
    shaped = FaceSplits(ends.reshape(-1, 2), faces.reshape(-1, 3), given, lengths.reshape(-1, 3))
    return MetricLengths(sides.reshape(-1, 3), shortened, split, shaped)


def own_array(name: str, value: Any, ndim: int, tail: tuple[int, ...], wanted: str) -> NDArray[np.float64]:
    """A read-only copy of an array of real numbers."""
    array = np.array(check.numbers(name, value, wanted), dtype=np.float64, order="C")
    if array.ndim != ndim or array.shape[1:] != tail:
        raise InvalidInput(f"{name}: has shape {array.shape}; give {wanted}.")
    array.flags.writeable = False
    return array


def _mesh(vertices: ArrayLike, faces: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
    points = check.vertices(vertices)
    return points, check.faces(faces, len(points))


def arrays(metric: Any, vertices: Any, faces: Any) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
    """Positions, which this metric needs, and faces, both checked."""
    if vertices is None:
        raise InvalidInput(f"vertices: is None; {type(metric).__name__} needs positions of shape (n, 3).")
    return _mesh(vertices, faces)
