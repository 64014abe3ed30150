"""Measures and draws what an index costs against what it gives, for both forms, four patch sizes and four deltas.

Usage: tests/bench/trade_off.sh [MESH]; MESH is a file or the name of a test mesh, by default rocker_arm. Writes
docs/figures/trade_off.png and prints the table.
"""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import matplotlib as mpl

mpl.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

import meshes

COLOURS = {90: "#0072B2", 180: "#009E73", 350: "#D55E00", 700: "#CC79A7"}  # Okabe, Ito
PANELS = (
    ("bytes_per_vertex", 1.0, "memory (bytes per vertex)"),
    ("build", 1e6, "build (microseconds per vertex, one core)"),
    ("pair", 1e6, "two points, mean (microseconds)"),
)


def measured(name: str, sources: int) -> tuple[int, list[dict[str, Any]]]:
    """Number of vertices, and one row per index."""
    file = meshes.find(name)
    if file is None:
        raise SystemExit(2)
    vertices, faces = meshes.load(file)
    meshes.WORK.mkdir(parents=True, exist_ok=True)
    raw = meshes.WORK / f"{file.stem}.trade_off.raw"
    with raw.open("wb") as out:
        np.array([len(vertices), len(faces)], np.int64).tofile(out)
        vertices.tofile(out)
        faces.tofile(out)
    program = meshes.ROOT / "build" / "bench" / "tests" / "bench" / "trade_off_bench"
    lines = subprocess.run([program, raw, str(sources)], check=True, capture_output=True, text=True).stdout
    return len(vertices), [json.loads(line) for line in lines.splitlines()]


def draw(name: str, count: int, rows: list[dict[str, Any]], file: Path) -> None:
    """Mean error of two-point distances against memory, build and query: a line per patch size along delta."""
    figure, panels = plt.subplots(1, 3, figsize=(13, 4.4), sharey=True, layout="constrained")
    for axes, (key, scale, label) in zip(panels, PANELS, strict=True):
        factor = scale / count if key == "build" else scale
        for size, colour in COLOURS.items():
            own = [row for row in rows if row["patch_size"] == size]
            graphs = [row for row in own if row["form"] == "graph"]
            x = [factor * row[key] for row in graphs]
            y = [100 * row["pair_error"] for row in graphs]
            axes.plot(x, y, "o-", color=colour, label=f"graph, {size} vertices a patch")
            if key == "bytes_per_vertex":
                for row, at_x, at_y in zip(graphs, x, y, strict=True):
                    place = {"textcoords": "offset points", "xytext": (5, 3), "fontsize": 7, "color": colour}
                    axes.annotate(f"{row['delta']:g}", (at_x, at_y), **place)
            for row in own:
                if row["form"] == "tables":
                    point = (factor * row[key], 100 * row["pair_error"])
                    axes.plot(*point, "*", color=colour, markersize=14, label=f"tables, {size} vertices a patch")
        axes.set(xscale="log", yscale="log", xlabel=label)
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
            axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
            axis.set_minor_formatter(NullFormatter())
        axes.grid(alpha=0.3, which="both")
    panels[0].set_ylabel("mean relative error of two points (%)")
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside right center", fontsize=8, frameon=False)
    figure.suptitle(f"{name}, {count:,} vertices: forms, patch sizes and delta (the numbers at the marks)", fontsize=11)
    file.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(file, dpi=110)


def main() -> None:
    """Measure, print, draw."""
    name = sys.argv[1] if len(sys.argv) > 1 else "rocker_arm"
    count, rows = measured(name, 10)
    print("form | patch | delta | build (µs/vertex) | bytes/vertex | field (ms) | pair (µs) | field (%) | pair (%)")
    print("|".join(["---"] * 9))
    for row in rows:
        print(
            f"{row['form']} | {row['patch_size']} | {row['delta']:g} | {1e6 * row['build'] / count:.0f} "
            f"| {row['bytes_per_vertex']:.0f} | {1e3 * row['field']:.2f} | {1e6 * row['pair']:.0f} "
            f"| {100 * row['field_error']:.4f} | {100 * row['pair_error']:.4f}"
        )
    draw(Path(name).stem, count, rows, meshes.ROOT / "docs" / "figures" / "trade_off.png")


if __name__ == "__main__":
    main()
