"""Curves that people measure along: paths through points, loops, girths and profiles, against formulas."""

from __future__ import annotations

import itertools
from typing import Any

import ask
import numpy as np
import pytest
import surfaces
import table
import vorogeo
from surfaces import Mesh, Rng, Shape
from test_path import assert_is_path

PRISM, PARTS = table.named("prism"), table.named("parts")
AROUND = 12 * 2 * np.sin(np.pi / 12)  # the girth of the prism
TILT, RINGS = 1.1, 12
CONE = surfaces.cone("steep cone", np.full(8, -TILT))
#: The angle between two rays of the cone; the eight of them sum to less than pi, so that loops go round the apex.
SECTOR = float(np.arccos(np.cos(TILT) ** 2 * np.cos(np.pi / 4) + np.sin(TILT) ** 2))
#: The cone without its tip, cut off at the first ring: a tube.
FRUSTUM = surfaces.shape("frustum", (CONE.vertices, CONE.faces[8:]), CONE.between, chart=CONE.chart)
CORNERS = np.array(list(itertools.product([0.0, 1.0], [0.0, 2.0], [0.0, 3.0])))
BOX = surfaces.shape(
    "box",
    (CORNERS, np.array([[0, 1, 3], [0, 3, 2], [4, 7, 5], [4, 6, 7], [0, 5, 1], [0, 4, 5], [2, 3, 7], [2, 7, 6],
                        [0, 2, 6], [0, 6, 4], [1, 7, 3], [1, 5, 7]], np.int32)),
    surfaces.straight,
)  # fmt: skip


def torus(around: int, across: int, far: float, near: float) -> Shape:
    """A torus around the z axis; i counts around, j across: vertex i * across + j."""
    i, j = (grid.ravel() for grid in np.meshgrid(np.arange(around), np.arange(across), indexing="ij"))
    phi, psi = 2 * np.pi * i / around, 2 * np.pi * j / across
    ring = far + near * np.cos(psi)
    vertices = np.column_stack([ring * np.cos(phi), ring * np.sin(phi), near * np.sin(psi)])
    right, up = (i + 1) % around * across, (j + 1) % across
    lower = np.column_stack([i * across + j, right + j, right + up])
    upper = np.column_stack([i * across + j, right + up, i * across + up])
    mesh: Mesh = vertices, np.vstack([lower, upper]).astype(np.int32)
    return surfaces.shape("torus", mesh, surfaces.straight)


def regular(corners: int, radius: float) -> float:
    """The perimeter of a regular polygon."""
    return float(2 * corners * radius * np.sin(np.pi / corners))


def assert_is_loop(shape: Shape, loop: vorogeo.GeodesicPath) -> None:
    """The loop is closed, runs over faces, and is as long as its steps."""
    np.testing.assert_allclose(loop.points[0], loop.points[-1], atol=1e-12)
    steps = np.linalg.norm(np.diff(loop.points, axis=0), axis=1)
    assert steps.sum() == pytest.approx(loop.length, rel=1e-12)
    assert_is_path(shape, loop, loop.surface_points[[0]], loop.surface_points[[-1]])


@table.asked(ask.TASKS, [shape for shape in table.UNROLLED if shape.name != "parts"])
def test_a_path_through_points_is_as_long_as_their_distances(by: str, shape: Shape, random: Rng) -> None:
    points = random.permutation(shape.sources)[:4]
    for closed, order in ((False, points), (True, [*points, points[0]])):
        legs = [shape.matrix([a], [b])[0, 0] for a, b in itertools.pairwise(order)]
        path = ask.task("path_through", by, shape, points, closed)
        assert path.length == pytest.approx(sum(legs), rel=max(shape.slack, 1e-9))
        assert path.certified == (not ask.jumps(shape))
        if shape.metric is None:
            assert_is_path(shape, path, order[0], order[-1])
            assert all((path.points == shape.vertices[vertex]).all(axis=1).any() for vertex in points)


