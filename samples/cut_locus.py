"""The cut locus of a point: where, on the far side, shortest paths arrive from different sides; writes a picture.

Usage: python samples/cut_locus.py [MESH]      (needs samples/setup.sh once; writes samples/out/cut_locus.png)
"""

import mesh_input
import numpy as np
import picture
import vorogeo

mesh_set = mesh_input.load_from_command_line()
mesh = mesh_set.current_mesh()
vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
surface = vorogeo.Surface(vertices, faces)
size = np.ptp(vertices, axis=0)
point = surface.snap(vertices.mean(axis=0) - size * [0, 0, 1])
locus = surface.cut_locus(point, min_angle=np.pi / 6)
print(f"{surface.last.seconds:.2f} s for the cut locus: {locus.length / size.max():.1f} times the width of the mesh")
print(f"shortest paths from the point are {locus.distance.min():.4g} long at least where they end on it")

field = surface.distance_field(point)
picture.draw("samples/out/cut_locus.png", vertices, faces, values=field, lines=locus)
