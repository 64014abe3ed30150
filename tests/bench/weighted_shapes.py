"""Surfaces with a metric that jumps at edges, and their distances by formulas: layers, a slab with a hole, a disc."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
import vorogeo
from numpy.typing import NDArray

Floats = NDArray[np.float64]

#: Places on the border of the disc from which formulas take the least.
PLACES = 1440


class Shape(NamedTuple):
    """A mesh with a metric, a source, and the distances of all vertices; NaN where there is no formula."""

    name: str
    vertices: Floats
    faces: NDArray[np.int32]
    metric: vorogeo.FaceCost | vorogeo.FaceTensor
    source: int
    exact: Floats


def all_shapes(cells: int) -> list[Shape]:
    """With 2 cells^2 faces each."""
    return [
        layers("two half-planes, 3 : 1", cells, [0.5], [3.0, 1.0]),
        layers("two half-planes, 30 : 1", cells, [0.5], [30.0, 1.0]),
        layers("three layers, 2 : 1 : 4", cells, [0.25, 0.75], [2.0, 1.0, 4.0]),
        slab(cells),
        disc(cells),
        tensor_layers(cells),
    ]


def square(cells: int) -> tuple[Floats, NDArray[np.int32]]:
    """The unit square; its diagonals all run the same way."""
    x, y = np.meshgrid(np.linspace(0, 1, cells + 1), np.linspace(0, 1, cells + 1))
    a = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).ravel()
    lower = np.column_stack([a, a + 1, a + cells + 2])
    upper = np.column_stack([a, a + cells + 2, a + cells + 1])
    return np.column_stack([x.ravel(), y.ravel(), 0 * x.ravel()]), np.vstack([lower, upper]).astype(np.int32)


def nearest(vertices: Floats, x: float, y: float) -> int:
    """The vertex nearest to a place."""
    return int(np.hypot(vertices[:, 0] - x, vertices[:, 1] - y).argmin())


def layers(name: str, cells: int, borders: Sequence[float], costs: Sequence[float]) -> Shape:
    """Horizontal layers: paths go straight through by Snell's law, or run along a border and come back."""
    vertices, faces = square(cells)
    cost = np.asarray(costs)[np.searchsorted(borders, vertices[faces].mean(axis=1)[:, 1])]
    source = nearest(vertices, 0.2, 0.1)
    exact = np.array([layered_distance(vertices[source], p, borders, costs) for p in vertices])
    return Shape(name, vertices, faces, vorogeo.FaceCost(cost), source, exact)


def layered_distance(p: Floats, q: Floats, borders: Sequence[float], costs: Sequence[float]) -> float:
    """The least over the way through by Snell's law and those that run along one of the borders."""
    low, high = sorted((p[1], q[1]))
    across = abs(p[0] - q[0])
    edges = np.array([-np.inf, *borders, np.inf])
    cost = np.asarray(costs)

    def heights(a: float, b: float) -> Floats:
        return np.maximum(0.0, np.minimum(edges[1:], max(a, b)) - np.maximum(edges[:-1], min(a, b)))

    best = np.inf
    through = heights(low, high)
    if not through.any():  # along a border or within a layer of no height
        at = np.isclose(edges, low)
        near = np.concatenate([cost[np.flatnonzero(at[1:])], cost[np.flatnonzero(at[:-1])]])
        best = across * (near.min() if near.size else cost[np.searchsorted(borders, low)])
    else:
        # A ray is the shortest path among those with its slowness along the layers.
        n, h = cost[through > 0], through[through > 0]
        slow, fast = 0.0, float(n.min())
        for _ in range(200):
            s = 0.5 * (slow + fast)
            reached = (h * s / np.sqrt(np.maximum(n * n - s * s, 1e-300))).sum()
            slow, fast = (s, fast) if reached < across else (slow, s)
        root = np.sqrt(np.maximum(n * n - slow * slow, 1e-300))
        best = (h * n * n / root).sum() + slow * max(0.0, across - (h * slow / root).sum())
    for k, border in enumerate(borders):
        s = min(cost[k], cost[k + 1])
        h = heights(p[1], border) + heights(q[1], border)
        n, h = cost[h > 0], h[h > 0]
        if np.any(n <= s):
            continue
        root = np.sqrt(n * n - s * s)
        if (h * s / root).sum() <= across:
            best = min(best, (h * root).sum() + s * across)
    return float(best)


def slab(cells: int) -> Shape:
    """A wall of cost 30 with a hole in it: from below to above, paths are taut strings through the hole."""
    vertices, faces = square(cells)
    middle = vertices[faces].mean(axis=1)
    left, right, low, high = 0.6, 0.7, 0.45, 0.55
    wall = (middle[:, 1] > low) & (middle[:, 1] < high) & ((middle[:, 0] < left) | (middle[:, 0] > right))
    source = nearest(vertices, 0.2, 0.1)
    start = vertices[source, :2]
    exact = np.full(len(vertices), np.nan)
    above = vertices[:, 1] > high - 1e-9
    corners = [np.array([x, y]) for x in (left, right) for y in (low, high)]

    def is_free(a: Floats, b: Floats) -> bool:
        """Whether a step passes both ends of the hole between its corners."""
        for y in (low, high):
            if min(a[1], b[1]) - 1e-12 <= y <= max(a[1], b[1]) + 1e-12 and abs(a[1] - b[1]) > 1e-12:
                x = a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
                if not left - 1e-9 <= x <= right + 1e-9:
                    return False
        return True

    def string(*points: Floats) -> float:
        steps = list(itertools.pairwise(points))
        return sum(float(np.hypot(*(b - a))) for a, b in steps) if all(is_free(a, b) for a, b in steps) else np.inf

    for v in np.flatnonzero(above):
        q = vertices[v, :2]
        bends = [(), *((c,) for c in corners), *((c, d) for c in corners for d in corners if c[1] < d[1])]
        exact[v] = min(string(start, *bend, q) for bend in bends)
    metric = vorogeo.FaceCost(np.where(wall, 30.0, 1.0))
    return Shape("slab of 30 with a hole", vertices, faces, metric, source, exact)