@table.asked(ask.TASKS, [shape for shape in table.LENGTHS if shape.name in ("plane", "prism", "cone", "repeats")])
def test_guides_hold_a_path_on_their_side_only(by: str, shape: Shape, random: Rng) -> None:
    guides = [shape.sources[0], *random.permutation(len(shape.vertices))[:2], shape.sources[-1]]
    path = ask.task("path_through", by, shape, guides, guides=True)
    assert_is_path(shape, path, guides[0], guides[-1])
    assert not path.certified
    through = ask.task("path_through", by, shape, guides)
    shortest = shape.matrix(shape.sources[:1], shape.sources[-1:])[0, 0]
    assert shortest * (1 - 1e-9) <= path.length <= through.length * (1 + 1e-9)
    if shape.name in ("plane", "repeats"):  # there is no other geodesic
        assert path.length == pytest.approx(shortest, rel=1e-9)


def test_guides_say_which_way_round_a_tube_a_path_leads() -> None:
    start, end = 12 * 3 + 2, 12 * 9 + 5  # a quarter turn and six rows apart
    apart, up = 3 * AROUND / 12, 6 * 4 / 13
    for half, length in (([], apart), ([12 * 5 + 10], AROUND - apart), ([40, 44, 48, 40, 44, 48], 2 * AROUND + apart)):
        path = ask.task("path_through", "exact", PRISM, [start, *half, end], guides=True)
        assert path.length == pytest.approx(np.hypot(length, up), rel=1e-12)
        assert_is_path(PRISM, path, start, end)
    closed = ask.task("path_through", "exact", PRISM, [13, 40, 17, 91, 20, 70, 23], closed=True, guides=True)
    assert closed.length == pytest.approx(AROUND, rel=1e-12)
    back = ask.task("path_through", "exact", PRISM, [30, 31, 43, 30], guides=True)
    assert back.length == 0
    np.testing.assert_array_equal(back.points, PRISM.vertices[[30]])


@pytest.mark.parametrize("by", ask.TASKS)
def test_loops_round_a_tube_are_as_long_as_its_sides(by: str, random: Rng) -> None:
    point = table.points_anywhere(PRISM, random, 1)
    ring, uneven = np.arange(60, 72), [13, 40, 17, 91, 20, 70, 23]
    for loop in (
        ask.task("shortest_loop", by, PRISM, point),
        ask.task("shortest_loop", by, PRISM, 77),
        ask.task("shortest_loop", by, PRISM, point, ring),
        ask.task("tighten", by, PRISM, ring),
        ask.task("tighten", by, PRISM, uneven),
        ask.task("tighten", by, PRISM, ask.task("path_through", by, PRISM, uneven, True)),
    ):
        assert loop.length == pytest.approx(AROUND, rel=1e-12)
        assert_is_loop(PRISM, loop)
        assert not loop.certified
    twice = ask.task("tighten", by, PRISM, [*uneven, *uneven])
    assert twice.length == pytest.approx(2 * AROUND, rel=1e-12)


def test_loops_round_a_cone_are_chords_of_its_sector(random: Rng) -> None:
    ring = 1 + 8 * 5 + np.arange(8)
    for point in ([1 + 8 * 10 + 3], table.points_anywhere(CONE, random, 1)):
        from_apex = np.linalg.norm(
            CONE.vertices[point] if isinstance(point, list) else point.positions(CONE.vertices, CONE.faces)
        )
        loop = ask.task("shortest_loop", "exact", CONE, point, ring)
        assert loop.length == pytest.approx(2 * from_apex * np.sin(4 * SECTOR), rel=1e-9)
        assert_is_loop(CONE, loop)
    # Without an apex, it is still the shortest loop through the point; pulled tight, it goes to the first ring.
    loop = ask.task("shortest_loop", "exact", FRUSTUM, 1 + 8 * 10 + 3)
    assert loop.length == pytest.approx(2 * 11 / RINGS * np.sin(4 * SECTOR), rel=1e-9)
    border = ask.task("tighten", "exact", FRUSTUM, ring)
    assert border.length == pytest.approx(8 * 2 / RINGS * np.sin(SECTOR / 2), rel=1e-9)
    assert_is_loop(FRUSTUM, border)


