"""Distance between two vertices, in PyMeshLab and with numpy arrays.

Usage: python samples/two_points.py [MESH]      (needs samples/setup.sh once)
"""

import mesh_input
import numpy as np
import vorogeo

mesh_set = mesh_input.load_from_command_line()
mesh = mesh_set.current_mesh()
last = mesh.vertex_number() - 1

# One pair in PyMeshLab; infinity if no path leads from one to the other.
result = mesh_set.get_vorogeo_distance_between_points(source=0, target=last)
print(f"vertex 0 to vertex {last}: {result['distance']:g}, found in {1e6 * result['seconds']:.0f} microseconds")

# Many pairs at once with numpy: two equally long arrays.
index = vorogeo.GeodesicIndex(mesh.vertex_matrix(), mesh.face_matrix())
sources, targets = np.random.default_rng(0).integers(0, last + 1, size=(2, 1000))
distances = index.distance(sources, targets)
print(f"1000 random pairs: median distance {np.median(distances):g}")
print(f"symmetric: {np.array_equal(distances, index.distance(targets, sources))}")
