"""Directions with numpy: frames, log maps and traced lines on surfaces that unroll, and what is refused."""

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid, cube, plane_grid, prism, real_mesh, side_by_side


def in_space(frame, vectors):
    return vectors @ frame[:2]


@pytest.mark.parametrize("where", ["vertex", "edge", "face"])
def test_on_a_plane_vectors_are_straight_lines(where):
    vertices, faces = plane_grid(9, 7, 1.6, 1.2)
    surface = vorogeo.Surface(vertices, faces)
    point = {
        "vertex": 30,
        "edge": vorogeo.SurfacePoints([40], [[0.3, 0.7, 0.0]]),
        "face": vorogeo.SurfacePoints([40], [[0.3, 0.5, 0.2]]),
    }[where]
    place = vertices[30] if where == "vertex" else point.positions(vertices, faces)[0]
    (frame,) = surface.tangent_frames(point)
    np.testing.assert_allclose(frame @ frame.T, np.eye(3), atol=1e-12)
    np.testing.assert_allclose(np.abs(frame[2]), [0, 0, 1], atol=1e-12)
    vector, distance = surface.log_map(point, return_distance=True)
    np.testing.assert_allclose(in_space(frame, vector), vertices - place, atol=1e-12)
    np.testing.assert_allclose(distance, np.linalg.norm(vertices - place, axis=1), atol=1e-12)
    ends, length = surface.exp_map(point, vector, return_length=True)
    np.testing.assert_allclose(ends.positions(vertices, faces), vertices, atol=1e-12)
    np.testing.assert_allclose(length, distance, atol=1e-12)
    targets = vorogeo.SurfacePoints([3, 50], [[0.2, 0.2, 0.6], [0.1, 0.9, 0.0]])
    there = targets.positions(vertices, faces)
    np.testing.assert_allclose(in_space(frame, surface.log_map(point, targets)), there - place, atol=1e-12)
    assert surface.last.by == "exact"


def test_the_first_edge_of_a_vertex_is_its_x_axis_and_angles_sum_to_two_pi():
    vertices, faces = cube()
    surface = vorogeo.Surface(vertices, faces)
    for vertex in range(8):
        face = int(np.flatnonzero((faces == vertex).any(axis=1))[-1])
        corner = int(np.flatnonzero(faces[face] == vertex)[0])
        following, last = faces[face][(corner + 1) % 3], faces[face][(corner + 2) % 3]
        vector = surface.log_map(vertex, [following, last])
        length = np.linalg.norm(vertices[[following, last]] - vertices[vertex], axis=1)
        np.testing.assert_allclose(vector[0], [length[0], 0.0], atol=1e-12)
        a, b = vertices[following] - vertices[vertex], vertices[last] - vertices[vertex]
        angle = np.arccos(a @ b / np.prod(length)) * 2 * np.pi / (1.5 * np.pi)
        np.testing.assert_allclose(vector[1], length[1] * np.array([np.cos(angle), np.sin(angle)]), atol=1e-12)
        # All edges, each turned back about the normal, (+-1, +-1, +-1) by symmetry.
        frame = surface.tangent_frames(vertex)[0]
        np.testing.assert_allclose(frame[2], (2 * vertices[vertex] - 1) / np.sqrt(3), atol=1e-12)
        others = np.unique(faces[(faces == vertex).any(axis=1)])
        others = others[others != vertex]
        known = surface.log_map(vertex, others)
        turn = np.arctan2(known[:, 1], known[:, 0])[:, None]
        edges = vertices[others] - vertices[vertex]
        flat = edges - (edges @ frame[2])[:, None] * frame[2]
        x = (np.cos(turn) * flat - np.sin(turn) * np.cross(frame[2], flat)).sum(axis=0)
        np.testing.assert_allclose(frame[0], x / np.linalg.norm(x), atol=1e-12)
        np.testing.assert_allclose(frame[1], np.cross(frame[2], frame[0]), atol=1e-12)


