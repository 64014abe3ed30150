"""Directions with numpy: frames, log maps and traced lines on surfaces that unroll, and what is refused."""

from pathlib import Path

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid, cube, plane_grid, prism, real_mesh, side_by_side, sphere, torus


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
    surface = vorogeo.Surface(vertices, faces)
    vector, distance = surface.log_map(12, max_distance=0.4, return_distance=True)
    assert surface.last.unreached == len(one[0])
    surface.log_map(12, targets=[0, 30, 40])
    assert surface.last.unreached == 2
    surface.gradient([12, 40])
    assert surface.last.unreached == 0
    known = np.linalg.norm(vertices - vertices[12], axis=1) <= 0.4
    assert np.isnan(vector[~known]).all()
    assert np.isinf(distance[~known]).all()
    assert np.isfinite(vector[known]).all()


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


def test_round_an_octant_of_a_sphere_a_vector_turns_by_its_area():
    """By symmetry, whatever its faces: an eighth of the curvature of the whole."""
    side = 6
    places = [(i, j, side - i - j) for i in range(side + 1) for j in range(side + 1 - i)]
    up, down = [(1, 0), (0, 1), (0, 0)], [(1, 0), (0, 1), (1, 1)]
    faces, number = [], {}
    for signs in np.array(np.meshgrid([1, -1], [1, -1], [1, -1])).reshape(3, 8).T:
        for i, j, k in places:
            for steps in [up, down][: min(k, 2)]:
                at = [tuple((signs * (i + a, j + b, k - a - b)).tolist()) for a, b in steps]
                faces.append([number.setdefault(place, len(number)) for place in at])
    vertices = np.array(list(number), dtype=float)
    vertices /= np.linalg.norm(vertices, axis=1, keepdims=True)
    surface = vorogeo.Surface(vertices, some_flipped(np.array(faces, dtype=np.int32)))
    steps = range(side)
    ring = [(side - i, i, 0) for i in steps] + [(0, side - i, i) for i in steps] + [(i, 0, side - i) for i in steps]
    (carried,) = surface.transport([number[place] for place in [*ring, ring[0]]], [3, 4])
    np.testing.assert_allclose(np.abs(carried @ [3, 4]), 0, atol=1e-9)
    np.testing.assert_allclose(np.linalg.norm(carried), 5, atol=1e-9)


@pytest.mark.parametrize("name", ["bunny10k_textured.obj", "fandisk", "casting"])
def test_carried_to_all_vertices_a_vector_is_that_carried_along_each_path(name):
    vertices, faces = real_mesh(name)
    surface = vorogeo.Surface(vertices, some_flipped(faces))
    for point in (17, vorogeo.SurfacePoints([40], [[0.3, 0.5, 0.2]]), vorogeo.SurfacePoints([40], [[0.3, 0.7, 0.0]])):
        carried = surface.transport_from(point, [3, 4])
        assert surface.last.by == "exact"
        reached = np.flatnonzero(np.isfinite(carried[:, 0]))
        np.testing.assert_allclose(np.linalg.norm(carried[reached], axis=1), 5, rtol=1e-9)
        chosen = np.random.default_rng(3).choice(reached, 100)
        along = [surface.transport(path, [3, 4])[0] for path in surface.path(point, chosen, method="exact")]
        same = np.abs(carried[chosen] - along).max(axis=1) < 1e-6
        assert same.mean() > 0.95  # others have several shortest paths
    np.testing.assert_allclose(surface.transport_from(17, [3, 4])[17], [3, 4])
    far = surface.distance_field(17, method="exact") > 0.1 * np.ptp(vertices)
    near = surface.transport_from(17, [3, 4], max_distance=0.1 * np.ptp(vertices))
    assert np.isnan(near[far]).all()
    assert np.isfinite(near[~far]).any()
    with pytest.raises(vorogeo.InvalidInput, match="vector: has 2 vectors"):
        surface.transport_from(17, [[1, 0], [0, 1]])


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
    assert straight > 0


