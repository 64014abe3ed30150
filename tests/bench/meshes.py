"""Meshes of the benchmarks: reading, making other sizes, and the raw files that all measured programs read."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

ROOT = Path(__file__).resolve().parents[2]
SHARED = Path(os.environ.get("VOROGEO_MESHES", ROOT.parent / "shared" / "meshes"))
WORK = ROOT / "build" / "bench-work"
PICTURES = ROOT / "docs" / "figures"

Mesh = tuple[NDArray[np.float64], NDArray[np.int32]]


def find(name: str) -> Path | None:
    """A mesh file, or the name of one in the folder of test meshes."""
    for file in (Path(name), SHARED / f"{name}.ply", WORK / f"{name}.ply"):
        if file.is_file():
            return file
    print(f"{name}: left out, there is neither a file {name} nor {SHARED / name}.ply", file=sys.stderr)
    return None


def load(file: Path) -> Mesh:
    """Vertices and triangles of any mesh file that PyMeshLab reads."""
    mesh_set = opened(file)  # it owns the mesh
    mesh = mesh_set.current_mesh()
    return np.ascontiguousarray(mesh.vertex_matrix(), np.float64), np.ascontiguousarray(mesh.face_matrix(), np.int32)


def opened(file: Path) -> Any:
    """A MeshSet with one mesh."""
    import pymeshlab

    mesh_set = pymeshlab.MeshSet()
    mesh_set.load_new_mesh(str(file))
    return mesh_set


def resized(file: Path, size: str) -> Path:
    """The mesh in another size, made once and kept in build/.

    "1/4": decimated to a share. "loop1", "loop2": subdivided after Loop. "@6890": with about so many vertices,
    subdivided if it has fewer, then decimated.
    """
    if size == "1":
        return file
    out = WORK / f"{file.stem}_{size.replace('/', '_')}.ply"
    if not out.is_file():
        mesh_set = opened(file)
        mesh = mesh_set.current_mesh()
        faces = 0
        if size.startswith("loop"):
            subdivide(mesh_set, int(size.removeprefix("loop")))
        elif size.startswith("@"):
            faces = 2 * int(size[1:]) - 4
            if mesh.vertex_number() < int(size[1:]):
                subdivide(mesh_set, 1)
        else:
            faces = mesh.face_number() // int(size.removeprefix("1/"))
        if faces:
            mesh_set.meshing_decimation_quadric_edge_collapse(targetfacenum=faces)
        WORK.mkdir(parents=True, exist_ok=True)
        mesh_set.save_current_mesh(str(out), binary=True, save_vertex_quality=False)
    return out


def subdivide(mesh_set: Any, times: int) -> None:
    """After Loop, every face."""
    import pymeshlab

    mesh_set.meshing_surface_subdivision_loop(iterations=times, threshold=pymeshlab.PureValue(0))


def elevation_grid(side: int) -> Mesh:
    """A raw elevation model: side x side posts 30 m apart, heights in whole metres, the sea flat."""
    rows, columns = np.meshgrid(np.arange(side), np.arange(side), indexing="ij")
    steepness = np.hypot(*np.meshgrid(np.fft.fftfreq(side), np.fft.rfftfreq(side), indexing="ij"))
    steepness[0, 0] = np.inf
    noise = np.fft.rfft2(np.random.default_rng(1).standard_normal((side, side)))
    hills = np.fft.irfft2(noise / steepness**1.8, (side, side))
    heights = np.maximum(np.rint(500.0 * (hills / hills.std() + 0.4)), 0.0)
    corner = (rows[:-1, :-1] * side + columns[:-1, :-1]).ravel()
    triangles = [corner + np.array(ends)[:, None] for ends in ((0, side, 1), (side, side + 1, 1))]
    positions = np.column_stack([30.0 * columns.ravel(), 30.0 * rows.ravel(), heights.ravel()])
    return positions, np.concatenate(triangles, axis=1).T.astype(np.int32)


def quartered(
    vertices: NDArray[np.float64], faces: NDArray[np.int32], values: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.int32], NDArray[np.float64]]:
    """Each face in four, with the same linear values on it."""
    ends = np.sort(faces[:, [1, 2, 2, 0, 0, 1]].reshape(-1, 2), axis=1)
    edges, of_side = np.unique(ends, axis=0, return_inverse=True)
    (a, b, c), (x, y, z) = faces.T, len(vertices) + of_side.reshape(-1, 3).T
    parts = [np.column_stack(part) for part in ((a, z, y), (b, x, z), (c, y, x), (x, y, z))]
    return (
        np.r_[vertices, vertices[edges].mean(axis=1)],
        np.concatenate(parts).astype(np.int32),
        np.r_[values, values[edges].mean(axis=1)],
    )


def write_raw(mesh: Mesh, file: Path) -> Path:
    """Write the raw file that raw_mesh.h describes."""
    file.parent.mkdir(parents=True, exist_ok=True)
    vertices, faces = mesh
    with file.open("wb") as stream:
        np.array([len(vertices), len(faces)], np.int64).tofile(stream)
        np.ascontiguousarray(vertices, np.float64).tofile(stream)
        np.ascontiguousarray(faces, np.int32).tofile(stream)
    return file


def read_raw(file: Path) -> Mesh:
    """Read a file of `write_raw`."""
    data = np.fromfile(file, np.uint8)
    n, m = data[:16].view(np.int64).tolist()
    vertices = data[16 : 16 + 24 * n].view(np.float64).reshape(n, 3)
    return vertices, data[16 + 24 * n : 16 + 24 * n + 12 * m].view(np.int32).reshape(m, 3)
