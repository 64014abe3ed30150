"""Poisson-disk samples by geodesic distance, their neighbours within a radius, and the nearest of each vertex.

Usage: python samples/sampling.py [MESH]      (needs samples/setup.sh once)
"""

from pathlib import Path

import mesh_input
import numpy as np
import picture
import vorogeo

mesh_set = mesh_input.load_from_command_line()
mesh = mesh_set.current_mesh()
vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
index = vorogeo.GeodesicIndex(vertices, faces)

radius = 0.05 * np.linalg.norm(np.ptp(vertices, axis=0))
samples = index.sample_poisson_disk(radius, seed=1)
print(f"{len(samples)} samples at least {radius:.4g} apart")

# A sparse matrix of all pairs within twice the radius: a graph over the samples.
print(f"memory needed: about {index.pairs_within_bytes(samples, 2 * radius) / 2**10:.0f} KiB")
graph = index.pairs_within(samples, 2 * radius)
print(f"{graph.nnz // 2} pairs, {graph.nnz / len(samples):.1f} neighbours each on average")

# The three samples nearest to some vertices: distances, and positions in the list of samples.
distances, places = index.nearest(samples, [0, 1, 2], k=3)
print(f"nearest to vertex 0: {samples[places[0]].tolist()} at {np.round(distances[0], 4).tolist()}")

# Picture: the distance of every vertex from its nearest sample; nowhere is it the radius or more.
field = index.distance_field(samples)
print(f"farthest from a sample: {field[np.isfinite(field)].max():.4g}")
picture.draw(Path(__file__).parent / "out" / "sampling.png", vertices, faces, values=field, points=vertices[samples])
