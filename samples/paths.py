"""Shortest paths between points of a surface, refined and exact, with numpy; writes a picture.

Usage: python samples/paths.py [MESH]      (needs samples/setup.sh once; writes samples/out/paths.png)
"""

import time
from pathlib import Path

import matplotlib
import mesh_input
import numpy as np
import vorogeo

matplotlib.use("agg")
from matplotlib import pyplot

mesh_set = mesh_input.load_from_command_line()
mesh = mesh_set.current_mesh()
vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
index = vorogeo.GeodesicIndex(vertices, faces)

# Points in space are moved to the surface; they need not be vertices.
low, high = vertices.min(axis=0), vertices.max(axis=0)
ends = index.snap(np.random.default_rng(1).uniform(low, high, size=(8, 3)))
print(f"moved to the surface by at most {ends.snap_distance.max():g}")

start = time.perf_counter()
paths = index.path(ends[:4], ends[4:])
print(f"4 refined paths in {1e3 * (time.perf_counter() - start):.2f} ms: {[round(p.length, 6) for p in paths]}")
exact = index.exact_path(ends[:4], ends[4:])
print(f"longer than the exact ones by {max(p.length / q.length - 1 for p, q in zip(paths, exact, strict=True)):.1e}")

axes = pyplot.figure(figsize=(8, 8)).add_subplot(projection="3d")
axes.plot_trisurf(*vertices.T, triangles=faces, color="lightgrey", alpha=0.4)
for path in exact:
    axes.plot(*path.points.T, linewidth=2.5)
axes.set_box_aspect(high - low)
Path("samples/out").mkdir(parents=True, exist_ok=True)
pyplot.savefig("samples/out/paths.png", dpi=120)