def test_around_a_tube_a_line_is_a_helix():
    sides, rows, height = 12, 9, 4.0
    vertices, faces = prism(sides, rows, height)
    surface = vorogeo.Surface(vertices, faces)
    point = surface.snap([0.99, 0.3, 1.1])
    place = point.positions(vertices, faces)[0]
    frame = surface.tangent_frames(point)[0]
    around = sides * 2 * np.sin(np.pi / sides)
    up = frame[:2, 2]
    across = np.array([-up[1], up[0]])
    rise = np.linspace(-1.0, 2.5, 30)
    turns = np.repeat([1.0, -1.0, 2.0], 10)
    ends = surface.exp_map(point, rise[:, None] * up + turns[:, None] * around * across)
    np.testing.assert_allclose(ends.positions(vertices, faces), place + rise[:, None] * [0, 0, 1], atol=1e-11)


def test_at_the_border_lines_end_or_slide():
    vertices, faces = plane_grid(5, 5)
    surface = vorogeo.Surface(vertices, faces)
    point = surface.snap([0.4, 0.7, 0.0])
    frame = surface.tangent_frames(point)[0]
    vectors = np.array([[0.3, 0.6, 0.0], [0.05, -0.1, 0.0]]) @ frame[:2].T
    ends, length = surface.exp_map(point, vectors, return_length=True)
    np.testing.assert_allclose(ends.positions(vertices, faces), [[0.55, 1, 0], [0.45, 0.6, 0]], atol=1e-12)
    np.testing.assert_allclose(length, [np.hypot(0.15, 0.3), np.hypot(0.05, 0.1)], atol=1e-12)
    ends, length = surface.exp_map(point, vectors, at_border="slide", return_length=True)
    slid = np.hypot(0.3, 0.6) - np.hypot(0.15, 0.3)
    np.testing.assert_allclose(ends.positions(vertices, faces)[0], [0.55 + slid, 1, 0], atol=1e-12)
    np.testing.assert_allclose(length, np.linalg.norm(vectors, axis=1), atol=1e-12)


def test_pairs_of_points_and_vectors():
    vertices, faces = plane_grid(9, 7, 1.6, 1.2)
    surface = vorogeo.Surface(vertices, faces)
    points = [30, 31, 40]
    frames = surface.tangent_frames(points)
    steps = np.array([[0.1, 0.05, 0], [-0.2, 0.1, 0], [0.0, -0.3, 0]])
    ends = surface.exp_map(points, np.einsum("kac,kc->ka", frames[:, :2], steps))
    np.testing.assert_allclose(ends.positions(vertices, faces), vertices[points] + steps, atol=1e-12)
    assert len(surface.exp_map(30, np.empty((0, 2)))) == 0
    np.testing.assert_allclose(surface.exp_map(30, [0, 0]).positions(vertices, faces)[0], vertices[30])


def test_of_other_components_and_beyond_the_limit_nothing_is_known():
    one = plane_grid(5, 5)
    vertices, faces = side_by_side(one, one)
    vector, distance = vorogeo.Surface(vertices, faces).log_map(12, max_distance=0.4, return_distance=True)
    known = np.linalg.norm(vertices - vertices[12], axis=1) <= 0.4
    assert np.isnan(vector[~known]).all()
    assert np.isinf(distance[~known]).all()
    assert np.isfinite(vector[known]).all()


@pytest.mark.parametrize("name", ["bunny10k_textured.obj", "spot", "fandisk"])
def test_lines_lead_back_to_where_log_maps_say(name):
    vertices, faces = real_mesh(name)
    surface = vorogeo.Surface(vertices, faces)
    vector, distance = surface.log_map(17, return_distance=True)
    np.testing.assert_allclose(distance, surface.distance_field(17, method="exact"), rtol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(vector, axis=1), distance, rtol=1e-12)
    chosen = np.random.default_rng(3).choice(np.flatnonzero(np.isfinite(distance) & (distance > 0)), 200)
    paths = surface.path(17, chosen, method="exact")
    straight = np.array([(path.vertices[1:-1] < 0).all() for path in paths])
    assert straight.sum() > 10  # the others lie behind a saddle of the rough surface
    ends = surface.exp_map(17, vector[chosen]).positions(vertices, faces)
    off = np.linalg.norm(ends - vertices[chosen], axis=1)
    assert (off[straight] <= 1e-9 * np.maximum(distance[chosen], np.ptp(vertices))[straight]).all()


