"""The mesh of a surface and points on it, and how the core is asked about it."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
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
from .progress import ProgressFunction, reporter
from .results import Answered

#: Beyond it, a distance from the surface may be more than a float can hold.
_GREATEST_COORDINATE = 1e307

#: By the numbers that the core has for them.
METHODS = ("automatic", "index", "exact", "quick")


@dataclass(frozen=True, eq=False)
class Shared:
    """What copies of a surface share, and pickle takes apart: its mesh, the threads and MiB of an index, the core's."""

    given: MeshInput
    threads: int
    budget: int
    core: _core.Surface

    def __deepcopy__(self, memo: dict[int, Any]) -> Shared:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        # An array, which pickle can hand over without a copy.
        index = _in_a_file(_saved, self.core) if self.core.has_index() else None
        return _restored, (self.given, self.threads, self.budget, index)


def _in_a_file(use: Callable[[str, Any], Any], what: Any) -> Any:
    """What is made of something by way of a temporary file."""
    with tempfile.TemporaryDirectory(prefix="vorogeo-") as folder:
        return use(str(Path(folder) / "index.vgi"), what)


def _saved(file: str, core: _core.Surface) -> NDArray[np.uint8]:
    core.save(file)
    return np.fromfile(file, np.uint8)


def _restored(given: MeshInput, threads: int, budget: int, index: NDArray[np.uint8] | None) -> Shared:
    mesh = given.core_mesh()

    def loaded(file: str, contents: NDArray[np.uint8]) -> _core.Surface:
        contents.tofile(file)
        return mesh.load_index(file, threads, False)  # copied, as the file goes

    core = mesh.surface(threads, budget) if index is None else _in_a_file(loaded, index)
    return Shared(given, threads, budget, core)


class OnMesh:
    """What `Surface` knows of its mesh, without distances, and how it asks the core."""

    #: What a question is answered by if it does not say.
    _default_method: ClassVar[str] = "automatic"

    _shared: Shared
    last: Answered | None

    def _method(self, method: str | None, choices: tuple[str, ...] = METHODS[:3]) -> int:
        return check.choice("method", self._default_method if method is None else method, choices)

    def _ask(
        self,
        question: Callable[..., Any],
        *arguments: Any,
        method: str | None,
        progress: ProgressFunction | bool | None = None,
        choices: tuple[str, ...] = METHODS[:3],
    ) -> Any:
        """What the core answers to a question, without what it says of the answer, which is noted."""
        how = self._method(method, choices)
        with reporter(progress) as report:
            *found, answered = question(*arguments, how, report)
        self.last = Answered(*answered)
        return found

    @property
    def vertices(self) -> NDArray[np.float64]:
        """Positions of the mesh, of shape (n, 3), read-only; NaN if it was given none."""
        return self._shared.given.vertices

    @property
    def faces(self) -> NDArray[np.int32]:
        """Triangles of the mesh as they were given, of shape (m, 3); read-only."""
        return self._shared.given.faces

    @property
    def mask(self) -> NDArray[np.bool_] | None:
        """Which faces belong to the surface, of shape (m,), read-only; None if all do."""
        return self._shared.given.mask

    @property
    def metric(self) -> Metric | None:
        """What paths cost; None is their length in space."""
        return self._shared.given.metric

    @property
    def gap(self) -> float:
        """The width up to which gaps are bridged."""
        return self._shared.given.gap[0]

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
        found = SurfacePoints(*self._shared.core.mesh.snap(positions))
        distance = cast(NDArray[np.float64], found.snap_distance)
        if (distance > limit).any():
            row = int(np.flatnonzero(distance > limit)[0])
            raise InvalidInput(
                f"points[{row}]: is {distance[row]:g} away from the surface, more than max_distance {limit:g}; "
                "move the point or raise the limit."
            )
        return found

    def _rows(self, name: str, points: Any, least: int = 0) -> Rows:
        """Checked points as the core takes them."""
        return point_lists.rows(name, points, len(self.vertices), least)

    def _source_rows(self, sources: Sources) -> tuple[Rows, NDArray[np.int32]]:
        """Sources as points, and for each the position of its source in the list; a curve is one source."""
        if not point_lists.holds(sources, EdgeCurve):
            found = self._rows("sources", sources)
            number = np.arange(len(found[0]), dtype=np.int32)
        else:
            parts, numbers, places = [], [], 0
            for i, part in enumerate(cast(list[Any], [sources] if isinstance(sources, EdgeCurve) else sources)):
                name = f"sources[{i}]"
                if isinstance(part, EdgeCurve):
                    spacing = 0.0 if part.spacing is None else check.length(f"{name}.spacing", part.spacing)
                    ends = part.edges(len(self.vertices), name)
                    parts.append(self._shared.core.mesh.along_edges(ends, spacing))
                    numbers.append(np.full(len(parts[-1][0]), places))
                    places += 1
                else:
                    parts.append(self._rows(name, part))
                    numbers.append(places + np.arange(len(parts[-1][0])))
                    places += len(parts[-1][0])
            found = point_lists.joined(parts)
            number = np.concatenate(numbers).astype(np.int32)
        if not len(found[0]):
            raise InvalidInput("sources: is empty; give at least one vertex id, surface point or curve.")
        return found, number