def test_loops_of_a_torus_go_round_its_tube_or_its_hole() -> None:
    shape = torus(48, 24, 2.0, 0.8)
    hole, tube = regular(48, 1.2), regular(24, 0.8)
    level = 24 * np.arange(48) + 9  # a ring above the inner one
    assert ask.task("tighten", "exact", shape, level).length == pytest.approx(hole, rel=1e-12)
    for vertex in (0, 30, 300, 1000):
        loop = ask.task("shortest_loop", "exact", shape, vertex)
        # Between two rings of vertices, the tube is narrower by the rise of an arc over its chord.
        assert tube * np.cos(np.pi / 48) <= loop.length <= tube * (1 + 1e-12)
        assert_is_loop(shape, loop)
        like = ask.task("shortest_loop", "exact", shape, vertex, level)
        assert like.length >= hole * (1 - 1e-12)
        assert_is_loop(shape, like)


def test_the_girth_of_a_box_depends_on_the_direction(random: Rng) -> None:
    surface = ask.surface(BOX)
    for axis, around in ((0, 10.0), (1, 8.0), (2, 6.0)):
        place = np.array([0.5, 1.0, 1.5])
        place[(axis + 1) % 3] = 0.0
        point = surface.snap(place)
        found = surface.girth(point, 5 * np.eye(3)[axis])
        for one in (found.section, found.tape, found.loop):
            assert one.length == pytest.approx(around, rel=1e-12)
        tilted = surface.girth(point, np.eye(3)[axis] + random.uniform(-0.05, 0.05, 3))
        assert tilted.section.length > around
        assert tilted.tape.length == pytest.approx(tilted.section.length, rel=1e-12)
        assert tilted.loop.length == pytest.approx(around, rel=1e-12)
        for path in (tilted.section, tilted.loop):
            assert_is_loop(BOX, path)
        heights = (tilted.section.points - point.positions(BOX.vertices, BOX.faces)) @ tilted.normal
        np.testing.assert_allclose(heights, 0, atol=1e-12)


def test_without_a_normal_the_girth_of_a_limb_is_found(random: Rng) -> None:
    surface = ask.surface(PRISM)
    for point in (77, table.points_anywhere(PRISM, random, 1)):
        place = PRISM.vertices[77] if point == 77 else point.positions(PRISM.vertices, PRISM.faces)[0]
        if not 1 < place[2] < 3:
            continue
        found = surface.girth(point)
        np.testing.assert_allclose(np.abs(found.normal), [0, 0, 1], atol=1e-5)
        for one in (found.section, found.tape, found.loop):
            assert one.length == pytest.approx(AROUND, rel=1e-9)


def test_a_tape_spans_what_bends_inwards() -> None:
    radius = np.where(np.arange(len(PRISM.vertices)) % 2 == 0, 1.0, 0.5)  # a star
    vertices = PRISM.vertices * np.column_stack([radius, radius, np.ones_like(radius)])
    found = vorogeo.Surface(vertices, PRISM.faces).girth(78, [0, 0, 1])
    assert found.tape.length == pytest.approx(6, rel=1e-12)
    for path in (found.section, found.loop):
        assert path.length == pytest.approx(12 * np.sqrt(1.25 - np.cos(np.pi / 6)), rel=1e-12)


