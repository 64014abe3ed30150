"""Geodesic Voronoi regions of points spread over a mesh: farthest points, relaxed, with borders and areas.

Usage: python samples/voronoi.py [MESH]      (needs samples/setup.sh once)
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

# 40 points as far apart as possible, then moved to the middle of their regions.
samples = index.sample_farthest(40)
print(f"40 samples: every vertex is within {samples.covering_radius:.4g} of one")
relaxed = index.relax(samples.vertices, rounds=10)
print(f"energy {relaxed.energy[0]:.4g}, after {len(relaxed.energy) - 1} rounds {relaxed.energy[-1]:.4g}")

regions = index.voronoi(relaxed.vertices)
print(f"areas from {regions.area.min():.4g} to {regions.area.max():.4g}; borders {regions.borders.length:.4g} long")
largest = np.bincount(regions.vertex_region[regions.vertex_region >= 0]).argmax()
print(f"the region with most vertices is that of vertex {relaxed.vertices[largest]}")

out = Path(__file__).parent / "out" / "voronoi.png"
picture.draw(
    out, vertices, faces, regions=regions.face_region, lines=regions.borders, points=vertices[relaxed.vertices]
)
