"""A mesh as it was given: its arrays, and which faces, lengths and gaps make the surface that is measured on."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as check
from . import _core
from .errors import InvalidInput
from .mesh_objects import arrays_of
from .metrics import EdgeLengths, Metric, MetricLengths


@dataclass(frozen=True, eq=False)
class MeshInput:
    """Checked arguments of a surface. Results refer to all vertices and faces, also to those that a mask leaves out.

    `gap` is the widest gap to bridge, and whether to bridge also where the surface folds back.
    """

    vertices: NDArray[np.float64]
    faces: NDArray[np.int32]
    mask: NDArray[np.bool_] | None
    metric: Metric | None
    lengths: MetricLengths | None
    gap: tuple[float, bool]

    @classmethod
    def read(
        cls,
        vertices: Any,
        faces: Any,
        mask: ArrayLike | None = None,
        metric: Metric | None = None,
        gap: float | None = 0.0,
        bridge_folds: bool = False,
    ) -> MeshInput:
        """Check the arguments and copy what the caller could change."""
        vertices, faces = arrays_of(vertices, faces)
        points = check.kept(_positions(vertices, faces, metric), vertices)
        triangles = check.kept(check.faces(faces, len(points)), faces)
        kept = _face_mask(mask, triangles, len(points))
        given = cls(points, triangles, kept, metric, None, gap_limit(gap, bridge_folds))
        return replace(given, lengths=_lengths(metric, points, given.measured_faces))

    @property
    def measured_faces(self) -> NDArray[np.int32]:
        """The faces for the core; masked ones name vertex 0 three times, so that it leaves them out but counts them."""
        return self.faces if self.mask is None else np.where(self.mask[:, None], self.faces, np.int32(0))

    def core_mesh(self, report: Callable[[float, str], object] | None = None) -> _core.Mesh:
        """The mesh of the compiled core."""
        found = self.lengths
        sides = None if found is None else (found.lengths, found.points, found.splits, found.drifts)
        return _core.read_mesh(self.vertices, self.measured_faces, sides, *self.gap, report)


def _positions(vertices: Any, faces: Any, metric: Any) -> NDArray[np.float64]:
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


def _lengths(metric: Any, vertices: NDArray[np.float64], faces: NDArray[np.int32]) -> MetricLengths | None:
    """What a metric makes of a mesh; None for lengths in space."""
    if metric is None:
        return None
    # A class passes as a Metric, too, as it has the method of its objects.
    if isinstance(metric, type) or not isinstance(metric, Metric):
        raise InvalidInput(
            f"metric: is a {type(metric).__name__}; give EdgeLengths, VertexCost, VertexTensor, FaceCost, FaceTensor, "
            "FaceRanders, or None for lengths in space."
        )
    return metric.edge_lengths(vertices, faces)


def gap_limit(gap: float | None, bridge_folds: bool) -> tuple[float, bool]:
    """The two arguments, checked: the gap is finite and not negative."""
    wanted = "a finite length of 0 or more in the unit of the vertices"
    number = 0.0 if gap is None else check.real("gap", gap, wanted)
    if not 0 <= number < math.inf:
        raise InvalidInput(f"gap: {number} is out of range; give {wanted}.")
    return number, bool(bridge_folds)


def _face_mask(mask: ArrayLike | None, faces: NDArray[np.int32], vertex_count: int) -> NDArray[np.bool_] | None:
    """Which faces belong to the surface, read-only; None if all do."""
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
