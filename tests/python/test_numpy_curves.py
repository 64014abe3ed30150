"""Curves with numpy: points along paths, Bezier curves and splines on surfaces that unroll, and what is refused."""

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid, plane_grid, prism, real_mesh, side_by_side


def sheet():
    return vorogeo.Surface(*plane_grid(9, 7, 1.6, 1.2))


def points_of(surface, places):
    return surface.snap(np.column_stack([places, np.zeros(len(places))]))


def bezier(controls, samples):
    t = np.linspace(0, 1, samples + 1)[:, None, None]
    rows = np.tile(controls, (samples + 1, 1, 1))
    while rows.shape[1] > 1:
        rows = (1 - t) * rows[:, :-1] + t * rows[:, 1:]
    return rows[:, 0]


def assert_passes(path, places):
    """Whether a path leads through places in their order, straight from each to the next."""
    apart = np.linalg.norm(path.points[:, None, :2] - places, axis=2)
    passed = apart.argmin(axis=0)
    np.testing.assert_allclose(apart[passed, np.arange(len(places))], 0, atol=1e-9)
    assert (np.diff(passed[:-1]) >= 0).all()  # a closed curve ends where it begins
    np.testing.assert_allclose(path.length, np.linalg.norm(np.diff(places, axis=0), axis=1).sum(), rtol=1e-9)


CONTROLS = np.array([[0.13, 0.21], [0.52, 1.07], [1.33, 1.11], [1.41, 0.17], [0.9, 0.3]])


#: Of splines, whose other control points are to lie on the sheet.
PASSED = np.array([[0.13, 0.21], [0.52, 0.9], [1.33, 0.95], [1.41, 0.17], [0.9, 0.3]])


@pytest.mark.parametrize("count", [2, 3, 4, 5])
def test_on_a_plane_bezier_curves_are_those_of_coordinates(count):
    surface = sheet()
    curve = surface.bezier(points_of(surface, CONTROLS[:count]), samples=10)
    assert_passes(curve, bezier(CONTROLS[:count], 10))
    assert not curve.certified


def catmull_rom(places, closed, samples):
    after, before = np.roll(places, -1, axis=0) - places, places - np.roll(places, 1, axis=0)
    slope = (after + before) / 2
    if not closed:
        slope[0], slope[-1] = after[0], before[-1]
    pieces = []
    for i in range(len(places) - (not closed)):
        j = (i + 1) % len(places)
        controls = np.array([places[i], places[i] + slope[i] / 3, places[j] - slope[j] / 3, places[j]])
        pieces.append(bezier(controls, samples)[:-1])
    return np.vstack([*pieces, places[:1] if closed else places[-1:]])


@pytest.mark.parametrize("closed", [False, True])
def test_on_a_plane_splines_are_those_of_catmull_and_rom(closed):
    surface = sheet()
    curve = surface.spline(points_of(surface, PASSED), closed=closed, samples=8)
    assert_passes(curve, catmull_rom(PASSED, closed, 8))
    mixed = [points_of(surface, PASSED[:2]), 40]  # vertex 40 lies on the sheet, which is flat there
    places = np.vstack([PASSED[:2], surface.vertices[40, :2]])
    assert_passes(surface.spline(mixed, samples=4), catmull_rom(places, False, 4))


def subdivided(places, closed, levels):
    """Control points of a uniform cubic B-spline by the rules for vertices and edges; open, with ends of three."""
    for _ in range(levels):
        before, after = np.roll(places, 1, axis=0), np.roll(places, -1, axis=0)
        if not closed:
            before[0], after[-1] = places[0], places[-1]
        on_vertices, on_edges = (before + 6 * places + after) / 8, (places + after) / 2
        if closed:
            places = np.stack([on_edges, np.roll(on_vertices, -1, axis=0)], axis=1).reshape(-1, 2)
        else:
            inner = np.stack([on_vertices, on_edges], axis=1).reshape(-1, 2)[:-1]
            places = np.vstack([places[:1], inner, places[-1:]])
    return np.vstack([places, places[:1]]) if closed else places


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("levels", [1, 3])
def test_on_a_plane_b_splines_are_those_of_coordinates(closed, levels):
    surface = sheet()
    curve = surface.b_spline(points_of(surface, CONTROLS), closed=closed, levels=levels)
    assert_passes(curve, subdivided(CONTROLS, closed, levels))
    assert not curve.certified


