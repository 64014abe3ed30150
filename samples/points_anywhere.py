"""Points that need not be vertices: distances between them, nearest ones, regions, a curve as source; with a picture.

Usage: python samples/points_anywhere.py [MESH]  (needs samples/setup.sh once; writes samples/out/points_anywhere.png)
"""

import mesh_input
import numpy as np
import picture
import vorogeo

mesh_set = mesh_input.load_from_command_line()
mesh = mesh_set.current_mesh()
vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
index = vorogeo.GeodesicIndex(vertices, faces)
print(index)

# Twelve points in space, moved to the surface, as a scanner or a user might give them.
low, high = vertices.min(axis=0), vertices.max(axis=0)
points = index.snap(np.random.default_rng(4).uniform(low, high, size=(12, 3)))
print(points)

matrix = index.distance_matrix(points)
print(f"between them: from {matrix[matrix > 0].min():.4g} to {matrix.max():.4g}")
by_filter = mesh_set.get_vorogeo_distance_matrix_of_selection(surface_points=points.to_text())  # or point_layer=...
print(f"the filter says the same: {np.allclose(by_filter['distances'], matrix.ravel())}")
distance, place = index.nearest(points, [0, points[:2]], k=3)  # a vertex and two of the points
print("nearest of vertex 0 and of the first two points:", place.tolist())

# Their regions, and the distance from a curve on the surface and, with an offset, from one of the points.
regions = index.voronoi(points)
path = index.path(0, len(vertices) // 2)
curve = path.surface_points
field = index.distance_field([curve, points[:1]], offsets=np.append(np.zeros(len(curve)), 0.1 * matrix.max()))
print(f"farthest from the path and the first point: {field[np.isfinite(field)].max():.4g}")

places = np.vstack([points.positions(vertices, faces), path.points])
picture.draw("samples/out/points_anywhere.png", vertices, faces, field, lines=regions.borders, points=places)
