"""Directions on a surface: where everything lies as seen from a point, and straight lines from it; writes a picture.

Usage: python samples/directions.py [MESH]      (needs samples/setup.sh once; writes samples/out/directions.png)
"""

import colorsys

import mesh_input
import numpy as np
import picture
import vorogeo

mesh_set = mesh_input.load_from_command_line()
mesh = mesh_set.current_mesh()
vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
surface = vorogeo.Surface(vertices, faces)
point = surface.snap(vertices.mean(axis=0) + np.ptp(vertices, axis=0) * [0, 0.1, 1])

# The faces as seen from the point: the angle of each as a hue, its distance as darker and lighter rings.
vector, distance = surface.log_map(point, return_distance=True)
print(f"{surface.last.seconds:.2f} s for the directions of all {len(vertices)} vertices")
angle = np.arctan2(vector[:, 1], vector[:, 0])
hue = np.angle(np.exp(1j * angle)[faces].mean(axis=1)) / (2 * np.pi) % 1
size = np.ptp(vertices, axis=0).max()
ring = (distance[faces].mean(axis=1) / (0.08 * size)).astype(int) % 2
wheel = [colorsys.hsv_to_rgb(h, 0.75, 1.0 - 0.18 * r) for h, r in zip(np.nan_to_num(hue), ring, strict=True)]

# Straight lines in 24 directions, each as the points at 60 lengths.
turns = np.repeat(2 * np.pi * np.arange(24) / 24, 60)
lengths = np.tile(np.linspace(0, 0.5 * size, 60), 24)
ends, walked = surface.exp_map(
    point, lengths[:, None] * np.column_stack([np.cos(turns), np.sin(turns)]), return_length=True
)
print(f"{surface.last.seconds:.3f} s for {len(ends)} lines; {np.sum(walked < 0.999 * lengths)} ended at a border")
picture.draw(
    "samples/out/directions.png",
    vertices,
    faces,
    colors=255 * np.array(wheel),
    lines=picture.joined(*ends.positions(vertices, faces).reshape(24, 60, 3)),
    points=point.positions(vertices, faces),
)
