"""Distance from points and from lines of other layers, in PyMeshLab, with the nearest source of each vertex.

Usage: python samples/curve_sources.py [MESH]      (needs samples/setup.sh once; writes samples/out/curve_sources.png)
"""

from pathlib import Path

import mesh_input
import numpy as np
import pymeshlab
import render_plain
from panel import Panel

out = Path("samples/out")
out.mkdir(parents=True, exist_ok=True)
mesh_set = mesh_input.load_from_command_line()
vertices = mesh_set.current_mesh().vertex_matrix()

# A layer of points, which need not lie on the surface: they are moved to it.
points = np.random.default_rng(1).uniform(vertices.min(axis=0), vertices.max(axis=0), size=(6, 3))
mesh_set.add_mesh(pymeshlab.Mesh(points), "points")
mesh_set.set_current_mesh(0)
result = mesh_set.compute_scalar_by_vorogeo_distance_from_layer_per_vertex(source_layer=1)
label = mesh_set.current_mesh().vertex_custom_scalar_attribute_array("nearest_source")
print(f"points moved by at most {result['snap_distance']:g}")
print(f"vertices nearest to each point: {np.bincount(label[label >= 0].astype(int)).tolist()}")
mesh_set.save_current_mesh(str(out / "from_points.ply"))

# A polyline layer: here a shortest path, which another filter draws.
path = mesh_set.generate_polyline_by_vorogeo_geodesic_path(source=0, target=len(vertices) // 2, exact=True)
line = mesh_set.current_mesh_id()
mesh_set.set_current_mesh(0)
result = mesh_set.compute_scalar_by_vorogeo_distance_from_layer_per_vertex(source_layer=line)
print(f"distances from {result['source_points']} points along a path of length {path['length']:g}")
mesh_set.save_current_mesh(str(out / "from_path.ply"))

render_plain.draw(out / "curve_sources.png", [Panel(out / "from_points.ply"), Panel(out / "from_path.ply")])
