"""Matrices of all distances of a mesh: time, memory and errors of ours beside other packages, as a table.

Each method has a process of its own, and works through spread rows until its seconds are over; the time of the whole
matrix is extrapolated from these, which the table says. Run by matrices.sh.
"""

from __future__ import annotations

import argparse
import json
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

import meshes
import methods
import pages

PEERS = ("vorogeo_exact", "pygeodesic", "gdist", "pp3d_heat", "pp3d_marching")
CHECKED = 12  # rows whose errors are taken


def main() -> None:
    """Measure the meshes of the command line and print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh", nargs="*", default=["homer@6890", "fsaverage5@32492"], metavar="MESH[@VERTICES]")
    parser.add_argument("--seconds", type=float, default=10, help="processor time of each method, without its set-up")
    parser.add_argument("--whole", action="store_true", help="our matrix to its end, in a file, instead of some rows")
    parser.add_argument("--write", action="store_true", help="renew the table in docs/figures.md")
    parser.add_argument("--one", nargs=4, help=argparse.SUPPRESS)  # method, raw mesh, seconds, whole
    given = parser.parse_args()
    if given.one:
        print(json.dumps(measure(given.one[0], Path(given.one[1]), float(given.one[2]), given.one[3] == "whole")))
        return
    lines = [
        "mesh | vertices | method | set-up (s) | rows measured | whole matrix (s) | peak memory (MiB) | mean error (%)",
        "---|--:|---|--:|--:|--:|--:|--:",
    ]
    for name in given.mesh:
        lines += rows_of(name, given.seconds, given.whole)
    text = "\n" + "\n".join(f"| {line} |" for line in lines) + "\n\n"
    print(text)
    if given.write:
        pages.replace(pages.FIGURES, "matrices", text)


def rows_of(name: str, seconds: float, whole: bool) -> list[str]:
    """The rows of the table for one mesh."""
    stem, _, size = name.partition("@")
    file = meshes.find(stem)
    if file is None:
        return []
    mesh = with_vertices(file, int(size)) if size else meshes.load(file)
    count = len(mesh[0])
    lines = []
    with tempfile.TemporaryDirectory() as folder:
        raw = meshes.write_raw(mesh, Path(folder) / "mesh.raw")
        for method in ("vorogeo_index", *PEERS):
            task = [sys.executable, __file__, "--one", method, str(raw), str(seconds), "whole" if whole else "rows"]
            done = subprocess.run(task, capture_output=True, text=True, check=False)
            if done.returncode != 0:
                print(
                    f"{method}: left out, {(done.stderr.strip().splitlines() or ['it crashed'])[-1]}", file=sys.stderr
                )
                continue
            found = json.loads(done.stdout.splitlines()[-1])
            title = "VoroGeo, index, float32" if method == "vorogeo_index" else methods.METHODS[method].title
            sign = "" if found["rows"] == count else "~ "
            lines.append(
                f"{stem} | {count:,} | {title} | {found['setup']:.3g} | {found['rows']:,} | "
                f"{sign}{found['seconds'] / found['rows'] * count:,.0f} | {found['memory']:,.0f} | {found['error']:.2g}"
            )
            print(lines[-1], file=sys.stderr)
    return lines


def with_vertices(file: Path, count: int) -> meshes.Mesh:
    """The mesh with about so many vertices: subdivided if it has fewer, then decimated."""
    import pymeshlab

    mesh_set = pymeshlab.MeshSet()
    mesh_set.load_new_mesh(str(file))
    if mesh_set.current_mesh().vertex_number() < count:
        mesh_set.meshing_surface_subdivision_loop(iterations=1, threshold=pymeshlab.PureValue(0))
    mesh_set.meshing_decimation_quadric_edge_collapse(targetfacenum=2 * count - 4)
    mesh = mesh_set.current_mesh()
    return mesh.vertex_matrix(), mesh.face_matrix().astype(np.int32)


def measure(method: str, raw: Path, seconds: float, whole: bool) -> dict[str, Any]:
    """Set-up, processor time of some rows, peak memory and mean error of one method."""
    methods.import_package("vorogeo_index")  # also for the exact distances of the errors
    if method != "vorogeo_index":
        methods.import_package(method)
    vertices, faces = meshes.read_raw(raw)
    count = len(vertices)
    order = np.random.default_rng(1).permutation(count)
    began = time.process_time()
    if method == "vorogeo_index":
        import vorogeo

        solver: Any = vorogeo.GeodesicIndex(vertices, faces)
    else:
        solver = methods.make(method, vertices, faces, 1, None)
    setup = time.process_time() - began
    began = time.process_time()
    if method == "vorogeo_index":
        rows, used = fill(solver, order, seconds, whole, raw.parent)
    else:
        rows = {}
        for source in order:
            rows[int(source)] = np.asarray(solver.field(int(source)), np.float32)
            if time.process_time() - began > seconds:
                break
        used = len(rows)
    took = time.process_time() - began
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    return {"setup": setup, "rows": used, "seconds": took, "memory": memory, "error": error_of(rows, vertices, faces)}


def fill(index: Any, order: Any, seconds: float, whole: bool, folder: Path) -> tuple[dict[int, Any], int]:
    """Rows of our matrix in a file of float32, and how many were filled: all, or as many as the seconds allow."""
    count = len(order)
    if whole:
        matrix = index.distance_matrix(np.arange(count), entries="fields", dtype="float32", out=folder / "matrix.npy")
        return {int(v): np.array(matrix[v]) for v in order[:CHECKED]}, count
    began = time.process_time()
    index.fields(order[:64], dtype="float32")
    some = int(min(count, max(64, 64 * seconds / (time.process_time() - began))))
    began = time.process_time()
    matrix = index.fields(order[:some], dtype="float32", out=folder / "matrix.npy")
    return {int(v): np.array(matrix[k]) for k, v in enumerate(order[:CHECKED])}, some + 64


def error_of(rows: dict[int, Any], vertices: Any, faces: Any) -> float:
    """Mean relative error of the first rows against exact fields, in percent."""
    import vorogeo

    errors = []
    for source, row in list(rows.items())[:CHECKED]:
        exact = vorogeo.exact_distance_field(vertices, faces, source)
        used = np.isfinite(exact) & (exact > 0)
        errors.append(np.abs(row[used] / exact[used] - 1).mean())
    return float(100 * np.mean(errors))


if __name__ == "__main__":
    main()
