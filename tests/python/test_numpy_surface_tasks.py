"""Voronoi regions, samplings, isolines, disks, extents and relaxation: closed forms on the plane, bad input."""

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid, plane_grid, side_by_side

PLANE = plane_grid(33, 25, 4.0, 3.0)
POSITIONS = PLANE[0]


@pytest.fixture(scope="module")
def index():
    return vorogeo.GeodesicIndex(*PLANE, patches=(4, 4))


@pytest.fixture(scope="module")
def two_components():
    return vorogeo.GeodesicIndex(*side_by_side(bent_grid(30, 20), plane_grid(6, 5)), patches=(4, 4))


def straight(points, others):
    return np.linalg.norm(POSITIONS[points][:, None] - POSITIONS[others][None], axis=2)


@pytest.mark.parametrize(("exact", "tolerance"), [(True, 1e-12), (False, 0.01)])
def test_voronoi_borders_lie_on_the_bisectors(index, exact, tolerance):
    sites = np.array([100, 500, 730, 333])
    found = index.voronoi(sites, method="exact" if exact else None)
    distance = np.linalg.norm(found.borders.points[:, None] - POSITIONS[sites][None], axis=2)
    sides = np.take_along_axis(distance[found.borders.edges[:, 0]], found.border_regions, axis=1)
    np.testing.assert_allclose(sides[:, 0], sides[:, 1], atol=tolerance)
    np.testing.assert_allclose(sides.min(axis=1), distance[found.borders.edges[:, 0]].min(axis=1), atol=tolerance)
    np.testing.assert_allclose(found.area.sum(), 12)
    nearest = straight(np.arange(len(POSITIONS)), sites)
    np.testing.assert_allclose(found.distance, nearest.min(axis=1), rtol=0.02)
    if exact:
        chosen = np.take_along_axis(nearest, found.vertex_region[:, None], axis=1)[:, 0]
        np.testing.assert_allclose(chosen, nearest.min(axis=1), atol=1e-12)
    assert found.vertex_region.dtype == found.face_region.dtype == found.borders.edges.dtype == np.int32
    assert found.face_region.shape == (len(PLANE[1]),)


def test_voronoi_of_other_components_and_left_out_faces(two_components):
    found = two_components.voronoi([0, 100])
    assert (found.vertex_region[600:] == -1).all()
    assert np.isinf(found.distance[600:]).all()
    vertices, faces = PLANE
    index = vorogeo.GeodesicIndex(vertices, np.vstack([faces[:1], faces]), patches=(2, 2))
    assert (index.voronoi([0, 700]).face_region == -1).sum() == 1


def test_isolines_of_a_distance_are_circles(index):
    centre = 12 * 33 + 16
    field = np.linalg.norm(POSITIONS - POSITIONS[centre], axis=1)
    found = index.isolines(field, [0.5, 1.1])
    np.testing.assert_allclose(np.linalg.norm(found.points - POSITIONS[centre], axis=1), found.values, atol=1e-12)
    assert set(found.values.tolist()) == {0.5, 1.1}
    assert (np.bincount(found.edges.ravel()) == 2).all()
    np.testing.assert_allclose(found.length, 2 * np.pi * 1.6, rtol=0.01)
    assert len(np.unique(index.isolines(field, 7).values)) == 7
    assert len(index.isolines(np.full(len(field), np.inf), 3).points) == 0


def test_lines_become_pyvista_meshes(index):
    pytest.importorskip("pyvista")
    found = index.isolines(index.distance_field(0), 3)
    mesh = found.to_pyvista()
    assert mesh.n_points == len(found.points)
    assert mesh.n_lines == len(found.edges)
    assert index.isolines(index.distance_field(0), []).to_pyvista().n_points == 0


def test_farthest_samples_cover_and_keep_their_distance(index):
    found = index.sample_farthest(30, start=[5])
    assert found.vertices[0] == 5
    assert np.isinf(found.radius[0])
    assert (np.diff(found.radius) <= 0).all()
    apart = straight(found.vertices, found.vertices)[np.triu_indices(30, 1)]
    assert apart.min() >= 0.98 * found.covering_radius
    np.testing.assert_allclose(
        found.covering_radius, straight(np.arange(len(POSITIONS)), found.vertices).min(axis=1).max(), rtol=0.02
    )
    np.testing.assert_array_equal(found.vertices[:10], index.sample_farthest(10, start=[5]).vertices)
    assert index.sample_farthest(radius=0.5).covering_radius <= 0.5


