"""Signed distances from a closed curve, and its offsets; writes a picture.

Usage: python samples/signed_distance.py [MESH]  (after samples/setup.sh; writes samples/out/signed_distance.png)
"""

import mesh_input
import numpy as np
import picture
import vorogeo

mesh_set = mesh_input.load_from_command_line()
mesh = mesh_set.current_mesh()
vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
surface = vorogeo.Surface(vertices, faces)
size = np.ptp(vertices, axis=0).max()

curve = surface.spline(mesh_input.star_on(surface), closed=True)
field = surface.signed_distance(curve)
print(f"{surface.last.seconds:.2f} s for distances from a curve of length {curve.length:.4g}")
print(f"{np.sum(field < 0)} vertices inside, the deepest at {field.min():.3g}")
offsets = surface.isolines(field, 0.025 * size * np.arange(-3, 8), "linear")
# Red inside, green on the curve, blue outside.
shown = np.where(field < 0, field / -field.min(), field / field.max())
picture.draw("samples/out/signed_distance.png", vertices, faces, values=shown, lines=offsets)
