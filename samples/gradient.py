"""Which way leads away from the nearest of some points, as short arrows from many; writes a picture.

Usage: python samples/gradient.py [MESH]      (needs samples/setup.sh once; writes samples/out/gradient.png)
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
sources = surface.sample_farthest(8).vertices
places = np.setdiff1d(surface.sample_poisson_disk(0.025 * size), sources)

# Gradients of the exact distance, of length 1, in the frames of the places; and a straight line along each.
away = surface.gradient(sources, places)
print(f"{surface.last.seconds:.2f} s for the gradient at {len(places)} places")
steps = np.linspace(0, 0.02 * size, 5)
ends = surface.exp_map(np.repeat(places, 5), (away[:, None] * steps[:, None]).reshape(-1, 2))
arrows = ends.positions(vertices, faces).reshape(-1, 5, 3)
picture.draw(
    "samples/out/gradient.png",
    vertices,
    faces,
    values=surface.distance_field(sources),
    lines=picture.joined(*arrows),
    points=vertices[sources],
)
