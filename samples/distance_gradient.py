"""How paths between points would change with the surface: where pushing it out makes them longer; writes a picture.

Usage: python samples/distance_gradient.py [MESH]  (after samples/setup.sh; writes samples/out/distance_gradient.png)
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
source = surface.snap(vertices.mean(axis=0) + np.ptp(vertices, axis=0) * [0, 0.1, 1])
targets = surface.sample_poisson_disk(0.05 * size)

# The derivative of the mean distance from a point by the position of each vertex.
found = surface.distance_gradient(source, targets)
print(f"{surface.last.seconds:.2f} s for {len(targets)} paths, which {len(np.unique(found.vertices))} vertices change")
gradient = np.zeros_like(vertices)
np.add.at(gradient, found.vertices, found.values / len(targets))

# Compared with the difference that a small move of all vertices makes.
change = 1e-7 * size * np.random.default_rng(1).normal(size=vertices.shape)
moved = vorogeo.Surface(vertices + change, faces).distance(source, targets, method="exact").mean()
print(f"predicted {(gradient * change).sum():.6e}, measured {moved - found.distances.mean():.6e}")

# Colours: the component along the normals, averaged over some rings of vertices; red where paths become shorter.
outwards = (gradient * mesh.vertex_normal_matrix()).sum(axis=1)
a, b = np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]).T
count = 1 + np.bincount(a, minlength=len(vertices)) + np.bincount(b, minlength=len(vertices))
for _ in range(12):
    around = np.bincount(a, outwards[b], len(vertices)) + np.bincount(b, outwards[a], len(vertices))
    outwards = (outwards + around) / count
limit = np.percentile(np.abs(outwards), 97)
picture.draw(
    "samples/out/distance_gradient.png",
    vertices,
    faces,
    values=np.clip(outwards, -limit, limit),
    points=source.positions(vertices, faces),
)
