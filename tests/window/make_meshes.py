"""Writes the meshes that the window opens, in single precision as the window holds them.

Usage: python make_meshes.py FOLDER [million]
  million: instead of the others, a mesh of a million vertices.
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
    if "million" in sys.argv[2:]:
        write_ply(folder / "million.ply", *terrain(1250, 800))
        return
    vertices, faces = terrain(70, 50)
    write_ply(folder / "terrain.ply", vertices, faces)
    write_ply(folder / "points.ply", vertices[[200, 3000]] + [0.01, 0.01, 0.02], faces[:0])
    write_ply(folder / "torus.ply", *torus(120, 90))
    write_ply(folder / "parts.ply", *parts())


if __name__ == "__main__":
    main()
