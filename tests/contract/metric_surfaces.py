"""The surfaces of the table on which paths cost something else than their length, also with formulas."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import surfaces
import vorogeo
from surfaces import Floats, Rng, Shape, shape

#: Twice the largest errors in docs/figures.md: costs that vary (25 cells), costs of faces.
OF_VARYING_COST = 3e-3
OF_FACES = 7.2e-3
STRETCH = np.array([[2.0, 0.6, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
TENSOR = STRETCH.T @ STRETCH


def stretched(a: Floats, b: Floats) -> Floats:
    """Lengths of straight lines on the stretched plane."""
    return surfaces.straight(a @ STRETCH.T, b @ STRETCH.T)


def edge_lengths(base: Shape) -> Shape:
    """A shape given by the lengths of its edges."""
    corner = base.vertices[base.faces]
    sides = np.linalg.norm(corner[:, [2, 0, 1]] - corner[:, [1, 2, 0]], axis=2)
    return replace(base, name=f"{base.name} by edge lengths", metric=vorogeo.EdgeLengths(sides))


def times(base: Shape, metric: vorogeo.VertexCost | vorogeo.FaceCost, factor: float, slack: float) -> Shape:
    """A shape with one cost everywhere."""
    name = f"{base.name} with one {type(metric).__name__}"
    return replace(base, name=name, metric=metric, slack=slack, between=lambda a, b: factor * base.between(a, b))


def half_plane() -> Shape:
    """The hyperbolic half-plane between heights of 0.5 and 1.5: a cost of 1 / y."""
    vertices, faces = surfaces.grid(np.linspace(0, 1, 26), np.linspace(0.5, 1.5, 26))

    def between(a: Floats, b: Floats) -> Floats:
        square = (surfaces.steps(a, b) ** 2).sum(axis=2)
        return np.arccosh(1 + square / (2 * a[:, None, 1] * b[None, :, 1]))

    cost = vorogeo.VertexCost(1 / vertices[:, 1])
    # Paths are arcs that bend upwards; from the middle they stay on the rectangle.
    sources = np.array([13 * 26 + 12, 2 * 26 + 12], np.int32)
    return shape("half-plane", (vertices, faces), between, metric=cost, slack=OF_VARYING_COST, sources=sources)


def refraction(dear: float = 3.0) -> Shape:
    """Land above and water below: paths refract by Snell's law, and go along the shore where that is cheaper."""
    vertices, faces = surfaces.plain_grid(17, 17, 1.0, 1.0)
    below = vertices[faces].mean(axis=1)[:, 1] < 0.5
    metric = vorogeo.FaceCost(np.where(below, dear, 1.0))

    def between(a: Floats, b: Floats) -> Floats:
        across = np.abs(b[None, :, 0] - a[:, None, 0])
        deep, depth = np.maximum(0.5 - a[:, None, 1], 0), np.maximum(0.5 - b[None, :, 1], 0)
        high, height = np.maximum(a[:, None, 1] - 0.5, 0), np.maximum(b[None, :, 1] - 0.5, 0)
        # Ends on one side: straight, or from water along the shore, reached at the angle whose sine is 1 / dear.
        line = np.hypot(across, b[None, :, 1] - a[:, None, 1])
        slant = np.sqrt(1 - 1 / dear**2)
        along = across - (deep + depth) / (dear * slant)
        shore = np.where(along >= 0, dear * (deep + depth) / slant + along, np.inf)
        same_water, same_land = np.minimum(dear * line, shore), line
        # Ends on both sides: bisection for the crossing at which the sines have the ratio of the costs.
        down, up = deep + depth, high + height
        low, top = np.zeros_like(across), across.copy()
        for _ in range(60):
            x = (low + top) / 2
            with np.errstate(invalid="ignore", divide="ignore"):
                late = dear * x / np.hypot(x, down) > (across - x) / np.hypot(across - x, up)
            low, top = np.where(late, low, x), np.where(late, x, top)
        bent = dear * np.hypot(low, down) + np.hypot(across - low, up)
        in_water = [a[:, None, 1] <= 0.5, b[None, :, 1] <= 0.5]
        return np.where(in_water[0] & in_water[1], same_water, np.where(in_water[0] | in_water[1], bent, same_land))

    return shape("shore", (vertices, faces), between, metric=metric, slack=OF_FACES)


def drifting(base: Shape, drift: Floats) -> Shape:
    """A shape on which a step v costs drift . v besides its length, so that ways back cost something else."""
    identity = np.broadcast_to(np.eye(3), (len(base.faces), 3, 3))
    tensors = base.metric.tensors if isinstance(base.metric, vorogeo.FaceTensor) else identity
    metric = vorogeo.FaceRanders(tensors, np.broadcast_to(drift, (len(base.faces), 3)))

    def between(a: Floats, b: Floats) -> Floats:
        return base.between(a, b) + surfaces.steps(a[:, :3], b[:, :3]) @ drift

    return replace(base, name=f"{base.name} with a drift", metric=metric, between=between)


def metrics(random: Rng, saddle: Shape) -> list[Shape]:
    """Shapes with metrics of their own; small ones, since building an index with values of faces takes long."""
    flat, tube = surfaces.plane(random, 11, 8), surfaces.prism(8)
    everywhere = np.broadcast_to(TENSOR, (len(flat.vertices), 3, 3))
    on_faces = np.broadcast_to(TENSOR, (len(flat.faces), 3, 3))
    return [
        edge_lengths(saddle),
        times(tube, vorogeo.VertexCost(np.full(len(tube.vertices), 3.0)), 3.0, 1e-9),
        times(tube, vorogeo.FaceCost(np.full(len(tube.faces), 3.0)), 3.0, 1e-9),
        replace(flat, name="plane with one VertexTensor", metric=vorogeo.VertexTensor(everywhere), between=stretched),
        replace(flat, name="plane with one FaceTensor", metric=vorogeo.FaceTensor(on_faces), between=stretched),
        half_plane(),
        refraction(),
    ]  # fmt: skip
