"""Draws a surface with lines and points on it into a PNG, without a screen.

Used by the samples: ``picture.draw("out.png", vertices, faces, values=field, lines=[isolines], points=positions)``.
VTK draws in a process of its own, since without any OpenGL it crashes; then matplotlib draws a plainer picture.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path
from types import SimpleNamespace

import numpy as np
from numpy.typing import ArrayLike, NDArray

SIZE = (1000, 900)
PALETTE = np.array(
    [[230, 159, 0], [86, 180, 233], [0, 158, 115], [240, 228, 66], [0, 114, 178], [213, 94, 0], [204, 121, 167]]
)


def draw(
    file: str | Path,
    vertices: ArrayLike,
    faces: ArrayLike,
    values: ArrayLike | None = None,
    regions: ArrayLike | None = None,
    colors: ArrayLike | None = None,
    lines: object = None,
    points: ArrayLike | None = None,
) -> None:
    """Write a picture: `values` of the vertices, `regions` or `colors` of the faces, polylines and points."""
    arrays = {"vertices": np.asarray(vertices), "faces": np.asarray(faces)}
    if values is not None:
        arrays["values"] = np.asarray(values)
    if regions is not None:
        arrays["colors"] = region_colors(arrays["faces"], np.asarray(regions))
    if colors is not None:
        arrays["colors"] = np.asarray(colors).astype(np.uint8)
    if lines is not None:
        arrays["line_points"], arrays["line_edges"] = lines.points, lines.edges
    if points is not None:
        arrays["points"] = np.asarray(points)
    Path(file).parent.mkdir(exist_ok=True)
    with tempfile.NamedTemporaryFile(suffix=".npz") as scene:
        np.savez(scene, **arrays)
        scene.flush()
        environment = dict(os.environ)
        if not os.environ.get("DISPLAY"):
            environment.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")
        command = [sys.executable, __file__, scene.name, str(file)]
        if subprocess.run(command, env=environment, capture_output=True, check=False).returncode != 0:
            draw_plain(file, arrays)
    print(f"written: {file}")


def joined(*lines: ArrayLike) -> SimpleNamespace:
    """Lines, each as its points in order, as the polylines that `draw` takes."""
    ends = np.cumsum([len(line) for line in lines])
    steps = np.setdiff1d(np.arange(ends[-1]), ends - 1)
    return SimpleNamespace(points=np.vstack(lines), edges=np.column_stack([steps, steps + 1]))


def region_colors(faces: NDArray[np.int32], regions: NDArray[np.int32]) -> NDArray[np.uint8]:
    """Colours of faces; regions that share a vertex differ as far as the palette allows."""
    corner_region = np.repeat(regions, 3)
    order = np.lexsort((corner_region, faces.ravel()))
    vertex, region = faces.ravel()[order], corner_region[order]
    neighbours = [set() for _ in range(regions.max() + 2)]
    for a, b in np.unique(np.column_stack([region[:-1], region[1:]])[vertex[:-1] == vertex[1:]], axis=0).tolist():
        neighbours[a].add(b)
        neighbours[b].add(a)
    color = {-1: -1}
    for name in range(regions.max() + 1):
        used = {color.get(other) for other in neighbours[name]}
        rotated = [(name + i) % len(PALETTE) for i in range(len(PALETTE))]
        color[name] = next((c for c in rotated if c not in used), rotated[0])
    table = np.array([color[name] for name in range(regions.max() + 1)] + [-1])
    return np.where((table[regions] < 0)[:, None], 160, PALETTE[table[regions]]).astype(np.uint8)


def view(vertices: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rows: to the right, up, and to the camera; up is y, or z for a mesh that lies flat."""
    size = np.ptp(vertices, axis=0)
    flat = size[2] < 0.5 * min(size[0], size[1])
    direction, up = ([0.25, -0.8, 1.0], [0.0, 0.0, 1.0]) if flat else ([0.3, 0.3, 1.0], [0.0, 1.0, 0.0])
    direction = np.array(direction) / np.linalg.norm(direction)
    right = np.cross(up, direction) / np.linalg.norm(np.cross(up, direction))
    return np.array([right, np.cross(direction, right), direction])