def test_more_samples_than_vertices_are_all_vertices(two_components):
    found = two_components.sample_farthest(10_000)
    np.testing.assert_array_equal(np.sort(found.vertices), np.arange(630))


def test_poisson_disk_samples_are_spaced_and_maximal(index):
    samples = index.sample_poisson_disk(0.4, seed=3, method="exact")
    assert straight(samples, samples)[np.triu_indices(len(samples), 1)].min() >= 0.4 - 1e-12
    assert straight(np.arange(len(POSITIONS)), samples).min(axis=1).max() < 0.4 + 1e-12
    np.testing.assert_array_equal(samples, index.sample_poisson_disk(0.4, seed=3, method="exact"))


def test_disk_is_what_is_within_the_radius(index):
    found = index.disk(400, 0.7, method="exact")
    expected = np.linalg.norm(POSITIONS - POSITIONS[400], axis=1)
    np.testing.assert_array_equal(found.vertices, np.flatnonzero(expected <= 0.7))
    np.testing.assert_allclose(found.distances, expected[found.vertices], atol=1e-12)
    inside = np.isin(PLANE[1], found.vertices).all(axis=1)
    np.testing.assert_array_equal(found.faces, np.flatnonzero(inside))


def test_extent_and_eccentricity_of_a_rectangle(index):
    distances, farthest = index.eccentricity([0, 16], method="exact")
    np.testing.assert_allclose(distances, [5, np.hypot(2, 3)])
    assert farthest[0] == 33 * 25 - 1
    found = index.extent(fields=200, method="exact")
    np.testing.assert_allclose(found.diameter, [5, 5])
    assert found.radius[0] <= 2.5 <= found.radius[1] + 1e-12
    assert straight([found.ends[0]], [found.ends[1]])[0, 0] == 5
    assert found.fields <= 200


def test_relaxed_points_spread(index):
    start = np.arange(8)
    found = index.relax(start, rounds=15, method="exact")
    assert (np.diff(found.energy) <= 1e-12).all()
    assert found.energy[-1] < 0.1 * found.energy[0]
    assert len(found.energy) <= 16


def test_tasks_can_be_cancelled_and_report(index):
    calls = [
        lambda report: index.voronoi([0, 9, 99], progress=report),
        lambda report: index.sample_farthest(5, progress=report),
        lambda report: index.sample_poisson_disk(0.5, progress=report),
        lambda report: index.extent(progress=report),
        lambda report: index.eccentricity([0, 9], progress=report),
        lambda report: index.relax([0, 9], progress=report),
    ]
    for call in calls:
        with pytest.raises(vorogeo.Cancelled):
            call(lambda *_: False)
        seen = []
        call(lambda fraction, text, seen=seen: seen.append(fraction))
        assert seen == sorted(seen)
        assert seen


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda i: i.voronoi([]), "points: is empty"),
        (lambda i: i.voronoi([0, -1]), r"points\[1\]: there is no vertex -1"),
        (lambda i: i.isolines([1.0, 2.0], [1.5]), "field: has 2 values"),
        (lambda i: i.isolines(np.zeros(825), [float("nan")]), "Level 0 is nan"),
        (lambda i: i.isolines(np.zeros(825), [0.0], interpolation="cubic"), "interpolation: 'cubic' is unknown"),
        (lambda i: i.sample_farthest(), "Give a count of samples"),
        (lambda i: i.sample_farthest(0), "count: 0 is out of range"),
        (lambda i: i.sample_poisson_disk(0), "radius: 0.0 is out of range"),
        (lambda i: i.sample_poisson_disk(float("nan")), "radius: is NaN"),
        (lambda i: i.disk([], 1), "sources: is empty"),
        (lambda i: i.disk(0, -1), "radius: -1.0 is negative"),
        (lambda i: i.extent(fields=1), "fields: 1 is out of range"),
        (lambda i: i.extent(start=825), "start: 825 is out of range"),
        (lambda i: i.relax([0], rounds=-1), "rounds: -1 is out of range"),
    ],
)
def test_bad_arguments_are_named(index, call, message):
    with pytest.raises(vorogeo.InvalidInput, match=message):
        call(index)
