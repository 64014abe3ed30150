"""Surfaces with gaps on numpy arrays: as the whole surface, marked on paths, and kept apart without a gap."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
import vorogeo

from sample_meshes import plane_grid, side_by_side

GAP = 1e-3


@pytest.fixture(scope="module")
def plates():
    """Two unit squares with other vertices at the gap between them."""
    return side_by_side(plane_grid(9, 9), plane_grid(9, 12), 1.0 + GAP)


@pytest.fixture(scope="module")
def index(plates):
    return vorogeo.GeodesicIndex(*plates, gap=2 * GAP)


def test_files_and_copies_know_the_gap(plates, index, tmp_path):
    vertices, faces = plates
    index.save(tmp_path / "plates.vgi")
    with pytest.raises(vorogeo.IndexFileError, match="other gaps bridged"):
        vorogeo.GeodesicIndex.load(tmp_path / "plates.vgi", vertices, faces)
    loaded = vorogeo.GeodesicIndex.load(tmp_path / "plates.vgi", vertices, faces, gap=2 * GAP)
    copied = pickle.loads(pickle.dumps(index))
    for other in (loaded, copied):
        np.testing.assert_array_equal(other.distance_field(3), index.distance_field(3))
    assert copied.gap == index.gap


def test_the_report_says_what_a_gap_would_join(plates):
    report = vorogeo.check_mesh(*plates, gap=2 * GAP)
    assert (report.joined_borders, report.components_after_bridging) == (2, 1)
    assert any("joins 2 borders of 2" in sentence for sentence in report.sentences)
