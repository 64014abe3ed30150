"""Points anywhere and curves as sources of every task: against formulas in the plane and against exact distances."""

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid, plane_grid, side_by_side

PLANE = plane_grid(31, 21, 3.0, 2.0)
RNG = np.random.default_rng(11)
PLACES = np.column_stack([RNG.uniform(0, 3, 14), RNG.uniform(0, 2, 14), np.zeros(14)])


@pytest.fixture(scope="module")
def plane():
    return vorogeo.GeodesicIndex(*PLANE, patches=(4, 4))


@pytest.fixture(scope="module")
def points(plane):
    return plane.snap(PLACES)


def straight(a, b):
    return np.linalg.norm(a[:, None] - b[None], axis=2)


def test_points_are_given_alike_everywhere(plane, points):
    mixed = [points[:3], 17, [5, 40], points[3]]
    places = np.vstack([PLACES[:3], PLANE[0][[17, 5, 40]], PLACES[3:4]])
    expected = straight(places, PLACES)
    np.testing.assert_allclose(plane.distance_matrix(mixed, points), expected, rtol=2e-3)
    np.testing.assert_allclose(plane.distances(mixed, points[:7]), np.diag(expected[:, :7]), rtol=1e-9)
    np.testing.assert_allclose(plane.distance(mixed, points[:7]), np.diag(expected[:, :7]), rtol=1e-9)
    np.testing.assert_allclose([p.length for p in plane.path(mixed, points[:7])], np.diag(expected[:, :7]), rtol=1e-9)
    np.testing.assert_allclose(plane.fields(mixed), straight(places, PLANE[0]), rtol=2e-2, atol=1e-12)
    np.testing.assert_allclose(plane.distance_field(mixed), straight(places, PLANE[0]).min(axis=0), rtol=2e-2)
    distances, farthest = plane.eccentricity(mixed)
    np.testing.assert_allclose(distances, straight(places, PLANE[0]).max(axis=1), rtol=2e-3)
    np.testing.assert_allclose(np.linalg.norm(PLANE[0][farthest] - places, axis=1), distances, rtol=2e-3)


def test_corners_are_vertices_and_edges_have_two_faces(plane):
    corner = vorogeo.SurfacePoints(np.array([0]), np.array([[0.0, 1.0, 0.0]]))
    vertex = int(PLANE[1][0, 1])
    np.testing.assert_array_equal(plane.fields(corner)[0], plane.distance_field(vertex))
    lower, upper = PLANE[1][[0, 600]]  # the two triangles of the first cell share its diagonal
    shared = set(lower) & set(upper)
    assert len(shared) == 2
    sides = [[0.5 if v in shared else 0.0 for v in face] for face in (lower, upper)]
    middle = vorogeo.SurfacePoints(np.array([0, 600]), np.array(sides))
    np.testing.assert_array_equal(plane.distance_matrix(middle, entries="fields"), np.zeros((2, 2)))
    assert plane.nearest(middle, 5)[1].tolist() == [[0]]


def test_a_curve_is_one_source_with_one_offset(plane):
    line = np.arange(31 * 10, 31 * 11)  # the row y = 1
    curve = vorogeo.EdgeCurve(line, spacing=0.02)
    distance, label = plane.distance_field([0, curve, 30], offsets=[0.1, 0.5, 0.0], return_labels=True)
    sums = np.column_stack(
        [
            straight(PLANE[0], PLANE[0][:1]) + 0.1,
            np.abs(PLANE[0][:, 1:2] - 1) + 0.5,
            straight(PLANE[0], PLANE[0][30:31]),
        ]
    )
    np.testing.assert_allclose(distance, sums.min(axis=1), rtol=2e-2, atol=1e-3)
    clear = np.ptp(np.sort(sums)[:, :2], axis=1) > 0.02
    np.testing.assert_array_equal(label[clear], sums.argmin(axis=1)[clear])
    edges = np.column_stack([line[:-1], line[1:]])[::-1]  # the same curve as edges in another order
    by_edges = plane.distance_field(vorogeo.EdgeCurve(edges, spacing=0.02))
    np.testing.assert_allclose(by_edges, np.abs(PLANE[0][:, 1] - 1), rtol=2e-2, atol=1e-3)


@pytest.mark.parametrize(
    ("curve", "message"),
    [
        (vorogeo.EdgeCurve([0, 2]), "no edge between vertex 0 and vertex 2"),
        (vorogeo.EdgeCurve([0]), "at least"),
        (vorogeo.EdgeCurve([0, 10**6]), "no vertex 1000000"),
        (vorogeo.EdgeCurve(np.zeros((2, 3), int)), r"shape \(2, 3\)"),
        (vorogeo.EdgeCurve([0, 1], spacing=-1), "spacing"),
    ],
)
def test_bad_curves_are_named(plane, curve, message):
    with pytest.raises(vorogeo.InvalidInput, match=message):
        plane.distance_field([3, curve])


def test_bad_points_are_named(plane, points):
    for call in (plane.distance_matrix, plane.voronoi, plane.fields, lambda p: plane.nearest(p, [1])):
        with pytest.raises(vorogeo.InvalidInput, match="Face 1000000"):
            call([3, vorogeo.SurfacePoints(np.array([10**6]), points.barycentric[:1])])
        with pytest.raises(vorogeo.InvalidInput, match=r"1 is not on the mesh.*sum"):
            call([3, vorogeo.SurfacePoints(np.array([3]), np.array([[0.5, 0.1, 0.1]]))])
        with pytest.raises(vorogeo.InvalidInput, match="2 faces but 1 rows"):
            call(vorogeo.SurfacePoints(np.array([3, 4]), points.barycentric[:1]))
    assert plane.distance_matrix(points[:0]).shape == (0, 0)


