"""Small surfaces on which every distance has a formula, in every metric: the contract is tested on this table."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import vorogeo
from numpy.typing import NDArray
from vorogeo.metrics import Metric

Floats = NDArray[np.float64]
Ids = NDArray[np.int32]
Mesh = tuple[Floats, Ids]
Rng = np.random.Generator


@dataclass(frozen=True, eq=False)
class Shape:
    """A mesh, a metric and its distances.

    `chart` gives each vertex coordinates that are linear over every face; `between` is the distance of each of k rows
    of such coordinates from each of m others. `slack` is the relative error that an answer called exact may have: the
    metric's own, or rounding. `sources` are vertices from which `between` holds.
    """

    name: str
    vertices: Floats
    faces: Ids
    between: Callable[[Floats, Floats], Floats]
    chart: Floats
    sources: Ids
    metric: Metric | None = None
    slack: float = 1e-9

    def fields(self, sources: vorogeo.SurfacePoints | Ids | list[int]) -> Floats:
        """The distances of all vertices from each source."""
        return self.between(self.charted(sources), self.chart)

    def matrix(self, points: Ids, others: Ids) -> Floats:
        """The distances from vertices to other vertices, a row for each of the former."""
        return self.between(self.chart[points], self.chart[others])

    def charted(self, points: vorogeo.SurfacePoints | Ids | list[int]) -> Floats:
        """The coordinates of vertices, or of points in faces."""
        if isinstance(points, vorogeo.SurfacePoints):
            return np.einsum("kc,kcd->kd", points.barycentric, self.chart[self.faces[points.faces]])
        return self.chart[np.atleast_1d(points)]

    def __repr__(self) -> str:
        return self.name


def grid(x: Floats, y: Floats) -> Mesh:
    """A flat rectangle with these columns and rows of vertices."""
    across, up = np.meshgrid(x, y)
    corner = (np.arange(len(y) - 1)[:, None] * len(x) + np.arange(len(x) - 1)).ravel()
    lower = np.column_stack([corner, corner + 1, corner + len(x) + 1])
    upper = np.column_stack([corner, corner + len(x) + 1, corner + len(x)])
    return np.column_stack([across.ravel(), up.ravel(), np.zeros(across.size)]), np.vstack([lower, upper]).astype(
        np.int32
    )


def plain_grid(columns: int, rows: int, width: float, height: float) -> Mesh:
    """A flat rectangle of equal cells."""
    return grid(np.linspace(0, width, columns), np.linspace(0, height, rows))


def shape(name: str, mesh: Mesh, between: Callable[[Floats, Floats], Floats], **more: object) -> Shape:
    """A shape whose chart is its positions and whose sources lie all over it, unless `more` says otherwise."""
    count = len(mesh[0])
    spread = np.linspace(1, count - 2, 5).astype(np.int32)
    return Shape(**{"name": name, "vertices": mesh[0], "faces": mesh[1], "between": between, "chart": mesh[0],
                    "sources": spread, **more})  # fmt: skip


def steps(a: Floats, b: Floats) -> Floats:
    """The steps from each row of `a` to each row of `b`."""
    return b[None] - a[:, None]


def straight(a: Floats, b: Floats) -> Floats:
    """Lengths of straight lines."""
    return np.linalg.norm(steps(a, b), axis=2)


def shaken_plane(random: Rng, columns: int, rows: int) -> Mesh:
    """A rectangle of 2 by 1.5 whose inner vertices are moved at random, by up to a fifth of a cell."""
    vertices, faces = plain_grid(columns, rows, 2.0, 1.5)
    inner = (vertices[:, 0] % 2.0 > 0) & (vertices[:, 1] % 1.5 > 0)
    cell = np.array([2.0 / (columns - 1), 1.5 / (rows - 1)])
    vertices[inner, :2] += cell * random.uniform(-0.2, 0.2, (int(inner.sum()), 2))
    return vertices, faces


def plane(random: Rng, columns: int = 21, rows: int = 16) -> Shape:
    """A flat rectangle."""
    return shape("plane", shaken_plane(random, columns, rows), straight)


def needles() -> Shape:
    """A flat rectangle with columns up to ten thousand times narrower than high."""
    widths = np.tile([0.1, 1e-3, 1e-5, 1e-3], 5)
    return shape("needles", grid(np.r_[0, np.cumsum(widths)], np.linspace(0, 1, 11)), straight)


def prism(rows: int = 14) -> Shape:
    """An open tube with flat sides, unrolled."""
    sides = 12
    angle = np.tile(2 * np.pi * np.arange(sides) / sides, rows)
    vertices = np.column_stack([np.cos(angle), np.sin(angle), np.repeat(np.linspace(0, 4, rows), sides)])
    low = np.arange(sides * (rows - 1))
    beside = low - low % sides + (low + 1) % sides
    faces = np.vstack(
        [np.column_stack([low, beside, beside + sides]), np.column_stack([low, beside + sides, low + sides])]
    )
    side = 2 * np.sin(np.pi / sides)

    def along(p: Floats) -> Floats:
        turn = np.arctan2(p[:, 1], p[:, 0]) / (2 * np.pi) % 1 * sides
        facet = np.floor(turn + 1e-9)
        corner = np.cos(2 * np.pi * facet / sides) + 1j * np.sin(2 * np.pi * facet / sides)
        return side * facet + np.abs(p[:, 0] + 1j * p[:, 1] - corner)

    def between(a: Floats, b: Floats) -> Floats:
        around = np.abs(along(b)[None] - along(a)[:, None])
        return np.hypot(np.minimum(around, sides * side - around), b[None, :, 2] - a[:, None, 2])

    return shape("prism", (vertices, faces.astype(np.int32)), between)


def cone(name: str, tilt: Floats) -> Shape:
    """Flat triangles around an apex, whose rays rise by these angles: a cone if they are equal, a saddle if not."""
    rays, rings = len(tilt), 12
    turn = 2 * np.pi * np.arange(rays) / rays
    ray = np.column_stack([np.cos(tilt) * np.cos(turn), np.cos(tilt) * np.sin(turn), np.sin(tilt)])
    sector = float(np.arccos(ray[0] @ ray[1]))
    chart = np.vstack([np.zeros((1, rays)), *(ring / rings * np.eye(rays) for ring in range(1, rings + 1))])
    inner = 1 + np.arange(rays * (rings - 1))
    beside = inner + np.where(inner % rays == 0, 1 - rays, 1)
    first = np.column_stack([np.zeros(rays), 1 + np.arange(rays), 1 + (np.arange(rays) + 1) % rays])
    faces = [
        first,
        np.column_stack([inner, inner + rays, beside + rays]),
        np.column_stack([inner, beside + rays, beside]),
    ]

    def polar(c: Floats) -> tuple[Floats, Floats]:
        pairs = c + np.roll(c, -1, axis=1)
        which = pairs.argmax(axis=1)
        rows = np.arange(len(c))
        place = c[rows, which] + c[rows, (which + 1) % rays] * (np.cos(sector) + 1j * np.sin(sector))
        return np.abs(place), which * sector + np.angle(place)

    def between(a: Floats, b: Floats) -> Floats:
        (r, phi), (s, psi) = polar(a), polar(b)
        apart = np.abs(psi[None] - phi[:, None]) % (rays * sector)
        apart = np.minimum(apart, rays * sector - apart)
        r, s = r[:, None], s[None]
        chord = np.sqrt(np.maximum(0, (r - s) ** 2 + 4 * r * s * np.sin(np.minimum(apart, np.pi) / 2) ** 2))
        return np.where(apart < np.pi, chord, r + s)

    return shape(name, (chart @ ray, np.vstack(faces).astype(np.int32)), between, chart=chart)


def parts() -> Shape:
    """Two squares that touch but are not joined, with vertices at the same places, and an isolated vertex."""
    square, faces = plain_grid(13, 13, 1.0, 1.0)
    vertices = np.vstack([square, square + np.array([1.0, 0, 0]), [[0.5, 0.5, 0]]])
    part = np.repeat([0.0, 1.0, 2.0], [len(square), len(square), 1])
    chart = np.column_stack([vertices, part])

    def between(a: Floats, b: Floats) -> Floats:
        return np.where(np.abs(steps(a[:, 3:], b[:, 3:])[..., 0]) < 0.5, straight(a[:, :3], b[:, :3]), np.inf)

    sources = np.array([3, 100, 200, 300], np.int32)
    return shape("parts", (vertices, np.vstack([faces, faces + len(square)]).astype(np.int32)), between, chart=chart,
                 sources=sources)  # fmt: skip


def repeats(random: Rng) -> Shape:
    """A flat rectangle with faces given twice, turned over, or naming a vertex twice."""
    vertices, faces = shaken_plane(random, 21, 16)
    faces = faces.copy()
    faces[::3] = faces[::3, ::-1]
    twice = faces[::4].copy()
    folded = faces[::5].copy()
    folded[:, 2] = folded[:, 0]
    return shape("repeats", (vertices, np.vstack([faces, folded, twice])), straight)


def hole() -> Shape:
    """A flat rectangle of 4 by 3 without [4/3, 8/3] by [1, 2]: paths bend at the corners of the hole."""
    vertices, faces = plain_grid(25, 19, 4.0, 3.0)
    low, high = np.array([4 / 3, 1.0]), np.array([8 / 3, 2.0])
    middle = vertices[faces].mean(axis=1)[:, :2]
    faces = faces[~((middle > low) & (middle < high)).all(axis=1)]
    used = np.unique(faces)
    vertices, faces = vertices[used], np.searchsorted(used, faces).astype(np.int32)
    corners = np.array([low, [high[0], low[1]], high, [low[0], high[1]]])  # round the hole
    sides = straight(corners, corners)
    # Between opposite ones: along two sides.
    sides[[0, 1, 2, 3], [2, 3, 0, 1]] = (high - low).sum()

    def seen(a: Floats, b: Floats) -> Floats:
        """Lengths of straight lines, infinite where one crosses the hole."""
        step = steps(a, b)
        with np.errstate(divide="ignore", invalid="ignore"):
            first, last = (low - a)[:, None] / step, (high - a)[:, None] / step
        is_still = np.abs(step) < 1e-9
        is_beside = is_still & ((a < low + 1e-9) | (a > high - 1e-9))[:, None]
        begin = np.where(is_still, 0.0, np.minimum(first, last)).max(axis=2).clip(min=0.0)
        end = np.where(is_still, 1.0, np.maximum(first, last)).min(axis=2).clip(max=1.0)
        is_open = is_beside.any(axis=2) | (end - begin < 1e-9)
        return np.where(is_open, np.linalg.norm(step, axis=2), np.inf)

    def between(a: Floats, b: Floats) -> Floats:
        a, b = a[:, :2], b[:, :2]
        to_corner = (seen(a, corners)[:, :, None] + sides).min(axis=1)
        round_it = (to_corner[:, :, None] + seen(corners, b)).min(axis=1)
        return np.minimum(seen(a, b), round_it)

    return shape("hole", (vertices, faces), between)


def book() -> Shape:
    """Three flat pages of 2 by 1 that share a side, the spine: any two of them are one plane when unfolded."""
    columns, rows, pages = 17, 9, 3
    flat, faces = plain_grid(columns, rows, 2.0, 1.0)
    page, beyond = np.arange(pages)[:, None], np.arange(len(flat)) - columns  # the spine is the first row of each
    ids = np.where(beyond < 0, np.arange(len(flat)), columns + page * (len(flat) - columns) + beyond)
    # Along the spine, and away from it on each page.
    chart = np.zeros((columns + pages * (len(flat) - columns), 1 + pages))
    for p in range(pages):
        chart[ids[p], 0], chart[ids[p], 1 + p] = flat[:, 0], flat[:, 1]
    turn = 2 * np.pi * np.arange(pages) / pages
    vertices = np.column_stack([chart[:, 1:] @ np.cos(turn), chart[:, 1:] @ np.sin(turn), chart[:, 0]])

    def between(a: Floats, b: Floats) -> Floats:
        out, away = a[:, 1:].max(axis=1)[:, None], b[:, 1:].max(axis=1)[None]
        same = a[:, 1:].argmax(axis=1)[:, None] == b[:, 1:].argmax(axis=1)[None]
        return np.hypot(steps(a, b)[..., 0], np.where(same, out - away, out + away))

    return shape("book", (vertices, np.vstack([each[faces] for each in ids]).astype(np.int32)), between, chart=chart)
