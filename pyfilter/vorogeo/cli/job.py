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
from ..mesh_files import read_mesh
from ..metrics import Metric
from ..points import Points
from ..surface import GeodesicIndex
from .metric_options import metric_of
from .sources import points_of


@dataclass(frozen=True)
class Job:
    """A command with its options, a mesh file and where the result goes; the options are plain values.

    Attributes
    ----------
    command, mesh : str
    out : str
        The file to write; empty: none.
    options : dict of str to Any
        By their names on the command line.
    """

    command: str
    mesh: str
    out: str
    options: dict[str, Any] = field(default_factory=dict)

    def as_dict(self) -> dict[str, Any]:
        """What JSON can hold."""
        return asdict(self)


class MeshTask:
    """The mesh of a job, scaled as asked for, and its index, each made when first needed."""

    def __init__(self, job: Job) -> None:
        self.job = job
        self.options = job.options
        self.file_vertices, self.faces = read_mesh(job.mesh)
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
    def gap(self) -> float:
        """The widest gap that is bridged."""
        return self.options.get("gap") or 0.0

    @cached_property
    def metric(self) -> Metric | None:
        """What paths cost; None is their length."""
        return metric_of(self.options, self.vertices, self.faces)

    @cached_property
    def index(self) -> GeodesicIndex:
        """The index: read from the file of --index, or built, in its file by the command that makes one."""
        threads = self.options.get("threads")
        if self.options.get("index"):
            return GeodesicIndex.load(
                self.options["index"],
                self.vertices,
                self.faces,
                threads,
                mask=self.mask,
                metric=self.metric,
                gap=self.gap,
            )
        return GeodesicIndex(
            self.vertices,
            self.faces,
            patches=self.options.get("patches"),
            delta=self.options.get("delta") or 0.0,
            threads=threads,
            progress=self.progress,
            memory_budget=self.options.get("memory_budget"),
            mask=self.mask,
            metric=self.metric,
            gap=self.gap,
            file=self.job.out if self.job.command == "index" else None,
        )

    def points(self, option: str) -> Points:
        """The points of an option such as ``--from``."""
        return points_of(f"--{option}", self.options[option], lambda where: self.index.snap(where), self.scale)

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
