"""Matrices of all distances of a mesh: time, memory and errors of ours, float32 in a file, beside other packages.

Each method works through random rows until its seconds are over; the time of the whole matrix is extrapolated from
these, which the sign ~ says.
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

import numpy as np
import vorogeo

import measure
import meshes
import methods
import summary
import tables

PEERS = ("vorogeo_exact", "pygeodesic", "gdist", "pp3d_heat", "pp3d_marching")
CHECKED = 12  # rows whose errors are taken
HEADING = "mesh, method | vertices | set-up (s) | rows measured | whole matrix (s) | peak memory (MiB) | mean error (%)"


def options(parser: argparse.ArgumentParser) -> None:
    """Which meshes, how long."""
    default = ["homer@6890", "fsaverage5", "fsaverage5@32492"]
    parser.add_argument("meshes", nargs="*", default=default, metavar="MESH[@VERTICES]", help="brought to that size")
    parser.add_argument("--seconds", type=float, default=10, help="processor time of each method, without its set-up")
    parser.add_argument("--whole", action="store_true", help="our matrix to its end instead of some rows")


def run(options: argparse.Namespace) -> dict[str, str]:
    """Rows for each mesh."""
    rows = [row for name in options.meshes for row in rows_of(name, options.seconds, options.whole)]
    return {"matrices": f"\n{tables.table(HEADING, rows)}\n"}


def rows_of(name: str, seconds: float, whole: bool) -> list[list[str]]:
    """The rows of the table for one mesh."""
    stem, _, size = name.partition("@")
    file = meshes.find(stem)
    if file is None:
        return []
    mesh = meshes.load(meshes.resized(file, f"@{size}") if size else file)
    count = len(mesh[0])
    order = np.random.default_rng(1).permutation(count).tolist()
    exact = np.stack([vorogeo.exact_distance_field(*mesh, source) for source in order[:CHECKED]])
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        raw = meshes.write_raw(mesh, Path(folder) / "mesh.raw")
        for method in ("vorogeo_index", *PEERS):
            own = method == "vorogeo_index"
            matrix = {"rows": count if whole else 0, "checked": CHECKED} if own else None
            task = measure.Task(raw, count, order, np.empty((0, 2), int), matrix=matrix)
            found = measure.run(method, task, measure.Limits(seconds, float("inf"), 1))
            if found.fields is None or found.failure:
                print(f"{method}: left out, {found.failure}", flush=True)
                continue
            done = found.matrix_rows if own else len(found.fields)
            checked = min(len(found.fields), CHECKED)
            errors = summary.errors(found.fields[:checked].ravel(), exact[:checked].ravel())
            title = methods.METHODS[method].title + ", float32" * own
            whole_seconds = f"{'' if done == count else '~ '}{sum(found.field_cpu) / done * count:,.0f}"
            costs = [tables.number(found.prepared), f"{done:,}", whole_seconds, f"{found.peak_bytes / 2**20:,.0f}"]
            rows.append([f"{stem}, {title}", f"{count:,}", *costs, tables.percent(errors, "mean")])
            print(" | ".join(rows[-1]), flush=True)
    return rows
