"""Areas of regions and inside curves, with their borders and volumes, against sums over faces and formulas."""

from __future__ import annotations

from typing import Any

import ask
import numpy as np
import pytest
import table
import vorogeo
from surfaces import Floats, Rng, Shape
from test_curves import AROUND, BOX, PRISM, torus
from test_cut import areas


def border_of(shape: Shape, mask: Any) -> float:
    """The length of the edges with exactly one face in the mask."""
    corners = shape.faces[mask & table.is_face(shape)]
    edges = np.sort(np.vstack([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]]), axis=1)
    edges, count = np.unique(edges, axis=0, return_counts=True)
    ends = shape.vertices[edges[count == 1]]
    return float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum())


@pytest.mark.parametrize("shape", table.LENGTHS, ids=str)
def test_regions_have_the_area_of_their_faces_and_the_length_of_their_edges(shape: Shape, random: Rng) -> None:
    surface = ask.surface(shape)
    size = areas(shape.vertices, shape.faces) * table.is_face(shape)
    label = random.integers(-1, 4, len(shape.faces))
    found = surface.area(label)
    assert len(found) == label.max() + 1
    for region, one in enumerate(found):
        assert one.area == pytest.approx(size[label == region].sum(), rel=1e-9)
        assert one.border_length == pytest.approx(border_of(shape, label == region), rel=1e-9)
        assert surface.area(label == region).area == pytest.approx(one.area)
    inside = random.random(len(shape.vertices)) < 0.8
    whole = surface.area(vertices=inside)
    assert whole.area == pytest.approx(size[inside[shape.faces].all(axis=1)].sum(), rel=1e-9)
    assert [one.area for one in surface.area(vertices=inside - 1)] == [whole.area]


def test_closed_regions_have_a_volume(random: Rng) -> None:
    turned = np.where(random.random((12, 1)) < 0.3, BOX.faces[:, ::-1], BOX.faces)
    for faces in (BOX.faces, BOX.faces[:, ::-1], turned):
        found = vorogeo.Surface(BOX.vertices + np.array([7, 8, 9]), faces).area(np.ones(12, bool))
        assert found.area == pytest.approx(22)
        assert found.border_length == 0
        assert found.volume == pytest.approx(6)
    # With a cavity, which is no region of its own, and beside another box.
    vertices = np.vstack([BOX.vertices, 0.5 * BOX.vertices + 0.1, BOX.vertices + 5])
    faces = np.vstack([BOX.faces, BOX.faces[:, ::-1] + 8, BOX.faces + 16])
    surface = vorogeo.Surface(vertices, faces)
    assert [one.volume for one in surface.area(np.repeat([0, 0, 1], 12))] == pytest.approx([6 - 0.75, 6])
    side = surface.area(np.arange(36) < 2)
    assert (side.area, side.border_length) == pytest.approx((6, 10))
    assert np.isnan(side.volume)


def test_a_closed_path_of_a_plane_encloses_its_polygon() -> None:
    shape = table.named("plane")
    surface = ask.surface(shape)
    corners = shape.vertices.min(axis=0) + np.ptp(shape.vertices, axis=0) * [
        [0.1, 0.2, 0],
        [0.9, 0.15, 0],
        [0.7, 0.8, 0],
    ]
    path = surface.path_through(surface.snap(corners), closed=True)
    (x, y, _), sides = corners.T, corners - np.roll(corners, 1, axis=0)
    found = surface.area(inside=path)
    assert found.area == pytest.approx(abs(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))) / 2, rel=1e-9)
    assert found.border_length == pytest.approx(np.linalg.norm(sides, axis=1).sum(), rel=1e-9)
    assert np.isnan(found.volume)
    cost = vorogeo.Surface(shape.vertices, shape.faces, metric=vorogeo.VertexCost(np.full(len(shape.vertices), 3.0)))
    priced = cost.area(inside=path)
    assert (priced.area, priced.border_length) == pytest.approx((9 * found.area, 3 * found.border_length))


