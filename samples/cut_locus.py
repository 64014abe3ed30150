"""A picture laid around a point, where shortest paths from there meet, and offsets of a closed curve; writes a picture.

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
size = np.ptp(vertices, axis=0).max()
point = surface.snap(vertices.mean(axis=0) + np.ptp(vertices, axis=0) * [-0.1, 0, 1])

# Texture coordinates of a disk: a chessboard of 8 x 8 fields on it.
uv, stretch = surface.texture_coordinates(point, radius=0.22 * size, rotation=np.pi / 8, scale=0.7)
inside = np.isfinite(stretch[:, 0])
least, greatest = np.percentile(stretch[inside], [5, 95])
print(f"{inside.sum()} faces with coordinates, nine of ten stretched by {least:.3f} to {greatest:.3f}")

# Where shortest paths from the point come from different sides.
locus = surface.cut_locus(point, min_angle=0.5)
print(f"{surface.last.seconds:.2f} s for the cut locus: {locus.length / size:.1f} times the width of the mesh")

# A closed curve through four points around the picture, pulled no tighter than these hold it, and its offsets.
corners = surface.exp_map(point, 0.3 * size * np.array([[1, 0], [0, 1], [-1, 0], [0, -1]]))
curve = surface.path_through(corners, closed=True)
field = surface.signed_distance(curve)
print(
    f"{surface.last.seconds:.2f} s for distances from a curve of length {curve.length:.4g}; {np.sum(field < 0)} inside"
)
levels = 0.02 * size * np.array([-2, -1, 0, 1, 2])
offsets = surface.isolines(field, levels, "linear")

# Each face in 16, so that the fields of the chessboard have straight borders.
columns, parts = np.column_stack([vertices, uv]), faces
for _ in range(2):
    sides = np.sort(parts[:, [[0, 1], [1, 2], [2, 0]]], axis=2).reshape(-1, 2)
    ends, number = np.unique(sides, axis=0, return_inverse=True)
    middle = len(columns) + number.reshape(-1, 3)
    columns = np.vstack([columns, columns[ends].mean(axis=1)])
    a, b, c = parts.T
    p, q, r = middle.T
    parts = np.concatenate([np.column_stack(part) for part in ([a, p, r], [p, b, q], [r, q, c], [p, q, r])])
place = columns[parts, 3:].mean(axis=1)
on_board = ((place >= 0) & (place < 1)).all(axis=1)
field_of = np.floor(8 * np.where(on_board[:, None], place, 0)).astype(int).sum(axis=1) % 2
colors = np.where(on_board[:, None], np.array([[120, 72, 40], [238, 217, 181]])[field_of], [[205, 210, 218]])

lines = vorogeo.Polylines(
    np.vstack([locus.points, offsets.points]), np.vstack([locus.edges, offsets.edges + len(locus.points)])
)
picture.draw(
    "samples/out/cut_locus.png",
    columns[:, :3],
    parts,
    colors=colors,
    lines=lines,
    points=point.positions(vertices, faces),
)
