"""A picture laid onto a mesh by texture coordinates, in a frame of shortest paths, both by filters; writes a picture.

Usage: python samples/decal.py [MESH]      (needs samples/setup.sh once; writes samples/out/decal.png)
"""

import io

import matplotlib
import mesh_input
import numpy as np
import picture
import pymeshlab
import vorogeo  # adds the filters
from matplotlib import pyplot

matplotlib.use("agg")


def image_to_lay() -> np.ndarray:
    """A chessboard with a word on it, as rows of RGB from below."""
    figure = pyplot.figure(figsize=(4, 4), dpi=200)
    axes = figure.add_axes((0, 0, 1, 1))
    board = 0.75 + 0.25 * (np.indices((8, 8)).sum(axis=0) % 2)
    axes.imshow(board, cmap="gray", vmin=0, vmax=1, extent=(0, 1, 0, 1))
    axes.text(0.5, 0.5, "VoroGeo", size=46, weight="bold", ha="center", va="center")
    axes.axis("off")
    file = io.BytesIO()
    figure.savefig(file)
    pyplot.close(figure)
    file.seek(0)
    return pyplot.imread(file)[::-1, :, :3]


def split(corners: np.ndarray) -> np.ndarray:
    """Each triangle in four, by the middles of its sides."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
    return np.concatenate([np.stack(t, axis=1) for t in [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]])


mesh_set = mesh_input.load_from_command_line()
mesh = mesh_set.current_mesh()
vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
size = np.ptp(vertices, axis=0).max()

# The picture is two thirds as wide as the disk, so that the disk reaches beyond its corners. The filter runs once to
# learn the angle of the direction to the right, and again to turn the picture by it.
disk = {
    "start_point": vertices.mean(axis=0) + np.ptp(vertices, axis=0) * [0.22, 0.08, 1],
    "radius": pymeshlab.PureValue(0.27 * size),
}
lay = mesh_set.compute_scalar_by_vorogeo_directions_from_given_point_per_vertex
lay(**disk)
angle = mesh.vertex_scalar_array()
right = np.where(angle >= 0, vertices[:, 0], -np.inf).argmax()
found = lay(**disk, rotation=np.degrees(angle[right]), scale=2 / 3, per_wedge=True)
print(f"lengths differ by {found['mean_distortion']:.1%} in the mean, at most by {found['max_distortion']:.0%}")
place = mesh.wedge_tex_coord_matrix().reshape(-1, 3, 2)
colors = mesh.vertex_color_matrix()[faces, :3].mean(axis=1)
is_mapped = np.ptp(place, axis=1).max(axis=1) > 0  # others have (0, 0) at all corners

# The frame: shortest paths between the vertices nearest to the corners of the picture.
ids, of_ids = faces[is_mapped].ravel(), place[is_mapped].reshape(-1, 2)
corners = [ids[np.linalg.norm(of_ids - at, axis=1).argmin()] for at in [(0, 0), (1, 0), (1, 1), (0, 1)]]
framed = mesh_set.generate_polyline_by_vorogeo_polygon(surface_points="; ".join(map(str, corners)))
print(f"frame: area {framed['area']:.4g}, as a flat square it would be {(0.36 * size) ** 2:.4g}")
print(f"angles in degrees: {np.degrees(framed['angles']).round(1)}")
line = mesh_set.current_mesh()

# Small triangles, each in the colour that the picture has there; outside it, the colour wheel of directions.
is_near = is_mapped & ((place > -0.1) & (place < 1.1)).all(axis=2).any(axis=1)
small, small_place = vertices[faces[is_near]], place[is_near]
small_colors = colors[is_near]
for _ in range(2):
    small, small_place, small_colors = split(small), split(small_place), np.tile(small_colors, (4, 1))
image = image_to_lay()
middle = small_place.mean(axis=1)
is_in = ((middle >= 0) & (middle < 1)).all(axis=1)
column, row = (middle[is_in] * image.shape[0]).astype(int).T
small_colors[is_in] = image[row, column]
triangles = np.concatenate([vertices[faces[~is_near]], small])
picture.draw(
    "samples/out/decal.png",
    triangles.reshape(-1, 3),
    np.arange(3 * len(triangles)).reshape(-1, 3),
    colors=255 * np.concatenate([colors[~is_near], small_colors]),
    lines=vorogeo.Polylines(line.vertex_matrix(), line.edge_matrix()),
    points=vertices[corners],
)
