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


def straight(vertices, source):
    return np.linalg.norm(vertices - vertices[source], axis=1)


def test_a_plane_in_two_parts_is_one(plates, index):
    vertices, faces = plates
    assert np.isinf(vorogeo.exact_distance_field(vertices, faces, 0)).sum() == 9 * 12
    field = vorogeo.exact_distance_field(vertices, faces, 0, gap=2 * GAP)
    np.testing.assert_allclose(field, straight(vertices, 0), rtol=1e-12)
    np.testing.assert_allclose(index.distance_field(0), straight(vertices, 0), rtol=1e-2)
    assert index.distance(0, len(vertices) - 1) == pytest.approx(straight(vertices, 0)[-1], rel=1e-3)
    assert index.gap == 2 * GAP
    assert index.statistics.faces == len(faces)
    assert index.statistics.bridges == 8 + 11


@pytest.mark.parametrize(("method", "error"), [("exact", 1e-9), ("quick", 3e-2), ("index", 1e-2)])
def test_a_surface_of_any_method_bridges(plates, method, error):
    vertices, faces = plates
    surface = vorogeo.Surface(vertices, faces, gap=2 * GAP)
    np.testing.assert_allclose(surface.distance_field(0, method=method), straight(vertices, 0), rtol=error)
    soup, loose = vertices[faces].reshape(-1, 3), np.arange(faces.size).reshape(-1, 3)
    field = vorogeo.Surface(soup, loose, gap=2 * GAP).distance_field(len(soup) - 1, method=method)
    np.testing.assert_allclose(field, straight(soup, len(soup) - 1), rtol=error)


def test_a_soup_is_the_merged_mesh():
    vertices, faces = plane_grid(7, 6)
    soup, loose = vertices[faces].reshape(-1, 3), np.arange(faces.size).reshape(-1, 3)
    field = vorogeo.exact_distance_field(soup, loose, 0, gap=1e-12)
    np.testing.assert_allclose(field, straight(soup, 0), atol=1e-12)
    assert vorogeo.check_mesh(soup, loose, gap=1e-12).components_after_bridging == 1
    assert np.isinf(vorogeo.exact_distance_field(soup, loose, 0)).sum() == len(soup) - 3


def test_path_points_over_the_gap_are_marked(plates, index):
    vertices, _ = plates
    path = index.exact_path(0, len(vertices) - 1)
    assert path.length == pytest.approx(straight(vertices, 0)[-1], rel=1e-12)
    x = path.points[:, 0]
    steps = np.column_stack([x[:-1], x[1:]])
    over = (steps.min(axis=1) >= 1 - 1e-9) & (steps.max(axis=1) <= 1 + GAP + 1e-9)
    np.testing.assert_array_equal(path.over_gap[:-1], over)
    assert path.over_gap.any()
    inside = (x > 1 + 1e-9) & (x < 1 + GAP - 1e-9)
    np.testing.assert_array_equal(path.surface_points.faces == -1, inside)
    assert not index.path(0, 5).over_gap.any()


def test_tasks_refer_to_the_faces_given(plates, index):
    vertices, faces = plates
    regions = index.voronoi([0, len(vertices) - 1])
    assert regions.area.sum() == pytest.approx(2.0, rel=1e-9)
    assert len(regions.face_region) == len(faces)
    assert index.face_patches(1).shape == (len(faces),)
    disk = index.disk(40, 10.0)
    np.testing.assert_array_equal(np.sort(disk.faces), np.arange(len(faces)))


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
    report = vorogeo.check_mesh(*plates)
    assert report.gap_to_join_all == pytest.approx(GAP, rel=1e-9)
    report = vorogeo.check_mesh(*plates, gap=2 * GAP)
    assert (report.joined_borders, report.components_after_bridging) == (2, 1)
    assert any("joins 2 borders of 2" in sentence for sentence in report.sentences)


@pytest.mark.parametrize("gap", [-1.0, np.nan, np.inf, "wide"])
def test_a_gap_that_is_no_length_is_refused(plates, gap):
    with pytest.raises(vorogeo.InvalidInput, match="gap: "):
        vorogeo.GeodesicIndex(*plates, gap=gap)
    with pytest.raises(vorogeo.InvalidInput, match="gap: "):
        vorogeo.check_mesh(*plates, gap=gap)


def test_a_gap_and_a_metric_are_refused(plates):
    vertices, faces = plates
    metric = vorogeo.VertexCost(np.ones(len(vertices)))
    with pytest.raises(vorogeo.InvalidInput, match="leave out the gap or the metric"):
        vorogeo.exact_distance_field(vertices, faces, 0, gap=GAP, metric=metric)


def test_exact_paths_without_an_index_cross_the_gap(plates):
    vertices, faces = plates
    path = vorogeo.exact_path(vertices, faces, 0, len(vertices) - 1, gap=2 * GAP)
    assert path.length == pytest.approx(straight(vertices, 0)[-1], rel=1e-12)
    assert path.over_gap.any()
    with pytest.raises(vorogeo.InvalidInput, match="leave out the gap or the metric"):
        vorogeo.exact_path(vertices, faces, 0, 1, gap=GAP, metric=vorogeo.FaceCost(np.ones(len(faces))))
