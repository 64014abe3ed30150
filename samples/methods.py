"""Time against error of geodesic methods on a mesh, one point a method, and where four of them err.

Usage: python samples/methods.py [MESH] [--methods NAMES] [--sources COUNT]
  Measures with the filter get_geodesic_method_table, which prints its table, and draws samples/out/methods_MESH.png.
  NAMES as the filter takes them: "vorogeo, svg(K=100), gsp". Without a mesh: the bunny of pymeshlab.
"""

from __future__ import annotations

import argparse
import csv
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import mesh_input
import numpy as np
import pymeshlab
import vorogeo

METHODS = "vorogeo, mmp, ammp, fast_marching, heat, gsp, gtu, stvd, dijkstra, svg, dgg(epsilon=0.01)"
MAPS = ("vorogeo", "gsp", "fast_marching", "heat")


def main() -> None:
    """Measure, and draw both parts of the figure."""
    parser = argparse.ArgumentParser(description="Draws time against error of geodesic methods.")
    parser.add_argument("mesh", nargs="?", type=Path, default=mesh_input.BUNNY)
    parser.add_argument("--methods", default=METHODS, help="names with commas between (default: most)")
    parser.add_argument("--sources", type=int, default=3, help="vertices to start from (default 3)")
    arguments = parser.parse_args()
    folder = Path(__file__).parent / "out"
    folder.mkdir(exist_ok=True)
    table = folder / f"methods_{arguments.mesh.stem}.csv"
    mesh_set = mesh_input.load(arguments.mesh)
    mesh_set.apply_filter(
        "get_geodesic_method_table", methods=arguments.methods, sources=arguments.sources, csv_file=str(table)
    )
    rows = list(csv.DictReader(table.open(newline="")))
    for row in rows:
        setup, field, mean, p99, largest = (
            float(row[name]) for name in ("setup_seconds", "field_seconds", "mean_error", "p99_error", "max_error")
        )
        print(
            f"{row['method']:24} set-up {setup:8.3f} s, field {field:7.4f} s, mean {100 * mean:.2g} %, "
            f"99 % below {100 * p99:.2g} %, largest {100 * largest:.2g} %; bound: {row['error_bound']}"
        )
    figure = plt.figure(figsize=(12, 9), layout="constrained")
    upper, lower = figure.subfigures(2, 1)
    draw_points(upper.subplots(), rows)
    draw_maps(lower, mesh_set.current_mesh())
    figure.suptitle(f"{arguments.mesh.stem}, {mesh_set.current_mesh().vertex_number():,} vertices")
    picture = table.with_suffix(".png")
    figure.savefig(picture, dpi=110)
    print(table, picture, sep="\n")


def draw_points(axes: plt.Axes, rows: list[dict[str, str]]) -> None:
    """Time of a field against mean error; exact methods stand at the left edge."""
    times = np.array([float(row["field_seconds"]) for row in rows])
    errors = np.array([100 * float(row["mean_error"]) for row in rows])
    least = 0.3 * errors[errors > 1e-7].min(initial=1.0)
    errors = np.maximum(errors, least)
    axes.scatter(errors, times)
    for place, i in enumerate(np.argsort(errors)):  # neighbours have their names above and below in turn
        below = place % 2
        axes.annotate(
            rows[i]["method"], (errors[i], times[i]), textcoords="offset points", xytext=(6, -12 if below else 4)
        )
    axes.set(xscale="log", yscale="log", xlabel="mean error in % (at the left edge: exact)", ylabel="field, seconds")
    axes.grid(alpha=0.3)
    axes.margins(x=0.1)


def draw_maps(figure: plt.Figure, mesh: pymeshlab.Mesh) -> None:
    """The vertices from the front, coloured by the signed error of a method, from vertex 0."""
    vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
    exact = vorogeo.exact_distance_field(vertices, faces, 0)
    order = np.argsort(vertices[:, 2])
    for axes, method in zip(figure.subplots(1, len(MAPS)), MAPS, strict=True):
        with np.errstate(divide="ignore", invalid="ignore"):
            error = 100 * (vorogeo.distance_field(vertices, faces, 0, method) / exact - 1)
        dots = axes.scatter(*vertices[order, :2].T, c=error[order], s=1, cmap="coolwarm", vmin=-1, vmax=1)
        axes.set(title=method, aspect="equal")
        axes.set_axis_off()
    figure.colorbar(dots, ax=figure.axes, label="error in %: too short, too long", shrink=0.8)


if __name__ == "__main__":
    main()
