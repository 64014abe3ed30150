"""The mesh of a surface: its arrays, points and curves on it, and which method answers."""

from __future__ import annotations

from typing import Any, ClassVar, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as check
from . import _core
from . import points as point_lists
from .errors import InvalidInput
from .mesh_input import MeshInput
from .metrics import Metric
from .points import EdgeCurve, Rows, Sources, SurfacePoints
from .results import Answered

#: Beyond it, a distance from the surface may be more than a float can hold.
_GREATEST_COORDINATE = 1e307

#: By the numbers that the core has for them.
METHODS = ("automatic", "index", "exact", "quick")


class OnMesh:
    """What `Surface` knows of its mesh, without distances."""

    __slots__ = ("_handle", "_input", "last")

    #: What a question is answered by if it does not say.
    _default_method: ClassVar[str] = "automatic"

    _input: MeshInput
    _handle: _core.Surface
    last: Answered | None

    def _method(self, method: str | None, choices: tuple[str, ...] = METHODS[:3]) -> int:
        return check.choice("method", self._default_method if method is None else method, choices)

    def _note(self, answered: Any) -> None:
        self.last = Answered(*answered)

    @property
    def _vertex_count(self) -> int:
        return len(self._input.vertices)

    @property
    def vertices(self) -> NDArray[np.float64]:
        """Positions of the mesh, of shape (n, 3), read-only; NaN if it was given none."""
        return self._input.vertices

    @property
    def faces(self) -> NDArray[np.int32]:
        """Triangles of the mesh as they were given, of shape (m, 3); read-only."""
        return self._input.faces

    @property
    def mask(self) -> NDArray[np.bool_] | None:
        """Which faces belong to the surface, of shape (m,), read-only; None if all do."""
        return self._input.mask

    @property
    def metric(self) -> Metric | None:
        """What paths cost; None is their length in space."""
        return self._input.metric

    @property
    def gap(self) -> float:
        """The width up to which gaps are bridged."""
        return self._input.gap[0]

    def snap(self, points: ArrayLike, max_distance: float | None = None) -> SurfacePoints:
        """Move points in space to the nearest points of the surface.

        Parameters
        ----------
        points : array_like, shape (3,) or (k, 3)
            Finite positions, of at most 1e307.
        max_distance : float, optional
            How far a point may be from the surface; None for any distance.

        Returns
        -------
        SurfacePoints
            With `snap_distance`.

        Raises
        ------
        InvalidInput
            (a ValueError) If a point is not finite, above 1e307 or farther away than `max_distance`; names the point.
        """
        positions = check.positions("points", points)
        too_far = np.abs(positions).max(axis=1, initial=0) > _GREATEST_COORDINATE
        if too_far.any():
            row = int(np.flatnonzero(too_far)[0])
            raise InvalidInput(
                f"points[{row}]: {positions[row].tolist()} is too far away for its distance to be a number; give "
                f"coordinates of at most {_GREATEST_COORDINATE:g}."
            )
        limit = check.max_distance(max_distance)
        faces, weights, distance = self._handle.snap(positions)
        if (distance > limit).any():
            row = int(np.flatnonzero(distance > limit)[0])
            raise InvalidInput(
                f"points[{row}]: is {distance[row]:g} away from the surface, more than max_distance {limit:g}; "
                "move the point or raise the limit."
            )
        return SurfacePoints(faces, weights.reshape(-1, 3), distance)

    def _source_rows(self, sources: Sources) -> tuple[Rows, NDArray[np.int32]]:
        """Sources as points, and for each the position of its source in the list; a curve is one source."""
        count = self._vertex_count
        if not point_lists.holds(sources, EdgeCurve):
            found = point_lists.rows("sources", sources, count)
            number = np.arange(len(found[0]), dtype=np.int32)
        else:
            parts, numbers, places = [], [], 0
            for i, part in enumerate(cast(list[Any], [sources] if isinstance(sources, EdgeCurve) else sources)):
                name = f"sources[{i}]"
                if isinstance(part, EdgeCurve):
                    spacing = 0.0 if part.spacing is None else check.length(f"{name}.spacing", part.spacing)
                    parts.append(self._handle.along_edges(part.edges(count, name), spacing))
                    numbers.append(np.full(len(parts[-1][0]), places))
                    places += 1
                else:
                    parts.append(point_lists.rows(name, part, count))
                    numbers.append(places + np.arange(len(parts[-1][0])))
                    places += len(parts[-1][0])
            found = point_lists.joined([(p[0], p[1], p[2].reshape(-1, 3)) for p in parts])
            number = np.concatenate(numbers).astype(np.int32)
        if not len(found[0]):
            raise InvalidInput("sources: is empty; give at least one vertex id, surface point or curve.")
        return found, number
