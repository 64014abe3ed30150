"""Build an index once, keep it in a file, and use it again: numpy only, PyMeshLab just reads the mesh.

Usage: python samples/save_and_load.py [MESH]      (needs samples/setup.sh once)
"""

import time
from pathlib import Path

import mesh_input
import numpy as np
import vorogeo

mesh_set = mesh_input.load_from_command_line()  # owns the mesh
mesh = mesh_set.current_mesh()
vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
file = Path(__file__).parent / "out" / "save_and_load.vgi"
file.parent.mkdir(exist_ok=True)

index = vorogeo.GeodesicIndex(vertices, faces, progress=True)
index.save(file)
print(f"built in {index.statistics.seconds:.2f} s, {file.stat().st_size / 2**20:.1f} MiB on disk")

start = time.perf_counter()
loaded = vorogeo.GeodesicIndex.load(file, vertices, faces)
print(f"loaded in {time.perf_counter() - start:.2f} s")
print(f"same answers: {np.array_equal(index.distance_field(0), loaded.distance_field(0))}")

# The file is tied to its mesh: an edited one is refused, never answered wrongly.
try:
    vorogeo.GeodesicIndex.load(file, 2 * vertices, faces)
except vorogeo.IndexFileError as error:
    print(f"for another mesh: {error}")
