"""The mean, the median and the medoid of some points, and the paths from the mean to them; writes a picture.

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
size = np.ptp(vertices, axis=0)
middle = surface.snap(vertices.mean(axis=0) + size * [0.1, -0.05, 1])

# Points all around the middle, some far away on one side.
random = np.random.default_rng(5)
turn, radius = (
    random.uniform(0, 2 * np.pi, 12),
    size.max() * np.append(random.uniform(0.03, 0.15, 8), [0.3, 0.35, 0.4, 0.45]),
)
turn[8:] = random.uniform(2.0, 2.6, 4)
points = surface.exp_map(middle, radius[:, None] * np.column_stack([np.cos(turn), np.sin(turn)]))

mean = surface.frechet_mean(points)
print(f"{surface.last.seconds:.2f} s for the mean. {surface.last.remark}")
median = surface.geometric_median(points)
print(f"{surface.last.seconds:.2f} s for the median. {surface.last.remark}")
best = surface.medoid(points)
for name, centre in [("mean", mean), ("median", median), ("medoid", points[best])]:
    distance = surface.distance(points, centre)
    print(f"{name}: sum of distances {distance.sum():.5g}, of their squares {(distance**2).sum():.5g}")
# Colours: the root of the sum of squares, which is least at the mean; with the paths from there.
squares = (surface.fields(points, method="exact") ** 2).sum(axis=0)
picture.draw(
    "samples/out/means.png",
    vertices,
    faces,
    values=np.sqrt(squares),
    lines=picture.joined(*(path.points for path in surface.path(mean, points))),
    points=np.vstack([place.positions(vertices, faces) for place in (points, mean, median)]),
)
