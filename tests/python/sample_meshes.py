"""Meshes for the tests: shapes whose distances have a formula, those that come with PyMeshLab, and the shared ones."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

Mesh = tuple[NDArray[np.float64], NDArray[np.int32]]

SHARED = Path(os.environ.get("VOROGEO_MESHES", Path(__file__).resolve().parents[3] / "shared" / "meshes"))


def plane_grid(columns: int, rows: int, width: float = 1.0, height: float = 1.0) -> Mesh:
    """A flat rectangle of columns x rows vertices; every distance is Euclidean."""
    x, y = np.meshgrid(np.linspace(0, width, columns), np.linspace(0, height, rows))
    vertices = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    return vertices, _grid_faces(columns, rows)


def bent_grid(columns: int, rows: int) -> Mesh:
    """A wavy rectangle, without symmetries."""
    vertices, faces = plane_grid(columns, rows, 2.0, 1.3)
    x, y = vertices[:, 0], vertices[:, 1]
    vertices[:, 2] = 0.3 * np.sin(3 * x + 1) * np.cos(4 * y) + 0.1 * np.sin(11 * x * y)
    return vertices, faces


def prism(sides: int, rows: int, height: float) -> Mesh:
    """An open tube of `rows` rings of `sides` vertices on the unit circle; it unrolls into a plane."""
    angle = np.tile(2 * np.pi * np.arange(sides) / sides, rows)
    z = np.repeat(np.linspace(0, height, rows), sides)
    faces = []
    for row in range(rows - 1):
        for i in range(sides):
            a, b = row * sides + i, row * sides + (i + 1) % sides
            faces += [[a, b, b + sides], [a, b + sides, a + sides]]
    return np.column_stack([np.cos(angle), np.sin(angle), z]), np.array(faces, dtype=np.int32)


def prism_distances(sides: int, rows: int, height: float, source: int) -> NDArray[np.float64]:
    """Distances of all vertices of `prism` from one of them, by unrolling."""
    ids = np.arange(sides * rows)
    steps = np.abs(ids % sides - source % sides)
    steps = np.minimum(steps, sides - steps)
    rise = (ids // sides - source // sides) * height / (rows - 1)
    return np.hypot(steps * 2 * np.sin(np.pi / sides), rise)


def cube() -> Mesh:
    """The unit cube with two triangles a side; vertex 4 x + 2 y + z lies at (x, y, z)."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = [triangle for a, b, c, d in quads for triangle in ((a, b, c), (a, c, d))]
    return corners, np.array(faces, dtype=np.int32)


def sphere(levels: int) -> Mesh:
    """A unit sphere: an octahedron whose faces are divided into four so many times."""
    vertices = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], dtype=float)
    faces = np.array([[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]])
    for _ in range(levels):
        edges = np.sort(np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
        unique, number = np.unique(edges, axis=0, return_inverse=True)
        ab, bc, ca = len(vertices) + number.reshape(3, -1)
        middle = vertices[unique].sum(axis=1)
        vertices = np.vstack([vertices, middle / np.linalg.norm(middle, axis=1)[:, None]])
        a, b, c = faces.T
        faces = np.vstack([np.column_stack(f) for f in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))])
    return vertices, faces


def torus(around: int, across: int) -> Mesh:
    """Of radii 2 and 0.8, by triangles that are nearly equilateral."""
    i, j = (k.ravel() for k in np.meshgrid(np.arange(around), np.arange(across), indexing="ij"))
    a, b = 2 * np.pi * (i + 0.5 * (j % 2)) / around, 2 * np.pi * j / across
    out = 2 + 0.8 * np.cos(b)
    vertices = np.column_stack([out * np.cos(a), out * np.sin(a), 0.8 * np.sin(b)])

    def at(x: NDArray[np.int64], y: NDArray[np.int64]) -> NDArray[np.int64]:
        return x % around * across + y % across

    even, here, above, right = j % 2 == 0, at(i, j), at(i, j + 1), at(i + 1, j)
    far = at(i + 1, j + 1)
    faces = [np.column_stack([here, right, np.where(even, above, far)])]
    faces.append(np.column_stack([np.where(even, right, here), far, above]))
    return vertices, np.vstack(faces).astype(np.int32)


def side_by_side(first: Mesh, second: Mesh, gap: float = 10.0) -> Mesh:
    """Both meshes as two components; the vertices of the first come first."""
    vertices = np.vstack([first[0], second[0] + [gap, 0, 0]])
    return vertices, np.vstack([first[1], second[1] + len(first[0])]).astype(np.int32)


def real_mesh(name: str) -> Mesh:
    """A mesh that comes with PyMeshLab ("cow.obj") or a shared one ("spot"), without which the test is skipped."""
    return packaged(name) if "." in name else shared(name)


def packaged(name: str) -> Mesh:
    """One of the sample meshes in the package pymeshlab, so that every clone has them."""
    pymeshlab = pytest.importorskip("pymeshlab")
    mesh_set = pymeshlab.MeshSet()
    mesh_set.load_new_mesh(str(Path(pymeshlab.__file__).parent / "tests" / "sample_meshes" / name))
    mesh = mesh_set.current_mesh()
    return mesh.vertex_matrix(), mesh.face_matrix().astype(np.int32)


def shared(name: str) -> Mesh:
    """One of the shared test meshes; skips the test where the folder is missing."""
    file = SHARED / f"{name}.ply"
    if not file.is_file():
        pytest.skip(f"the shared test mesh {file} is not there")
    data = file.read_bytes()
    header, body = data.split(b"end_header\n", 1)
    counts = [int(line.split()[-1]) for line in header.decode().splitlines() if line.startswith("element")]
    real = np.dtype("<f8" if b"property double x" in header else "<f4")
    vertices = np.frombuffer(body, real, 3 * counts[0]).reshape(-1, 3).astype(float)
    offset = 3 * real.itemsize * counts[0]
    rows = np.frombuffer(body, np.dtype([("size", "u1"), ("ids", "<i4", 3)]), counts[1], offset)
    assert (rows["size"] == 3).all()
    return vertices, np.ascontiguousarray(rows["ids"])


def write_off(file: Path, vertices: NDArray[np.float64], faces: NDArray[np.int32]) -> None:
    """A mesh as an .off file, without loss of precision."""
    lines = ["OFF", f"{len(vertices)} {len(faces)} 0"]
    lines += [" ".join(map(repr, row)) for row in vertices.tolist()]
    lines += [f"3 {a} {b} {c}" for a, b, c in faces.tolist()]
    file.write_text("\n".join(lines) + "\n")


def _grid_faces(columns: int, rows: int) -> NDArray[np.int32]:
    a = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    lower = np.column_stack([a, a + 1, a + columns + 1])
    upper = np.column_stack([a, a + columns + 1, a + columns])
    return np.vstack([lower, upper]).astype(np.int32)