def test_a_constant_cost_scales_vectors_and_has_no_frames_in_space():
    vertices, faces = bent_grid(9, 8)
    dear = vorogeo.Surface(vertices, faces, metric=vorogeo.VertexCost(np.full(len(vertices), 3.0)))
    plain = vorogeo.Surface(vertices, faces)
    np.testing.assert_allclose(dear.log_map(30), 3 * plain.log_map(30), rtol=1e-9, atol=1e-9)
    with pytest.raises(vorogeo.InvalidInput, match="With a metric, frames have no axes in space"):
        dear.tangent_frames(30)


def test_an_index_answers_for_log_maps_where_it_is_asked_to():
    vertices, faces = bent_grid(80, 75)
    index = vorogeo.GeodesicIndex(vertices, faces)
    exact = index.log_map(3030)
    np.testing.assert_array_equal(exact, vorogeo.Surface(vertices, faces).log_map(3030))
    assert index.last.by == "exact"
    vector, distance = index.log_map(3030, return_distance=True, method="index")
    assert index.last.by == "index"
    length = np.linalg.norm(exact, axis=1)
    np.testing.assert_allclose(np.linalg.norm(vector, axis=1), distance, rtol=1e-12)
    np.testing.assert_allclose(distance, length, rtol=0.02)
    # What the vectors are apart, in units of their length: the angle between them.
    apart = np.linalg.norm(vector - exact, axis=1)[length > 0] / length[length > 0]
    assert np.degrees(apart.mean()) < 0.5
    for row, point in zip(index.log_map(3030, [7, 3000], method="index"), (7, 3000), strict=True):
        np.testing.assert_array_equal(row, vector[point])


def test_log_maps_from_an_index_leave_its_fields_alone_and_are_the_same_from_its_file(tmp_path):
    vertices, faces = bent_grid(70, 60)
    index = vorogeo.GeodesicIndex(vertices, faces, threads=2)
    point = vorogeo.SurfacePoints([900], [[0.2, 0.3, 0.5]])
    field, regions = index.distance_field(2100), index.voronoi([5, 2100, 4100]).vertex_region
    vector = index.log_map(point, method="index")
    np.testing.assert_array_equal(index.distance_field(2100), field)
    np.testing.assert_array_equal(index.voronoi([5, 2100, 4100]).vertex_region, regions)
    index.save(tmp_path / "grid.vgi")
    loaded = vorogeo.GeodesicIndex.load(tmp_path / "grid.vgi", vertices, faces, threads=1)
    np.testing.assert_array_equal(loaded.log_map(point, method="index"), vector)


def test_log_maps_from_an_index_count_in_its_metric_up_to_a_limit_and_to_points_in_faces():
    vertices, faces = plane_grid(70, 60, 1.4, 1.2)
    index = vorogeo.GeodesicIndex(vertices, faces, metric=vorogeo.VertexCost(np.full(len(vertices), 3.0)))
    rng = np.random.default_rng()
    targets = vorogeo.SurfacePoints(rng.integers(len(faces), size=500), rng.dirichlet([1, 1, 1], 500))
    source = int(rng.choice(np.flatnonzero(((vertices > 0.1) & (vertices < [1.3, 1.1, 1]) | [0, 0, 1]).all(axis=1))))
    frame = vorogeo.Surface(vertices, faces).tangent_frames(source)[0]
    for ends, there in ((None, vertices), (targets, targets.positions(vertices, faces))):
        straight = 3 * (there - vertices[source])
        length = np.linalg.norm(straight, axis=1)
        vector, distance = index.log_map(source, ends, 1.5, return_distance=True, method="index")
        near, far = length < 1.49, length > 1.51
        assert np.isfinite(vector[near]).all()
        assert np.isnan(vector[far]).all()
        assert np.isinf(distance[far]).all()
        apart = np.linalg.norm(in_space(frame, vector) - straight, axis=1)[near & (length > 0)]
        assert np.degrees((apart / length[near & (length > 0)]).mean()) < 0.3


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda s: s.log_map([1, 2]), "point: has 2 points; give one"),
        (lambda s: s.log_map(1000), "point: there is no vertex 1000"),
        (lambda s: s.log_map(1, max_distance=-1), "max_distance: -1.0 is negative"),
        (lambda s: s.log_map(1, method="quick"), "method: 'quick' is unknown"),
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


