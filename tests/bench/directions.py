"""Directions beside those of potpourri3d: log maps, lines traced from a point, vectors carried to all vertices."""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from typing import Any

import numpy as np
import vorogeo
from numpy.typing import NDArray

import meshes
import plots
import questions
import tables

SOURCES = 4
LINES = 1000
#: Of the length of a line that leads back to its target.
BACK = 1e-9
STRATEGIES = ("VectorHeat", "AffineLocal", "AffineAdaptive")
MAPS = (
    "mesh | vertices | log map by | set-up | one | leads back (%) | angle: mean (°) | median (°) | 95 % (°) | "
    "distance: mean (%)"
)
LINES_HEADING = (
    "mesh | a line, VoroGeo | potpourri3d | same end (%) | carried to all vertices, VoroGeo | potpourri3d | "
    "off: median (°)"
)

Vectors = NDArray[np.float64]


def options(parser: argparse.ArgumentParser) -> None:
    """Which meshes."""
    default = ["spot", "casting", "fandisk", "rocker_arm", "bunny", "igea"]
    parser.add_argument("meshes", nargs="*", default=default, metavar="MESH", help="default: " + " ".join(default))


def run(options: argparse.Namespace) -> dict[str, str]:
    """Measure the meshes one by one; the picture is of the last."""
    maps: list[list[str]] = []
    lines: list[list[str]] = []
    for name in options.meshes:
        file = meshes.find(name)
        if not file:
            continue
        one = Comparison(file.stem, meshes.load(file))
        maps += one.log_maps()
        lines.append(one.lines_and_transport())
        print("\n".join(" | ".join(row) for row in [*maps[-2 - len(STRATEGIES) :], lines[-1]]), flush=True)
    if options.write and maps:
        plots.log_maps(*one.mesh, one.picture)
    return {"log maps": tables.table(MAPS, maps), "lines": tables.table(LINES_HEADING, lines)}


class Comparison:
    """Both packages on one mesh, each with what it prepares once."""

    def __init__(self, name: str, mesh: meshes.Mesh) -> None:
        import potpourri3d

        self.name, self.mesh = name, mesh
        self.sources = questions.sources_of(mesh, SOURCES)
        self.surface = vorogeo.Surface(*mesh)
        self.surface.distance_field(self.sources[0], method="exact")
        self.prepared, self.heat = timed(lambda: potpourri3d.MeshVectorHeatSolver(*mesh))
        self.tracer = potpourri3d.GeodesicTracer(*mesh)
        self.picture: dict[str, Vectors] = {}

    def log_maps(self) -> list[list[str]]:
        """A row of ours, whose directions are exact, one from an index, and one for each way of theirs."""
        maps = [timed(lambda source=source: self.surface.log_map(source)) for source in self.sources]
        exact = [vectors for _, vectors in maps]
        self.picture["VoroGeo"] = exact[0]
        lead_back = 100 * float(np.mean([self.leads_back(*both) for both in zip(self.sources, exact, strict=True)]))
        ours = [self.name, f"{len(self.mesh[0]):,}", "VoroGeo", "-", seconds_of(maps), tables.number(lead_back)]
        rows = [[*ours, "0", "0", "0", "0"]]
        build, _ = timed(self.surface.build_index)
        self.surface.log_map(self.sources[0], method="index")
        answers = [timed(lambda source=source: self.surface.log_map(source, method="index")) for source in self.sources]
        rows.append(["", "", "VoroGeo, index", tables.duration(build), *self.beside(exact, answers)])
        for way in STRATEGIES:
            heat = [
                timed(lambda source=source, way=way: self.heat.compute_log_map(source, way)) for source in self.sources
            ]
            self.picture[f"potpourri3d, {way}"] = heat[0][1]
            rows.append(["", "", f"potpourri3d, {way}", tables.duration(self.prepared), *self.beside(exact, heat)])
        return rows

    def beside(self, exact: list[Vectors], answers: list[tuple[float, Vectors]]) -> list[str]:
        """The time of some log maps, which of their lines lead back, and what they are off."""
        off = np.concatenate([angle_between(a, b) for a, (_, b) in zip(exact, answers, strict=True)])
        length = np.concatenate([np.linalg.norm(a, axis=1) for a in exact])
        theirs = np.concatenate([np.linalg.norm(b, axis=1) for _, b in answers])
        reached = np.isfinite(length) & (length > 0)
        error = 100 * float(np.mean(np.abs(theirs[reached] / length[reached] - 1)))
        back = 100 * float(np.mean([self.leads_back(s, b) for s, (_, b) in zip(self.sources, answers, strict=True)]))
        angles = [float(np.mean(off[reached])), *np.percentile(off[reached], [50, 95])]
        return [
            seconds_of(answers),
            tables.number(back),
            *[tables.number(float(a)) for a in angles],
            tables.number(error),
        ]

    def leads_back(self, source: int, vectors: Vectors) -> float:
        """The share of vertices to which a straight line along their vector leads."""
        vertices, faces = self.mesh
        reached = np.flatnonzero(np.isfinite(vectors).all(axis=1))
        ends = self.surface.exp_map(source, vectors[reached]).positions(vertices, faces)
        off = np.linalg.norm(ends - vertices[reached], axis=1)
        return float(np.mean(off <= BACK * np.linalg.norm(vectors[reached], axis=1)))

    def lines_and_transport(self) -> list[str]:
        """Lines as long as half the diagonal, and a vector of length 1 carried along all shortest paths."""
        vertices, faces = self.mesh
        length = 0.5 * float(np.linalg.norm(np.ptp(vertices, axis=0)))
        turn = np.random.default_rng(3).uniform(0, 2 * np.pi, LINES)
        steps = length * np.column_stack([np.cos(turn), np.sin(turn)])
        x, y, _ = self.heat.get_tangent_frames()
        source = self.sources[0]
        ours, ends = timed(lambda: self.surface.exp_map(source, steps))
        in_space = steps @ np.array([x[source], y[source]])
        theirs, traced = timed(lambda: [self.tracer.trace_geodesic_from_vertex(source, step)[-1] for step in in_space])
        same = np.linalg.norm(ends.positions(vertices, faces) - traced, axis=1) <= BACK * length
        carry = [timed(lambda source=source: self.surface.transport_from(source, [1, 0])) for source in self.sources]
        heat = [
            timed(lambda source=source: self.heat.transport_tangent_vector(source, [1, 0])) for source in self.sources
        ]
        off = np.concatenate([angle_between(a, b) for (_, a), (_, b) in zip(carry, heat, strict=True)])
        figures = [
            tables.duration(ours / LINES),
            tables.duration(theirs / LINES),
            tables.number(100 * float(same.mean())),
        ]
        return [self.name, *figures, seconds_of(carry), seconds_of(heat), tables.number(float(np.nanmedian(off)))]


def timed(ask: Callable[[], Any]) -> tuple[float, Any]:
    """Processor time and answer."""
    start = time.process_time()
    answer = ask()
    return time.process_time() - start, answer


def seconds_of(answers: list[tuple[float, Any]]) -> str:
    """The median time."""
    return tables.duration(float(np.median([seconds for seconds, _ in answers])))


def as_complex(vectors: Vectors) -> NDArray[np.complex128]:
    """Vectors in a plane as numbers."""
    return vectors[:, 0] + 1j * vectors[:, 1]


def angle_between(a: Vectors, b: Vectors) -> NDArray[np.float64]:
    """In degrees, of each pair of rows."""
    return np.degrees(np.abs(np.angle(as_complex(a) * as_complex(b).conj())))