def draw_with_vtk(arrays: dict[str, NDArray], file: str) -> None:
    """Draw through VTK off screen."""
    import pyvista

    plotter = pyvista.Plotter(off_screen=True, window_size=SIZE)
    plotter.set_background("white")
    mesh = pyvista.PolyData.from_regular_faces(arrays["vertices"], arrays["faces"])
    look = {"ambient": 0.35, "diffuse": 0.7, "show_scalar_bar": False}
    if "colors" in arrays:
        mesh.cell_data["color"] = arrays["colors"]
        plotter.add_mesh(mesh, scalars="color", rgb=True, **look)
    elif "values" in arrays:
        mesh["value"] = np.where(np.isfinite(arrays["values"]), arrays["values"], np.nan)
        plotter.add_mesh(mesh, scalars="value", cmap="turbo_r", nan_color="lightgrey", **look)
    else:
        plotter.add_mesh(mesh, color="lightgrey", **look)
    if len(arrays.get("line_edges", ())):
        cells = np.insert(arrays["line_edges"].astype(int), 0, 2, axis=1).ravel()
        lines = pyvista.PolyData(arrays["line_points"], lines=cells)
        plotter.add_mesh(lines.tube(radius=0.0015 * mesh.length), color="black", lighting=False)
    if len(arrays.get("points", ())):
        balls = pyvista.PolyData(arrays["points"]).glyph(
            geom=pyvista.Sphere(0.006 * mesh.length), scale=False, orient=False
        )
        plotter.add_mesh(balls, color="white", ambient=0.5)
    right, up, direction = view(arrays["vertices"])
    across, along = arrays["vertices"] @ right, arrays["vertices"] @ up
    size = max(np.ptp(along), np.ptp(across) * SIZE[1] / SIZE[0])
    centre = 0.5 * ((across.min() + across.max()) * right + (along.min() + along.max()) * up)
    plotter.camera.focal_point = centre + (arrays["vertices"] @ direction).mean() * direction
    plotter.camera.position = np.array(plotter.camera.focal_point) + 10 * size * direction
    plotter.camera.up = up
    plotter.enable_parallel_projection()
    plotter.camera.parallel_scale = 0.53 * size
    plotter.reset_camera_clipping_range()
    plotter.enable_anti_aliasing("ssaa")
    plotter.screenshot(file)


def draw_plain(file: str | Path, arrays: dict[str, NDArray]) -> None:
    """Draw with matplotlib: triangles from back to front, then all lines and points, hidden ones included."""
    import matplotlib

    matplotlib.use("agg")
    from matplotlib import pyplot
    from matplotlib.collections import LineCollection, PolyCollection

    right, up, direction = view(arrays["vertices"])
    plane = np.array([right, up]).T
    corners = arrays["vertices"][arrays["faces"]]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    light = 0.4 + 0.6 * np.abs(normals @ direction) / np.maximum(np.linalg.norm(normals, axis=1), 1e-300)
    colors = np.full((len(corners), 3), 0.8)
    if "colors" in arrays:
        colors = arrays["colors"] / 255
    elif "values" in arrays:
        value = arrays["values"][arrays["faces"]].mean(axis=1)
        reached = np.isfinite(value)
        colors[reached] = pyplot.get_cmap("turbo_r")(value[reached] / (value[reached].max() or 1))[:, :3]
    order = np.argsort(corners.mean(axis=1) @ direction)
    shaded = (colors * light[:, None])[order]
    figure, axis = pyplot.subplots(figsize=(8, 7))
    axis.add_collection(PolyCollection((corners @ plane)[order], facecolors=shaded, edgecolors=shaded, linewidths=0.3))
    if "line_edges" in arrays:
        axis.add_collection(LineCollection((arrays["line_points"] @ plane)[arrays["line_edges"]], colors="k"))
    if "points" in arrays:
        axis.scatter(*(arrays["points"] @ plane).T, s=12, c="white", edgecolors="black", zorder=3)
    axis.autoscale()
    axis.set_aspect("equal")
    axis.axis("off")
    figure.savefig(file, dpi=120)
    pyplot.close(figure)


if __name__ == "__main__":
    draw_with_vtk(dict(np.load(sys.argv[1])), sys.argv[2])
