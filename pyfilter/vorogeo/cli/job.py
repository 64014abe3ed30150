"""One command on one mesh: what to compute, and how the mesh and its index are had."""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import InvalidInput
from ..mesh_files import read_with_values
from ..metrics import FaceRanders, Metric
from ..points import Points
from ..surface import GeodesicIndex, Surface
from .sources import metric_of, points_of


@dataclass(frozen=True)
class Job:
    """A command with its options, a mesh file and where the result goes; the options are plain values."""

    command: str
    mesh: str
    out: str  # the file to write; empty: none
    options: dict[str, Any] = field(default_factory=dict)  # by their names on the command line

    def as_dict(self) -> dict[str, Any]:
        """What JSON can hold."""
        return asdict(self)


class MeshTask:
    """The mesh of a job, scaled as asked for, and what answers on it, each made when first needed."""

    def __init__(self, job: Job) -> None:
        self.job = job
        self.options = job.options
        (self.file_vertices, self.faces), self.vertex_values = read_with_values(job.mesh)
        self.mask: NDArray[Any] | None = None
        if self.options.get("mask"):
            from ..brain import read_mask

            self.mask = read_mask(self.options["mask"], len(self.file_vertices))
        self.scale = 1.0
        if self.options.get("normalise") == "sqrt-area":
            area = surface_area(self.file_vertices, self.faces)
            if not area > 0:
                raise InvalidInput(f"{job.mesh}: has no area to divide by; leave out --normalise.")
            self.scale = float(1 / np.sqrt(area))
        self.vertices = self.file_vertices * self.scale

    @property
    def method(self) -> str | None:
        """What answers, if it is asked for."""
        return "exact" if self.exact else None

    @property
    def exact(self) -> bool:
        """Whether distances are exact."""
        return bool(self.options.get("exact"))

    @property
    def dtype(self) -> str:
        """The type of distances."""
        return str(self.options.get("dtype") or "float64")

    @property
    def progress(self) -> bool:
        """Whether a bar is drawn."""
        shown = bool(self.options.get("progress")) and sys.stderr.isatty()
        return shown and importlib.util.find_spec("tqdm") is not None

    @property
    def how(self) -> dict[str, Any]:
        """What questions take besides what they are about."""
        return {"method": self.method, "progress": self.progress}

    @cached_property
    def metric(self) -> Metric | None:
        """What paths cost; None is their length."""
        return metric_of(self.options, self.vertices, self.faces)

    @property
    def _measured(self) -> dict[str, Any]:
        """What every surface takes."""
        names = ("mask", "metric", "vertices", "faces")
        own = {name: getattr(self, name) for name in names}
        return {**own, "gap": self.options.get("gap") or 0.0, "threads": self.options.get("threads")}

    @property
    def plain(self) -> Surface:
        """A surface without an index, which has answered nothing yet."""
        return Surface(**self._measured, memory_budget=self.options.get("memory_budget"))

    @cached_property
    def index(self) -> GeodesicIndex:
        """The index: read from the file of --index, or built, in its file by the command that makes one."""
        if self.options.get("index"):
            return GeodesicIndex.load(self.options["index"], **self._measured)
        return GeodesicIndex(
            **self._measured,
            patches=self.options.get("patches"),
            delta=self.options.get("delta") or 0.0,
            progress=self.progress,
            memory_budget=self.options.get("memory_budget"),
            file=self.job.out if self.job.command == "index" else None,
        )

    @cached_property
    def surface(self) -> Surface:
        """What answers: the index that options name or describe, else a surface that builds one where that pays."""
        chosen = self.options.get("patches") or self.options.get("delta")
        described = chosen and not self.exact and not isinstance(self.metric, FaceRanders)
        return self.index if self.options.get("index") or described else self.plain

    def points(self, option: str) -> Points:
        """The points of an option such as ``--from``."""
        limit = self.options.get("max_snap")
        return points_of(f"--{option}", self.options[option], lambda where: self.surface.snap(where, limit), self.scale)

    def sources(self) -> tuple[Points, bool]:
        """The points of --from or --to, and whether the ways to them are asked for."""
        given = [option for option in ("from", "to") if self.options.get(option)]
        if len(given) != 1:
            raise InvalidInput("--from: is missing; name the sources, or points to go to by --to.")
        return self.points(given[0]), given == ["to"]

    @property
    def shown_mesh(self) -> tuple[NDArray[Any], NDArray[Any]]:
        """The mesh as it is in its file."""
        return self.file_vertices, self.faces

    @property
    def target(self) -> Path:
        """Where the result goes."""
        return Path(self.job.out)


def surface_area(vertices: NDArray[np.float64], faces: NDArray[np.int32]) -> float:
    """Sum of the areas of all faces."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)


Command = Callable[[MeshTask], Any]
