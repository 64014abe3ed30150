"""Points and curves: rounded weights, places far away, edges in any order, and what is refused."""

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid, plane_grid

PLANE = plane_grid(31, 21, 3.0, 2.0)


@pytest.fixture(scope="module")
def plane():
    return vorogeo.GeodesicIndex(*PLANE, patches=(4, 4))


def test_a_curve_is_its_edges_in_any_order_and_has_one_offset(plane):
    line = np.arange(31 * 10, 31 * 11)  # the row y = 1
    edges = np.column_stack([line[:-1], line[1:]])[::-1]
    above = np.abs(PLANE[0][:, 1] - 1)
    for vertices in (line, edges):
        field = plane.distance_field(vorogeo.EdgeCurve(vertices, spacing=0.02), offsets=[0.5], method="exact")
        np.testing.assert_allclose(field, above + 0.5, atol=1e-2)


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
    with pytest.raises(vorogeo.InvalidInput, match="2 faces but 1 rows"):
        plane.fields(vorogeo.SurfacePoints(np.array([3, 4]), np.full((1, 3), 1 / 3)))
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


@pytest.mark.parametrize("bad", [[0, np.inf, 0], [0, 0, -1.7e308]])
def test_points_that_cannot_be_snapped_are_named(plane, bad):
    with pytest.raises(vorogeo.InvalidInput, match=r"points\[1\]: .*(nan|inf|1.7e\+308)"):
        plane.snap([[0, 0, 0], bad])
