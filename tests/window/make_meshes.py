"""Writes the meshes that the window opens, in single precision as the window holds them.

Usage: python make_meshes.py FOLDER [large]
  large: instead of the others, a mesh of two million vertices.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np


def terrain(columns: int, rows: int) -> tuple[np.ndarray, np.ndarray]:
    """Hills over a rectangle: a surface with a border, no two distances alike."""
    x, y = np.meshgrid(np.linspace(0, 3, columns), np.linspace(0, 2, rows))
    z = 0.25 * np.sin(3.1 * x) * np.cos(4.3 * y) + 0.05 * np.sin(11 * x + 5 * y)
    corner = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    faces = np.concatenate(
        [
            np.column_stack([corner, corner + 1, corner + columns + 1]),
            np.column_stack([corner, corner + columns + 1, corner + columns]),
        ]
    )
    return np.column_stack([x.ravel(), y.ravel(), z.ravel()]), faces


def torus(around: int, across: int) -> tuple[np.ndarray, np.ndarray]:
    """A closed surface."""
    u, v = (a.ravel() for a in np.mgrid[0:around, 0:across])
    corner = [((u + i) % around) * across + (v + j) % across for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    faces = np.concatenate([np.column_stack([corner[i] for i in t]) for t in ((0, 1, 2), (0, 2, 3))])
    a, b = 2 * np.pi * u / around, 2 * np.pi * v / across
    radius = 1 + 0.4 * np.cos(b)
    return np.column_stack([radius * np.cos(a), radius * np.sin(a), 0.4 * np.sin(b)]), faces


def parts() -> tuple[np.ndarray, np.ndarray]:
    """Two pieces of 80 vertices each, apart, and vertex 160, which no face names."""
    vertices, faces = terrain(10, 8)
    both = np.concatenate([vertices, vertices + np.array([4, 0, 0]), [[2, 4, 0]]])
    return both, np.concatenate([faces, faces + len(vertices)])


def sphere(subdivisions: int) -> tuple[np.ndarray, np.ndarray]:
    """A unit sphere: an octahedron whose faces are divided and moved outwards."""
    vertices = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], dtype=float)
    around = np.array([[0, 2], [2, 1], [1, 3], [3, 0]])
    faces = np.concatenate(
        [np.column_stack([around, np.full(4, 4)]), np.column_stack([around[:, ::-1], np.full(4, 5)])]
    )
    for _ in range(subdivisions):
        edges = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
        unique, number = np.unique(edges, axis=0, return_inverse=True)
        a, b, c = number.reshape(3, -1) + len(vertices)
        vertices = np.concatenate([vertices, vertices[unique].mean(axis=1)])
        v0, v1, v2 = faces.T
        faces = np.concatenate([np.column_stack(t) for t in ((v0, a, c), (v1, b, a), (v2, c, b), (a, b, c))])
        vertices /= np.linalg.norm(vertices, axis=1, keepdims=True)
    return vertices, faces


HOLE = 0.4  # radius
PLATE_AT = np.array([2.6, 0.0, 0.0])


def plate_with_hole(around: int = 256, across: int = 24) -> tuple[np.ndarray, np.ndarray]:
    """A square of side 2 beside the sphere, with a round hole in its middle, and below it a small square apart."""
    angle = 2 * np.pi * np.arange(around) / around
    circle = np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])
    square = circle / np.abs(circle).max(axis=1, keepdims=True)
    part = np.linspace(0, 1, across)[:, None, None]
    vertices = ((1 - part) * HOLE * circle + part * square).reshape(-1, 3)
    ring, step = (a.ravel() for a in np.mgrid[0 : across - 1, 0:around])
    corner = [(ring + i) * around + (step + j) % around for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    faces = np.concatenate([np.column_stack([corner[i] for i in t]) for t in ((0, 1, 2), (0, 2, 3))])
    small = np.array([[-0.2, -1.6, 0], [0.2, -1.6, 0], [0.2, -1.2, 0], [-0.2, -1.2, 0]])
    both = np.concatenate([vertices, small]) + PLATE_AT
    return both, np.concatenate([faces, np.array([[0, 1, 2], [0, 2, 3]]) + len(vertices)])


def write_ply(file: Path, vertices: np.ndarray, faces: np.ndarray) -> None:
    """A binary PLY file with float coordinates."""
    header = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {len(vertices)}\nproperty float x\nproperty float y\nproperty float z\n"
        f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    rows = np.empty(len(faces), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    rows["count"], rows["corners"] = 3, faces
    file.write_bytes(header.encode() + vertices.astype("<f4").tobytes() + rows.tobytes())


def main() -> None:
    """Write the meshes."""
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    if "large" in sys.argv[2:]:
        write_ply(folder / "large.ply", *terrain(1700, 1200))
        return
    vertices, faces = terrain(70, 50)
    write_ply(folder / "terrain.ply", vertices, faces)
    write_ply(folder / "points.ply", vertices[[200, 3000]] + [0.01, 0.01, 0.02], faces[:0])
    write_ply(folder / "torus.ply", *torus(120, 90))
    write_ply(folder / "parts.ply", *parts())
    write_ply(folder / "sphere.ply", *sphere(5))
    write_ply(folder / "plate.ply", *plate_with_hole())
    write_ply(folder / "terrain_20k.ply", *terrain(160, 125))


if __name__ == "__main__":
    main()
