"""A mesh as it was given: its arrays, and which faces, lengths and gaps make the surface that is measured on."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as check
from . import metrics
from .errors import InvalidInput
from .metrics import CoreSides, Metric, MetricLengths

GapLimit = tuple[float, bool]
"""The widest gap to bridge, and whether also where the surface turns back."""


@dataclass(frozen=True, eq=False)
class MeshInput:
    """Checked arguments of a surface. Results refer to all vertices and faces, also to those that a mask leaves out."""

    vertices: NDArray[np.float64]
    faces: NDArray[np.int32]
    mask: NDArray[np.bool_] | None
    metric: Metric | None
    lengths: MetricLengths | None
    gap: GapLimit

    @classmethod
    def read(
        cls,
        vertices: ArrayLike | None,
        faces: ArrayLike,
        mask: ArrayLike | None = None,
        metric: Metric | None = None,
        gap: float | None = 0.0,
        bridge_folds: bool = False,
    ) -> MeshInput:
        """Check the arguments and copy what the caller could change.

        Raises
        ------
        InvalidInput
            (a ValueError) If an argument has a wrong shape, type or range, naming the element.
        """
        points = check.kept(metrics.positions(vertices, faces, metric), vertices)
        triangles = check.kept(check.faces(faces, len(points)), faces)
        kept = face_mask(mask, triangles, len(points))
        lengths = metrics.lengths(metric, points, without_masked(triangles, kept))
        return cls(points, triangles, kept, metric, lengths, gap_limit(gap, bridge_folds))

    @property
    def core_mesh(self) -> tuple[NDArray[np.float64], NDArray[np.int32], CoreSides | None]:
        """Positions, faces and lengths as the compiled core takes them."""
        return self.vertices, without_masked(self.faces, self.mask), metrics.core_sides(self.lengths)


def gap_limit(gap: float | None, bridge_folds: bool) -> GapLimit:
    """The two arguments, checked.

    Raises
    ------
    InvalidInput
        (a ValueError) If the gap is negative or not finite.
    """
    wanted = "a finite length of 0 or more in the unit of the vertices"
    number = 0.0 if gap is None else check.real("gap", gap, wanted)
    if not 0 <= number < math.inf:
        raise InvalidInput(f"gap: {number} is out of range; give {wanted}.")
    return number, bool(bridge_folds)


def face_mask(mask: ArrayLike | None, faces: NDArray[np.int32], vertex_count: int) -> NDArray[np.bool_] | None:
    """Which faces belong to the surface, read-only; None if all do.

    Raises
    ------
    InvalidInput
        (a ValueError) If the mask has neither a value for each face nor one for each vertex, or values other than
        false and true.
    """
    if mask is None:
        return None
    wanted = (
        f"one value for each of the {len(faces)} faces or {vertex_count} vertices, True where it belongs to the surface"
    )
    try:
        given: NDArray[Any] = np.asarray(mask)
    except (TypeError, ValueError) as error:
        raise InvalidInput(f"mask: cannot be read as an array ({error}); give {wanted}.") from None
    if given.shape not in ((len(faces),), (vertex_count,)):
        raise InvalidInput(f"mask: has shape {given.shape}; give {wanted}.")
    if given.dtype.kind not in "biuf" or not np.isin(given, (0, 1)).all():
        row = int(np.flatnonzero(~np.isin(given, (0, 1)))[0]) if given.dtype.kind in "biuf" else 0
        raise InvalidInput(f"mask[{row}]: is {given[row]!r}, neither False nor True; give {wanted}.")
    kept: NDArray[np.bool_] = given.astype(bool)
    if len(given) != len(faces):
        kept = np.logical_and.reduce(kept[faces], axis=1)
    kept.flags.writeable = False
    return kept


def without_masked(faces: NDArray[np.int32], mask: NDArray[np.bool_] | None) -> NDArray[np.int32]:
    """The faces for the core: it leaves out those that name a vertex twice, and goes on counting them."""
    return faces if mask is None else np.where(mask[:, None], faces, np.int32(0))
