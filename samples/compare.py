"""One figure per mesh: distance fields of several methods side by side, where they err, how much and how fast.

Usage: python samples/compare.py [MESH...] [--source VERTEX] [--scale PERCENT]
  Every method runs in PyMeshLab through the filter that compares geodesic methods; the reference is the exact
  distance. The figure of MESH is written to samples/out/compare_MESH.png. Without a mesh: the bunny of pymeshlab.
"""

from __future__ import annotations

import argparse
import os
from pathlib import Path
from typing import NamedTuple

import mesh_input
import numpy as np
import pymeshlab

os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "" if os.environ.get("DISPLAY") else "vtkEGLRenderWindow")

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import pyvista

FILTER = "compute_scalar_by_geodesic_method_comparison_per_vertex"
EXACT = "Exact (VoroGeo)"
METHODS = {
    "VoroGeo index": "VoroGeo",
    "Fast marching (MeshLab)": "fast marching (MeshLab)",
    "Heat method (MeshLab)": "heat method (MeshLab)",
    "Shortest edge path (Dijkstra)": "edge paths (Dijkstra)",
}
PANEL = (760, 700)
ISOLINES = 25


class Result(NamedTuple):
    """A method on a mesh: its signed relative errors, and the figures that the filter returned."""

    name: str
    error: np.ndarray
    figures: dict[str, float]


def main() -> None:
    """Draw the meshes of the command line."""
    parser = argparse.ArgumentParser(description="Compares geodesic methods with the exact distance.")
    parser.add_argument("meshes", nargs="*", type=Path, default=[mesh_input.BUNNY])
    parser.add_argument("--source", type=int, default=0, help="vertex where distances start (default 0)")
    parser.add_argument("--scale", type=float, default=1.0, help="error, in percent, of the full colours (default 1)")
    arguments = parser.parse_args()
    folder = Path(__file__).parent / "out"
    folder.mkdir(exist_ok=True)
    for file in arguments.meshes:
        picture = folder / f"compare_{file.stem}.png"
        draw(picture, mesh_input.load(file), file.stem, arguments.source, arguments.scale)
        print(picture)


def draw(picture: Path, mesh_set: pymeshlab.MeshSet, name: str, source: int, scale: float) -> None:
    """Compute everything and draw the figure."""
    mesh_set.compute_scalar_by_exact_geodesic_distance_from_given_point_per_vertex(vertex_index=source)
    mesh = mesh_set.current_mesh()
    exact = mesh.vertex_scalar_array().copy()
    results = [result for method in METHODS if (result := compare(mesh_set, method, source))]
    surface = pyvista.PolyData.from_regular_faces(mesh.vertex_matrix(), mesh.face_matrix())
    columns = len(results)
    pictures = []
    for result in results:
        field = np.where(exact < 0, -1.0, exact * (1 + result.error))
        pictures.append(picture_of(surface, field, "turbo_r", (0.0, float(exact.max())), isolines=True))
        pictures.append(picture_of(surface, 100 * result.error, "coolwarm", (-scale, scale), isolines=False))
    pictures = without_margins(pictures)
    height = 4 * pictures[0].shape[0] / pictures[0].shape[1]
    figure = plt.figure(figsize=(4 * columns, 2 * height + 3.4), dpi=100, layout="constrained")
    grid = figure.add_gridspec(3, columns, height_ratios=(height, height, 2.6))
    for column, result in enumerate(results):
        for row in range(2):
            axes = figure.add_subplot(grid[row, column])
            axes.imshow(pictures[2 * column + row])
            axes.set_axis_off()
            if row == 0:
                axes.set_title(METHODS[result.name], fontsize=15)
    ramp = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(-scale, scale), "coolwarm")
    figure.colorbar(ramp, ax=figure.axes[1::2], label="error in %: too short, too long", shrink=0.8)
    halves = grid[2, :].subgridspec(1, 2)
    draw_histogram(figure.add_subplot(halves[0]), results)
    draw_table(figure.add_subplot(halves[1]), results)
    figure.suptitle(f"{name}, {mesh.vertex_number():,} vertices, distances from vertex {source}", fontsize=16)
    figure.savefig(picture)
    plt.close(figure)


