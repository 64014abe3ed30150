"""Geodesic diameter and centre of a mesh, isolines of the distance from the centre, and a disk around it.

Usage: python samples/isolines.py [MESH]      (needs samples/setup.sh once)
"""

from pathlib import Path

import mesh_input
import picture
import vorogeo

mesh_set = mesh_input.load_from_command_line()
mesh = mesh_set.current_mesh()
vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
index = vorogeo.GeodesicIndex(vertices, faces)

extent = index.extent(fields=20)
print(f"diameter from {extent.diameter[0]:.4g} to {extent.diameter[1]:.4g}, between vertices {extent.ends}")
print(f"radius from {extent.radius[0]:.4g} to {extent.radius[1]:.4g}, around vertex {extent.centre}")

field = index.distance_field(extent.centre)
lines = index.isolines(field, 20)  # 20 evenly spaced values; or give the values themselves
print(f"isolines: {len(lines.points)} points, {len(lines.edges)} edges, {lines.length:.4g} long")

disk = index.disk(extent.centre, 0.5 * extent.radius[1])
print(f"half the radius holds {len(disk.vertices)} of {len(vertices)} vertices and {len(disk.faces)} faces")

out = Path(__file__).parent / "out" / "isolines.png"
picture.draw(out, vertices, faces, values=field, lines=lines, points=vertices[[extent.centre, *extent.ends]])
