"""vorogeo.GeodesicIndex: patches, statistics, forms, and a warning before a build that hardly pays."""

import dataclasses
import warnings

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid, cube

GRID = bent_grid(60, 45)


@pytest.fixture(scope="module")
def index():
    return vorogeo.GeodesicIndex(*GRID, patches=(5, 4))


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


def test_the_form_follows_delta_and_the_memory_budget(index):
    assert index.statistics.form == "tables"
    assert vorogeo.GeodesicIndex(*GRID, memory_budget=4096).statistics.form == "tables"
    assert vorogeo.GeodesicIndex(*GRID, delta=0.001).statistics.form == "graph"
    with pytest.raises(vorogeo.InvalidInput, match=r"The memory budget is 1 MiB.* takes (at least|more than) \d+ MiB"):
        vorogeo.GeodesicIndex(*bent_grid(90, 80), memory_budget=1)


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
