"""Walking times on a real elevation grid: up is not down, so isochrones, paths and regions there and back differ.

Usage: python samples/hiking.py       (needs samples/setup.sh once; writes samples/out/hiking.png)
The grid is the one that comes with matplotlib: the Jacksboro fault in Tennessee, 3 arc seconds, heights in metres.
"""

from __future__ import annotations

from pathlib import Path

import matplotlib
import numpy as np
import vorogeo

matplotlib.use("agg")
from matplotlib import cbook, colors, pyplot

SIZE = 130  # cells of the part that is taken, each way

with cbook.get_sample_data("jacksboro_fault_dem.npz") as grid:
    height = grid["elevation"][200 : 200 + SIZE, 180 : 180 + SIZE].astype(float)
    latitude = np.radians((grid["ymin"] + grid["ymax"]) / 2)
    spacing = 111_320 * np.array([grid["dx"] * np.cos(latitude), grid["dy"]])
x, y = np.meshgrid(np.arange(SIZE) * spacing[0], -np.arange(SIZE) * spacing[1])
vertices = np.column_stack([x.ravel(), y.ravel(), height.ravel()])
corner = (np.arange(SIZE - 1)[:, None] * SIZE + np.arange(SIZE - 1)).ravel()
faces = np.vstack(
    [
        np.column_stack([corner, corner + SIZE, corner + 1]),
        np.column_stack([corner + 1, corner + SIZE, corner + SIZE + 1]),
    ]
)

surface = vorogeo.Surface(vertices, faces, metric=vorogeo.hiking_time(vertices, faces))
valley = int(height.argmin())
hours = [surface.distance_field(valley, to=to) / 3600 for to in (False, True)]
summit = int(height.argmax())
print(f"from the valley to the summit {hours[0][summit]:.2f} h, and back {hours[1][summit]:.2f} h")
there, back = surface.path([valley, summit], [summit, valley])
for name, path in (("there", there), ("back", back)):
    steps = np.diff(path.points, axis=0)
    on_map = np.hypot(steps[:, 0], steps[:, 1])
    print(f"{name}: {on_map.sum() / 1000:.1f} km on the map, {np.maximum(steps[:, 2], 0).sum():.0f} m of ascent")

# At one speed for both ways, both would take their mean: each way differs from that by so much.
difference = np.abs(hours[0] - hours[1]) / np.maximum(hours[0] + hours[1], 1e-9)
print(f"each way differs from the mean of both by {100 * difference.mean():.0f} % on average")

# Which hut a place reaches first, and from which hut one is back first.
huts = [int(row * SIZE + column) for row, column in ((22, 30), (35, 100), (95, 20), (105, 95))]
regions = [surface.voronoi(huts, to=to) for to in (True, False)]
moved = (regions[0].vertex_region != regions[1].vertex_region).mean()
print(f"{100 * moved:.1f} % of the places are nearer to another hut on the way there than on the way back")

shade = colors.LightSource(315, 45).hillshade(height, dx=spacing[0], dy=spacing[1])
figure, axes = pyplot.subplots(1, 3, figsize=(12.5, 5.6))
titles = ("hours from the valley", "hours to the valley")
levels = np.linspace(0, max(field.max() for field in hours), 16)
for axis in axes:
    axis.imshow(shade, cmap="gray", extent=(0, x.max(), y.min(), 0), alpha=0.7)
    axis.axis("off")
for axis, field, path, title in zip(axes[:2], hours, (there, back), titles, strict=True):
    lines = axis.contour(x, y, field.reshape(x.shape), levels, cmap="viridis", linewidths=1)
    axis.clabel(lines, fmt="%.1f", fontsize=7)
    axis.plot(path.points[:, 0], path.points[:, 1], color="crimson", linewidth=1.8)
    axis.plot(*vertices[[valley, summit], :2].T, "o", color="crimson", markersize=4)
    axis.set_title(title, fontsize=10)
# Where both borders coincide, the wide line shows on both sides of the narrow one.
kinds = (("crimson", 3, "first hut to reach"), ("navy", 1, "first back from it"))
for found, (color, width, name) in zip(regions, kinds, strict=True):
    lines = np.concatenate([[*found.borders.points[edge, :2], [np.nan] * 2] for edge in found.borders.edges])
    axes[2].plot(*lines.T, color=color, linewidth=width, label=name)
axes[2].plot(*vertices[huts, :2].T, "^", color="black", markersize=7)
axes[2].legend(fontsize=8, loc="lower right")
axes[2].set_title("regions of huts, there and back", fontsize=10)
figure.tight_layout()
Path("samples/out").mkdir(exist_ok=True)
figure.savefig("samples/out/hiking.png", dpi=90)
print("written: samples/out/hiking.png")
