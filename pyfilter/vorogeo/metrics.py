"""Metrics: what paths over a surface cost, instead of their length in space; linear over faces or constant in each."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple, Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as check
from . import _core
from .errors import InvalidInput

#: What a unit of length costs at each grade: a function, or rows of a grade and its cost.
CostOfGrade = Callable[[NDArray[np.float64]], ArrayLike] | ArrayLike


class FaceSplits(NamedTuple):
    """Faces in parts, where a metric varies too much for one triangle.

    Attributes
    ----------
    middle_of : ndarray of int32, shape (k, 2)
        For each vertex that is added after the n given ones, the ends of the line whose midpoint it is.
    faces : ndarray of int32, shape (p, 3)
        All faces, the parts of a face in its place.
    given_face : ndarray of int32, shape (p,)
        The given face that each face is, or is a part of.
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
        Of the side opposite each corner; 0 in a face that names a vertex twice, infinite in one that no path may enter.
        No side is longer than the other two together.
    shortened_edges : int
        Edges that would still be longer than the other two sides of a face together, after faces were split. No
        shortest path follows them, and they have the length of these two sides.
    split_faces : int
        Faces that are measured in parts, as the metric varies over them or over a neighbour: bisected in the middle of
        the longest side, together with the other face at that side, and their parts likewise.
    splits : FaceSplits or None
        The faces that are measured on where some are split, with `lengths` of their own: those of whole faces do not
        count then. Results refer to the vertices and faces that were given.
    points : int
        Points on each edge from which faces are crossed, where the two faces of an edge disagree; 0 in other metrics.
    drifts : ndarray of float64, shape (m, 3), or None
        What is added to these lengths along each side, from the next corner to the one after it, and subtracted on the
        way back; None where both ways cost the same.
    """

    lengths: NDArray[np.float64]
    shortened_edges: int
    split_faces: int = 0
    splits: FaceSplits | None = None
    points: int = 0
    drifts: NDArray[np.float64] | None = None


@runtime_checkable
class Metric(Protocol):
    """What paths cost: EdgeLengths, VertexCost, VertexTensor, FaceCost, FaceTensor or FaceRanders."""

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
        ``1 / speed``. Infinite: no path enters the faces at the vertex.

    Examples
    --------
    >>> vorogeo.exact_distance_field(vertices, faces, 0, metric=vorogeo.VertexCost(1 / speed))
    """

    cost: ArrayLike

    def __post_init__(self) -> None:
        _own(self, "cost", (), "a number above 0 for each vertex, of shape (n,)")

    def edge_lengths(self, vertices: ArrayLike | None, faces: ArrayLike) -> MetricLengths:
        """The integrals of the cost along the edges. Each vertex of a face needs a cost above 0."""
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
        Above 0: COST per unit of length, not speed. Along an edge the cheaper of its faces counts. Infinite: no path
        enters the face, but paths may run along edges that it shares with other faces.
    points : int, default 6
        Points on an edge between well-shaped faces, 1 to 1000, from which faces are crossed; other edges may have more.
        Errors fall with the square of this number or faster, time grows with it.

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
        """The sides of each face times its cost, which is above 0: two faces may disagree on a common edge."""
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
        """The roots of v' G v for the sides v of each face: two faces may disagree on the length of their edge.

        G is finite, symmetric and positive on its face. A default of more than 300 `points` is an error.
        """
        mesh = _arrays(self, vertices, faces)
        sides = _core.sides_by_face_tensor(*mesh, np.asarray(self.tensors))
        points = _core.edge_points_for(*mesh, sides) if self.points is None else self.points
        return MetricLengths(sides, 0, points=points)


@dataclass(frozen=True, eq=False)
class FaceRanders:
    """A Randers metric for each face: a step v costs sqrt(v' G v) + w . v, so that a way back costs something else.

    Parameters
    ----------
    tensors : array_like, shape (m, 3, 3)
        G, as for `FaceTensor`.
    drift : array_like, shape (m, 3)
        w: a step along it costs more, a step against it less. In the lengths of G it is shorter than 1 on the plane of
        the face, so that every step costs something; its component normal to the face does not count.
    points : int, optional
        As for `FaceTensor`.

    Notes
    -----
    Fields, pairs, paths and what is built on fields, such as `Surface.voronoi`, `disk`, `band` and `sample_farthest`,
    are answered by the method "exact": from the points, and with ``to=True`` to them. Questions that need ways back to
    cost the same are refused, as is an index.

    Examples
    --------
    >>> metric = vorogeo.FaceRanders(np.tile(np.eye(3), (len(faces), 1, 1)), 0.3 * downhill)
    """

    tensors: ArrayLike
    drift: ArrayLike
    points: int | None = None

    def __post_init__(self) -> None:
        _own(self, "tensors", (3, 3), "a symmetric 3 x 3 matrix for each face, of shape (m, 3, 3)")
        _own(self, "drift", (3,), "a vector for each face, of shape (m, 3)")
        if self.points is not None:
            object.__setattr__(self, "points", check.integer("points", self.points, 1, 1000))

    def edge_lengths(self, vertices: ArrayLike | None, faces: ArrayLike) -> MetricLengths:
        """The lengths of `FaceTensor`, and w . v for the sides v of each face."""
        lengths = FaceTensor(self.tensors, self.points).edge_lengths(vertices, faces)
        mesh = _arrays(self, vertices, faces)
        return lengths._replace(drifts=_core.drifts_by_face(*mesh, lengths.lengths, np.asarray(self.drift)))


