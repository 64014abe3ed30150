"""Metrics on meshes of every kind against themselves on finer ones: errors by points on edges, and by metric."""

from __future__ import annotations

import argparse
import time
from typing import Any

import numpy as np
import vorogeo
from numpy.typing import NDArray

import meshes
import plots
import summary
import tables

MESHES = ("spot", "fandisk", "rocker_arm", "gears", "basket", "abc3")
POINTS = (3, 6, 12, 24, 48)
FINEST = 96
#: Lengths along an axis that is turned are 8 times those across.
STRETCH = np.eye(3) + 7 * np.outer(*2 * [np.array([2.0, 1.0, 2.0]) / 3])

Floats = NDArray[np.float64]
Field = tuple[Floats, float]
Errors = tuple[Any, float]


def options(parser: argparse.ArgumentParser) -> None:
    """Which meshes."""
    parser.add_argument("meshes", nargs="*", metavar="MESH", default=MESHES, help=f"default: {' '.join(MESHES)}")


def run(options: argparse.Namespace) -> dict[str, str]:
    """A column for each mesh, and a line in the picture."""
    files = [file for file in map(meshes.find, options.meshes) if file]
    by_points, by_metric = [], []
    for file in files:
        mesh = component_of_first_vertex(meshes.load(file))
        length = field(mesh, None)
        by_points.append(errors_by_points(mesh, length))
        by_metric.append(errors_by_metric(mesh, length))
        print(*row(file.stem, by_points[-1]), *row("", by_metric[-1].values()), sep="  ", flush=True)
    lines = {file.stem: [found["mean"] for found, _ in errors] for file, errors in zip(files, by_points, strict=True)}
    if options.write:
        plots.convergence(POINTS, lines, meshes.PICTURES / "convergence.png")
    heading = " | ".join(lines)
    rows = [row(str(points), each) for points, each in zip(POINTS, zip(*by_points, strict=True), strict=True)]
    orders = [-np.polyfit(np.log(POINTS), np.log(means), 1)[0] for means in lines.values()]
    rows.append(["order", *(f"{order:.1f}" for order in orders), ""])
    return {
        "convergence": tables.table(f"points | {heading} | time", rows),
        "metrics by mesh": tables.table(
            f"metric | {heading} | time", [row(name, [each[name] for each in by_metric]) for name in by_metric[0]]
        ),
    }


def row(name: str, errors: Any) -> list[str]:
    """Mean and largest error on each mesh, and the least and the greatest time."""
    times = [ratio for _, ratio in errors]
    least, most = (tables.number(time, 2) for time in (min(times), max(times)))
    return [name, *(shown(found) for found, _ in errors), f"{least} to {most}"]


def shown(found: dict[str, float]) -> str:
    """Mean and largest; below rounding they are 0."""
    largest = max(found["over"], found["under"])
    return " / ".join("0" if error < 1e-8 else tables.number(error, 2) for error in (found["mean"], largest))


def component_of_first_vertex(mesh: meshes.Mesh) -> meshes.Mesh:
    """What a field from there reaches."""
    vertices, faces = mesh
    reached = np.isfinite(vorogeo.exact_distance_field(vertices, faces, 0))
    return vertices[reached], (np.cumsum(reached) - 1)[faces[reached[faces[:, 0]]]].astype(np.int32)


def field(mesh: meshes.Mesh, metric: Any) -> Field:
    """Of the first vertex, and the processor time of one on a surface that has answered before."""
    surface = vorogeo.Surface(*mesh, metric=metric)
    surface.distance_field(0, method="exact")
    begin = time.process_time()
    found = surface.distance_field(0, method="exact")
    return found, time.process_time() - begin


def compared(found: Field, exact: Floats, length: Field) -> Errors:
    """Errors in percent, and the time as a multiple of that of a field of lengths."""
    return summary.errors(found[0], exact), found[1] / length[1]


def halves(mesh: meshes.Mesh, points: int) -> vorogeo.FaceCost:
    """Cost 4 on one half of the mesh, 1 on the other."""
    x = mesh[0][:, 0]
    return vorogeo.FaceCost(np.where(x[mesh[1]].mean(axis=1) < (x.min() + x.max()) / 2, 4.0, 1.0), points=points)


def errors_by_points(mesh: meshes.Mesh, length: Field) -> list[Errors]:
    """Of costs by halves, against many points."""
    finest = vorogeo.exact_distance_field(*mesh, 0, metric=halves(mesh, FINEST))
    return [compared(field(mesh, halves(mesh, points)), finest, length) for points in POINTS]


def errors_by_metric(mesh: meshes.Mesh, length: Field) -> dict[str, Errors]:
    """Of metrics that are one for the whole mesh, and of costs that vary over its faces."""
    vertices, faces = mesh
    n, m = len(vertices), len(faces)
    stretched = vorogeo.exact_distance_field(vertices @ STRETCH, faces, 0)
    tensor = STRETCH @ STRETCH
    x = vertices[:, 0]
    cost = 1 + 3 * (x - x.min()) / np.ptp(x)
    *finer, cost_there = meshes.quartered(*meshes.quartered(*in_parts(vertices, faces, cost)))
    varying = vorogeo.exact_distance_field(*finer, 0, metric=vorogeo.VertexCost(cost_there))[:n]
    tests: dict[str, tuple[Any, Floats]] = {
        "constant `FaceCost`": (vorogeo.FaceCost(np.full(m, 3.0)), 3 * length[0]),
        "constant `FaceTensor`": (vorogeo.FaceTensor(np.tile(tensor, (m, 1, 1))), stretched),
        "constant `VertexTensor`": (vorogeo.VertexTensor(np.tile(tensor, (n, 1, 1))), stretched),
        "`VertexCost`, 1 to 4": (vorogeo.VertexCost(cost), varying),
    }
    return {name: compared(field(mesh, metric), exact, length) for name, (metric, exact) in tests.items()}


def in_parts(vertices: Floats, faces: NDArray[np.int32], cost: Floats) -> tuple[Floats, NDArray[np.int32], Floats]:
    """The mesh that a varying cost is measured on."""
    splits = vorogeo.VertexCost(cost).edge_lengths(vertices, faces).splits
    if splits is None:
        return vertices, faces, cost
    rows = [*np.column_stack([vertices, cost])]
    for a, b in splits.middle_of:
        rows.append((rows[a] + rows[b]) / 2)
    found = np.array(rows)
    return found[:, :3].copy(), splits.faces, found[:, 3].copy()