def disc(cells: int) -> Shape:
    """A disc of cost 1.3 in one of cost 1: paths refract in it, or go round it along its border."""
    radius, cost, rings = 0.4, 1.3, cells // 2
    around = 2 * cells
    inner = max(1, round(radius * rings))
    heights = np.concatenate([np.linspace(0, radius, inner + 1)[1:], np.linspace(radius, 1, rings - inner + 1)[1:]])
    angle = 2 * np.pi * np.arange(around) / around
    ring = np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])
    vertices = np.vstack([np.zeros((1, 3)), *(h * ring for h in heights)])
    a, b = np.arange(around), (np.arange(around) + 1) % around
    faces = [np.column_stack([0 * a, 1 + a, 1 + b])]
    for k in range(1, len(heights)):
        i, o = 1 + (k - 1) * around, 1 + k * around
        faces += [np.column_stack([i + a, o + a, o + b]), np.column_stack([i + a, o + b, i + b])]
    triangles = np.vstack(faces).astype(np.int32)
    inside = np.hypot(*vertices[triangles].mean(axis=1)[:, :2].T) < radius
    source = nearest(vertices, -0.8, 0.0)
    exact = disc_distances(vertices[source, :2], vertices[:, :2], radius, cost)
    return Shape("disc of 1.3", vertices, triangles, vorogeo.FaceCost(np.where(inside, cost, 1.0)), source, exact)


def disc_distances(p: Floats, points: Floats, radius: float, cost: float) -> Floats:
    """From a point outside: straight or round the disc, or into it and out of it at two places of its border."""
    angle = 2 * np.pi * np.arange(PLACES) / PLACES
    places = radius * np.column_stack([np.cos(angle), np.sin(angle)])
    at_border = outside_distances(p, places, radius)
    chords = cost * 2 * radius * np.abs(np.sin(0.5 * (angle[:, None] - angle)))
    through = (at_border[:, None] + chords).min(axis=0)
    exact = np.empty(len(points))
    for i, q in enumerate(points):
        if np.hypot(*q) < radius * (1 - 1e-9):
            exact[i] = (at_border + cost * np.hypot(*(places - q).T)).min()
        else:
            exact[i] = min(
                outside_distances(p, q[None], radius)[0], (through + outside_distances(q, places, radius)).min()
            )
    return exact


def outside_distances(p: Floats, q: Floats, radius: float) -> Floats:
    """Between points outside a disc: the straight line, or two tangents and the arc between."""
    straight = np.hypot(*(q - p).T)
    far_p, far_q = np.hypot(*p), np.hypot(*q.T)
    cosine = np.clip((q @ p) / (far_p * far_q), -1, 1)
    arc = np.arccos(cosine) - np.arccos(np.minimum(1, radius / far_p)) - np.arccos(np.minimum(1, radius / far_q))
    tangents = np.sqrt(np.maximum(0, far_p**2 - radius**2)) + np.sqrt(np.maximum(0, far_q**2 - radius**2))
    return np.where(arc <= 0, straight, tangents + radius * arc)


def tensor_layers(cells: int) -> Shape:
    """Two layers of tensors: from the lower to the upper one, the crossing is the least of a convex function."""
    vertices, faces = square(cells)
    tensors = np.array([[[2.0, 1, 0], [1, 3, 0], [0, 0, 1]], [[4.0, 0, 0], [0, 1, 0], [0, 0, 1]]])
    metric = vorogeo.FaceTensor(tensors[(vertices[faces].mean(axis=1)[:, 1] > 0.5).astype(int)])
    source = nearest(vertices, 0.4, 0.2)
    exact = np.full(len(vertices), np.nan)
    upper = vertices[:, 1] > 0.5 - 1e-9
    exact[upper] = [crossing_distance(vertices[source, :2], q[:2], tensors[:, :2, :2]) for q in vertices[upper]]
    return Shape("two layers of tensors", vertices, faces, metric, source, exact)


def crossing_distance(p: Floats, q: Floats, tensors: Floats) -> float:
    """From below the line y = 0.5 to above it, within the unit square; by scipy."""
    from scipy.optimize import minimize_scalar

    def length(x: float) -> float:
        first, second = np.array([x - p[0], 0.5 - p[1]]), np.array([q[0] - x, q[1] - 0.5])
        return float(np.sqrt(first @ tensors[0] @ first) + np.sqrt(second @ tensors[1] @ second))

    solve: Callable[..., object] = minimize_scalar
    found = solve(length, bounds=(0, 1), method="bounded", options={"xatol": 1e-10})
    return float(found.fun)  # type: ignore[attr-defined]
