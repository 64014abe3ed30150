"""Means, medians, medoids and clusters with numpy: formulas of surfaces that unroll, and what is refused."""

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid, cube, plane_grid, prism, real_mesh, side_by_side, sphere


def on_plane(seed, count, columns=9, rows=7):
    """A sheet, some of its points, vertices among them, and where they lie."""
    vertices, faces = plane_grid(columns, rows, 1.6, 1.2)
    random = np.random.default_rng(seed)
    surface = vorogeo.Surface(vertices, faces)
    inside = surface.snap(np.column_stack([random.random((count - 2, 2)) * [1.6, 1.2], np.zeros(count - 2)]))
    points = [inside, int(random.integers(len(vertices))), int(random.integers(len(vertices)))]
    places = np.vstack([inside.positions(vertices, faces), vertices[points[1:]]])
    return surface, points, places, random.random(count) + 0.1


def position(surface, point):
    assert len(point) == 1
    return point.positions(surface.vertices, surface.faces)[0]


def geometric_median(places, weights):
    """Weiszfeld's iteration."""
    at = weights @ places / weights.sum()
    for _ in range(20000):
        pull = weights / np.maximum(np.linalg.norm(places - at, axis=1), 1e-300)
        at = pull @ places / pull.sum()
    return at


@pytest.mark.parametrize("seed", range(5))
def test_on_a_plane_they_are_those_of_coordinates(seed):
    surface, points, places, weights = on_plane(seed, 12)
    np.testing.assert_allclose(position(surface, surface.frechet_mean(points)), places.mean(axis=0), atol=1e-9)
    mean = position(surface, surface.frechet_mean(points, weights))
    np.testing.assert_allclose(mean, weights @ places / weights.sum(), atol=1e-9)
    assert surface.last.by == "exact"
    assert surface.last.remark == ""
    median = position(surface, surface.geometric_median(points, weights))
    np.testing.assert_allclose(median, geometric_median(places, weights), atol=1e-8)
    apart = np.linalg.norm(places[:, None] - places, axis=2)
    assert surface.medoid(points, weights) == np.argmin(apart @ weights)


def test_the_median_of_a_triangle_is_its_fermat_point_or_a_corner_of_120_degrees():
    vertices, faces = plane_grid(9, 7, 1.6, 1.2)
    surface = vorogeo.Surface(vertices, faces)
    corners = np.array([[0.31, 0.22, 0], [1.27, 0.35, 0], [0.66, 0.95, 0]])
    point = position(surface, surface.geometric_median(surface.snap(corners)))
    rays = corners - point
    rays /= np.linalg.norm(rays, axis=1)[:, None]
    np.testing.assert_allclose(rays @ rays.T, 1.5 * np.eye(3) - 0.5, atol=1e-7)
    blunt = np.array([[0.31, 0.22, 0], [1.27, 0.35, 0], [0.77, 0.4, 0]])
    np.testing.assert_allclose(position(surface, surface.geometric_median(surface.snap(blunt))), blunt[2], atol=1e-12)
    np.testing.assert_allclose(position(surface, surface.geometric_median(surface.snap(blunt), [5, 1, 1])), blunt[0])


def test_one_point_and_points_at_one_place_are_their_own_mean():
    surface, *_ = on_plane(1, 3)
    for points in (30, [30], [30, 30, 30]):
        for found in (surface.frechet_mean(points), surface.geometric_median(points)):
            np.testing.assert_array_equal(position(surface, found), surface.vertices[30])
        assert surface.medoid(points) == 0
    middle = (surface.vertices[30] + surface.vertices[41]) / 2
    np.testing.assert_allclose(position(surface, surface.frechet_mean([30, 41])), middle, atol=1e-12)


def unrolled(angle, height, sides=12):
    """Points of a prism by their place in the plane that it unrolls into."""
    side = 2 * np.sin(np.pi / sides)
    whole, part = np.divmod(np.asarray(angle) / side, 1)
    corner = np.exp(2j * np.pi * whole / sides)
    place = corner + part * (np.exp(2j * np.pi * (whole + 1) / sides) - corner)
    return np.column_stack([place.real, place.imag, height])


