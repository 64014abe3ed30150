"""Metrics by which a way back costs something else: against formulas, and what refuses them."""

from __future__ import annotations

import secrets

import numpy as np
import pytest
import vorogeo
from scipy.optimize import minimize_scalar

from sample_meshes import bent_grid, plane_grid

IDENTITY = np.eye(3)


def shaken_plane(count=25):
    """A grid over the unit square whose inner vertices are moved."""
    vertices, faces = plane_grid(count, count)
    inner = ((vertices[:, :2] > 1e-9) & (vertices[:, :2] < 1 - 1e-9)).all(axis=1)
    vertices[inner, :2] += np.random.default_rng(2).uniform(-0.3, 0.3, (inner.sum(), 2)) / count
    return vertices, faces


def mosaic(seed=4, strongest=0.6, points=None):
    """Random tensors and drifts on a bent grid."""
    vertices, faces = bent_grid(18, 14)
    random = np.random.default_rng(seed)
    cost = random.uniform(1, 3, len(faces))
    drift = random.normal(size=(len(faces), 3))
    drift *= (strongest * random.uniform(0, 1, len(faces)) * cost / np.linalg.norm(drift, axis=1))[:, None]
    return vertices, faces, vorogeo.FaceRanders(cost[:, None, None] ** 2 * IDENTITY, drift, points)


def assert_near(found, expected):
    """Nearly all are exact where waves are circles around one source; points on edges err elsewhere, by little."""
    error = np.abs(found - expected) / np.maximum(expected, 1e-12)
    error[expected == 0] = found[expected == 0]
    assert np.quantile(error, 0.9) < 1e-9
    assert error.mean() < 1e-4
    assert error.max() < 4e-3


def zermelo(step, wind, speed):
    """Times of straight steps, each the least t for which the boat's own step is as long as speed times t."""
    lam = speed**2 - wind @ wind
    along = step @ wind
    return (np.sqrt(along**2 + lam * (step * step).sum(axis=1)) - along) / lam


@pytest.mark.parametrize("speed", [1.0, 2.5])
def test_constant_wind_on_a_plane_is_zermelos(speed):
    vertices, faces = shaken_plane()
    wind = speed * np.array([0.6, -0.5, 0.0])
    surface = vorogeo.Surface(vertices, faces, metric=vorogeo.travel_time(vertices, faces, (*wind[:2], 7.0), speed))
    source = 12 * 25 + 7
    expected = zermelo(vertices - vertices[source], wind, speed)
    assert_near(surface.distance_field(source), expected)
    back = zermelo(vertices[source] - vertices, wind, speed)
    assert_near(surface.distance_field(source, to=True), back)
    ends = np.array([0, 24, 600, 624])
    for there, here in ((surface.path(source, ends), expected), (surface.path(ends, source), back)):
        for path, end in zip(there, ends, strict=True):
            assert path.length == pytest.approx(here[end], rel=1e-9)
            assert surface.profile(path).length[-1] == pytest.approx(path.length, rel=1e-9, abs=1e-12)
            steps = np.linalg.norm(np.diff(path.points, axis=0), axis=1).sum()
            assert steps == pytest.approx(np.linalg.norm(vertices[end] - vertices[source]), rel=1e-9)