def test_a_square_on_a_plane_has_a_signed_distance_and_offsets():
    vertices, faces = plane_grid(17, 17, 2.0, 2.0)
    surface = vorogeo.Surface(vertices, faces)
    at = {tuple(p): i for i, p in enumerate(np.round(vertices[:, :2], 9).tolist())}
    corners = [at[x, y] for x, y in [(0.5, 0.5), (1.5, 0.5), (1.5, 1.5), (0.5, 1.5)]]
    curve = surface.path_through(corners, closed=True)
    found = surface.signed_distance(curve)
    assert surface.last.by == "exact"
    off = np.abs(vertices[:, :2] - 1.0) - 0.5
    expected = np.minimum(off.max(axis=1), 0) + np.linalg.norm(np.maximum(off, 0), axis=1)
    np.testing.assert_allclose(found, expected, atol=1e-6)
    np.testing.assert_allclose(surface.signed_distance(curve.surface_points), found, atol=1e-12)
    np.testing.assert_allclose(surface.signed_distance([curve]), found, atol=1e-12)
    region = (np.abs(vertices[faces].mean(axis=1)[:, :2] - 1.0) < 0.5).all(axis=1)
    np.testing.assert_allclose(surface.signed_distance(region), found, atol=1e-12)
    limited = surface.signed_distance(curve, max_distance=0.25)
    np.testing.assert_array_equal(np.isinf(limited), np.abs(found) > 0.25)
    assert np.sign(limited[np.isinf(limited)]).tolist() == np.sign(found[np.isinf(limited)]).tolist()
    # A square of half the side, whose corners are cut off in their faces.
    inner = surface.isolines(found, [-0.25], "linear")
    assert 1.8 < inner.length < 2.0
    assert np.abs(np.abs(inner.points[:, :2] - 1).max(axis=1) - 0.25).max() < 0.07


def test_regions_and_limits_that_are_none_are_refused():
    surface = vorogeo.Surface(*plane_grid(9, 9, 1.0, 1.0))
    with pytest.raises(vorogeo.InvalidInput, match="give one for each of the 128 faces"):
        surface.signed_distance(np.ones(5, dtype=bool))
    with pytest.raises(vorogeo.InvalidInput, match="Curve 0 is open: it begins at vertex 0"):
        surface.signed_distance([0, 1, 2])
    with pytest.raises(vorogeo.InvalidInput, match="max_distance"):
        surface.signed_distance([10, 11, 20, 10], max_distance=-1)


@pytest.mark.parametrize("seed", [1, 2])
def test_derivatives_of_distances_are_those_of_finite_differences(seed):
    vertices, faces = cube()
    random = np.random.default_rng(seed)
    surface = vorogeo.Surface(vertices, faces)
    source = vorogeo.SurfacePoints([0, 3, 6], random.dirichlet([2, 2, 2], 3))
    target = vorogeo.SurfacePoints([11, 8, 1], random.dirichlet([2, 2, 2], 3))
    found = surface.distance_gradient(source, target)
    np.testing.assert_allclose(found.distances, surface.distance(source, target, method="exact"), rtol=1e-12)
    weights = np.array([1.0, -2.0, 0.5])
    gradient = np.zeros_like(vertices)
    np.add.at(gradient, found.vertices, found.values * weights[found.pairs, None])
    np.testing.assert_allclose(gradient.sum(axis=0), 0, atol=1e-12)
    np.testing.assert_allclose((gradient * vertices).sum(), weights @ found.distances, rtol=1e-9)
    way, step = random.normal(size=vertices.shape), 1e-6
    there, here = (
        vorogeo.Surface(vertices + side * way, faces).distance(source, target, method="exact") for side in (step, -step)
    )
    np.testing.assert_allclose((gradient * way).sum(), weights @ (there - here) / (2 * step), atol=1e-6)