def barycentric_from_positions(triangles, places):
    """By dot products, as trimesh.triangles.points_to_barycentric computes them, in the precision of its input."""
    edges = triangles[:, 1:] - triangles[:, :1]
    offset = places - triangles[:, 0]
    dots = [[np.einsum("kd,kd->k", edges[:, i], edges[:, j]) for j in range(2)] for i in range(2)]
    along = [np.einsum("kd,kd->k", edges[:, i], offset) for i in range(2)]
    divisor = 1 / (dots[0][0] * dots[1][1] - dots[0][1] * dots[1][0])
    second = (dots[1][1] * along[0] - dots[0][1] * along[1]) * divisor
    third = (dots[0][0] * along[1] - dots[0][1] * along[0]) * divisor
    return np.column_stack([1 - second - third, second, third])


@pytest.mark.parametrize("kind", [np.float32, np.float64])
@pytest.mark.parametrize("how", ["drawn", "from positions"])
def test_rounded_weights_are_taken(kind, how):
    mesh = bent_grid(20, 15)
    index = vorogeo.GeodesicIndex(*mesh, patches=(3, 3))
    rng = np.random.default_rng(8)
    faces = rng.integers(0, len(mesh[1]), 500)
    true = rng.dirichlet(np.ones(3), 500)
    true[::5, 0] = 0  # on edges
    true[::25, 1] = 0  # in corners
    true /= true.sum(axis=1, keepdims=True)
    weights = true.astype(kind)
    if how == "from positions":
        triangles = mesh[0].astype(kind)[mesh[1][faces]]
        weights = barycentric_from_positions(triangles, np.einsum("kc,kcd->kd", weights, triangles))
        rounded = np.abs(weights - true).max(axis=1, keepdims=True) < 9e-7  # the others lost more than the last digits
        assert rounded.mean() > 0.5
        weights = np.where(rounded, weights, true.astype(kind))
    assert weights.dtype == kind
    assert (weights < 0).any() or (weights.sum(axis=1, dtype=float) != 1).any()
    np.testing.assert_allclose(
        index.distance_field(vorogeo.SurfacePoints(faces, weights)),
        index.distance_field(vorogeo.SurfacePoints(faces, true)),
        atol=1e-5,
    )
    found = index.distances(vorogeo.SurfacePoints(faces, weights), np.zeros(500, int))
    np.testing.assert_allclose(
        found, index.distances(vorogeo.SurfacePoints(faces, true), np.zeros(500, int)), atol=1e-5
    )


def test_weights_that_are_wrong_are_named(plane):
    for weights, wrong in (([0.5, 0.5, 2e-6], "do not sum to 1"), ([-2e-6, 0.5, 0.5], r"outside \[0, 1\]")):
        points = vorogeo.SurfacePoints(np.array([4, 7]), np.array([[1 / 3, 1 / 3, 1 / 3], weights]))
        with pytest.raises(vorogeo.InvalidInput, match=rf"1 is not on the mesh.*face 7.*{wrong}.*give weights"):
            plane.distance_field(points)


@pytest.mark.parametrize("far", [1e9, 1e30, 1e300, 1e307])
def test_far_points_are_snapped(plane, far):
    found = plane.snap([[far, 0, 0], [-far, -far, 1], [1, 1, -far]])
    places = found.positions(*PLANE)
    np.testing.assert_allclose(places[0][0], 3, atol=1e-6)
    np.testing.assert_allclose(places[1], [0, 0, 0], atol=1e-6)
    np.testing.assert_allclose(found.snap_distance, far * np.array([1, np.sqrt(2), 1]), rtol=1e-8)


@pytest.mark.parametrize("bad", [[np.nan, 0, 0], [0, np.inf, 0], [0, 0, -1.7e308]])
def test_points_that_cannot_be_snapped_are_named(plane, bad):
    with pytest.raises(vorogeo.InvalidInput, match=r"points\[1\]: .*(nan|inf|1.7e\+308)"):
        plane.snap([[0, 0, 0], bad])


def test_far_points_in_faces_against_exact_distances():
    mesh = side_by_side(bent_grid(50, 40), plane_grid(6, 6))
    index = vorogeo.GeodesicIndex(*mesh, patches=(5, 4))
    faces = np.array([10, 900, 1800, 2700, 3600, len(mesh[1]) - 1])
    inner = vorogeo.SurfacePoints(faces, np.tile([0.2, 0.5, 0.3], (6, 1)))
    exact = np.array([[path.length for path in index.exact_path(inner[[i] * 6], inner)] for i in range(6)])
    for method in ("pairs", "fields"):
        found = index.distance_matrix(inner, entries=method)
        np.testing.assert_array_equal(np.isinf(found), np.isinf(exact))
        near = np.isfinite(exact)
        np.testing.assert_allclose(found[near], exact[near], rtol=1e-2)
        assert np.mean(np.abs(found[near] - exact[near])) < 1e-3 * exact[near].mean()