def slope_cost(
    vertices: ArrayLike, faces: ArrayLike, up: ArrayLike = (0.0, 0.0, 1.0), penalty: float | CostOfGrade = 1.0
) -> VertexCost | FaceCost:
    """A cost for terrain that grows with the slope: 1 on level ground, 1 + penalty on a wall; or any function of grade.

    Parameters
    ----------
    vertices, faces
        As for `Surface`: shapes (n, 3) and (m, 3).
    up : array_like, shape (3,)
        The direction upwards, of any length.
    penalty : float, function of an ndarray, or array_like of shape (k, 2), default 1
        A number of at least 0: the cost is 1 + penalty sin(slope), where the slope is the angle of the normal with
        `up`. A function or table of the steepest grade of each face (rise by length on the map, at least 0): what a
        unit of length costs there, given as for `hiking_time`; faces of infinite cost are barriers, such as those
        steeper than 1 in 12 by `wheelchair`.

    Returns
    -------
    VertexCost, or FaceCost of a function or table
        The cost is the same uphill, downhill and along the slope; `hiking_time` tells these apart.

    Examples
    --------
    >>> vorogeo.slope_cost(vertices, faces, penalty=vorogeo.wheelchair)
    >>> vorogeo.slope_cost(vertices, faces, penalty=[[0, 1], [0.2, 1.5], [0.6, 4]])  # and no way where it is steeper
    """
    towards = check.positions("up", up)
    if towards.shape != (1, 3):
        raise InvalidInput(f"up: has shape {np.shape(up)}; give one vector of three numbers.")
    mesh = _mesh(vertices, faces)
    if callable(penalty) or np.ndim(penalty) > 0:
        return FaceCost(_costs_at("penalty", penalty, _core.grades_of(*mesh, towards[0])))
    least = check.real("penalty", penalty, "a number of at least 0")
    return VertexCost(_core.slope_cost(*mesh, towards[0], least))


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


def travel_time(
    vertices: ArrayLike, faces: ArrayLike, wind: ArrayLike, speed: float | ArrayLike = 1.0, points: int | None = None
) -> FaceRanders:
    """Time of a boat in a current or of an aircraft in wind: Zermelo's problem.

    Parameters
    ----------
    vertices, faces, points
        As for `Surface` and `FaceRanders`.
    wind : array_like, shape (3,) or (m, 3)
        The velocity of the current or wind, in all faces or in each; its component normal to a face does not count.
    speed : float or array_like, shape (m,), default 1
        The vehicle's own speed, above that of the wind. Both may be NaN in faces that a mask leaves out.

    Returns
    -------
    FaceRanders
        At speed 1 in the wind W, with lam = 1 - W . W: G = (lam I + W W') / lam**2 and w = -W / lam; other speeds scale
        these.
    """
    positions, triangles = _mesh(vertices, faces)
    count = len(triangles)
    along, own = _spread("wind", wind, (count, 3)), _spread("speed", speed, (count,))
    return _randers(_core.travel_time(positions, triangles, along, own), points)


def tobler(grade: ArrayLike) -> NDArray[np.float64]:
    """Seconds per metre on the map at a grade (rise by distance on the map): Tobler's hiking function.

    1 / speed of 6 exp(-3.5 abs(grade + 0.05)) km/h: fastest slightly downhill.
    """
    return _at_grades(_core.tobler, grade)


def naismith(grade: ArrayLike) -> NDArray[np.float64]:
    """Seconds per metre on the map at a grade, by Naismith's rule: 5 km/h, and an hour for each 600 m of ascent."""
    return _at_grades(_core.naismith, grade)


def climbing_cost(uphill: float = 8.0, downhill: float = 2.0) -> Callable[[ArrayLike], NDArray[np.float64]]:
    """A pace for `hiking_time`: length in space, plus a cost of at least 0 for each unit of height, up and down.

    The first default is about Naismith's rule, the second that of walkers who go down steep ways more slowly.
    """
    up, down = (check.real(name, cost, "a number") for name, cost in (("uphill", uphill), ("downhill", downhill)))
    _core.climbing_cost(np.zeros(1), up, down)  # refuses numbers below 0
    return lambda grade: _at_grades(lambda at: _core.climbing_cost(at, up, down), grade)