@pytest.mark.parametrize("seed", range(3))
def test_on_a_tube_they_are_those_of_the_plane_that_it_unrolls_into(seed):
    surface = vorogeo.Surface(*prism(12, 9, 4.0))
    random = np.random.default_rng(seed)
    flat = random.random((8, 2)) * [2.5, 3.5] + [5.0, 0.2]  # less than half way round, across where it is sewn
    weights = random.random(8) + 0.1
    points = surface.snap(unrolled(*flat.T))
    mean = weights @ flat / weights.sum()
    np.testing.assert_allclose(
        position(surface, surface.frechet_mean(points, weights)), unrolled(*mean[:, None])[0], atol=1e-9
    )
    median = geometric_median(flat, weights)
    np.testing.assert_allclose(
        position(surface, surface.geometric_median(points, weights)), unrolled(*median[:, None])[0], atol=1e-8
    )


def test_of_points_evenly_round_a_tube_the_mean_is_one_of_several():
    surface = vorogeo.Surface(*prism(12, 9, 4.0))
    surface.frechet_mean([36, 40, 44])
    assert "one of several" in surface.last.remark
    surface.frechet_mean([36, 38, 39])
    assert surface.last.remark == ""


def test_beside_the_apex_of_a_cone_the_mean_is_that_of_the_unrolled_faces():
    sectors, wide, rings = 8, 0.6, 4  # the angles at the apex sum to 4.8
    around = 2 * np.pi * np.arange(sectors) / sectors
    radius = np.sin(wide / 2) / np.sin(np.pi / sectors)
    ring = np.column_stack(
        [radius * np.cos(around), radius * np.sin(around), np.full(sectors, -np.sqrt(1 - radius**2))]
    )
    surface = vorogeo.Surface(*round_an_apex(ring, rings))
    chosen = [3 * sectors + 1, 3 * sectors + 2, 2 * sectors + 3, sectors + 3]
    angle, radius = wide * np.array([0, 1, 2, 2]), np.array([4, 4, 3, 2])
    mean = (radius * np.exp(1j * angle)).mean()
    sector = int(np.angle(mean) / wide)
    corners = np.exp(1j * wide * np.array([sector, sector + 1]))
    weights = np.linalg.solve([corners.real, corners.imag], [mean.real, mean.imag])
    found = position(surface, surface.frechet_mean(chosen))
    np.testing.assert_allclose(found, weights @ ring[[sector, sector + 1]], atol=1e-9)


def round_an_apex(ring, rings):
    """Faces between vertex 0, at the origin, and multiples of a ring around it."""
    sectors = len(ring)
    vertices = np.vstack([np.zeros((1, 3))] + [ring * (r + 1) for r in range(rings)])
    faces = [[0, 1 + i, 1 + (i + 1) % sectors] for i in range(sectors)]
    for r in range(rings - 1):
        for i in range(sectors):
            a, b = 1 + r * sectors + i, 1 + r * sectors + (i + 1) % sectors
            faces += [[a, a + sectors, b + sectors], [a, b + sectors, b]]
    return vertices, np.array(faces)


def test_means_stick_to_a_saddle_that_all_paths_lead_through():
    around = 2 * np.pi * np.arange(12) / 12
    ring = np.column_stack([np.cos(around), np.sin(around), 0.9 * (-1.0) ** np.arange(12)])
    surface = vorogeo.Surface(*round_an_apex(ring, 2))  # neighbours of the ring are seen 88 degrees apart
    for points, weights in ([[13, 17, 21], None], [[13, 17, 21], [1, 1.2, 1.1]], [[14, 17, 21, 22], None]):
        for found in (surface.frechet_mean(points, weights), surface.geometric_median(points, weights)):
            np.testing.assert_allclose(position(surface, found), 0, atol=1e-12)


@pytest.mark.parametrize("name", ["bunny10k_textured.obj", "spot", "fandisk"])
def test_on_meshes_no_point_nearby_is_better(name):
    vertices, faces = real_mesh(name)
    random = np.random.default_rng(5)
    size = np.linalg.norm(np.ptp(vertices, axis=0))
    vertices = vertices / size
    surface = vorogeo.Surface(vertices, faces)
    used = np.unique(faces)
    points, weights = random.choice(used, 20, replace=False), random.random(20)
    for find, power in ((surface.frechet_mean, 2), (surface.geometric_median, 1)):
        found = find(points, weights)
        assert "settle" not in surface.last.remark
        near = vertices[faces[found.faces[0]]]
        beside = surface.snap(position(surface, found) + random.normal(size=(40, 3)) * np.ptp(near, axis=0).max() / 5)
        energy = weights @ surface.distance_matrix(points, [found, beside, *points], method="exact") ** power
        assert energy[0] <= energy.min() * (1 + 1e-12)