def test_the_derivative_can_be_used_in_torch():
    torch = pytest.importorskip("torch")
    text = (Path(__file__).parents[2] / "docs" / "directions.md").read_text()
    recipe = next(block for block in text.split("```python")[1:] if "torch.autograd.Function" in block).split("```")[0]
    names = {"torch": torch, "np": np, "vorogeo": vorogeo}
    exec(recipe, names)
    vertices, faces = cube()
    at = torch.tensor(vertices, requires_grad=True)
    names["Distances"].apply(at, faces, [0, 1], [7, 6]).sum().backward()
    assert torch.isclose((at.grad * at).sum(), torch.tensor(2 * np.sqrt(5.0), dtype=torch.float64))


def test_the_cut_locus_of_a_tube_is_the_line_opposite():
    vertices, faces = prism(12, 9, 4.0)
    surface = vorogeo.Surface(vertices, faces)
    point = surface.snap([0.9, 0.1, 1.1])
    place = point.positions(vertices, faces)[0]
    locus = surface.cut_locus(point)
    np.testing.assert_allclose(locus.length, 4.0, atol=1e-9)
    half = 12 * np.sin(np.pi / 12)
    np.testing.assert_allclose(locus.distance, np.hypot(half, locus.points[:, 2] - place[2]), atol=1e-9)
    np.testing.assert_allclose(locus.surface_points.positions(vertices, faces), locus.points, atol=1e-12)
    assert locus.angle.max() <= np.pi + 1e-12
    assert len(surface.cut_locus(point, min_angle=3.0).edges) < len(locus.edges)
    for angle, problem in ((4, "4.0 is out of range"), (-1, "-1.0 is out of range"), (np.nan, "is NaN")):
        with pytest.raises(vorogeo.InvalidInput, match=f"min_angle: {problem}; give an angle from 0 to pi, in radians"):
            surface.cut_locus(point, min_angle=angle)
    with pytest.raises(vorogeo.InvalidInput, match="sources: is empty"):
        surface.cut_locus([])


def apart():
    """Two sheets of so many vertices, behind them a vertex without faces and the corners of a face without area."""
    vertices, faces = plane_grid(9, 7, 1.6, 1.2)
    count = len(vertices)
    beside = vertices + np.array([9, 0, 0])
    vertices = np.vstack([vertices, beside, [[5, 5, 0], [0, 7, 0], [1, 7, 0], [2, 7, 0]]])
    last = len(vertices) - 1
    return vertices, np.vstack([faces, faces + count, [[last - 2, last - 1, last]]]), count


def test_what_no_path_reaches_is_counted():
    vertices, faces, count = apart()
    surface = vorogeo.Surface(vertices, faces)
    elsewhere = [count, 2 * count, 2 * count + 1]
    vector, distance = surface.log_map(3, targets=elsewhere, return_distance=True)
    assert np.isnan(vector).all()
    assert np.isinf(distance).all()
    assert surface.last.unreached == 3
    surface.cut_locus([3, 9])
    assert surface.last.unreached == len(vertices) - count
    assert np.isinf(surface.distance_gradient([3, 3], [count, 9]).distances).tolist() == [True, False]
    assert surface.last.unreached == 1


