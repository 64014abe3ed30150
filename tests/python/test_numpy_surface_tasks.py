"""Voronoi regions, samplings, isolines, disks, extents and relaxation: closed forms on the plane, bad input."""

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid, plane_grid, side_by_side

PLANE = plane_grid(33, 25, 4.0, 3.0)


@pytest.fixture(scope="module")
def index():
    return vorogeo.GeodesicIndex(*PLANE, patches=(4, 4))


@pytest.fixture(scope="module")
def two_components():
    return vorogeo.GeodesicIndex(*side_by_side(bent_grid(30, 20), plane_grid(6, 5)), patches=(4, 4))


def test_voronoi_of_other_components_and_left_out_faces(two_components):
    found = two_components.voronoi([0, 100])
    assert (found.vertex_region[600:] == -1).all()
    assert np.isinf(found.distance[600:]).all()
    vertices, faces = PLANE
    index = vorogeo.GeodesicIndex(vertices, np.vstack([faces[:1], faces]), patches=(2, 2))
    assert (index.voronoi([0, 700]).face_region == -1).sum() == 1


def test_lines_become_pyvista_meshes(index):
    pytest.importorskip("pyvista")
    found = index.isolines(index.distance_field(0), 3)
    mesh = found.to_pyvista()
    assert mesh.n_points == len(found.points)
    assert mesh.n_lines == len(found.edges)
    assert index.isolines(index.distance_field(0), []).to_pyvista().n_points == 0


def test_more_samples_than_vertices_are_all_vertices(two_components):
    found = two_components.sample_farthest(10_000)
    np.testing.assert_array_equal(np.sort(found.vertices), np.arange(630))


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
