"""vorogeo.GeodesicIndex: values against exact distances, symmetry, patches, statistics."""

import dataclasses
import warnings

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid, cube, real_mesh

GRID = bent_grid(60, 45)


@pytest.fixture(scope="module")
def index():
    return vorogeo.GeodesicIndex(*GRID, patches=(5, 4))


def relative_errors(measured, exact):
    positive = exact > 0
    return np.abs(measured[positive] - exact[positive]) / exact[positive]


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


@pytest.mark.parametrize("name", ["bunny10k_textured.obj", "bunny.obj", "cow.obj"])
def test_distances_are_symmetric_and_fields_agree_with_pairs(name):
    vertices, faces = real_mesh(name)
    index = vorogeo.GeodesicIndex(vertices, faces)
    source, target = np.random.default_rng(6).integers(0, len(vertices), (2, 40))
    exact = index.distance(source, target, method="exact")
    np.testing.assert_allclose(exact, index.distance(target, source, method="exact"), rtol=1e-9)
    by_fields = [index.distance_field(int(a), method="exact")[b] for a, b in zip(source, target, strict=True)]
    np.testing.assert_allclose(by_fields, exact, rtol=1e-9)
    pairs = index.distance(source, target)
    np.testing.assert_array_equal(pairs, index.distance(target, source))
    fields = index.fields(source)[np.arange(40), target]
    for answer in (pairs, fields):
        np.testing.assert_array_equal(np.isinf(answer), np.isinf(exact))
        reached = np.isfinite(exact)
        assert relative_errors(answer[reached], exact[reached]).max() <= 1e-2


@pytest.mark.parametrize("layer", [1, 2])
def test_patches_cover_all_faces(index, layer):
    patches = index.face_patches(layer)
    assert patches.dtype == np.int32
    assert patches.shape == (len(GRID[1]),)
    count = (index.statistics.first_layer_patches, index.statistics.second_layer_patches)[layer - 1]
    assert np.unique(patches).tolist() == list(range(count))


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
    # It names the line that called the package, however deep in it the build began.
    surface = vorogeo.Surface(np.tile(vertices, (parts, 1)) + apart, many)
    with pytest.warns(UserWarning, match="as long as") as warned, pytest.raises(vorogeo.Cancelled):
        surface.distances([0], [1], method="index", progress=lambda fraction, _: fraction < 0.3)
    assert warned[0].filename == __file__
