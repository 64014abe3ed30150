"""Distances in other metrics: a slope penalty, a painted cost, limbs, edge lengths, a lake, layers; writes pictures.

Usage: python samples/metrics.py      (needs samples/setup.sh once; writes samples/out/metric_*.png and metrics.png)
"""

from __future__ import annotations

import itertools

import matplotlib
import mesh_input
import numpy as np
import picture
import vorogeo
from numpy.typing import NDArray

matplotlib.use("agg")
from matplotlib import pyplot

LINES = 18


def joined(paths: list[vorogeo.GeodesicPath]) -> vorogeo.Polylines:
    """Several paths as one set of lines."""
    begins = np.cumsum([0] + [len(path.points) for path in paths])
    rows = [np.column_stack([np.arange(a, b - 1), np.arange(a + 1, b)]) for a, b in itertools.pairwise(begins)]
    return vorogeo.Polylines(np.vstack([path.points for path in paths]), np.vstack(rows).astype(np.int32))


def both(first: vorogeo.Polylines, second: vorogeo.Polylines) -> vorogeo.Polylines:
    """Two sets of lines as one."""
    edges = np.vstack([first.edges, second.edges + len(first.points)]).astype(np.int32)
    return vorogeo.Polylines(np.vstack([first.points, second.points]), edges)


def square(count: int) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
    """The unit square as a grid of count x count vertices."""
    x, y = np.meshgrid(np.linspace(0, 1, count), np.linspace(0, 1, count))
    a = (np.arange(count - 1)[:, None] * count + np.arange(count - 1)).ravel()
    lower = np.column_stack([a, a + 1, a + count + 1])
    upper = np.column_stack([a, a + count + 1, a + count])
    return np.column_stack([x.ravel(), y.ravel(), 0 * x.ravel()]), np.vstack([lower, upper]).astype(np.int32)


# Terrain: with a slope penalty, paths go round the hills that the shortest ones climb.
ground, faces = square(101)
x, y = ground[:, 0], ground[:, 1]
ground[:, 2] = 0.18 * np.exp(-40 * ((x - 0.45) ** 2 + (y - 0.5) ** 2)) + 0.12 * np.exp(
    -60 * ((x - 0.75) ** 2 + (y - 0.3) ** 2)
)
ends = [50 * 101 + 5] * 4, [25 * 101 + 97, 50 * 101 + 97, 70 * 101 + 97, 12 * 101 + 94]
shortest = vorogeo.GeodesicIndex(ground, faces).path(*ends)
slope = vorogeo.slope_cost(ground, faces, penalty=6)
index = vorogeo.GeodesicIndex(ground, faces, metric=slope)
cheapest = index.path(*ends)
for plain, cheap in zip(shortest, cheapest, strict=True):
    steps = np.linalg.norm(np.diff(cheap.points, axis=0), axis=1).sum()
    print(f"terrain: length {plain.length:.3f}, cheapest {steps:.3f} at the cost {cheap.length:.3f}")
picture.draw("samples/out/metric_terrain.png", ground, faces, slope.cost, lines=joined(shortest + cheapest))

# A cost painted on the bunny, in PyMeshLab: ten times as expensive on one side.
mesh_set = mesh_input.load(mesh_input.BUNNY)
x = mesh_set.current_mesh().vertex_matrix()[:, 0]
middle, steep = x.mean(), 40 / np.ptp(x)
mesh_set.compute_scalar_by_function_per_vertex(q=f"1 + 9 / (1 + exp({-steep} * (x - {middle})))")
found = mesh_set.compute_scalar_by_vorogeo_distance_from_given_point_per_vertex(
    vertex_index=0, metric="Vertex quality as cost"
)
bunny = mesh_set.current_mesh()
print(f"bunny: the farthest vertex costs {found['max_distance']:.4f}; the paint is kept as metric_cost")
cost = vorogeo.VertexCost(bunny.vertex_custom_scalar_attribute_array("metric_cost"))
painted = vorogeo.GeodesicIndex(bunny.vertex_matrix(), bunny.face_matrix(), metric=cost)
field = bunny.vertex_scalar_array()
lines = painted.isolines(field, LINES)
picture.draw("samples/out/metric_cost.png", painted.vertices, painted.faces, field, lines=lines)

# A fibre direction: the limbs of the cow, which are cheaper along than around.
skin, triangles = vorogeo.read_mesh(mesh_input.BUNNY.with_name("cow.obj"))
index = vorogeo.GeodesicIndex(skin, triangles, metric=vorogeo.curvature_tensor(skin, triangles, 8))
field = index.distance_field(int(skin[:, 1].argmax()))
print(f"cow: the farthest vertex costs {field.max():.4f}")
picture.draw("samples/out/metric_fibres.png", skin, triangles, field, lines=index.isolines(field, LINES))

# Lengths from elsewhere: the hyperbolic plane, as the distances of the ends of each edge.
plane, faces = square(81)
plane[:, 1] += 0.3
corner = plane[faces]
first, second = corner[:, [1, 2, 0]], corner[:, [2, 0, 1]]
lengths = np.arccosh(1 + ((first - second) ** 2).sum(-1) / (2 * first[..., 1] * second[..., 1]))
index = vorogeo.GeodesicIndex(plane, faces, metric=vorogeo.EdgeLengths(lengths))
field = index.distance_field(24 * 81 + 40)
fan = joined(index.path([24 * 81 + 40] * 7, [80 * 81 + 13 * k for k in range(7)]))
lines = both(fan, index.isolines(field, LINES))
picture.draw("samples/out/metric_lengths.png", plane, faces, field, lines=lines)

# Costs that jump at edges: a lake that is five times as expensive, and layers that are cheap in different directions.
flat, faces = square(61)
middle = flat[faces].mean(axis=1)
lake = np.hypot(middle[:, 0] - 0.5, middle[:, 1] - 0.5) < 0.25
metric = vorogeo.FaceCost(np.where(lake, 5.0, 1.0))
fan = joined(
    vorogeo.exact_path(flat, faces, [30 * 61 + 3] * 9, [57 + 61 * (6 + 6 * k) for k in range(9)], metric=metric)
)
picture.draw("samples/out/metric_faces.png", flat, faces, regions=lake.astype(int), lines=fan)

layer = (middle[:, 1] * 4).astype(int)
cheap = np.array([[1, 1, 0], [1, -1, 0]])[layer % 2] / np.sqrt(2)
metric = vorogeo.FaceTensor(9 * np.eye(3) - 8 * cheap[:, :, None] * cheap[:, None, :])
fan = joined(vorogeo.exact_path(flat, faces, [30] * 9, [60 * 61 + 6 + 6 * k for k in range(9)], metric=metric))
picture.draw("samples/out/metric_layers.png", flat, faces, regions=layer, lines=fan)

figure, axes = pyplot.subplots(2, 3, figsize=(11, 6.6))
titles = {
    "terrain": "slope penalty: shortest and cheapest paths",
    "cost": "vertex cost, ten times as dear on the right",
    "fibres": "tensor: limbs cheaper along than around",
    "lengths": "edge lengths of the hyperbolic plane",
    "faces": "face cost: round a lake five times as dear",
    "layers": "face tensor: cheap along one diagonal or the other",
}
for axis, (name, title) in zip(axes.flat, titles.items(), strict=True):
    axis.imshow(pyplot.imread(f"samples/out/metric_{name}.png"))
    axis.set_title(title, fontsize=10)
    axis.axis("off")
figure.tight_layout()
figure.savefig("samples/out/metrics.png", dpi=90)
print("written: samples/out/metrics.png")
