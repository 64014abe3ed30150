"""Faces that a metric splits: all questions in numbers of what was given, and distances against finer meshes."""

from __future__ import annotations

import pickle
import sys
from pathlib import Path

import numpy as np
import pytest
import vorogeo

from sample_meshes import plane_grid

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "bench"))
import meshes


@pytest.fixture(scope="module")
def hill():
    """A square with a cost that grows 10,000 times within some faces, and the same linear cost on smaller faces."""
    vertices, faces = plane_grid(12, 12)
    cost = 1 + 1e4 * np.exp(-((vertices[:, :2] - 0.5) ** 2).sum(axis=1) / 0.02)
    fine = vertices, faces, cost
    for _ in range(3):
        fine = meshes.quartered(*fine)
    exact = vorogeo.exact_distance_field(*fine[:2], 0, metric=vorogeo.VertexCost(fine[2]))[: len(vertices)]
    return vertices, faces, vorogeo.VertexCost(cost), exact


@pytest.fixture(scope="module")
def index(hill):
    vertices, faces, metric, _ = hill
    return vorogeo.GeodesicIndex(vertices, faces, patches=(4, 2), metric=metric)


def test_distances_are_closer_than_with_shortened_edges(hill):
    vertices, faces, metric, exact = hill
    found = metric.edge_lengths(vertices, faces)
    assert found.split_faces > 0
    assert found.shortened_edges <= 0.01 * len(found.splits.faces)
    whole = vorogeo.exact_distance_field(vertices, faces, 0, metric=vorogeo.EdgeLengths(found.lengths))
    split = vorogeo.exact_distance_field(vertices, faces, 0, metric=metric)
    assert split.shape == exact.shape
    error = (np.abs(np.array([whole, split]) - exact) / exact.clip(1e-12))[:, 1:]
    assert error[1].mean() < min(0.02, 0.5 * error[0].mean())
    assert error[1].max() < 0.5 * error[0].max()


def test_all_questions_refer_to_what_was_given(hill, index):
    vertices, faces, metric, _ = hill
    n, m = len(vertices), len(faces)
    assert index.statistics.split_faces == metric.edge_lengths(vertices, faces).split_faces
    assert (index.statistics.vertices, index.statistics.faces) == (n, m)
    exact = index.distance_field(5, method="exact")
    for field in (exact, index.distance_field(5), vorogeo.Surface(vertices, faces, metric=metric).distance_field(5)):
        np.testing.assert_allclose(field, exact, rtol=0.02)
    assert index.fields([5, 7]).shape == (2, n)
    assert index.distance_matrix([5, 7, n - 1]).shape == (3, 3)
    assert index.eccentricity([0])[1][0] < n
    assert max(index.extent().ends) < n
    assert index.sample_poisson_disk(100.0).max() < n
    samples = index.sample_farthest(12)
    assert samples.vertices.max() < n
    assert samples.distance.shape == (n,)
    assert index.relax([3, 9], 3).vertices.max() < n
    regions = index.voronoi([0, n - 1])
    assert regions.vertex_region.shape == (n,)
    assert regions.face_region.shape == (m,)
    disk = index.disk(0, 300.0)
    np.testing.assert_array_equal(disk.vertices, np.flatnonzero(index.distance_field(0, 300.0) < np.inf))
    within = np.isin(faces, disk.vertices).all(axis=1)
    np.testing.assert_array_equal(disk.faces, np.flatnonzero(within))
    assert index.face_patches(1).shape == (m,)
    lines = index.isolines(vertices[:, 0], [0.31], "linear")
    np.testing.assert_allclose(lines.points[:, 0], 0.31, atol=1e-12)
    curve = index.distance_field(vorogeo.EdgeCurve(np.arange(12), 0.01))
    np.testing.assert_allclose(curve[:12], 0, atol=1e-12)
    again = pickle.loads(pickle.dumps(index))
    np.testing.assert_array_equal(again.distance_field(5), index.distance_field(5))
    surface = pickle.loads(pickle.dumps(vorogeo.Surface(vertices, faces, metric=metric)))
    np.testing.assert_array_equal(surface.distance_field(5), exact)


def test_faces_have_the_region_of_their_centre(hill, index):
    vertices, faces, metric, _ = hill
    sites = np.random.default_rng(0).choice(len(vertices), 12, replace=False)
    found = index.voronoi(sites, method="exact").face_region
    centres = vorogeo.SurfacePoints(np.arange(len(faces)), np.full((len(faces), 3), 1 / 3))
    distance = index.distance_matrix(centres, sites, method="exact")
    parts = np.bincount(metric.edge_lengths(vertices, faces).splits.given_face)
    farther = distance[np.arange(len(faces)), found] > 1.05 * distance.min(axis=1)
    assert farther[parts > 1].mean() <= 0.02  # a field is not linear within a face: in whole faces it is 0.01


@pytest.mark.parametrize(
    ("part", "value", "message"),
    [
        ("middle_of", 10**6, "splits.middle_of: row 0 is wrong; give two vertices that come before"),
        ("faces", -1, "splits.faces: row 0 is wrong; give vertices given or added"),
        ("given_face", 10**6, "splits.given_face: row 0 is wrong; give numbers of the faces given"),
        ("lengths", None, "splits: has .* faces, but .* lengths of"),
    ],
)
def test_wrong_splits_of_a_metric_of_ones_own_are_refused(hill, part, value, message):
    vertices, faces, metric, _ = hill

    class Own:
        def edge_lengths(self, vertices, faces):
            found = metric.edge_lengths(vertices, faces)
            wrong = getattr(found.splits, part).copy()
            wrong[0] = 0 if value is None else value
            wrong = wrong[1:] if value is None else wrong
            return found._replace(splits=found.splits._replace(**{part: wrong}))

    with pytest.raises(vorogeo.InvalidInput, match=message):
        vorogeo.exact_distance_field(vertices, faces, 0, metric=Own())


def test_points_and_paths_name_the_faces_given(hill, index):
    vertices, faces, metric, _ = hill
    places = np.column_stack([np.random.default_rng(1).random((40, 2)), np.zeros(40)])
    points = index.snap(places)
    assert points.faces.max() < len(faces)
    np.testing.assert_allclose(points.positions(vertices, faces), places, atol=1e-12)
    for path in (
        *index.path(points[:20], points[20:]),
        *vorogeo.exact_path(vertices, faces, points[:3], points[3:6], metric),
    ):
        np.testing.assert_allclose(path.surface_points.positions(vertices, faces), path.points, atol=1e-12)
        assert path.vertices.max(initial=-1) < len(vertices)
    np.testing.assert_allclose(
        index.distance(points[:20], points[20:]),
        [p.length for p in index.exact_path(points[:20], points[20:])],
        rtol=0.02,
    )
