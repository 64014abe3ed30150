"""Distance matrix of points on a mesh: in memory, in a file larger than memory may hold, and as a picture.

Usage: python samples/distance_matrix.py [MESH]      (needs samples/setup.sh once)
"""

import time
from pathlib import Path

import matplotlib
import mesh_input
import numpy as np
import vorogeo

matplotlib.use("agg")
from matplotlib import pyplot

mesh_set = mesh_input.load_from_command_line()
mesh = mesh_set.current_mesh()
index = vorogeo.GeodesicIndex(mesh.vertex_matrix(), mesh.face_matrix(), progress=True)  # a tqdm bar
out = Path(__file__).parent / "out"
out.mkdir(exist_ok=True)

points = index.sample_farthest(200).vertices
print(f"a matrix of 200 x 200 takes {vorogeo.matrix_bytes(200, 200) / 2**10:.0f} KiB")
start = time.perf_counter()
matrix = index.distance_matrix(points)
print(f"computed in {time.perf_counter() - start:.2f} s; symmetric: {np.array_equal(matrix, matrix.T)}")

# Fields of 20 points to all vertices, written to a file that is mapped: it need not fit into memory.
fields = index.fields(points[:20], out=out / "fields.npy")
print(f"{type(fields).__name__} of shape {fields.shape}; farthest of all: {fields[np.isfinite(fields)].max():.4g}")

order = np.argsort(matrix[0])
pyplot.imshow(matrix[np.ix_(order, order)], cmap="turbo_r")
pyplot.colorbar(label="geodesic distance")
pyplot.savefig(out / "distance_matrix.png", dpi=120)
print(f"written: {out / 'distance_matrix.png'}")