def test_round_a_tube_curves_are_those_of_the_plane_that_it_unrolls_into():
    sides, height = 12, 4.0
    surface = vorogeo.Surface(*prism(sides, 9, height))
    side = 2 * np.sin(np.pi / sides)

    def rolled(flat):
        whole, part = np.divmod(flat[:, 0] / side, 1)
        corner = np.exp(2j * np.pi * whole / sides)
        place = corner + part * (np.exp(2j * np.pi * (whole + 1) / sides) - corner)
        return np.column_stack([place.real, place.imag, flat[:, 1]])

    flat = np.array([[5.1, 0.5], [6.3, 1.2], [7.6, 2.9], [6.9, 3.4]])  # across where it is sewn together
    curve = surface.bezier(surface.snap(rolled(flat)), samples=12)
    wanted = rolled(bezier(flat, 12))
    apart = np.linalg.norm(curve.points[:, None] - wanted, axis=2).min(axis=0)
    np.testing.assert_allclose(apart, 0, atol=1e-9)
    spline = surface.spline(surface.snap(rolled(flat)), samples=12)
    apart = np.linalg.norm(spline.points[:, None] - rolled(catmull_rom(flat, False, 12)), axis=2).min(axis=0)
    np.testing.assert_allclose(apart, 0, atol=1e-9)


def test_points_along_a_path_are_at_fractions_of_its_length():
    surface = sheet()
    path = surface.path_through(points_of(surface, CONTROLS[:3]))
    t = np.linspace(0, 1, 41)
    legs = np.linalg.norm(np.diff(CONTROLS[:3], axis=0), axis=1)
    at = t * legs.sum()
    wanted = np.column_stack([np.interp(at, [0, legs[0], legs.sum()], CONTROLS[:3, k]) for k in (0, 1)])
    found = surface.points_along(path, t).positions(surface.vertices, surface.faces)
    np.testing.assert_allclose(found[:, :2], wanted, atol=1e-12)
    np.testing.assert_allclose(found[:, 2], 0)
    assert len(surface.points_along(path, 0.5)) == 1
    assert len(surface.points_along(path, [])) == 0
    still = surface.points_along(surface.path(30, 30), [0, 0.3, 1]).positions(surface.vertices, surface.faces)
    np.testing.assert_array_equal(still, surface.vertices[[30, 30, 30]])


def turn_at(path, place):
    """How far a path turns in space at a place that it passes."""
    i = int(np.linalg.norm(path.points - place, axis=1).argmin())
    before, after = path.points[i] - path.points[i - 1], path.points[i + 1] - path.points[i]
    return np.arccos(before @ after / np.linalg.norm(before) / np.linalg.norm(after))


@pytest.mark.parametrize("name", ["bunny10k_textured.obj", "spot"])
def test_on_meshes_curves_lead_over_the_faces_through_their_points(name):
    vertices, faces = real_mesh(name)
    surface = vorogeo.Surface(vertices, faces)
    points = surface.sample_farthest(40, seed=2).vertices[10:14]
    curve = surface.spline(points, closed=True, samples=6)
    assert np.isfinite(curve.length)
    np.testing.assert_allclose(curve.surface_points.positions(vertices, faces), curve.points, atol=1e-9)
    np.testing.assert_allclose(np.linalg.norm(np.diff(curve.points, axis=0), axis=1).sum(), curve.length, rtol=1e-9)
    for point in points:
        assert np.linalg.norm(curve.points - vertices[point], axis=1).min() < 1e-12
    assert curve.length >= surface.path_through(points, closed=True, method="exact").length * (1 - 1e-9)
    ends = surface.bezier(points[:3], samples=5)
    np.testing.assert_allclose(ends.points[[0, -1]], vertices[points[[0, 2]]])
    assert ends.length >= surface.exact_path(points[0], points[2]).length * (1 - 1e-9)


def test_a_fine_spline_does_not_turn_at_its_points_but_the_path_through_them_does():
    surface = sheet()
    points = points_of(surface, PASSED)
    fine = surface.spline(points, samples=200)
    for place in np.column_stack([PASSED, np.zeros(5)])[1:4]:
        assert turn_at(fine, place) < 0.1 < turn_at(surface.path_through(points), place)