@pytest.mark.parametrize(
    ("where", "message"),
    [
        ("alone", r"vertex \d+: no face has it"),
        ("corner", r"vertex \d+: the angles of its faces sum to 0"),
        ("face", r"face \d+: it has no area"),
    ],
)
def test_places_without_directions_are_named(where, message):
    vertices, faces, count = apart()
    face = vorogeo.SurfacePoints([len(faces) - 1], [[0.3, 0.3, 0.4]])
    where = {"alone": 2 * count, "corner": 2 * count + 1, "face": face}[where]
    surface = vorogeo.Surface(vertices, faces)
    for ask in (
        lambda: surface.log_map(where),
        lambda: surface.exp_map(where, [1, 0]),
        lambda: surface.exp_map(where, [0, 0]),
        lambda: surface.tangent_frames(where),
        lambda: surface.transport_from(where, [1, 0]),
        lambda: surface.frechet_mean(where),
        lambda: surface.texture_coordinates(where, radius=1),
    ):
        with pytest.raises(vorogeo.InvalidInput, match=message):
            ask()
    assert len(surface.cut_locus(where).edges) == 0
    assert np.isnan(surface.gradient(where)[:count]).all()


@pytest.mark.parametrize("height", [1e3, 1e6, 1e9, 1e12, 1e15])
def test_directions_at_needles(height):
    """A tip whose angles sum to next to nothing is reached by lines; where they sum to rounding, it has no frame."""
    angle = np.arange(12) * np.pi / 6
    vertices = np.vstack([[0, 0, height], np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])])
    surface = vorogeo.Surface(vertices, [[0, 1 + i, 1 + (i + 1) % 12] for i in range(12)])
    up = surface.log_map(1, targets=[0])
    np.testing.assert_allclose(np.hypot(*up[0]), np.hypot(1, height), rtol=1e-12)
    np.testing.assert_allclose(surface.exp_map(1, up).positions(vertices, surface.faces), vertices[:1], rtol=1e-9)
    if height < 1e12:
        down = surface.log_map(0)[1:]
        np.testing.assert_allclose(np.hypot(*down.T), np.hypot(1, height), rtol=1e-12)
        turned = np.sort(np.arctan2(down[:, 1], down[:, 0]))
        np.testing.assert_allclose(np.diff(turned), np.pi / 6, rtol=1e-6)
    else:
        with pytest.raises(vorogeo.InvalidInput, match="the angles of its faces sum to 0"):
            surface.log_map(0)


def test_texture_coordinates_of_a_plane_are_the_picture_itself():
    vertices, faces = plane_grid(9, 7, 1.6, 1.2)
    surface = vorogeo.Surface(vertices, faces)
    uv, stretch = surface.texture_coordinates(30, radius=0.5, rotation=0.4, scale=2)
    off = vertices - vertices[30]
    frame = surface.tangent_frames(30)[0]
    x, y = np.cos(0.4) * frame[0] + np.sin(0.4) * frame[1], np.cos(0.4) * frame[1] - np.sin(0.4) * frame[0]
    near = np.linalg.norm(off, axis=1) <= 0.5
    np.testing.assert_allclose(uv[near], 0.5 + np.column_stack([off @ x, off @ y])[near] / 2, atol=1e-12)
    assert np.isnan(uv[~near]).all()
    np.testing.assert_allclose(stretch[near[faces].all(axis=1)], 1, atol=1e-7)
    assert np.isnan(stretch[~near[faces].all(axis=1)]).all()
    for wrong, message in [
        ({"radius": 0}, "The radius"),
        ({"radius": 1, "scale": np.nan}, "scale"),
        ({"radius": -1}, "radius"),
    ]:
        with pytest.raises(vorogeo.InvalidInput, match=message):
            surface.texture_coordinates(30, **wrong)


