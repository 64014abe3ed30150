"""Straight lines side by side from a guide curve, as fibres are laid on a body; writes a picture.

Usage: python samples/straight_lines.py [MESH]      (needs samples/setup.sh once; writes samples/out/straight_lines.png)
"""

import mesh_input
import numpy as np
import picture
import vorogeo

mesh_set = mesh_input.load_from_command_line()
mesh = mesh_set.current_mesh()
vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
surface = vorogeo.Surface(vertices, faces)
size = np.ptp(vertices, axis=0)
middle = surface.snap(vertices.mean(axis=0) + size * [0.2, 0, 1])
up = surface.tangent_frames(middle)[0, :2, 1]
ends = surface.exp_map(middle, np.outer([-0.22, 0.22], up / np.linalg.norm(up)) * size.max())
guide = surface.path(ends[0], ends[1])

# Places along the guide; across it leads the gradient of the distance from its start, turned by a right angle.
places = surface.points_along(guide, np.linspace(0.02, 1, 24))
along = surface.gradient(ends[0], places)
across = np.column_stack([-along[:, 1], along[:, 0]])

steps = np.linspace(-0.3, 0.3, 161) * size.max()
lines = surface.exp_map(places[np.repeat(np.arange(24), 161)], (across[:, None] * steps[:, None]).reshape(-1, 2))
print(f"{surface.last.seconds:.3f} s for the ends of {len(lines)} lines")
strips = lines.positions(vertices, faces).reshape(24, 161, 3)
gaps = np.linalg.norm(np.diff(strips, axis=0), axis=2)
print(f"gaps between strips: {gaps[:, 80].mean():.3g} at the guide, {gaps.min():.3g} to {gaps.max():.3g} everywhere")
picture.draw("samples/out/straight_lines.png", vertices, faces, lines=picture.joined(guide.points, *strips))
