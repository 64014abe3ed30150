"""Shortest paths between points of a surface, refined and exact, with numpy; writes a picture.

Usage: python samples/paths.py [MESH]      (needs samples/setup.sh once; writes samples/out/paths.png)
"""

import time

import mesh_input
import numpy as np
import picture
import vorogeo

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

lines = picture.joined(*(p.points for p in exact))
places = ends.positions(vertices, faces)
picture.draw("samples/out/paths.png", vertices, faces, index.distance_field(ends), lines=lines, points=places)
