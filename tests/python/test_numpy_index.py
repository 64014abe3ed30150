"""vorogeo.GeodesicIndex: values against exact distances, symmetry, infinity, patches, statistics."""

import dataclasses
import warnings

import numpy as np
import pytest
import vorogeo
from hypothesis import given, settings
from hypothesis import strategies as st

from sample_meshes import bent_grid, cube, plane_grid, real_mesh, side_by_side

GRID = bent_grid(60, 45)


@pytest.fixture(scope="module")
def index():
    return vorogeo.GeodesicIndex(*GRID, patches=(5, 4))


def relative_errors(measured, exact):
    positive = exact > 0
    return np.abs(measured[positive] - exact[positive]) / exact[positive]


def test_plane_field_is_euclidean():
    vertices, faces = plane_grid(40, 30, 4.0, 3.0)
    index = vorogeo.GeodesicIndex(vertices, faces)
    exact = np.linalg.norm(vertices - vertices[617], axis=1)
    errors = relative_errors(index.distance_field(617), exact)
    assert errors.mean() <= 2e-5
    assert errors.max() <= 1e-3


@pytest.mark.parametrize("name", ["bunny10k_textured.obj", "spot", "rocker_arm"])
def test_field_is_near_pygeodesic(name):
    geodesic = pytest.importorskip("pygeodesic.geodesic")
    vertices, faces = real_mesh(name)
    index = vorogeo.GeodesicIndex(vertices, faces)
    reference, _ = geodesic.PyGeodesicAlgorithmExact(vertices, faces).geodesicDistances(np.array([1500]))
    errors = relative_errors(index.distance_field(1500), reference)
    # What an index promises on every mesh: mean, 99th percentile, largest.
    assert errors.mean() <= 3e-4
    assert np.quantile(errors, 0.99) <= 2e-3
    assert errors.max() <= 1e-2


def test_pairs_are_near_exact(index):
    rng = np.random.default_rng(5)
    targets = rng.integers(0, len(GRID[0]), 300)
    exact = vorogeo.exact_distance_field(*GRID, 1000)
    errors = relative_errors(index.distance(np.full(300, 1000), targets), exact[targets])
    assert errors.mean() <= 1e-4
    assert errors.max() <= 5e-3


@settings(max_examples=50, deadline=None)
@given(st.lists(st.tuples(st.integers(0, 2699), st.integers(0, 2699)), min_size=1, max_size=20))
def test_symmetric_and_zero_only_on_the_diagonal(index, pairs):
    a, b = np.array(pairs).T
    forward = index.distance(a, b)
    np.testing.assert_array_equal(forward, index.distance(b, a))
    np.testing.assert_array_equal(forward, [index.distance(int(i), int(j)) for i, j in pairs])
    np.testing.assert_array_equal(forward == 0, a == b)


def test_many_pairs_equal_single_ones(index):
    a, b = np.random.default_rng(3).integers(0, 2700, (2, 1000))
    together = index.distance(a, b)
    assert together.shape == (1000,)
    assert together.dtype == np.float64
    np.testing.assert_array_equal(
        together[::97], [index.distance(int(i), int(j)) for i, j in np.column_stack([a, b])[::97]]
    )


def test_several_sources_give_the_nearest(index):
    sources = [0, 1333, 2650]
    together = index.distance_field(sources)
    nearest = np.min([index.distance_field(source) for source in sources], axis=0)
    np.testing.assert_allclose(together, nearest, rtol=0.05)
    assert (together[sources] == 0).all()
    np.testing.assert_array_equal(index.distance_field([0, 0, 1333, 2650, 1333]), together)


def test_max_distance_cuts_to_infinity(index):
    full = index.distance_field(77)
    limit = float(np.median(full))
    cut = index.distance_field(77, max_distance=limit)
    np.testing.assert_array_equal(cut, np.where(full <= limit, full, np.inf))
    assert np.flatnonzero(np.isfinite(index.distance_field(77, max_distance=0))).tolist() == [77]
    np.testing.assert_array_equal(index.distance_field(77, max_distance=np.inf), full)


def test_infinite_between_components_and_at_isolated_vertices():
    vertices, faces = side_by_side(plane_grid(9, 9), cube())
    vertices = np.vstack([vertices, [5, 5, 5]])
    index = vorogeo.GeodesicIndex(vertices, faces)
    field = index.distance_field(3)
    assert np.isfinite(field[:81]).all()
    assert np.isinf(field[81:]).all()
    np.testing.assert_array_equal(index.distance([3, 85, 89, 89], [85, 3, 3, 89]), [np.inf, np.inf, np.inf, 0])
    assert index.statistics.components == 3


@pytest.mark.parametrize("layer", [1, 2])
def test_patches_cover_all_faces(index, layer):
    patches = index.face_patches(layer)
    assert patches.dtype == np.int32
    assert patches.shape == (len(GRID[1]),)
    count = (index.statistics.first_layer_patches, index.statistics.second_layer_patches)[layer - 1]
    assert np.unique(patches).tolist() == list(range(count))


def test_second_layer_patches_lie_in_one_first_layer_patch(index):
    pairs = np.unique(np.column_stack([index.face_patches(2), index.face_patches(1)]), axis=0)
    assert len(pairs) == index.statistics.second_layer_patches


def test_faces_left_out_have_no_patch():
    vertices, faces = cube()
    doubled = np.vstack([[[2, 2, 5]], faces, faces[3:4, ::-1]])
    patches = vorogeo.GeodesicIndex(vertices, doubled).face_patches(1)
    assert patches[0] == patches[-1] == -1
    assert (patches[1:-1] >= 0).all()


def test_statistics_describe_the_mesh(index):
    statistics = index.statistics
    assert (statistics.vertices, statistics.faces, statistics.components) == (2700, len(GRID[1]), 1)
    assert statistics.first_layer_patches == 5
    assert statistics.arcs <= statistics.arcs_before_pruning
    assert statistics.bytes > 0
    assert statistics.seconds > 0
    assert statistics.delta == 0.0
    with pytest.raises(dataclasses.FrozenInstanceError):
        statistics.vertices = 3


def test_a_build_that_hardly_pays_warns_before_it_begins(index):
    assert index.statistics.expected_fields == 0
    vertices, faces = bent_grid(60, 40)
    parts = 16
    apart = np.repeat(np.arange(parts), len(vertices))[:, None] * [0.0, 0.0, 10.0]
    many = np.concatenate([faces + k * len(vertices) for k in range(parts)])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(UserWarning, match=r"about [0-9.]+ s of one core, as long as [0-9]+ exact fields"):
            vorogeo.GeodesicIndex(np.tile(vertices, (parts, 1)) + apart, many)


def test_repr_says_what_it_is(index):
    assert repr(index).startswith(f"GeodesicIndex(2700 vertices, {len(GRID[1])} faces, patches (5, ")


def test_same_seed_same_index_whatever_the_threads():
    a = vorogeo.GeodesicIndex(*GRID, seed=9, threads=1)
    b = vorogeo.GeodesicIndex(*GRID, seed=9, threads=3)
    np.testing.assert_array_equal(a.face_patches(2), b.face_patches(2))
    np.testing.assert_array_equal(a.distance_field(8), b.distance_field(8))
