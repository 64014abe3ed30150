"""Meshes, exact distances and comparisons for the plugin tests."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import filters
import numpy as np
import pygeodesic.geodesic
import pymeshlab
import pytest

PROJECT = Path(__file__).resolve().parents[2]

Arrays = tuple[np.ndarray, np.ndarray]


def host_version() -> str:
    """MeshLab version inside the installed PyMeshLab, such as '2025.07'."""
    year, month = re.match(r"(\d+)\.(\d+)", pymeshlab.pmeshlab.__version__).groups()
    return f"{year}.{int(month):02d}"


def grid(columns: int, rows: int, spacing: float = 1.0) -> Arrays:
    """A flat rectangle of columns x rows squares, each split into two triangles."""
    x, y = np.meshgrid(np.arange(columns + 1), np.arange(rows + 1))
    vertices = np.column_stack([x.ravel() * spacing, y.ravel() * spacing, np.zeros(x.size)])
    corner = (np.arange(rows)[:, None] * (columns + 1) + np.arange(columns)).ravel()
    faces = np.concatenate(
        [
            np.column_stack([corner, corner + 1, corner + columns + 2]),
            np.column_stack([corner, corner + columns + 2, corner + columns + 1]),
        ]
    )
    return vertices.astype(float), faces.astype(np.int32)


def tube(radii: list[float], sides: int = 12, height: float = 1.0) -> Arrays:
    """Rings of a regular polygon one above the other, joined by triangles; open at both ends."""
    turn = 2 * np.pi * np.arange(sides) / sides
    ring = np.column_stack([np.cos(turn), np.sin(turn), np.zeros(sides)])
    vertices = np.concatenate([ring * radius + [0, 0, height * k] for k, radius in enumerate(radii)])
    i, j = np.arange(sides), np.roll(np.arange(sides), -1)
    band = np.concatenate([np.column_stack([i, j, j + sides]), np.column_stack([i, j + sides, i + sides])])
    return vertices, np.concatenate([band + sides * k for k in range(len(radii) - 1)]).astype(np.int32)


def sphere(subdivisions: int) -> Arrays:
    """A unit icosphere."""
    golden = (1 + 5**0.5) / 2
    vertices = np.array(
        [[-1, golden, 0], [1, golden, 0], [-1, -golden, 0], [1, -golden, 0], [0, -1, golden], [0, 1, golden],
         [0, -1, -golden], [0, 1, -golden], [golden, 0, -1], [golden, 0, 1], [-golden, 0, -1], [-golden, 0, 1]]
    )  # fmt: skip
    faces = np.array(
        [[0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4], [11, 10, 2], [10, 7, 6],
         [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10],
         [8, 6, 7], [9, 8, 1]]
    )  # fmt: skip
    for _ in range(subdivisions):
        edges = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
        unique, number = np.unique(edges, axis=0, return_inverse=True)
        a, b, c = (number.reshape(3, -1) + len(vertices)).astype(int)
        vertices = np.concatenate([vertices, vertices[unique].mean(axis=1)])
        v0, v1, v2 = faces.T
        faces = np.concatenate([np.column_stack(t) for t in [(v0, a, c), (v1, b, a), (v2, c, b), (a, b, c)]])
    return vertices / np.linalg.norm(vertices, axis=1, keepdims=True), faces.astype(np.int32)


def mesh_for(name: str) -> Arrays:
    """A mesh that a filter can answer on.

    For a girth a ball: sections of a rectangle meet its border; for loops a tube, which points 3, 31 and 143 lie
    around. Those of the rectangle lead from border to border.
    """
    if name == filters.GIRTH:
        return sphere(2)
    return tube([1.0] * 12) if name in (filters.TIGHT, filters.LOOP) else grid(12, 12)


def length(value: float) -> object:
    """A length in the unit of the mesh, for parameters that may also be given in percent."""
    return pymeshlab.PureValue(value) if hasattr(pymeshlab, "PureValue") else pymeshlab.AbsoluteValue(value)


def side_by_side(*parts: Arrays) -> Arrays:
    """Several meshes in one, as components of their own."""
    offsets = np.cumsum([0] + [len(vertices) for vertices, _ in parts[:-1]])
    vertices = np.concatenate([v + np.array([10.0 * i, 0, 0]) for i, (v, _) in enumerate(parts)])
    return vertices, np.concatenate([f + o for (_, f), o in zip(parts, offsets, strict=True)])


def mesh_set(vertices: np.ndarray, faces: np.ndarray | None = None) -> pymeshlab.MeshSet:
    """A MeshSet with one layer."""
    ms = pymeshlab.MeshSet()
    ms.add_mesh(pymeshlab.Mesh(vertices) if faces is None else pymeshlab.Mesh(vertices, faces))
    return ms


def load(ms: pymeshlab.MeshSet, file: str) -> None:
    """Load a file into a new layer.

    PyMeshLab's progress of loading goes into the log of the MeshSet that applied a filter last, even if that one is
    gone: a filter without effect makes it this one.
    """
    ms.apply_filter("set_selection_none")
    ms.load_new_mesh(file)


def layer_count(ms: pymeshlab.MeshSet) -> int:
    """Number of layers."""
    return ms.mesh_number() if hasattr(ms, "mesh_number") else ms.number_meshes()


def select_vertices(ms: pymeshlab.MeshSet, numbers: list[int]) -> None:
    """Select exactly these vertices of the current layer."""
    mesh = ms.current_mesh()
    condition = " || ".join(f"(vi == {number})" for number in numbers)
    ms.apply_filter("compute_selection_by_condition_per_vertex", condselect=condition)
    assert mesh.selected_vertex_number() == len(numbers)


def exact_distances(vertices: np.ndarray, faces: np.ndarray, sources: list[int]) -> np.ndarray:
    """Distances from the nearest source by pygeodesic, an independent exact solver (MMP)."""
    solver = pygeodesic.geodesic.PyGeodesicAlgorithmExact(vertices, faces)
    return solver.geodesicDistances(np.asarray(sources), None)[0]


def field(ms: pymeshlab.MeshSet) -> np.ndarray:
    """Quality of the vertices of the current layer."""
    return ms.current_mesh().vertex_scalar_array()


def arrays(ms: pymeshlab.MeshSet) -> Arrays:
    """Vertices and faces of the current layer."""
    return ms.current_mesh().vertex_matrix(), ms.current_mesh().face_matrix()


def assert_close_to_exact(values: np.ndarray, exact: np.ndarray, mean: float, largest: float) -> None:
    """Relative errors over all vertices but the sources."""
    others = exact > 0
    errors = np.abs(values[others] - exact[others]) / exact[others]
    np.testing.assert_array_equal(values[~others], 0.0)
    assert errors.mean() <= mean
    assert errors.max() <= largest


def state(ms: pymeshlab.MeshSet) -> dict[str, np.ndarray]:
    """Everything a filter of the plugin could have changed."""
    mesh = ms.current_mesh()
    result = {
        "vertices": mesh.vertex_matrix().copy(),
        "faces": mesh.face_matrix().copy(),
        "vertex selection": np.asarray(mesh.vertex_selection_array()).copy(),
        "vertex colours": mesh.vertex_color_matrix().copy(),
    }
    result["quality"] = mesh.vertex_scalar_array().copy()
    result["has face colours"] = np.array(mesh.has_face_color())
    if mesh.has_face_color():
        result["face colours"] = mesh.face_color_matrix().copy()
    return result


def logged(setup: str, calls: list[str]) -> list[str]:
    """What a verbose MeshSet `ms` logs in each of some calls.

    In a process of its own: after a filter failed in this one, PyMeshLab leaves its output redirected.
    """
    script = [
        "import ctypes, sys, conftest, numpy as np, pymeshlab, support",
        "from support import *",
        "from filters import *",
        "conftest.pytest_configure(None)",
        "ms = pymeshlab.MeshSet(verbose=True)",
        *setup.split("\n"),
    ]
    for call in calls:
        script += ["ctypes.CDLL(None).fflush(None)", "print('NEXT', file=sys.stderr, flush=True)", call]
    done = subprocess.run(
        [sys.executable, "-c", "\n".join(script)], cwd=Path(__file__).parent, capture_output=True, text=True, check=True
    )
    return done.stderr.split("NEXT\n")[1:]


@contextmanager
def fails_and_changes_nothing(ms: pymeshlab.MeshSet, message: str) -> Iterator[None]:
    """The block raises an error with a message that contains this text; the layer is as before."""
    before = state(ms)
    with pytest.raises(pymeshlab.PyMeshLabException, match=re.escape(message)):
        yield
    after = state(ms)
    assert before.keys() == after.keys()
    for name, values in before.items():
        np.testing.assert_array_equal(values, after[name], err_msg=name)
