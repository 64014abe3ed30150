"""Clusters of all vertices, the mean of some points, and a smooth closed curve; writes a picture.

Usage: python samples/means.py [MESH]      (needs samples/setup.sh once; writes samples/out/means.png)
"""

import mesh_input
import numpy as np
import picture
import vorogeo

mesh_set = mesh_input.load_from_command_line()
mesh = mesh_set.current_mesh()
vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
surface = vorogeo.Surface(vertices, faces)

clusters = surface.k_means(40)
print(
    f"{surface.last.seconds:.1f} s for 40 clusters in {len(clusters.energy) - 1} rounds; "
    f"the energy fell to {clusters.energy[-1] / clusters.energy[0]:.2f} of what it was"
)

# Points in a star on the side that is seen, joined by a spline; their mean, and its paths to them.
middle, size = vertices.mean(axis=0), np.ptp(vertices, axis=0)
turn = 2 * np.pi * np.arange(10) / 10
star = np.where(np.arange(10) % 2, 0.14, 0.26)[:, None] * np.column_stack([np.cos(turn), np.sin(turn)])
points = surface.snap(middle + size * np.column_stack([star + np.array([0.08, -0.07]), np.ones(10)]))
curve = surface.spline(points, closed=True, samples=24)
print(f"{surface.last.seconds:.1f} s for a spline of length {curve.length:g}")
mean = surface.frechet_mean(points)
print(f"{surface.last.seconds:.1f} s for a mean. {surface.last.remark}")

lines, joints, begin = [], [], 0
for path in [curve, *surface.path(mean, points)]:
    lines.append(path.points)
    joints.append(begin + np.column_stack([np.arange(len(path.points) - 1), np.arange(1, len(path.points))]))
    begin += len(path.points)
picture.draw(
    "samples/out/means.png",
    vertices,
    faces,
    regions=clusters.labels[faces].max(axis=1),
    lines=vorogeo.Polylines(np.vstack(lines), np.vstack(joints)),
    points=np.vstack([points.positions(vertices, faces), mean.positions(vertices, faces)]),
)