def test_profiles_have_heights_and_slopes(random: Rng) -> None:
    surface = ask.surface(PRISM)
    path = surface.path(25, 100)
    length, height, angle, _, _ = surface.profile(path, [0, 0, 3.0])
    assert length[0] == 0
    assert length[-1] == pytest.approx(path.length, rel=1e-12)
    np.testing.assert_allclose(height, path.points[:, 2], atol=1e-12)
    np.testing.assert_allclose(angle, np.pi / 2, atol=1e-9)
    slope = surfaces.shape("slope", surfaces.plain_grid(5, 5, 1.0, 1.0), surfaces.straight)
    slope.vertices[:, 2] = slope.vertices[:, 0]
    along = ask.surface(slope).profile(ask.surface(slope).path(0, 24))
    np.testing.assert_allclose(along.height, along.length / np.sqrt(3), atol=1e-12)
    assert np.abs(np.cos(along.angle)) == pytest.approx(np.sqrt(0.5), abs=1e-12)


def test_on_a_sharp_ridge_the_normal_leads_upwards() -> None:
    vertices = np.array([[-1, 0, 0], [1, 0, 0], [0, 0, 3], [-1, 1, 0], [1, 1, 0], [0, 1, 3]], dtype=float)
    faces = np.array([[2, 0, 3], [2, 3, 5], [5, 4, 1], [1, 2, 5]], dtype=np.int32)
    for turned in (faces, np.vstack([faces[:2], faces[2:, ::-1]])):
        surface = vorogeo.Surface(vertices, turned)
        _, height, angle, _, _ = surface.profile(vorogeo.SurfacePoints([1, 1], [[0.3, 0, 0.7], [0.7, 0, 0.3]]))
        np.testing.assert_allclose(height, 3)
        np.testing.assert_allclose(np.sin(angle), 0, atol=1e-9)


def test_profiles_have_the_curvature_of_a_tube_in_their_direction(random: Rng) -> None:
    # Between two corners, the normals of the prism turn by 2 sin(pi / 12) over as long a side.
    start, end = 12 * 3 + 2, 12 * 9 + 5
    slope = np.arctan2(6 * 4 / 13, 3 * AROUND / 12)
    flipped = np.where(random.random((len(PRISM.faces), 1)) < 0.3, PRISM.faces[:, ::-1], PRISM.faces)
    for faces, sign in ((PRISM.faces, 1), (flipped, 1), (PRISM.faces[:, ::-1], -1)):
        surface = vorogeo.Surface(PRISM.vertices, faces)
        for path, curvature in (
            (surface.path(start, start + 3), 1.0),
            (surface.path(start, start + 72), 0.0),
            (surface.path(start, end), np.cos(slope) ** 2),
        ):
            found = surface.profile(path)
            np.testing.assert_allclose(found.curvature, sign * curvature, atol=1e-9)
            if sign < 0:
                assert np.isinf(found.thickness).all()
            else:
                inside = found.thickness[1:-1]
                assert ((inside > 2 * np.cos(np.pi / 12) - 1e-9) & (inside < 2 + 1e-9)).all()


def test_profiles_have_the_thickness_of_a_box(random: Rng) -> None:
    surface = ask.surface(BOX)
    size = np.array([1.0, 2.0, 3.0])
    for axis in range(3):
        ends = random.uniform(0.1, 0.9, (2, 3)) * size
        ends[:, axis] = size[axis]
        middle = size / 2
        middle[axis] = 0
        for path in (surface.path(*(surface.snap(end) for end in ends)), surface.snap(middle)):
            found = surface.profile(path)
            np.testing.assert_allclose(found.thickness, size[axis], rtol=1e-12)
            np.testing.assert_array_less(np.abs(found.curvature), 3)
    flat = ask.surface(table.named("plane")).profile([0])
    assert np.isinf(flat.thickness).all()
    assert flat.curvature == 0


def with_isolated_vertex(shape: Shape) -> vorogeo.Surface:
    return vorogeo.Surface(np.vstack([shape.vertices, np.ones(3)]), shape.faces)