def compare(mesh_set: pymeshlab.MeshSet, method: str, source: int) -> Result | None:
    """One method against the exact distance; None if this MeshLab lacks the method or it fails on the mesh."""
    try:
        figures = mesh_set.apply_filter(FILTER, vertex_index=source, method=method, reference=EXACT)
    except pymeshlab.PyMeshLabException as error:
        print(f"{method}: {str(error).strip().splitlines()[-1]}")
        return None
    return Result(method, mesh_set.current_mesh().vertex_scalar_array().copy(), figures)


def picture_of(
    surface: pyvista.PolyData, values: np.ndarray, ramp: str, limits: tuple[float, float], isolines: bool
) -> np.ndarray:
    """The surface coloured by values at its vertices, seen a little from above, as an array of pixels."""
    plotter = pyvista.Plotter(off_screen=True, window_size=PANEL, border=False)
    plotter.set_background("white")
    mesh = surface.copy()
    mesh["values"] = values
    plotter.add_mesh(
        mesh, scalars="values", cmap=ramp, clim=limits, smooth_shading=True, ambient=0.4, diffuse=0.65,
        show_scalar_bar=False,
    )  # fmt: skip
    if isolines:
        lines = mesh.contour(np.linspace(*limits, ISOLINES + 1)[1:-1], scalars="values")
        if lines.n_points:
            plotter.add_mesh(lines.tube(radius=0.0013 * mesh.length), color="black", lighting=False)
    plotter.view_vector((0.3, 0.3, 1.0), (0.0, 1.0, 0.0))
    plotter.enable_parallel_projection()
    plotter.enable_anti_aliasing("ssaa")
    plotter.camera.zoom(1.45)
    pixels = plotter.screenshot(return_img=True)
    plotter.close()
    return pixels


def without_margins(pictures: list[np.ndarray]) -> list[np.ndarray]:
    """All pictures cropped alike, to the part where any of them is not white."""
    drawn = np.any([picture.min(axis=2) < 255 for picture in pictures], axis=0)
    rows, columns = (np.flatnonzero(drawn.any(axis=axis)) for axis in (1, 0))
    return [picture[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1] for picture in pictures]


def draw_histogram(axes: plt.Axes, results: list[Result]) -> None:
    """Histogram of the errors, on a logarithmic scale."""
    bins = np.logspace(-5, 2, 60)
    for result in results:
        sizes = np.clip(100 * np.abs(result.error[result.error != 0]), bins[0], bins[-1])
        axes.hist(sizes, bins, histtype="step", linewidth=2, label=METHODS[result.name])
    axes.set_xscale("log")
    axes.set_xlabel("error in %")
    axes.set_ylabel("vertices")
    axes.legend(loc="upper left", fontsize=9)


def draw_table(axes: plt.Axes, results: list[Result]) -> None:
    """Mean, RMS, percentile and largest error, and the times."""
    axes.set_axis_off()
    rows = [
        [
            METHODS[result.name],
            *(f"{100 * result.figures[key]:.2g} %" for key in ("mean_error", "rms_error", "p99_error", "max_error")),
            f"{1e3 * result.figures['method_seconds']:.0f} ms",
        ]
        for result in results
    ]
    exact = min(result.figures["reference_seconds"] for result in results)
    rows.append(["exact (VoroGeo)", "reference", "", "", "", f"{1e3 * exact:.0f} ms"])
    table = axes.table(rows, colLabels=["", "mean", "RMS", "99 %", "largest", "field"], loc="center", cellLoc="right",
                       colWidths=[0.36, 0.13, 0.13, 0.13, 0.13, 0.12])  # fmt: skip
    table.auto_set_font_size(False)
    table.set_fontsize(11)
    table.scale(1, 1.7)


if __name__ == "__main__":
    main()
