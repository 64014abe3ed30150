"""Pictures of PLY files that VoroGeo coloured, drawn without a screen: fields with isolines, patches with borders.

Usage: python samples/render.py PICTURE.png FILE.ply...
  Several files are drawn side by side. Where VTK cannot draw (no OpenGL at all), matplotlib draws a plainer picture.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import render_plain
from panel import Panel

if TYPE_CHECKING:
    import pyvista

SIZE = (1000, 900)  # of one panel
ISOLINES = 24
MAX_BALLS = 20
LINE = 0.0012  # radius of lines, relative to the diagonal of the mesh


def main() -> None:
    """Draw what the command line names."""
    if len(sys.argv) < 3:
        sys.exit("usage: python samples/render.py PICTURE.png FILE.ply...")
    picture, files = Path(sys.argv[1]), [Path(file) for file in sys.argv[2:]]
    if os.environ.get("VOROGEO_RENDER_CHILD"):
        draw_with_vtk(picture, [Panel(file) for file in files])
    else:
        draw(picture, files)


def draw(picture: Path, files: list[Path]) -> None:
    """Draw with VTK in a process of its own, since without OpenGL it crashes; otherwise with matplotlib."""
    environment = {**os.environ, "VOROGEO_RENDER_CHILD": "1"}
    if not os.environ.get("DISPLAY"):
        environment.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")
    command = [sys.executable, __file__, str(picture), *map(str, files)]
    child = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    if child.returncode != 0:
        panels = [Panel(file) for file in files]
        print(f"VTK cannot draw here, so matplotlib draws {picture.name}", file=sys.stderr)
        render_plain.draw(picture, panels)


def draw_with_vtk(picture: Path, panels: list[Panel]) -> None:
    """Draw through VTK off screen."""
    import pyvista  # only where it is used: importing it takes a second

    plotter = pyvista.Plotter(
        off_screen=True, shape=(1, len(panels)), border=False, window_size=(SIZE[0] * len(panels), SIZE[1])
    )
    plotter.set_background("white")
    for column, panel in enumerate(panels):
        plotter.subplot(0, column)
        mesh = pyvista.PolyData.from_regular_faces(panel.vertices, panel.faces)
        if panel.distance is not None:
            add_field(plotter, mesh, panel.distance)
        else:
            mesh.cell_data["color"] = panel.colors
            plotter.add_mesh(mesh, scalars="color", rgb=True, ambient=0.35, diffuse=0.7)
            borders = panel.patch_borders()
            if len(borders):
                lines = pyvista.PolyData(panel.vertices, lines=np.insert(borders, 0, 2, axis=1).ravel())
                plotter.add_mesh(lines.tube(radius=LINE * mesh.length), color="black", lighting=False)
        aim(plotter, panel)
        plotter.enable_anti_aliasing("ssaa")
    plotter.screenshot(picture)


def add_field(plotter: pyvista.Plotter, mesh: pyvista.PolyData, distance: np.ndarray) -> None:
    """The surface in the colours of a ramp, isolines, and sources as white balls; grey where nothing was reached."""
    import pyvista

    limits = (0.0, float(distance.max()) or 1.0)
    mesh["distance"] = distance
    reached = (distance[mesh.regular_faces] >= 0).all(axis=1)
    if not reached.all():
        plotter.add_mesh(mesh.extract_cells(~reached), color="lightgrey", ambient=0.35, diffuse=0.7)
    part = mesh.extract_cells(reached).extract_surface(algorithm="geometry")
    surface = plotter.add_mesh(
        part, scalars="distance", clim=limits, cmap="turbo_r", smooth_shading=True, split_sharp_edges=True,
        ambient=0.35, diffuse=0.7, specular=0.05, show_scalar_bar=False,
    )  # fmt: skip
    lines = part.contour(np.linspace(*limits, ISOLINES + 1)[1:-1], scalars="distance")
    if lines.n_points:
        plotter.add_mesh(lines.tube(radius=LINE * mesh.length), color="black", lighting=False)
    for source in mesh.points[distance == 0][:MAX_BALLS]:
        plotter.add_mesh(pyvista.Sphere(0.008 * mesh.length, source), color="white", ambient=0.6)
    plotter.add_scalar_bar(
        " ", mapper=surface.mapper, n_labels=5, color="black", fmt="%.3g", label_font_size=22, width=0.5, height=0.06,
        position_x=0.25, position_y=0.05,
    )  # fmt: skip
    plotter.add_text("geodesic distance", (0.39, 0.012), font_size=13, color="black", viewport=True)


def aim(plotter: pyvista.Plotter, panel: Panel) -> None:
    """Parallel projection that fills the panel, with room for the bar below a field."""
    direction, right, up = panel.view()
    across, along = panel.vertices @ right, panel.vertices @ up
    size = max(np.ptp(along), np.ptp(across) * SIZE[1] / SIZE[0])
    below = 0.12 * size if panel.distance is not None else 0.0
    centre = (
        0.5 * (across.min() + across.max()) * right
        + (0.5 * (along.min() + along.max()) - 0.5 * below) * up
        + (panel.vertices @ direction).mean() * direction
    )
    plotter.camera.focal_point = centre
    plotter.camera.position = centre + 10 * size * direction
    plotter.camera.up = up
    plotter.enable_parallel_projection()
    plotter.camera.parallel_scale = 0.5 * (1.06 * size + below)
    plotter.reset_camera_clipping_range()


if __name__ == "__main__":
    main()