REFUSED: dict[str, tuple[Any, str]] = {
    "two components": (lambda: ask.surface(PARTS).path_through([3, 100, 200]),
                       r"from point 1 \(vertex 100\) to point 2 \(vertex 200\): they are on two components"),
    "a curve on two components": (lambda: ask.surface(PARTS).tighten([3, 200]), r"point 1 \(vertex 200\)"),
    "a curve on another component": (lambda: ask.surface(PARTS).shortest_loop(3, [200, 201, 215]),
                                     "No path leads from vertex 3 to the curve"),
    "one point": (lambda: ask.surface(PRISM).path_through([3]), "There are 1 points to pass through; give at least"),
    "a curve of one point": (lambda: ask.surface(PRISM).tighten([3]), "The curve has 1 points; give at least two"),
    "two points to loop through": (lambda: ask.surface(PRISM).shortest_loop([3, 4]), "point: has 2 points; give one"),
    "a curve that slips off": (lambda: ask.surface(CONE).tighten(1 + 8 * 5 + np.arange(8)),
                               "The curve slips off: pulled tight, it contracts to a point, at vertex 0"),
    "a loop that contracts": (lambda: ask.surface(CONE).shortest_loop(30),
                              "Every loop through vertex 30 contracts to it"),
    "a loop like one that slips off": (lambda: ask.surface(PRISM).shortest_loop(30, [30, 31, 43]),
                                       "slips off: pulled tight, it contracts to a point, at vertex 30"),
    "a loop like a point": (lambda: ask.surface(PRISM).shortest_loop(30, [77, 77]),
                            "slips off: pulled tight, it contracts to a point, at vertex 77"),
    "a section with ends": (lambda: ask.surface(PRISM).girth(77, [1.0, 0.1, 0]),
                            r"through vertex 77 is not closed: it meets the border at the edge between vertex \d+ and"),
    "a plane that touches": (lambda: ask.surface(BOX).girth(0, [1.0, 1, 1]), "only touches the surface at vertex 0"),
    "a loop through a vertex without a face": (lambda: with_isolated_vertex(BOX).shortest_loop(len(BOX.vertices)),
                                               r"No loop passes through vertex \d+, as no face has it"),
    "the girth at a vertex without a face": (lambda: with_isolated_vertex(BOX).girth(len(BOX.vertices)),
                                             r"No loop passes through vertex \d+, as no face has it"),
    "a normal of 0": (lambda: ask.surface(BOX).girth(0, [0.0, 0, 0]), "normal: is .* give three numbers"),
    "upwards without direction": (lambda: ask.surface(BOX).profile([0, 1], np.zeros(3)), "up: is .* give three"),
    "a path that leaps": (lambda: ask.surface(PRISM).profile([0, 100]),
                          r"Points 0 \(vertex 0\) and 1 \(vertex 100\) of the path share no face"),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_what_cannot_be_measured_is_refused(case: str) -> None:
    question, sentence = REFUSED[case]
    with ask.refused(sentence):
        question()


def test_metrics_that_jump_have_paths_through_points_but_no_loops() -> None:
    shape = next(shape for shape in table.METRICS if ask.jumps(shape))
    for question in (lambda s: s.tighten([0, 1, 2]), lambda s: s.shortest_loop(0), lambda s: s.girth(0)):
        with ask.refused("Loops need edges on whose length both faces agree"):
            question(ask.surface(shape))
    with ask.refused("Paths by guides need edges on whose length both faces agree"):
        ask.surface(shape).path_through([0, 1, 2], guides=True)


def test_a_limb_without_a_neck_has_section_and_tape_and_no_loop() -> None:
    surface = vorogeo.Surface(CONE.vertices, CONE.faces)
    found = surface.girth(1 + 8 * 6, [0, 0, 1])
    ring = 8 * 2 * 7 / RINGS * np.sin(SECTOR / 2)
    assert found.section.length == pytest.approx(ring, rel=1e-9)
    assert found.tape.length == pytest.approx(ring, rel=1e-9)
    assert found.loop.length == 0
    np.testing.assert_allclose(found.loop.points, CONE.vertices[:1])
    assert "The loop slips off" in surface.last.remark
    assert "at vertex 0" in surface.last.remark