def test_moved_turned_scaled_and_renumbered_all_directions_are_the_same():
    random = np.random.default_rng()
    vertices, faces = bent_grid(13, 11)
    vertices = vertices + random.uniform(-0.01, 0.01, vertices.shape)
    turn = np.linalg.qr(random.normal(size=(3, 3)))[0]
    turn *= np.linalg.det(turn)
    scale, order = 10 ** random.uniform(-3, 3), random.permutation(len(vertices))
    number = np.argsort(order)  # by vertex, the new one
    rows = random.permutation(len(faces))
    corners = (np.arange(3) + random.integers(3, size=(len(faces), 1))) % 3
    renumbered = np.take_along_axis(number[faces], corners, axis=1)[rows]
    one = vorogeo.Surface(vertices, faces)
    other = vorogeo.Surface((scale * vertices @ turn.T + random.normal(size=3))[order], renumbered)
    point = int(random.integers(len(vertices)))
    there = int(number[point])
    axes = one.tangent_frames(np.arange(len(vertices)))
    new_axes = other.tangent_frames(number)  # by the old number
    np.testing.assert_allclose(axes[:, 2] @ turn.T, new_axes[:, 2], atol=1e-9)

    def same(vectors, others, lengths=1.0):
        """In space, but for places to which several paths are shortest."""
        a, b = (np.einsum("nk,nkc->nc", *pair) for pair in ((vectors, axes[:, :2]), (others, new_axes[:, :2])))
        off = np.linalg.norm(lengths * a @ turn.T - b, axis=1)
        assert (off[np.isfinite(off)] < 1e-7 * lengths).mean() > 0.97
        np.testing.assert_array_equal(np.isnan(a), np.isnan(b))

    same(one.gradient(point), other.gradient(there)[number])
    vector = random.normal(size=2)
    moved = vector @ axes[point][:2] @ turn.T @ new_axes[point][:2].T
    same(one.transport_from(point, vector), other.transport_from(there, moved)[number])
    ours, theirs = one.log_map(point), other.log_map(there)[number]
    ours, theirs = (v @ a[:2] for v, a in ((ours, axes[point]), (theirs, new_axes[point])))
    off = np.linalg.norm(scale * ours @ turn.T - theirs, axis=1)
    assert (off < 1e-7 * scale).mean() > 0.97
    uv, stretch = one.texture_coordinates(point, 0.6)
    new_uv, new_stretch = other.texture_coordinates(there, 0.6 * scale)
    np.testing.assert_allclose(
        np.linalg.norm(uv - 0.5, axis=1), np.linalg.norm(new_uv[number] - 0.5, axis=1), atol=1e-9
    )
    assert (np.abs(stretch[rows] - new_stretch) < 1e-6)[np.isfinite(new_stretch)].mean() > 0.7
    ring = [29, 35, 113, 107]
    curve = one.path_through(ring, closed=True)
    again = other.path_through(number[ring], closed=True)
    np.testing.assert_allclose(
        scale * one.signed_distance(curve), other.signed_distance(again)[number], atol=1e-8 * scale
    )
    locus, new_locus = one.cut_locus(point), other.cut_locus(there)
    # Of the points where lines meet, a few are off by up to a face.
    np.testing.assert_allclose(scale * locus.length, new_locus.length, rtol=1e-2, atol=0.1 * scale)
    np.testing.assert_allclose(scale * locus.distance.max(initial=0), new_locus.distance.max(initial=0), rtol=1e-9)


