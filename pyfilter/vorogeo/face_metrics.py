"""Metrics that jump at edges: a cost or a tensor for each face."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from . import _arguments as check
from . import _core
from .metrics import MetricLengths, arrays, own_array


@dataclass(frozen=True, eq=False)
class FaceCost:
    """A cost for each face: the weighted region problem. Paths refract at edges, and run along cheap ones.

    Parameters
    ----------
    cost : array_like, shape (m,)
        Above 0: COST per unit of length, not speed. Along an edge the cheaper of its faces counts.
    points : int, default 6
        Points on each edge, 1 to 1000, from which faces are crossed: errors fall with its square, time grows with it.

    Notes
    -----
    Distances err by some hundredths of a percent even without an index; paths are refined until Snell's law holds.

    Examples
    --------
    >>> vorogeo.exact_distance_field(vertices, faces, 0, metric=vorogeo.FaceCost(np.where(is_water, 5.0, 1.0)))
    """

    cost: ArrayLike
    points: int = 6

    def __post_init__(self) -> None:
        object.__setattr__(
            self, "cost", own_array("FaceCost", self.cost, 1, (), "a number above 0 for each face, (m,)")
        )
        object.__setattr__(self, "points", check.integer("points", self.points, 1, 1000))

    def edge_lengths(self, vertices: ArrayLike | None, faces: ArrayLike) -> MetricLengths:
        """The sides of each face, times its cost: the two faces of an edge disagree.

        Raises
        ------
        InvalidInput
            (a ValueError) If a cost is not above 0 and finite, or their number is not that of the faces.
        """
        sides = _core.sides_by_face_cost(*arrays(self, vertices, faces), np.asarray(self.cost))
        return MetricLengths(sides.reshape(-1, 3), 0, points=self.points)


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
        wanted = "a symmetric 3 x 3 matrix for each face, of shape (m, 3, 3)"
        object.__setattr__(self, "tensors", own_array("FaceTensor", self.tensors, 3, (3, 3), wanted))
        if self.points is not None:
            object.__setattr__(self, "points", check.integer("points", self.points, 1, 1000))

    def edge_lengths(self, vertices: ArrayLike | None, faces: ArrayLike) -> MetricLengths:
        """The roots of v' G v for the sides v of each face: the two faces of an edge disagree.

        Raises
        ------
        InvalidInput
            (a ValueError) If a tensor is not finite, symmetric and positive on its face; or if `points` is None and
            more than 300 would be needed.
        """
        positions, triangles = arrays(self, vertices, faces)
        sides = _core.sides_by_face_tensor(positions, triangles, np.asarray(self.tensors).ravel()).reshape(-1, 3)
        points = self.points
        if points is None:
            points = _core.edge_points_for(positions, triangles, sides)
        return MetricLengths(sides, 0, points=points)