@pytest.mark.parametrize("to", [False, True])
def test_paths_refract_where_the_wind_changes(to):
    """Wind up the left half of a square and down the right half: the best crossing, by minimizing over it."""
    vertices, faces = plane_grid(25, 25)
    on_the_left = vertices[faces][:, :, 0].mean(axis=1) < 0.5
    up = np.array([0.0, 0.7, 0.0])
    winds = np.where(on_the_left[:, None], up, -up)
    surface = vorogeo.Surface(vertices, faces, metric=vorogeo.travel_time(vertices, faces, winds, points=24))
    source = 6 * 25 + 6
    targets = np.flatnonzero((vertices[:, 0] > 0.7) & (vertices[:, 1] > 0.3) & (vertices[:, 1] < 0.8))
    way = -1.0 if to else 1.0

    def time_by(y, end):
        crossing = np.array([0.5, y, 0.0])
        pieces = way * np.stack([crossing - vertices[source], end - crossing])
        return zermelo(pieces[:1], up, 1.0)[0] + zermelo(pieces[1:], -up, 1.0)[0]

    expected = [
        minimize_scalar(time_by, bounds=(0, 1), args=(end,), method="bounded", options={"xatol": 1e-9}).fun
        for end in vertices[targets]
    ]
    np.testing.assert_allclose(surface.distance_field(source, to=to)[targets], expected, rtol=1e-4)
    ends = (targets[::9], source) if to else (source, targets[::9])
    lengths = [path.length for path in surface.path(*ends)]
    np.testing.assert_allclose(lengths, expected[::9], rtol=1e-8)


def test_up_and_down_an_inclined_plane():
    vertices, faces = shaken_plane()
    grade = 0.2
    vertices[:, 2] = grade * vertices[:, 0]
    surface = vorogeo.Surface(vertices, faces, metric=vorogeo.hiking_time(vertices, faces))
    low, high, beside = 12 * 25, 12 * 25 + 24, 24
    assert surface.distance(low, high) == pytest.approx(0.6 * np.exp(3.5 * (grade + 0.05)), rel=1e-9)
    assert surface.distance(high, low) == pytest.approx(0.6 * np.exp(3.5 * (grade - 0.05)), rel=1e-9)
    assert surface.distance(beside, 624) == pytest.approx(0.6 * np.exp(3.5 * 0.05), rel=1e-9)


def test_a_slope_that_is_too_steep_is_climbed_by_zigzags():
    """Where none can go up more than 1 in 12, a climb of h takes 12 h on the map; a wall has no map at all."""
    for corners, climb in (([[0, 0, 0], [1, 0, 1], [0, 1, 0]], 1.0), ([[0, 0, 0], [0, 0, 2], [0, 1, 0]], 2.0)):
        metric = vorogeo.hiking_time(np.array(corners, float), [[0, 1, 2]], vorogeo.wheelchair)
        surface = vorogeo.Surface(np.array(corners, float), [[0, 1, 2]], metric=metric)
        assert surface.distance(0, 1) == pytest.approx(12 * climb, rel=3e-4)
        assert surface.distance(0, 2) == pytest.approx(1.0, rel=1e-9)


def test_no_drift_is_the_metric_without_it():
    vertices, faces = bent_grid(18, 14)
    tensors = np.random.default_rng(1).uniform(1, 9, len(faces))[:, None, None] * IDENTITY
    still = vorogeo.Surface(vertices, faces, metric=vorogeo.FaceRanders(tensors, np.zeros((len(faces), 3))))
    old = vorogeo.Surface(vertices, faces, metric=vorogeo.FaceTensor(tensors))
    np.testing.assert_array_equal(still.distance_field(5), old.distance_field(5))
    np.testing.assert_array_equal(still.distance_field(5, to=True), old.distance_field(5))


def test_a_constant_drift_shifts_distances_over_t_junctions_too():
    vertices = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0, 0], [0.4, -1, 0]])
    faces = np.array([[0, 1, 2], [0, 2, 3], [0, 4, 1], [0, 5, 4], [4, 5, 1]])
    cost, drift = np.array([1, 1, 1, 9, 9.0]), np.array([0.5, 0.3, 0])
    tensors = np.eye(3) * (cost**2)[:, None, None]
    along = vorogeo.Surface(vertices, faces, metric=vorogeo.FaceRanders(tensors, np.tile(drift, (5, 1)), points=30))
    level = vorogeo.Surface(vertices, faces, metric=vorogeo.FaceTensor(tensors, points=30))
    for source in range(6):
        expected = level.distance_field(source) + (vertices - vertices[source]) @ drift
        np.testing.assert_allclose(along.distance_field(source), expected, atol=1e-9)
        for target in range(6):
            assert along.path(source, target).length == pytest.approx(expected[target], rel=1e-4, abs=1e-9)