def test_a_loop_round_a_tube_encloses_its_shorter_end() -> None:
    surface = ask.surface(PRISM)
    loop = surface.tighten(np.arange(48, 60))
    height = loop.points[0, 2]
    assert height < 2
    found = surface.area(inside=loop)
    assert (found.area, found.border_length) == pytest.approx((AROUND * height, AROUND))


PLANE = table.named("plane")


def crossing() -> Floats:
    """The corners of an hourglass."""
    return PLANE.vertices.min(axis=0) + np.ptp(PLANE.vertices, axis=0) * [
        [0.1, 0.1, 0], [0.9, 0.9, 0], [0.9, 0.1, 0], [0.1, 0.9, 0]]  # fmt: skip


def test_what_a_curve_passes_forth_and_back_encloses_nothing(random: Rng) -> None:
    angles = random.uniform(0, 2 * np.pi) + np.radians([0, 120, 240]) + random.uniform(-0.4, 0.4, 3)
    directions = np.column_stack([np.cos(angles), np.sin(angles)])
    corners = 0.5 + np.vstack([0.25 * directions, 0.4 * directions[1]])  # the last one lies behind the second
    low, size = PLANE.vertices.min(axis=0), np.ptp(PLANE.vertices, axis=0)
    surface = ask.surface(PLANE)
    points = surface.snap(low + size * np.column_stack([corners, np.zeros(4)]))
    a, b, c = points.positions(PLANE.vertices, PLANE.faces)[:3, :2]
    for order in ([0, 1, 3, 1, 2], [3, 1, 2, 0, 1]):  # in the middle of the curve, and where it begins
        found = surface.area(inside=surface.path_through(points[order], closed=True))
        assert found.area == pytest.approx(abs(np.linalg.det([b - a, c - a])) / 2)
        assert found.border_length == pytest.approx(sum(np.linalg.norm(p - q) for p, q in ((a, b), (b, c), (c, a))))


REFUSED: dict[str, tuple[Any, str]] = {
    "nothing": (lambda s: s.area(), "Give one of faces, vertices and inside"),
    "two": (lambda s: s.area([True], [True]), "Give one of faces, vertices and inside"),
    "too few": (lambda s: s.area([True, False]), r"faces: has shape \(2,\), but there are \d+ faces; give for each"),
    "words": (lambda s: s.area(vertices=["a"]), "vertices: is not an array of numbers"),
    "NaN": (lambda s: s.area(np.full(len(s.faces), np.nan)), r"has type float64, not integer: faces\[0\] is nan"),
    "a number of no region": (lambda s: s.area(np.full(len(s.faces), 2**40)), "faces: 1099511627776 is out of range"),
    "an open curve": (lambda s: s.area(inside=s.path(0, 100)), "The curve is not closed"),
    "a curve of one place": (lambda s: s.area(inside=[3, 3, 3]), "The curve has no length"),
    "a curve that crosses itself": (lambda s: s.area(inside=s.path_through(s.snap(crossing()), closed=True)),
                                    r"crosses or touches itself at face \d+"),
    "a curve that leaps": (lambda s: s.area(inside=[0, 1, 150, 0]), "share no face"),
    "no vertex": (lambda s: s.area(inside=[0, 1, 99999, 0]), "curve.*there is no vertex 99999"),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_what_has_no_area_is_refused(case: str) -> None:
    question, sentence = REFUSED[case]
    with ask.refused(sentence):
        question(ask.surface(PLANE))


def test_a_curve_round_a_handle_encloses_nothing() -> None:
    shape = torus(24, 12, 2.0, 0.8)
    surface = vorogeo.Surface(shape.vertices, shape.faces)
    with ask.refused("The curve's parts have the same side left and right"):
        surface.area(inside=surface.shortest_loop(0))
