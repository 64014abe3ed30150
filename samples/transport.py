"""A vector carried in parallel along the shortest paths to all vertices, as a field of lines; writes a picture.

Usage: python samples/transport.py [MESH]      (needs samples/setup.sh once; writes samples/out/transport.png)
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
point = surface.snap(vertices.mean(axis=0) + np.ptp(vertices, axis=0) * [0, 0.1, 1])
field = surface.transport_from(point, [1, 0])
print(f"{surface.last.seconds:.2f} s for a vector at all {len(vertices)} vertices")

places = surface.sample_poisson_disk(0.02 * size)
places = places[np.isfinite(field[places, 0])]
steps = np.linspace(0, 0.016 * size, 4)
ends = surface.exp_map(np.repeat(places, 4), (field[places, None] * steps[:, None]).reshape(-1, 2))
lines = ends.positions(vertices, faces).reshape(-1, 4, 3)

# Round a triangle of shortest paths, a vector comes back turned by the curvature inside.
corners = surface.exp_map(point, 0.2 * size * np.array([[1, 0], [-0.5, 0.8], [-0.5, -0.8]]))
ring = surface.path_through(corners, closed=True)
(back,) = surface.transport(ring, [1, 0])
print(f"round the triangle a vector turns by {np.degrees(np.arctan2(back[1], back[0])):.2f} degrees")
picture.draw(
    "samples/out/transport.png",
    vertices,
    faces,
    values=surface.distance_field(point),
    lines=picture.joined(ring.points, *lines),
    points=point.positions(vertices, faces),
)
