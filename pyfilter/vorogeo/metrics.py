"""Metrics: what a path costs where it runs over a surface, instead of its length in space; linear or by faces."""

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
    With it, ``vertices`` may be None: positions are only needed for points in space (`Surface.snap`, lines).
    Points of paths are then NaN, but have their faces and weights.

    Examples
    --------
    >>> sides = np.linalg.norm(vertices[faces[:, [2, 0, 1]]] - vertices[faces[:, [1, 2, 0]]], axis=2)
    >>> vorogeo.Surface(None, faces, metric=vorogeo.EdgeLengths(sides))
    """

    lengths: ArrayLike

    def __post_init__(self) -> None:
        _own(self, "lengths", (3,), "the length of the side opposite each corner, real numbers of shape (m, 3)")

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
        _own(self, "cost", (), "a number above 0 for each vertex, of shape (n,)")

    def edge_lengths(self, vertices: ArrayLike | None, faces: ArrayLike) -> MetricLengths:
        """The integrals of the cost along the edges; there is one above 0 and finite for each vertex."""
        return _lengths(*_core.lengths_by_cost(*_arrays(self, vertices, faces), np.asarray(self.cost)))


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
    >>> vorogeo.Surface(vertices, faces, metric=vorogeo.VertexTensor(np.eye(3) + 3 * along))
    """

    tensors: ArrayLike

    def __post_init__(self) -> None:
        _own(self, "tensors", (3, 3), "a symmetric 3 x 3 matrix for each vertex, of shape (n, 3, 3)")

    def edge_lengths(self, vertices: ArrayLike | None, faces: ArrayLike) -> MetricLengths:
        """The integrals of the root of v' G v along the edges; G is finite, symmetric and positive on its faces."""
        return _lengths(*_core.lengths_by_tensor(*_arrays(self, vertices, faces), np.asarray(self.tensors)))


@dataclass(frozen=True, eq=False)
class FaceCost:
    """A cost for each face: the weighted region problem. Paths refract at edges, and run along cheap ones.

    Parameters
    ----------
    cost : array_like, shape (m,)
        Above 0: COST per unit of length, not speed. Along an edge the cheaper of its faces counts.
    points : int, default 6
        Points on the median edge, 1 to 1000, from which faces are crossed; long edges have more. Errors fall with its
        square or faster, time grows with it.

    Notes
    -----
    Distances err by some thousandths of a percent even without an index; paths are refined until Snell's law holds.
    Where all faces agree on the lengths of their edges, as with one cost, distances are exact.

    Examples
    --------
    >>> vorogeo.exact_distance_field(vertices, faces, 0, metric=vorogeo.FaceCost(np.where(is_water, 5.0, 1.0)))
    """

    cost: ArrayLike
    points: int = 6

    def __post_init__(self) -> None:
        _own(self, "cost", (), "a number above 0 for each face, of shape (m,)")
        object.__setattr__(self, "points", check.integer("points", self.points, 1, 1000))

    def edge_lengths(self, vertices: ArrayLike | None, faces: ArrayLike) -> MetricLengths:
        """The sides of each face, times its cost, above 0 and finite: the two faces of an edge disagree."""
        sides = _core.sides_by_face_cost(*_arrays(self, vertices, faces), np.asarray(self.cost))
        return MetricLengths(sides, 0, points=self.points)


