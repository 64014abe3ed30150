"""Surfaces of the table with holes, slits, edges of three faces, several parts, and faces that are none."""

from __future__ import annotations

import numpy as np
from surfaces import Floats, Ids, Mesh, Rng, Shape, plain_grid, shaken_plane, shape, steps, straight


def hole() -> Shape:
    """A flat square with a square hole, round whose corners paths bend."""
    vertices, faces = plain_grid(19, 19, 3.0, 3.0)
    middle = np.abs(vertices[faces].mean(axis=1)[:, :2] - 1.5)
    mesh = without_lone_vertices(vertices, faces[(middle > 0.5).any(axis=1)])
    corners = np.array([[1.0, 1, 0], [2, 1, 0], [2, 2, 0], [1, 2, 0]])
    rim = np.array([[0, 1, 2, 1], [1, 0, 1, 2], [2, 1, 0, 1], [1, 2, 1, 0]], float)

    def seen(a: Floats, b: Floats) -> Floats:
        """Lengths of the straight lines that miss the hole (Liang, Barsky 1984), else infinity."""
        step = steps(a, b)[..., :2]
        with np.errstate(divide="ignore", invalid="ignore"):
            ends = np.stack([(1 + 1e-9 - a[:, None, :2]) / step, (2 - 1e-9 - a[:, None, :2]) / step])
        outside = ((step == 0) & (np.abs(a[:, None, :2] - 1.5) >= 0.5 - 1e-9)).any(axis=2)
        ends = np.where(step == 0, np.array([-np.inf, np.inf])[:, None, None, None], ends)
        enter, leave = ends.min(axis=0).max(axis=2), ends.max(axis=0).min(axis=2)
        blocked = ~outside & (np.maximum(enter, 0) < np.minimum(leave, 1))
        return np.where(blocked, np.inf, straight(a, b))

    def between(a: Floats, b: Floats) -> Floats:
        bent = seen(a, corners)[:, :, None] + rim
        return np.minimum(seen(a, b), (bent.min(axis=1)[:, :, None] + seen(corners, b)[None]).min(axis=1))

    return shape("hole", mesh, between)


def slit() -> Shape:
    """A flat square cut from above to its middle: two vertices at each place of the cut, joined at its end only."""
    vertices, faces = plain_grid(17, 17, 2.0, 2.0)
    cut = np.flatnonzero((np.abs(vertices[:, 0] - 1) < 1e-9) & (vertices[:, 1] > 1 + 1e-9))
    right = vertices[faces].mean(axis=1)[:, 0] > 1
    number = np.arange(len(vertices))
    number[cut] = len(vertices) + np.arange(len(cut))
    faces = np.where(right[:, None], number[faces], faces).astype(np.int32)
    side = np.sign((vertices[:, 0] - 1).round(9))
    side[cut] = -1
    chart = np.vstack(
        [np.column_stack([vertices[:, :2], side]), np.column_stack([vertices[cut, :2], np.ones(len(cut))])]
    )
    tip = np.array([1.0, 1.0])

    def between(a: Floats, b: Floats) -> Floats:
        a, b = a[:, None], b[None]
        share = np.divide(1 - a[..., 0], b[..., 0] - a[..., 0], out=np.ones(np.broadcast(a, b).shape[:2]),
                          where=a[..., 0] != b[..., 0])  # fmt: skip
        height = a[..., 1] + share * (b[..., 1] - a[..., 1])
        same = np.linalg.norm(a[..., :2] - b[..., :2], axis=2)
        round_tip = np.linalg.norm(a[..., :2] - tip, axis=2) + np.linalg.norm(b[..., :2] - tip, axis=2)
        return np.where((np.sign(a[..., 2]) * np.sign(b[..., 2]) < 0) & (height > 1), round_tip, same)

    return shape("slit", (np.vstack([vertices, vertices[cut]]), faces), between, chart=chart)


def book() -> Shape:
    """Three flat pages that share one edge line: edges of three faces."""
    vertices, faces = plain_grid(9, 13, 0.8, 1.2)
    spine = vertices[:, 0] == 0
    pages, charts, every = [vertices], [page_chart(vertices, 0)], [faces]
    for page in (1, 2):
        number = np.where(spine, np.arange(len(vertices)), -1)
        number[~spine] = sum(map(len, pages)) + np.arange(int((~spine).sum()))
        turn = 2 * np.pi * page / 3
        x, y, _ = vertices[~spine].T
        pages.append(np.column_stack([x * np.cos(turn), y, x * np.sin(turn)]))
        charts.append(page_chart(vertices[~spine], page))
        every.append(number[faces])

    def between(a: Floats, b: Floats) -> Floats:
        step = np.abs(steps(a, b))
        return np.hypot(step[..., 0], step[..., 1:].sum(axis=2))

    return shape("book", (np.vstack(pages), np.vstack(every).astype(np.int32)), between, chart=np.vstack(charts))


def page_chart(flat: Floats, page: int) -> Floats:
    """Height, and the distance from the spine in the column of this page."""
    chart = np.zeros((len(flat), 4))
    chart[:, 0], chart[:, 1 + page] = flat[:, 1], flat[:, 0]
    return chart


def parts() -> Shape:
    """Two squares with vertices at the same places along their border, not joined, and a vertex without a face."""
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


def without_lone_vertices(vertices: Floats, faces: Ids) -> Mesh:
    """The mesh without the vertices that no face names."""
    used, number = np.unique(faces, return_inverse=True)
    return vertices[used], number.reshape(-1, 3).astype(np.int32)
