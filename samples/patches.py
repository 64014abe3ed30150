"""Geodesic Voronoi patches of both layers: face colours in PyMeshLab, patch numbers with numpy.

Usage: python samples/patches.py [MESH]      (needs samples/setup.sh once)
"""

from pathlib import Path

import mesh_input
import numpy as np
import vorogeo

mesh_set = mesh_input.load_from_command_line()
mesh = mesh_set.current_mesh()
out = Path(__file__).parent / "out"
out.mkdir(exist_ok=True)

# 20 patches, each split into about 5: from then on, the index with these patches is that of the mesh.
index = mesh_set.compute_geodesic_index_by_vorogeo(n1=20, n2=5)
print(f"{index['first_layer_patches']} and {index['second_layer_patches']} patches")
mesh_set.compute_color_by_vorogeo_patches_per_face(layer=1)
mesh_set.save_current_mesh(str(out / "patches.ply"), save_face_color=True)
print(f"written: {out / 'patches.ply'}")

# The same with numpy: the patch of each face, -1 for a face that is left out.
patch = vorogeo.GeodesicIndex(mesh.vertex_matrix(), mesh.face_matrix(), patches=(20, 5)).face_patches(1)
print(f"faces per patch: {np.bincount(patch[patch >= 0]).tolist()}")