def gradients(vertices, faces, height):
    """Of a function that is linear over each face: a vector of its plane for each."""
    a, b, c = (vertices[faces[:, i]] for i in range(3))
    normal = np.cross(b - a, c - a)
    rise = height[faces]
    turned = rise[:, :1] * np.cross(normal, c - b) + rise[:, 1:2] * np.cross(normal, a - c)
    return (turned + rise[:, 2:] * np.cross(normal, b - a)) / (normal * normal).sum(axis=1, keepdims=True)


def test_a_drift_that_is_a_gradient_changes_no_path_and_stays_exact():
    """By component: beside a mosaic of winds, which are no gradient, and with costs that jump."""
    vertices, faces = bent_grid(18, 14)
    height = 0.3 * np.sin(5 * vertices[:, 0]) * np.cos(4 * vertices[:, 1])
    drift, count = gradients(vertices, faces, height), len(vertices)
    scale = 0.9 / np.linalg.norm(drift, axis=1).max()
    drift, height = scale * drift, scale * height
    others, other_faces, mosaic_metric = mosaic(3)
    both = np.vstack([vertices, others]), np.vstack([faces, other_faces + count])
    metric = vorogeo.FaceRanders(
        np.vstack([np.tile(IDENTITY, (len(faces), 1, 1)), mosaic_metric.tensors]),
        np.vstack([drift, mosaic_metric.drift]),
    )
    surface, level = vorogeo.Surface(*both, metric=metric), vorogeo.Surface(vertices, faces)
    alone = vorogeo.Surface(others, other_faces, metric=mosaic_metric)
    sources, offsets = np.array([5, 130]), np.array([0.2, 0.0])
    for way in (1, -1):
        each = np.stack([level.distance_field(int(s)) + way * (height - height[s]) for s in sources])
        sums = each + offsets[:, None]
        field, label = surface.distance_field(
            [*sources, count + 3], offsets=[*offsets, 0.0], return_labels=True, to=way < 0
        )
        np.testing.assert_allclose(field[:count], sums.min(axis=0), rtol=1e-11, atol=1e-12)
        np.testing.assert_array_equal(label[:count], sums.argmin(axis=0))
        np.testing.assert_allclose(field[count:], alone.distance_field(3, to=way < 0), rtol=1e-12)
        limit = float(np.median(each[0]))
        near = surface.distance_field(5, limit, to=way < 0)[:count]
        np.testing.assert_allclose(near, np.where(each[0] <= limit, each[0], np.inf), rtol=1e-11, atol=1e-12)
    inside = surface.snap((vertices[faces[40]].mean(axis=0), vertices[faces[200]].mean(axis=0)))
    there = surface.path(inside[[0]], inside[[1]])
    expected = level.distance(inside[[0]], inside[[1]]) + height[faces[200]].mean() - height[faces[40]].mean()
    one = vorogeo.Surface(vertices, faces, metric=vorogeo.FaceRanders(np.tile(IDENTITY, (len(faces), 1, 1)), drift))
    assert one.path(inside[[0]], inside[[1]]).certified
    assert not there.certified  # as those of any surface with a component that jumps
    assert there.length == pytest.approx(expected, rel=1e-11)
    paths = surface.path(5, np.arange(1, 240, 2))  # from one propagation
    expected = level.distance_field(5) + height - height[5]
    np.testing.assert_allclose([path.length for path in paths], expected[1:240:2], rtol=1e-11)
    for ask in (lambda: surface.log_map(5), lambda: surface.gradient(5)):
        with pytest.raises(vorogeo.InvalidInput, match="Directions need ways back that cost the same"):
            ask()
    cost = np.random.default_rng(5).uniform(1, 4, len(faces))
    tensors = (cost**2)[:, None, None] * IDENTITY
    jumping = vorogeo.Surface(vertices, faces, metric=vorogeo.FaceRanders(tensors, drift))
    expected = vorogeo.Surface(vertices, faces, metric=vorogeo.FaceTensor(tensors)).distance_field(7)
    np.testing.assert_allclose(jumping.distance_field(7), expected + height - height[7], rtol=1e-11, atol=1e-12)