def test_moved_turned_and_scaled_curves_are_the_same():
    vertices, faces = bent_grid(15, 12)
    turn, _ = np.linalg.qr(np.random.default_rng(2).normal(size=(3, 3)))
    one, other = vorogeo.Surface(vertices, faces), vorogeo.Surface(1000 * vertices @ turn, faces)
    points = [18, 70, 100, 25]
    for name, steps in (("bezier", {"samples": 6}), ("spline", {"samples": 6}), ("b_spline", {"levels": 3})):
        first, second = getattr(one, name)(points, **steps), getattr(other, name)(points, **steps)
        np.testing.assert_allclose(second.length, 1000 * first.length, rtol=1e-7)
    by_index = vorogeo.GeodesicIndex(vertices, faces, patches=(3, 3)).spline(points, samples=6)
    np.testing.assert_allclose(by_index.length, one.spline(points, samples=6).length, rtol=1e-7)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda s: s.bezier([3]), "There are 1 points for a curve; give at least 2"),
        (lambda s: s.b_spline([3, 4], closed=True), "There are 2 points for a curve; give at least 3"),
        (lambda s: s.b_spline([3, 4], levels=0), "levels: 0 is out of range"),
        (lambda s: s.b_spline([3, 4, 30]), r"from point 1 \(vertex 4\) to point 2 \(vertex 30\).*two components"),
        (lambda s: s.spline([3, 4], closed=True), "There are 2 points for a curve; give at least 3"),
        (lambda s: s.bezier([3, 4], samples=0), "samples: 0 is out of range"),
        (lambda s: s.spline([3, 99]), r"points\[1\]: there is no vertex 99"),
        (lambda s: s.bezier([3, 4, 30]), r"from point 1 \(vertex 4\) to point 2 \(vertex 30\).*two components"),
        (lambda s: s.spline([3, 30, 4]), r"from point 0 \(vertex 3\) to point 1 \(vertex 30\).*two components"),
        (lambda s: s.points_along([3, 24], [0.5]), "Points 0 .vertex 3. and 1 .vertex 24. of the path share no face"),
        (lambda s: s.points_along([], [0.5]), "The path has no point"),
        (lambda s: s.points_along([3, 4], [0.5, 1.5]), "Fraction 1 is 1.5"),
        (lambda s: s.points_along([3, 4], np.nan), "Fraction 0 is nan"),
    ],
)
def test_bad_input_is_refused_by_name(call, message):
    surface = vorogeo.Surface(*side_by_side(plane_grid(5, 5), plane_grid(5, 5)))
    with pytest.raises(vorogeo.InvalidInput, match=message):
        call(surface)


def test_where_a_metric_jumps_there_are_bezier_curves_but_no_splines():
    vertices, faces = plane_grid(9, 8)
    cost = np.ones(len(faces))
    cost[5] = 4.0
    surface = vorogeo.Surface(vertices, faces, metric=vorogeo.FaceCost(cost))
    assert np.isfinite(surface.bezier([30, 40, 50], samples=4).length)
    with pytest.raises(vorogeo.InvalidInput, match="Directions need edges on whose length both faces agree"):
        surface.spline([30, 40, 50])


def test_isolines_in_order_are_curves_to_pull_tight():
    """Round a tube each isoline of the height is closed, and as long as its regular polygon once it is tight."""
    surface = vorogeo.Surface(*prism(12, 9, 4.0))
    levels = np.sort(np.random.default_rng().uniform(0.3, 3.7, 3))
    lines = surface.isolines(surface.vertices[:, 2], levels, "linear").lines()
    assert len(lines) == 3
    round_it = 24 * np.sin(np.pi / 12)
    for line in lines:
        np.testing.assert_array_equal(line[0], line[-1])
        assert np.abs(line[:, 2, None] - levels).min(axis=1).max() < 1e-9
        assert surface.tighten(surface.snap(line, max_distance=1e-9)).length == pytest.approx(round_it, rel=1e-9)
    across = vorogeo.Polylines(surface.vertices, np.array([[3, 1], [2, 1], [5, 3]]))
    np.testing.assert_array_equal(across.lines()[0], surface.vertices[[2, 1, 3, 5]])
    with pytest.raises(vorogeo.InvalidInput, match="The curve branches: point 1 has 3 of its edges"):
        vorogeo.Polylines(surface.vertices, np.array([[3, 1], [2, 1], [1, 4]])).lines()