def test_moved_turned_and_scaled_they_stay_the_same_points():
    vertices, faces = bent_grid(15, 12)
    points, weights = [3, 40, 77, 100, 150], [1, 2, 1, 3, 1]
    turn, _ = np.linalg.qr(np.random.default_rng(2).normal(size=(3, 3)))
    one, other = vorogeo.Surface(vertices, faces), vorogeo.Surface(1000 * vertices @ turn + 5, faces)
    for name in ("frechet_mean", "geometric_median"):
        found, again = getattr(one, name)(points, weights), getattr(other, name)(points, weights)
        there = again.positions(vertices, faces)
        np.testing.assert_allclose(there, found.positions(vertices, faces), atol=1e-8)
    assert one.medoid(points, weights) == other.medoid(points, weights)


def test_on_a_sphere_the_mean_is_that_of_a_symmetric_set():
    # Corners of a triangle round the pole of a finely divided octahedron, turned so that no symmetry helps.
    vertices, faces = sphere(5)
    surface = vorogeo.Surface(vertices, faces)
    pole = np.array([1.0, 2.0, 3.0]) / np.sqrt(14)
    x = np.cross(pole, [0, 0, 1]) / np.linalg.norm(np.cross(pole, [0, 0, 1]))
    angle = 2 * np.pi * np.arange(5) / 5
    ring = 0.5 * pole + np.sqrt(0.75) * (np.outer(np.cos(angle), x) + np.outer(np.sin(angle), np.cross(pole, x)))
    for find in (surface.frechet_mean, surface.geometric_median):
        assert np.linalg.norm(position(surface, find(surface.snap(ring))) - pole) < 0.02


@pytest.mark.parametrize("seed", [1, 2])
def test_the_medoid_is_that_of_the_distance_matrix(seed):
    vertices, faces = bent_grid(25, 21)
    random = np.random.default_rng(seed)
    points, weights = random.choice(len(vertices), 150, replace=False), random.random(150) * (random.random(150) < 0.7)
    index = vorogeo.GeodesicIndex(vertices, faces, patches=(3, 3))
    matrix = index.distance_matrix(points, method="exact")
    assert index.medoid(points, weights, method="exact") == np.argmin(matrix @ weights)
    by_index = (matrix @ weights)[index.medoid(points, weights)]
    assert by_index <= (matrix @ weights).min() * 1.005


def blobs(seed=3):
    random = np.random.default_rng(seed)
    middles = np.array([[0.3, 0.3], [1.3, 0.25], [0.4, 0.95], [1.25, 0.9]])
    places = np.vstack([middle + 0.05 * random.normal(size=(15, 2)) for middle in middles])
    surface = vorogeo.Surface(*plane_grid(17, 13, 1.6, 1.2))
    return surface, places, surface.snap(np.column_stack([places, np.zeros(len(places))]))


def same_division(labels, others):
    """The name of each cluster among the others."""
    pairs = np.unique(np.column_stack([labels, others]), axis=0)
    assert len(pairs) == len(np.unique(labels)) == len(np.unique(others))
    return pairs[np.argsort(pairs[:, 0]), 1]


def test_of_blobs_in_a_plane_k_means_are_those_of_scipy():
    kmeans2 = pytest.importorskip("scipy.cluster.vq").kmeans2
    surface, places, points = blobs()
    found = surface.k_means(4, points, seed=1)
    centres, labels = kmeans2(places, 4, minit="++", seed=1)
    names = same_division(found.labels, labels)
    at = found.centres.positions(surface.vertices, surface.faces)[:, :2]
    np.testing.assert_allclose(at, centres[names], atol=1e-8)
    energy = ((places - at[found.labels]) ** 2).sum()
    np.testing.assert_allclose(found.energy[-1], energy, rtol=1e-9)
    assert (np.diff(found.energy) <= 0).all()