def test_a_drift_round_a_ring_is_no_gradient():
    """It has none along any loop but those round the hole, so both ways between opposite points go with it."""
    around, rings = 48, 6
    angle = 2 * np.pi * np.arange(around) / around
    radius = np.repeat(np.linspace(1, 2, rings), around)
    vertices = np.column_stack([radius * np.tile(np.cos(angle), rings), radius * np.tile(np.sin(angle), rings)])
    vertices = np.column_stack([vertices, np.zeros(len(vertices))])
    low = np.arange(around * (rings - 1))
    beside = low - low % around + (low + 1) % around
    faces = np.vstack(
        [np.column_stack([low, beside, beside + around]), np.column_stack([low, beside + around, low + around])]
    )
    turn = np.angle(np.exp(1j * (np.tile(angle, rings)[faces] - np.tile(angle, rings)[faces[:, :1]])))
    a, b, c = (vertices[faces[:, i]] for i in range(3))
    drift = np.stack(
        [
            np.r_[np.linalg.solve(np.stack([q - p, r - p])[:, :2], t[1:]), 0]
            for p, q, r, t in zip(a, b, c, turn, strict=True)
        ]
    )
    strength = 0.4
    wind = vorogeo.FaceRanders(np.tile(IDENTITY, (len(faces), 1, 1)), strength * drift, points=20)
    surface, level = vorogeo.Surface(vertices, faces, metric=wind), vorogeo.Surface(vertices, faces)
    expected = level.distance(0, around // 2) - strength * np.pi
    assert surface.distance(0, around // 2) == pytest.approx(expected, rel=1e-3)
    assert surface.distance(around // 2, 0) == pytest.approx(expected, rel=1e-3)


@pytest.mark.parametrize("height", [1e-6, 1e-9])
def test_needles_take_the_drift_along_them(height):
    vertices = np.array([[0, 0, 0], [1, 0, 0], [0.5, height, 0], [0.5, 1, 0]])
    faces = np.array([[0, 1, 2], [0, 2, 3], [2, 1, 3]])
    drift = np.array([[0.2, -0.3 / height, 0], [0.2, 0, 0], [0.2, 0, 0]])
    surface = vorogeo.Surface(vertices, faces, metric=vorogeo.FaceRanders(np.tile(np.eye(3), (3, 1, 1)), drift))
    np.testing.assert_allclose(surface.distance_field(0), [0, 1.2, 0.6, np.sqrt(1.25) + 0.1], rtol=1e-3)


@pytest.mark.parametrize("seed", range(4))
def test_ways_that_agree_with_one_another(seed):
    """Fields from and to, pairs and paths; and no way round is shorter."""
    vertices, faces, metric = mosaic(seed, points=20)
    surface = vorogeo.Surface(vertices, faces, metric=metric)
    ends = np.random.default_rng(seed).choice(len(vertices), 7, replace=False)
    fields = np.stack([surface.distance_field(int(v)) for v in ends])
    to = np.stack([surface.distance_field(int(v), to=True) for v in ends])
    matrix = fields[:, ends]
    np.testing.assert_allclose(to[:, ends].T, matrix, rtol=2e-3)
    detours = (matrix[:, :, None] + matrix[None, :, :]).min(axis=1)
    assert (matrix <= detours * (1 + 2e-3) + 1e-12).all()
    # From one point to others one run serves all, to one point from others each has its own.
    for paths, lengths in (
        (surface.path(int(ends[0]), ends[1:]), matrix[0, 1:]),
        (surface.path(ends[1:], int(ends[0])), matrix[1:, 0]),
    ):
        np.testing.assert_allclose([path.length for path in paths], lengths, rtol=2e-3)


def test_an_edge_between_two_winds_is_followed_by_both():
    """Two strips whose winds blow against each other: along the edge between, both ways go with the wind."""
    count = 40
    x = np.linspace(0, 1, count)
    vertices = np.vstack([np.column_stack([x, np.full(count, y), 0 * x]) for y in (-0.3, 0.0, 0.3)])
    a = (np.arange(2)[:, None] * count + np.arange(count - 1)).ravel()
    faces = np.vstack([np.column_stack([a, a + 1, a + count + 1]), np.column_stack([a, a + count + 1, a + count])])
    above = vertices[faces][:, :, 1].mean(axis=1) > 0
    winds = np.where(above[:, None], [0.5, 0.0, 0.0], [-0.5, 0.0, 0.0])
    surface = vorogeo.Surface(vertices, faces, metric=vorogeo.travel_time(vertices, faces, winds))
    assert surface.distance(count, 2 * count - 1) == pytest.approx(1 / 1.5, rel=1e-12)
    assert surface.distance(2 * count - 1, count) == pytest.approx(1 / 1.5, rel=1e-12)
    there = surface.distance_field(count)[count : 2 * count]
    np.testing.assert_allclose(there, x / 1.5, rtol=1e-12)


def test_refusals():
    vertices, faces, metric = mosaic()
    count = len(faces)
    strong = np.zeros((count, 3))
    strong[7] = (
        3
        * (vertices[faces[7, 1]] - vertices[faces[7, 0]])
        / np.linalg.norm(vertices[faces[7, 1]] - vertices[faces[7, 0]])
    )
    same = np.tile(IDENTITY, (count, 1, 1))
    for drift, sentence in (
        (strong, "The drift of face 7 has the norm 3.0"),
        (np.full((count, 3), np.nan), "The drift of face 0 is not finite"),
    ):
        with pytest.raises(vorogeo.InvalidInput, match=sentence):
            vorogeo.Surface(vertices, faces, metric=vorogeo.FaceRanders(same, drift))
    with pytest.raises(vorogeo.InvalidInput, match="drifts"):
        vorogeo.Surface(vertices, faces, metric=vorogeo.FaceRanders(same, strong[1:]))
    with pytest.raises(vorogeo.InvalidInput, match="no way against it"):
        vorogeo.travel_time(vertices, faces, strong)
    with pytest.raises(vorogeo.InvalidInput, match="pace"):
        vorogeo.hiking_time(vertices, faces, lambda grade: 0 * grade)
    with pytest.raises(vorogeo.InvalidInput, match="infinite"):
        vorogeo.hiking_time(vertices, faces, lambda grade: np.where(grade > 0, np.inf, 1.0))
    for cost in (-1.0, np.inf):
        with pytest.raises(vorogeo.InvalidInput, match="The downhill cost is"):
            vorogeo.climbing_cost(8, cost)
    for pace in ([[-1, 1], [0, 1], [1, np.nan]], [[0, 1], [0, 2]], [[-1, 1], [1, -1]], [[0, 1, 2]]):  # no tables
        with pytest.raises(vorogeo.InvalidInput, match="pace"):
            vorogeo.hiking_time(vertices, faces, pace)
    for pace in ([[-1, 1], [0, np.inf], [1, 1]], [[0, 1], [1, 1]]):  # no way on the level, none down
        with pytest.raises(vorogeo.InvalidInput, match="infinite on the level, or at all grades up or down"):
            vorogeo.hiking_time(vertices, faces, pace)
    leaning = np.tile(np.diag([1.0, -1.0, 1.0]), (count, 1, 1))
    with pytest.raises(vorogeo.InvalidInput, match="face 0"):
        vorogeo.Surface(vertices, faces, metric=vorogeo.FaceRanders(leaning, np.zeros((count, 3))))
    surface = vorogeo.Surface(vertices, faces, metric=metric)
    for ask, what in (
        (lambda: surface.distance_field(0, method="index"), "Indexes"),
        (lambda: surface.voronoi([0, 5], method="index"), "Indexes"),
        (lambda: surface.distance_field(0, method="quick"), "Quick distances"),
    ):
        with pytest.raises(vorogeo.InvalidInput, match=f"{what} need ways back that cost the same"):
            ask()


@pytest.mark.parametrize("to", [False, True])
def test_the_area_within_a_time_in_a_wind_is_that_of_a_circle_that_drifts(to):
    """In time t one reaches a circle of radius speed times t; areas are those of the metric's squared lengths."""
    vertices, faces = shaken_plane()
    speed, wind = 2.0, np.array([0.9, 0.5, 0.0])
    surface = vorogeo.Surface(vertices, faces, metric=vorogeo.travel_time(vertices, faces, wind, speed))
    found = surface.band(12 * 25 + 12, 0.12, to=to)
    lam = 1 - wind @ wind / speed**2
    assert found.area == pytest.approx(np.pi * 0.12**2 / lam**1.5, rel=1e-5)
    assert surface.disk_area(12 * 25 + 12, 0.12, to=to) == found.area


@pytest.mark.parametrize("seed", range(3))
def test_regions_of_two_landings_meet_where_both_times_are_equal(seed):
    """On a plane in a constant wind, by Zermelo's times; the border of a face is off by a part of a 16th of it."""
    random = np.random.default_rng(secrets.randbits(32))
    vertices, faces = shaken_plane()
    wind = np.append(random.uniform(-0.5, 0.5, 2), 0.0)
    surface = vorogeo.Surface(vertices, faces, metric=vorogeo.travel_time(vertices, faces, wind))
    sites = random.choice(len(vertices), 2, replace=False)
    for to in (False, True):
        regions = surface.voronoi(sites, to=to)
        ends = regions.borders.points
        steps = ends[None] - vertices[sites][:, None]
        times = np.stack([zermelo(-step if to else step, wind, 1.0) for step in steps])
        assert np.abs(times[0] - times[1]).max() < 0.06 / 8
        times = np.stack([zermelo((-1 if to else 1) * (vertices - vertices[s]), wind, 1.0) for s in sites])
        np.testing.assert_allclose(regions.distance, times.min(axis=0), rtol=1e-9, atol=1e-12)
        centre = (1 - wind @ wind) ** -1.5
        assert regions.area.sum() == pytest.approx(centre, rel=1e-9)


def test_climbing_costs_are_length_and_so_much_for_each_unit_of_height():
    vertices, faces = shaken_plane()
    grade = 0.3
    vertices[:, 2] = grade * vertices[:, 0]
    surface = vorogeo.Surface(vertices, faces, metric=vorogeo.hiking_time(vertices, faces, vorogeo.climbing_cost(7, 3)))
    low, high, beside = 12 * 25, 12 * 25 + 24, 24
    length = np.hypot(1, grade)
    assert surface.distance(low, high) == pytest.approx(length + 7 * grade, rel=1e-9)
    assert surface.distance(high, low) == pytest.approx(length + 3 * grade, rel=1e-9)
    assert surface.distance(beside, 624) == pytest.approx(1, rel=1e-9)
    wall = np.array([[0, 0, 0], [0, 0, 2.0], [0, 1, 0]])
    metric = vorogeo.hiking_time(wall, [[0, 1, 2]], vorogeo.climbing_cost(7, 0))
    there, back = vorogeo.Surface(wall, [[0, 1, 2]], metric=metric).distances([0, 1], [1, 0])
    assert (there, back) == pytest.approx((2 + 7 * 2, 2), rel=1e-4)
    even = vorogeo.hiking_time(vertices, faces, vorogeo.climbing_cost(0, 0))
    np.testing.assert_allclose(
        vorogeo.Surface(vertices, faces, metric=even).distance_field(5),
        vorogeo.Surface(vertices, faces).distance_field(5),
        rtol=1e-9,
    )