@pytest.mark.parametrize("sides", [5, 6, 9])
def test_at_the_tip_of_a_cone_angles_are_those_of_a_turn(sides):
    """At the tip of a pyramid or of a saddle (of 9 triangles): polar coordinates with the angle scaled to 2 pi."""
    radii = np.array([1.0, 2.0, 2.5])
    angle = 2 * np.pi * np.arange(sides) / sides
    # Side lengths alone make the cone: each ring a multiple of equilateral triangles with the tip.
    faces, lengths = [], []

    def at(ring, k):
        return 0 if ring < 0 else 1 + ring * sides + k % sides

    for k in range(sides):
        faces.append([0, at(0, k), at(0, k + 1)])
        lengths.append([1.0, 1.0, 1.0])
        for ring in range(2):
            a, b = radii[ring], radii[ring + 1]
            across = np.sqrt(a * a + b * b - a * b)  # 60 degrees between them
            faces.append([at(ring, k), at(ring + 1, k), at(ring + 1, k + 1)])
            lengths.append([b, across, b - a])
            faces.append([at(ring, k), at(ring + 1, k + 1), at(ring, k + 1)])
            lengths.append([b - a, a, across])
    faces, lengths = np.array(faces), np.array(lengths)
    surface = vorogeo.Surface(None, faces, metric=vorogeo.EdgeLengths(lengths))
    vector = surface.log_map(0)[1:] @ [1, 1j]
    expected = (radii[:, None] * np.exp(1j * angle)).ravel()
    turned = vector / expected
    np.testing.assert_allclose(turned, turned[0], atol=1e-9)
    np.testing.assert_allclose(np.abs(turned[0]), 1, rtol=1e-12)
    np.testing.assert_allclose(surface.exp_map(0, surface.log_map(0)[1:]).barycentric.max(axis=1), 1, atol=1e-9)
    # From a place on the innermost ring, through the unrolled faces on its side of the tip.
    seen = np.abs(surface.log_map(1) @ [1, 1j])
    apart = np.minimum(np.arange(sides), sides - np.arange(sides)) * np.pi / 3
    for ring, radius in enumerate(radii):
        straight = np.sqrt(1 + radius**2 - 2 * radius * np.cos(apart))
        np.testing.assert_allclose(
            seen[1 + ring * sides : 1 + (ring + 1) * sides],
            np.where(apart < np.pi, straight, 1 + radius),
            atol=1e-9,
        )


@pytest.mark.parametrize("shape", ["sphere", "ellipsoid", "torus"])
def test_on_smooth_meshes_vectors_are_those_of_potpourri3d(shape):
    """Its frames and lines to rounding; its maps and carried vectors up to its errors, from the heat method."""
    potpourri3d = pytest.importorskip("potpourri3d")
    vertices, faces = torus(48, 24) if shape == "torus" else sphere(4)
    if shape == "ellipsoid":
        vertices = vertices * [1, 0.8, 1.3]
    surface = vorogeo.Surface(vertices, faces)
    solver, tracer = potpourri3d.MeshVectorHeatSolver(vertices, faces), potpourri3d.GeodesicTracer(vertices, faces)
    x, y, normal = solver.get_tangent_frames()
    frames = surface.tangent_frames(np.arange(len(vertices)))
    np.testing.assert_allclose(frames, np.stack([x, y, normal], axis=1), atol=1e-12)
    random = np.random.default_rng()
    point = int(random.integers(len(vertices)))
    vectors, distance = surface.log_map(point, return_distance=True)
    near = (distance > 0.1) & (distance < 1)

    def median_turn(ours, theirs):
        a, b = ((v @ [1, 1j])[near] for v in (ours, theirs))
        return np.degrees(np.median(np.abs(np.angle(a / b))))

    theirs = solver.compute_log_map(point, "AffineLocal")
    assert median_turn(vectors, theirs) < 1
    np.testing.assert_allclose(np.linalg.norm(theirs, axis=1)[near], distance[near], rtol=0.05)
    turn = random.uniform(0, 2 * np.pi)
    vector = np.array([np.cos(turn), np.sin(turn)])
    carried = surface.transport_from(point, vector)
    assert median_turn(carried, solver.transport_tangent_vector(point, vector)) < 1.5
    (end,) = surface.exp_map(point, 0.9 * vector).positions(vertices, faces)
    traced = tracer.trace_geodesic_from_vertex(point, 0.9 * vector @ np.array([x[point], y[point]]))[-1]
    np.testing.assert_allclose(end, traced, atol=1e-9)