def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def some_flipped(faces):
    turned = np.random.default_rng().random(len(faces)) < 0.3
    return np.where(turned[:, None], faces[:, ::-1], faces)


def test_on_a_plane_gradients_lead_straight_away_and_vectors_stay_as_they_are():
    vertices, faces = plane_grid(9, 7, 1.6, 1.2)
    faces = some_flipped(faces)
    surface = vorogeo.Surface(vertices, faces)
    source = vorogeo.SurfacePoints([40], [[0.3, 0.5, 0.2]])
    centres = vorogeo.SurfacePoints(np.arange(len(faces)), np.full((len(faces), 3), 1 / 3))
    place = source.positions(vertices, faces)[0]
    inside = np.setdiff1d(np.arange(len(vertices)), [0, 8, 54, 62])  # at the corners of the sheet, angles are scaled
    for points, places in ((inside, vertices[inside]), (centres, centres.positions(vertices, faces))):
        frames = surface.tangent_frames(points)
        gradient = np.einsum("ka,kac->kc", surface.gradient(source, points), frames[:, :2])
        np.testing.assert_allclose(gradient, unit(places - place), atol=1e-9)
    assert np.isnan(surface.gradient(source, source)).all()
    assert np.isnan(surface.gradient([30, 31], max_distance=0.3)[[30, 31, 62]]).all()
    np.testing.assert_array_equal(surface.gradient(source)[inside], surface.gradient(source, inside))
    for target in inside:
        path = surface.path(source, target)
        before, after = (surface.tangent_frames(point)[0] for point in (source, target))
        carried = surface.transport(path, [[1, 2], [0, 0]])
        np.testing.assert_allclose(in_space(after, carried), in_space(before, np.array([[1, 2], [0, 0]])), atol=1e-9)


def test_gradients_over_a_bridged_gap_and_steps_of_rounding():
    one = plane_grid(5, 5)
    vertices, faces = np.vstack([one[0], one[0] + [1.0, 0, 0]]), np.vstack([one[1], one[1] + 25])
    gradient = vorogeo.Surface(vertices, faces, gap=1e-3).gradient(12)
    assert np.isnan(gradient[12]).all()
    np.testing.assert_allclose(np.linalg.norm(np.delete(gradient, 12, axis=0), axis=1), 1)
    near = vorogeo.SurfacePoints([9, 9], [[0.3, 0.5, 0.2], [0.3 + 1e-15, 0.5 - 1e-15, 0.2]])
    np.testing.assert_allclose(vorogeo.Surface(*one).transport(near, [1, 2]), [[1, 2]], atol=1e-9)


def test_round_a_corner_of_a_cube_a_vector_turns_by_the_angle_that_is_missing_there():
    vertices, faces = cube()
    surface = vorogeo.Surface(vertices, some_flipped(faces))
    corner = vertices.max(axis=0)
    size = corner[0] - vertices.min()
    ring = surface.snap(corner - 0.3 * size * np.array([[1, 1, 0], [0, 1, 1], [1, 0, 1]]))
    (carried,) = surface.transport(surface.path_through(ring, closed=True), [3, 4])
    np.testing.assert_allclose(np.abs(np.dot(carried, [3, 4])), 0, atol=1e-9)
    np.testing.assert_allclose(np.linalg.norm(carried), 5, atol=1e-9)