def test_of_blobs_k_medoids_are_the_best_of_each_blob():
    surface, places, points = blobs()
    found = min((surface.k_medoids(4, points, seed=seed) for seed in range(8)), key=lambda each: each.energy[-1])
    same_division(found.labels, np.arange(60) // 15)
    at = found.centres.positions(surface.vertices, surface.faces)[:, :2]
    for i in range(4):
        own = places[found.labels == i]
        apart = np.linalg.norm(own[:, None] - own, axis=2).sum(axis=0)
        np.testing.assert_allclose(at[i], own[np.argmin(apart)], atol=1e-12)
    assert (np.diff(found.energy) <= 0).all()


@pytest.mark.parametrize("method", ["exact", "index"])
@pytest.mark.parametrize("of", ["points", "vertices"])
@pytest.mark.parametrize("name", ["k_means", "k_medoids"])
def test_energy_falls_and_every_point_is_with_its_nearest_centre(method, of, name):
    vertices, faces = bent_grid(25, 21)
    surface = vorogeo.Surface(vertices, faces)
    random = np.random.default_rng(4)
    points = None if of == "vertices" else random.choice(len(vertices), 80, replace=False)
    found = getattr(surface, name)(6, points, seed=2, method=method)
    assert surface.last.by == method
    assert (np.diff(found.energy) <= 0).all()
    assert found.energy[-1] < 0.9 * found.energy[0]
    chosen = np.arange(len(vertices)) if points is None else points
    apart = surface.distance_matrix(chosen, found.centres, method="exact")
    slack = 1e-9 if method == "exact" else 0.02
    assert (apart[np.arange(len(chosen)), found.labels] <= apart.min(axis=1) * (1 + slack) + 1e-12).all()
    weights = np.ones(len(chosen))
    if points is None:
        area = np.linalg.norm(np.cross(*(vertices[faces[:, k]] - vertices[faces[:, 0]] for k in (1, 2))), axis=1) / 2
        weights = np.bincount(faces.ravel(), np.repeat(area / 3, 3))
    power = 2 if name == "k_means" else 1
    np.testing.assert_allclose(found.energy[-1], weights @ apart.min(axis=1) ** power, rtol=slack * 2)
    again = getattr(surface, name)(6, points, seed=2, method=method)
    np.testing.assert_array_equal(again.labels, found.labels)
    assert len(getattr(surface, name)(6, points, rounds=0, method=method).energy) == 1


@pytest.mark.parametrize("name", ["k_means", "k_medoids"])
def test_points_without_weight_go_to_the_nearest_centre_however_far_it_is(name):
    vertices, faces = plane_grid(41, 5, 10.0, 1.0)
    surface = vorogeo.Surface(vertices, faces)
    random = np.random.default_rng()
    weights = ((vertices[:, 0] < 0.6) | (vertices[:, 0] > 9.4)) * random.uniform(0.5, 1, len(vertices))
    found = getattr(surface, name)(2, np.arange(len(vertices)), weights, method="exact")
    centres = found.centres.positions(vertices, faces)
    apart = np.linalg.norm(vertices[:, None] - centres, axis=2)
    np.testing.assert_allclose(apart[np.arange(len(vertices)), found.labels], apart.min(axis=1), atol=1e-9)
    power = 2 if name == "k_means" else 1
    np.testing.assert_allclose(found.energy[-1], weights @ apart.min(axis=1) ** power, rtol=1e-9)


def test_clusters_of_all_vertices_by_quick_fields():
    vertices, faces = bent_grid(25, 21)
    surface = vorogeo.Surface(vertices, faces)
    area = np.linalg.norm(np.cross(*(vertices[faces[:, k]] - vertices[faces[:, 0]] for k in (1, 2))), axis=1) / 2
    weights = np.bincount(faces.ravel(), np.repeat(area / 3, 3))
    for power, find in (2, surface.k_means), (1, surface.k_medoids):
        found = find(6, seed=2, method="quick")
        assert surface.last.by == "quick"
        assert (np.diff(found.energy) <= 0).all()
        exact = weights @ surface.distance_field(found.centres, method="exact") ** power
        np.testing.assert_allclose(found.energy[-1], exact, rtol=0.02)
        assert exact < 1.1 * find(6, seed=2, method="exact").energy[-1]
    start = [0, 100, 300]
    quick = surface.relax(start, method="quick")
    assert surface.last.by == "quick"
    assert quick.energy[-1] < 1.1 * surface.relax(start, method="exact").energy[-1]


def test_clusters_by_weight_and_of_several_components():
    one = plane_grid(5, 5)
    vertices, faces = side_by_side(one, one)
    vertices = np.vstack([vertices, [[5, 5, 5]]])
    surface = vorogeo.Surface(vertices, faces)
    found = surface.k_means(2)
    np.testing.assert_array_equal(found.labels[-1], -1)
    assert len(set(found.labels[:25])) == len(set(found.labels[25:50])) == 1
    centres = found.centres.positions(vertices, faces)
    np.testing.assert_allclose(np.sort(centres[:, 0]), [0.5, 10.5])
    weights = np.zeros(51)
    weights[[3, 30]] = 1
    found = surface.k_medoids(2, weights=weights)
    np.testing.assert_array_equal(np.sort(found.centres.positions(vertices, faces), axis=0)[:, 0], [0.75, 10.0])
    np.testing.assert_array_equal(found.energy[-1], 0)


def test_means_with_a_metric_and_over_a_gap():
    vertices, faces = plane_grid(9, 7, 1.6, 1.2)
    dear = vorogeo.Surface(vertices, faces, metric=vorogeo.VertexCost(np.full(len(vertices), 3.0)))
    plain = vorogeo.Surface(vertices, faces)
    for name in ("frechet_mean", "geometric_median"):
        one, other = getattr(plain, name)([3, 30, 47]), getattr(dear, name)([3, 30, 47])
        np.testing.assert_allclose(position(dear, other), position(plain, one), atol=1e-9)
    one = plane_grid(5, 5)
    parted = vorogeo.Surface(np.vstack([one[0], one[0] + [1.01, 0, 0]]), np.vstack([one[1], one[1] + 25]), gap=0.02)
    np.testing.assert_allclose(position(parted, parted.frechet_mean([12, 37, 38])), [3.77 / 3, 0.5, 0], atol=1e-9)
    middle = parted.frechet_mean([12, 37])  # on the bridge
    assert middle.faces.tolist() == [-1]
    with pytest.raises(vorogeo.InvalidInput, match="a point on the bridge over a gap is in no face"):
        position(parted, middle)
    with pytest.raises(vorogeo.InvalidInput, match="a point on the bridge over a gap is in no face"):
        parted.points_along(parted.path(3, 40), 0.5)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda s: s.frechet_mean([]), "points: is empty"),
        (lambda s: s.frechet_mean([1, 1000]), r"points\[1\]: there is no vertex 1000"),
        (lambda s: s.frechet_mean([1, 2], [1]), r"weights: has shape \(1,\); give 2 numbers of 0 or more"),
        (lambda s: s.geometric_median([1, 2], [1, -1]), r"weights\[1\]: is -1.0"),
        (lambda s: s.medoid([1, 2], [1, np.nan]), r"weights\[1\]: is nan"),
        (lambda s: s.medoid([1, 2], [0, 0]), "All weights are 0"),
        (lambda s: s.frechet_mean([1, 2, 30]), r"from point 0 \(vertex 1\) to point 2 \(vertex 30\).*two components"),
        (lambda s: s.medoid([30, 2]), r"from point 0 \(vertex 30\) to point 1 \(vertex 2\)"),
        (lambda s: s.frechet_mean(50), "There are no directions at vertex 50: no face has it"),
        (lambda s: s.k_means(0), "count: 0 is out of range"),
        (lambda s: s.k_means(4, [1, 2, 3]), "There are 3 points to be divided into 4 clusters; ask for 1 to 3"),
        (lambda s: s.k_medoids(51), "There are 50 points to be divided into 51 clusters"),
        (lambda s: s.k_medoids(3, [1, 2, 1, 2]), "Only 2 points differ from one another"),
        (lambda s: s.k_means(1, [1, 30]), "The points lie on 2 components"),
        (lambda s: s.k_means(2, [1, 3], [1, -3]), r"weights\[1\]: is -3.0"),
        (lambda s: s.k_means(2, rounds=-1), "rounds: -1 is out of range"),
        (lambda s: s.k_means(2, [1, 3], method="quick"), "method: 'quick' is unknown"),
    ],
)
def test_bad_input_is_refused_by_name(call, message):
    one = plane_grid(5, 5)
    vertices, faces = side_by_side(one, one)
    surface = vorogeo.Surface(np.vstack([vertices, [[5, 5, 5]]]), faces)
    with pytest.raises(vorogeo.InvalidInput, match=message):
        call(surface)


def test_metrics_that_jump_have_medoids_but_no_means():
    vertices, faces = plane_grid(9, 8)
    cost = np.ones(len(faces))
    cost[5] = 4.0
    surface = vorogeo.Surface(vertices, faces, metric=vorogeo.FaceCost(cost))
    for find in (surface.frechet_mean, surface.geometric_median):
        with pytest.raises(vorogeo.InvalidInput, match="Directions need edges on whose length both faces agree"):
            find([30, 40])
    assert surface.medoid([30, 31, 32]) == 1
    assert len(surface.k_means(3).centres) == 3


def test_on_a_cube_and_cancelled():
    vertices, faces = cube()
    surface = vorogeo.Surface(vertices, faces)
    found = position(surface, surface.frechet_mean([0, 1, 2, 3]))
    np.testing.assert_allclose(found, [0, 0.5, 0.5], atol=1e-9)
    for call in (surface.frechet_mean, surface.medoid, lambda points, **how: surface.k_means(2, points, **how)):
        with pytest.raises(vorogeo.Cancelled):
            call([0, 3, 5], progress=lambda *_: False)
