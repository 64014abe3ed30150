"""vorogeo.exact_distance_field against formulas and against pygeodesic."""

import numpy as np
import pytest
import vorogeo
from hypothesis import given, settings
from hypothesis import strategies as st

from sample_meshes import bent_grid, cube, plane_grid, prism, prism_distances, real_mesh, side_by_side


@settings(max_examples=25, deadline=None)
@given(st.integers(2, 12), st.integers(2, 12), st.floats(0.1, 10), st.data())
def test_plane_distances_are_euclidean(columns, rows, width, data):
    vertices, faces = plane_grid(columns, rows, width)
    source = data.draw(st.integers(0, len(vertices) - 1))
    field = vorogeo.exact_distance_field(vertices, faces, source)
    np.testing.assert_allclose(field, np.linalg.norm(vertices - vertices[source], axis=1), rtol=1e-12, atol=1e-14)


@pytest.mark.parametrize("source", [0, 7, 45])
def test_prism_distances_are_those_of_the_unrolled_plane(source):
    vertices, faces = prism(12, 9, 3.0)
    field = vorogeo.exact_distance_field(vertices, faces, source)
    np.testing.assert_allclose(field, prism_distances(12, 9, 3.0, source), rtol=1e-12, atol=1e-14)


def test_cube_corners():
    field = vorogeo.exact_distance_field(*cube(), sources=[0])
    corner_sums = cube()[0].sum(axis=1).astype(int)
    np.testing.assert_allclose(field, np.sqrt([0, 1, 2, 5])[corner_sums], rtol=1e-14)


@pytest.mark.parametrize("name", ["bunny10k_textured.obj", "spot", "fandisk"])
def test_equals_pygeodesic(name):
    geodesic = pytest.importorskip("pygeodesic.geodesic")
    vertices, faces = real_mesh(name)
    reference, _ = geodesic.PyGeodesicAlgorithmExact(vertices, faces).geodesicDistances(np.array([11, 1234]))
    field = vorogeo.exact_distance_field(vertices, faces, [11, 1234])
    np.testing.assert_allclose(field, reference, rtol=1e-9, atol=1e-12)


def test_several_sources_give_the_nearest():
    vertices, faces = bent_grid(14, 11)
    sources = [3, 77, 140]
    single = [vorogeo.exact_distance_field(vertices, faces, source) for source in sources]
    together = vorogeo.exact_distance_field(vertices, faces, [*sources, 77])
    np.testing.assert_allclose(together, np.min(single, axis=0), rtol=1e-12, atol=1e-14)


def test_max_distance_cuts_to_infinity():
    vertices, faces = plane_grid(11, 11)
    full = np.linalg.norm(vertices - vertices[60], axis=1)
    field = vorogeo.exact_distance_field(vertices, faces, 60, max_distance=0.33)
    np.testing.assert_allclose(field, np.where(full <= 0.33, full, np.inf), rtol=1e-12)


def test_infinite_between_components_and_at_isolated_vertices():
    vertices, faces = side_by_side(plane_grid(4, 4), cube())
    field = vorogeo.exact_distance_field(np.vstack([vertices, [5, 5, 5]]), faces, 2)
    assert np.isfinite(field[:16]).all()
    assert np.isinf(field[16:]).all()


def test_result_belongs_to_the_caller():
    field = vorogeo.exact_distance_field(*cube(), 0)
    assert field.dtype == np.float64
    assert field.shape == (8,)
    assert field.flags.writeable
    field[:] = 1.0


def test_paths_of_pairs_and_of_many_targets_from_one_source_are_exact():
    vertices, faces = prism(12, 9, 3.0)
    sources = np.r_[np.full(len(vertices), 7), [0, 45]]
    targets = np.r_[np.arange(len(vertices)), [60, 3]]
    expected = [prism_distances(12, 9, 3.0, s)[t] for s, t in zip(sources, targets, strict=True)]
    paths = vorogeo.exact_path(vertices, faces, sources, targets)
    np.testing.assert_allclose([path.length for path in paths], expected, rtol=1e-9, atol=1e-12)
    for path, source, target in zip(paths, sources, targets, strict=True):
        assert path.certified
        assert (path.vertices[0], path.vertices[-1]) == (source, target)
        steps = np.linalg.norm(np.diff(path.points, axis=0), axis=1)
        assert steps.sum() == pytest.approx(path.length, rel=1e-12, abs=1e-14)


def test_no_path_is_certified_beside_an_edge_too_long_for_digits():
    vertices, faces = plane_grid(14, 14, 1.0)
    vertices[100, 2] = 1e15
    for count in (5, 150):  # a corridor for each, one propagation for all
        targets = np.setdiff1d(np.arange(1, 160), [100])[:count]
        paths = vorogeo.exact_path(vertices, faces, np.zeros(count, int), targets)
        assert not any(path.certified for path in paths)


def test_a_path_to_another_component_has_no_points():
    vertices, faces = side_by_side(cube(), cube())
    none = vorogeo.exact_path(vertices, faces, 0, len(vertices) - 1)
    assert (none.length, len(none.points)) == (np.inf, 0)