@pytest.mark.parametrize("name", ["bunny10k_textured.obj", "spot", "fandisk"])
def test_a_direction_that_is_carried_along_its_line_is_the_gradient_at_the_end(name):
    vertices, faces = real_mesh(name)
    surface = vorogeo.Surface(vertices, faces)
    vector, gradient = surface.log_map(17), surface.gradient(17)
    np.testing.assert_allclose(np.linalg.norm(gradient[np.isfinite(vector[:, 0])][:17], axis=1), 1)
    straight = 0
    for target in np.random.default_rng().choice(np.flatnonzero(np.isfinite(gradient[:, 0])), 100):
        path = surface.path(17, target, method="exact")
        if (path.vertices[1:-1] >= 0).any():
            continue
        straight += 1
        np.testing.assert_allclose(surface.transport(path, unit(vector[target]))[0], gradient[target], atol=1e-7)
    assert straight > 3


def test_a_constant_cost_scales_vectors_and_has_no_frames_in_space():
    vertices, faces = bent_grid(9, 8)
    dear = vorogeo.Surface(vertices, faces, metric=vorogeo.VertexCost(np.full(len(vertices), 3.0)))
    plain = vorogeo.Surface(vertices, faces)
    np.testing.assert_allclose(dear.log_map(30), 3 * plain.log_map(30), rtol=1e-9, atol=1e-9)
    with pytest.raises(vorogeo.InvalidInput, match="With a metric, frames have no axes in space"):
        dear.tangent_frames(30)


def test_an_index_does_not_answer_for_directions():
    vertices, faces = bent_grid(9, 8)
    index = vorogeo.GeodesicIndex(vertices, faces)
    np.testing.assert_array_equal(index.log_map(30), vorogeo.Surface(vertices, faces).log_map(30))
    assert index.last.by == "exact"


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda s: s.log_map([1, 2]), "point: has 2 points; give one"),
        (lambda s: s.log_map(1000), "point: there is no vertex 1000"),
        (lambda s: s.log_map(1, max_distance=-1), "max_distance: -1.0 is negative"),
        (lambda s: s.exp_map([1, 2], [[1, 0]] * 3), "points has 2 points, vectors 3"),
        (lambda s: s.exp_map(1, [1, 2, 3]), r"vectors: has shape \(1, 3\)"),
        (lambda s: s.exp_map(1, [np.nan, 0]), r"vectors\[0\]: \[nan, 0.0\] is not finite"),
        (lambda s: s.exp_map(1, [1, 0], at_border="stop"), "at_border: 'stop' is unknown"),
        (lambda s: s.gradient([]), "sources"),
        (lambda s: s.gradient(1, 80), "There are no directions at vertex 80"),
        (lambda s: s.transport([1, 2], [np.inf, 0]), "vectors"),
        (
            lambda s: s.transport([1, 71], [1, 0]),
            r"Points 0 \(vertex 1\) and 1 \(vertex 71\) of the path share no face",
        ),
        (lambda s: s.log_map(80), "There are no directions at vertex 80: no face has it"),
        (lambda s: s.exp_map(vorogeo.SurfacePoints([112], [[0.2, 0.3, 0.5]]), [1, 0]), "face 112: it has no area"),
    ],
)
def test_bad_input_is_refused_by_name(call, message):
    vertices, faces = plane_grid(9, 8)  # 72 vertices, 112 faces
    vertices = np.vstack([vertices, np.tile([5.0, 5.0, 0.0], (9, 1)) + np.arange(9)[:, None]])
    surface = vorogeo.Surface(vertices, np.vstack([faces, [[72, 73, 75]]]))
    with pytest.raises(vorogeo.InvalidInput, match=message):
        call(surface)


def test_metrics_that_jump_are_refused_by_name():
    vertices, faces = plane_grid(9, 8)
    cost = np.ones(len(faces))
    cost[5] = 4.0
    surface = vorogeo.Surface(vertices, faces, metric=vorogeo.FaceCost(cost))
    with pytest.raises(vorogeo.InvalidInput, match="Directions need edges on whose length both faces agree"):
        surface.log_map(30)
