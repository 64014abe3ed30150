"""How long it takes to bridge a mesh: whole, cut open by two cracks, and as loose triangles."""

from __future__ import annotations

import argparse

import numpy as np
import vorogeo

import meshes
import tables
from worker import timed

HEADING = "mesh | vertices | read | with the gap bridged | bridging | components, before and after"


def options(parser: argparse.ArgumentParser) -> None:
    """Which mesh."""
    parser.add_argument("mesh", nargs="?", default="igea", metavar="MESH", help="default: igea")


def run(options: argparse.Namespace) -> dict[str, str]:
    """Measure the mesh."""
    file = meshes.find(options.mesh)
    return {"bridging": tables.table(HEADING, bridging(meshes.load(file)))} if file else {}


def with_cracks(mesh: meshes.Mesh, width: float) -> meshes.Mesh:
    """The mesh cut open along two planes through its middle, both sides pulled back by half of `width`."""
    vertices, faces = mesh
    for axis in (0, 1):
        middle = np.median(vertices[:, axis])
        beyond = vertices[faces][:, :, axis].mean(axis=1) > middle
        both = np.intersect1d(faces[beyond], faces[~beyond])
        copies = np.arange(len(vertices), len(vertices) + len(both), dtype=faces.dtype)
        new = np.arange(len(vertices), dtype=faces.dtype)
        new[both] = copies
        aside = np.zeros(3)
        aside[axis] = width / 2
        vertices = np.vstack([vertices, vertices[both] + aside])
        vertices[both] -= aside
        faces = np.where(beyond[:, None], new[faces], faces)
    return np.ascontiguousarray(vertices), np.ascontiguousarray(faces)


def bridging(mesh: meshes.Mesh) -> list[list[str]]:
    """Rows with the time that a mesh takes longer to be read with a gap than without."""
    edge = float(np.linalg.norm(np.diff(mesh[0][mesh[1][:, :2]], axis=1), axis=2).mean())
    loose = mesh[0][mesh[1]].reshape(-1, 3), np.arange(3 * len(mesh[1]), dtype=mesh[1].dtype).reshape(-1, 3)
    rows = []
    for name, given in (("whole", mesh), ("two cracks", with_cracks(mesh, 0.3 * edge)), ("loose triangles", loose)):
        _, _, plain = timed(lambda m=given: vorogeo.Surface(*m))
        _, _, bridged = timed(lambda m=given: vorogeo.Surface(*m, gap=edge))
        report = vorogeo.check_mesh(*given, gap=edge)
        counts = f"{report.components:,}, {report.components_after_bridging:,}"
        rows.append([name, f"{len(given[0]):,}", *map(tables.duration, (plain, bridged, bridged - plain)), counts])
    return rows