def _at_grades(law: Callable[[NDArray[np.float64]], NDArray[np.float64]], grade: ArrayLike) -> NDArray[np.float64]:
    """The values of a law at grades in an array of any shape."""
    wanted = "rises by length on the map, as real numbers"
    grades = np.asarray(check.numbers("grade", grade, wanted), dtype=np.float64)
    return law(grades.ravel()).reshape(grades.shape)


def wheelchair(grade: ArrayLike) -> NDArray[np.float64]:
    """1 for each unit of length at a grade of up to 1 in 12, infinite where it is steeper."""
    return _at_grades(lambda at: np.where(np.abs(at) <= (1 + 1e-9) / 12, 1.0, np.inf), grade)


def hiking_time(
    vertices: ArrayLike,
    faces: ArrayLike,
    pace: CostOfGrade = tobler,
    up: ArrayLike = (0.0, 0.0, 1.0),
    points: int | None = None,
) -> FaceRanders:
    """Time over terrain, or any cost that differs uphill and downhill.

    Parameters
    ----------
    vertices, faces, points
        As for `Surface` and `FaceRanders`.
    pace : function of an ndarray, or array_like of shape (k, 2), default `tobler`
        The cost per unit of length on the map at each grade: rise by length on the map, below 0 downhill. Above 0;
        infinite for grades at which none can go, as with `wheelchair`. A table has rows of a grade, ascending, and its
        cost: linear between them, infinite beyond them.
    up : array_like, shape (3,)
        The direction upwards, of any length.

    Returns
    -------
    FaceRanders
        In each face the costs straight up, straight down and on the level are those of `pace`, and those in directions
        between follow an ellipse. Where a gentler grade climbs (or descends) faster, a zigzag at that grade counts.
    """
    positions, triangles = _mesh(vertices, faces)
    upwards = np.array(check.direction("up", up))
    return _randers(
        _core.hiking_time(positions, triangles, lambda grades: _costs_at("pace", pace, grades), upwards), points
    )


def _randers(found: tuple[NDArray[np.float64], NDArray[np.float64]], points: int | None) -> FaceRanders:
    """What the compiled core returns."""
    return FaceRanders(found[0].reshape(-1, 3, 3), found[1], points)


def _costs_at(name: str, cost: CostOfGrade, grades: NDArray[np.float64]) -> NDArray[np.float64]:
    """What a function or a table of grade says, one above 0 for each grade."""
    if callable(cost):
        wanted = "a function that returns a number above 0 for each grade"
        found = np.ascontiguousarray(check.numbers(name, cost(grades), wanted), dtype=np.float64)
        if found.shape != grades.shape or not (found > 0).all():
            raise InvalidInput(f"{name}: returns other values than one above 0 for each grade; give such a function.")
        return found
    wanted = "a function of grade, or a table with rows of a grade, ascending, and its cost above 0"
    table = np.asarray(check.numbers(name, cost, wanted), dtype=np.float64)
    if table.ndim != 2 or table.shape[1] != 2 or not len(table):
        raise InvalidInput(f"{name}: has shape {table.shape}; give {wanted}.")
    at, costs = table.T
    bad = ~(np.isfinite(at) & (costs > 0) & (np.diff(at, prepend=-np.inf) > 0))
    if bad.any():
        row = int(np.flatnonzero(bad)[0])
        raise InvalidInput(f"{name}[{row}]: is {table[row].tolist()}; give {wanted}.")
    none = np.isinf(costs)
    barred = np.interp(grades, at, none, 1, 1) > 0
    return np.where(barred, np.inf, np.interp(grades, at, np.where(none, 0, costs)))


def _spread(name: str, values: ArrayLike, shape: tuple[int, ...]) -> NDArray[np.float64]:
    """Finite numbers for each face, or the same in all."""
    wanted = f"finite numbers of shape {shape}, or {shape[1:] or 'one'} for all faces"
    array = np.asarray(check.numbers(name, values, wanted), dtype=np.float64)
    # A NaN may belong to a face that is left out; the core refuses others.
    known = np.isfinite(array) | (np.isnan(array) & (array.shape == shape))
    if array.shape not in (shape, shape[1:]) or not known.all():
        raise InvalidInput(f"{name}: has shape {array.shape} or a value that is not finite; give {wanted}.")
    return np.ascontiguousarray(np.broadcast_to(array, shape))


def _lengths(sides: NDArray[np.float64], shortened: int, split: int, splits: Any) -> MetricLengths:
    """What the compiled core returns."""
    return MetricLengths(sides, shortened, split, None if splits is None else FaceSplits(*splits))


def _own(metric: Any, field: str, tail: tuple[int, ...], wanted: str) -> None:
    """Make a field a read-only copy of its real numbers: for each element one, or an array of shape `tail`."""
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