@dataclass(frozen=True, eq=False)
class FaceTensor:
    """A tensor G for each face: the squared length of a step v in it is v' G v.

    Parameters
    ----------
    tensors : array_like, shape (m, 3, 3)
        Symmetric, and positive on the plane of the face: SQUARED LENGTH, not its inverse.
    points : int, optional
        As for `FaceCost`. By default 6, and more where tensors of neighbouring faces stretch lengths in different
        directions: 2.5 times the stretch that a tenth of all edges exceed, up to 300.

    Examples
    --------
    >>> across = np.eye(3) - fibres[:, :, None] * fibres[:, None, :]  # unit vectors, one for each face
    >>> vorogeo.exact_path(vertices, faces, 0, 17, metric=vorogeo.FaceTensor(np.eye(3) + 8 * across))
    """

    tensors: ArrayLike
    points: int | None = None

    def __post_init__(self) -> None:
        _own(self, "tensors", (3, 3), "a symmetric 3 x 3 matrix for each face, of shape (m, 3, 3)")
        if self.points is not None:
            object.__setattr__(self, "points", check.integer("points", self.points, 1, 1000))

    def edge_lengths(self, vertices: ArrayLike | None, faces: ArrayLike) -> MetricLengths:
        """The roots of v' G v for the sides v of each face: the two faces of an edge disagree.

        G is finite, symmetric and positive on its face. More than 300 `points` are never chosen, but an error.
        """
        mesh = _arrays(self, vertices, faces)
        sides = _core.sides_by_face_tensor(*mesh, np.asarray(self.tensors))
        points = _core.edge_points_for(*mesh, sides) if self.points is None else self.points
        return MetricLengths(sides, 0, points=points)


def slope_cost(
    vertices: ArrayLike, faces: ArrayLike, up: ArrayLike = (0.0, 0.0, 1.0), penalty: float = 1.0
) -> VertexCost:
    """A cost for terrain that grows with the slope: 1 on level ground, 1 + penalty on a wall.

    Parameters
    ----------
    vertices, faces
        As for `Surface`: shapes (n, 3) and (m, 3).
    up : array_like, shape (3,)
        The direction upwards, of any length.
    penalty : float, default 1
        At least 0; the cost is 1 + penalty sin(slope), with the slope between the normal and `up`.

    Returns
    -------
    VertexCost
        The same uphill, downhill and along the slope: metrics are symmetric.
    """
    towards = check.positions("up", up)
    if towards.shape != (1, 3):
        raise InvalidInput(f"up: has shape {np.shape(up)}; give one vector of three numbers.")
    least = check.real("penalty", penalty, "a number of at least 0")
    return VertexCost(_core.slope_cost(*_mesh(vertices, faces), towards[0], least))


def curvature_tensor(vertices: ArrayLike, faces: ArrayLike, weight: float = 3.0) -> VertexTensor:
    """A tensor that makes one of the principal directions of a surface costlier.

    Parameters
    ----------
    vertices, faces
        As for `Surface`: shapes (n, 3) and (m, 3).
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
    found = _core.curvature_tensors(*_mesh(vertices, faces), check.real("weight", weight, "a number"))
    return VertexTensor(found.reshape(-1, 3, 3))


def _lengths(sides: NDArray[np.float64], shortened: int, split: int, splits: Any) -> MetricLengths:
    """What the compiled core returns."""
    return MetricLengths(sides, shortened, split, None if splits is None else FaceSplits(*splits))


def _own(metric: Any, field: str, tail: tuple[int, ...], wanted: str) -> None:
    """Make a field a read-only copy of its real numbers: of one for each element, or of `tail` numbers."""
    name = type(metric).__name__
    array = np.array(check.numbers(name, getattr(metric, field), wanted), dtype=np.float64, order="C")
    if array.ndim != 1 + len(tail) or array.shape[1:] != tail:
        raise InvalidInput(f"{name}: has shape {array.shape}; give {wanted}.")
    array.flags.writeable = False
    object.__setattr__(metric, field, array)


def _mesh(vertices: ArrayLike, faces: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
    points = check.vertices(vertices)
    return points, check.faces(faces, len(points))


def _arrays(metric: Any, vertices: Any, faces: Any) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
    """Positions, which this metric needs, and faces, both checked."""
    if vertices is None:
        raise InvalidInput(f"vertices: is None; {type(metric).__name__} needs positions of shape (n, 3).")
    return _mesh(vertices, faces)
