"""Metrics that jump at edges, on numpy arrays: against formulas and exact distances; refusals."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid, plane_grid, prism, shared

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "bench"))
import weighted_shapes


@pytest.fixture(scope="module")
def mosaic():
    vertices, faces = bent_grid(40, 30)
    metric = vorogeo.FaceCost(np.random.default_rng(3).uniform(1, 5, len(faces)))
    return vertices, faces, metric, vorogeo.GeodesicIndex(vertices, faces, metric=metric)


def test_an_index_answers_as_many_points_on_edges_do(mosaic):
    vertices, faces, metric, index = mosaic
    fine = vorogeo.FaceCost(metric.cost, points=20)
    exact = vorogeo.exact_distance_field(vertices, faces, 17, metric=fine)
    others = exact > 0
    error = np.abs(index.distance_field(17) - exact)[others] / exact[others]
    assert error.mean() < 5e-3
    assert np.quantile(error, 0.99) < 3e-2
    assert index.distance(17, 1100) == index.distance(1100, 17) == pytest.approx(exact[1100], rel=5e-3)
    for path in index.path(17, 1100), index.exact_path(17, 1100):
        assert path.length == pytest.approx(exact[1100], rel=1e-3)
        assert not path.certified
    near = index.path(17, 18)
    assert near.length == pytest.approx(exact[18], rel=1e-3)


@pytest.mark.parametrize("shape", weighted_shapes.all_shapes(20), ids=lambda shape: shape.name)
def test_index_against_formulas(shape):
    index = vorogeo.GeodesicIndex(shape.vertices, shape.faces, metric=shape.metric)
    known = np.flatnonzero(np.isfinite(shape.exact) & (shape.exact > 0))
    chosen = known[:: len(known) // 40]
    for found, targets in (
        (index.distance_field(shape.source)[known], known),
        (index.distance(np.full(len(chosen), shape.source), chosen), chosen),
    ):
        error = np.abs(found - shape.exact[targets]) / shape.exact[targets]
        assert error.mean() < 1e-3
        assert error.max() < 1e-2
    for path, length in zip(index.path(np.full(5, shape.source), chosen[-5:]), shape.exact[chosen[-5:]], strict=True):
        assert length * (1 - 1e-3) <= path.length <= length * (1 + 1e-3)


def test_the_expected_error_is_near_the_real_one():
    """Against eight times as many points: costs of two halves, costs and tensors without order, and winds."""
    random, ratios = np.random.default_rng(8), []
    for vertices, faces in (bent_grid(30, 22), prism(24, 20, 6.0), shared("spot")):
        count, middle = len(faces), vertices[faces].mean(axis=1)[:, 0]
        direction = random.normal(size=(count, 3))
        direction /= np.linalg.norm(direction, axis=1, keepdims=True)
        across = np.eye(3) - direction[:, :, None] * direction[:, None, :]
        halves = np.where(middle > np.median(middle), 3.0, 1.0)
        for metric in (
            vorogeo.FaceCost(halves),
            vorogeo.FaceCost(random.uniform(1, 5, count)),
            vorogeo.FaceTensor(np.eye(3) + 3 * across, 6),
            vorogeo.travel_time(vertices, faces, 0.5 * direction, points=6),
        ):
            coarse = vorogeo.Surface(vertices, faces, metric=metric)
            found = coarse.distance_field(3, method="exact")
            exact = vorogeo.exact_distance_field(vertices, faces, 3, metric=replace(metric, points=48))
            others = exact > 0
            ratios.append(coarse.last.expected_error / np.abs(found[others] / exact[others] - 1).mean())
    assert 1 / 3 < np.median(ratios) < 3
    assert np.min(ratios) > 0.1


def test_what_is_expected_of_exact_fields_and_of_others(mosaic):
    vertices, faces, metric, index = mosaic
    index.distance_field(17)
    assert np.isnan(index.last.expected_error), "the errors of the index and of the metric add up"
    surface = vorogeo.Surface(vertices, faces, metric=metric)
    surface.distance_field(17, 0.5, method="exact")
    assert 0 < surface.last.expected_error < 1e-3
    even = vorogeo.Surface(vertices, faces, metric=vorogeo.FaceCost(np.full(len(faces), 2.0)))
    even.distance_field(17, method="exact")
    assert even.last.expected_error == 0


def test_the_points_on_edges_are_checked():
    with pytest.raises(vorogeo.InvalidInput, match="points"):
        vorogeo.FaceCost(np.ones(18), points=0)
    vertices, faces = plane_grid(4, 4)
    with pytest.raises(vorogeo.InvalidInput, match="this metric jumps at edges"):
        vorogeo.distance_field(vertices, faces, 0, method="heat", metric=vorogeo.FaceCost(np.arange(1, 19)))


def test_costs_that_agree_everywhere_do_not_jump():
    vertices, faces = bent_grid(12, 9)
    metric = vorogeo.FaceCost(np.full(len(faces), 3.0))
    length = vorogeo.exact_distance_field(vertices, faces, 5)
    np.testing.assert_allclose(vorogeo.exact_distance_field(vertices, faces, 5, metric=metric), 3 * length, rtol=1e-10)
    graph = [vorogeo.distance_field(vertices, faces, 5, method="dijkstra", metric=each) for each in (None, metric)]
    np.testing.assert_allclose(graph[1], 3 * graph[0], rtol=1e-10)
    assert vorogeo.exact_path(vertices, faces, 5, 60, metric=metric).certified


def test_points_in_faces_are_as_far_in_both_directions():
    vertices, faces = bent_grid(20, 15)
    rng = np.random.default_rng(5)
    points = vorogeo.SurfacePoints(faces=rng.integers(0, len(faces), 8), barycentric=rng.dirichlet([2, 2, 2], 8))
    for metric in vorogeo.FaceCost(rng.uniform(1, 5, len(faces))), vorogeo.VertexCost(rng.uniform(1, 5, len(vertices))):
        index = vorogeo.GeodesicIndex(vertices, faces, metric=metric)
        vertex = np.full(8, 3)
        np.testing.assert_array_equal(index.distance(vertex, points), index.distance(points, vertex))
        there, back = index.path([3], points[:1])[0], index.path(points[:1], [3])[0]
        np.testing.assert_allclose(there.points, back.points[::-1])


def t_junctions(cells=6):
    """Cells beside others of half their width: faces without width close the T-junctions."""
    below, lower = plane_grid(cells + 1, cells + 1)
    above, upper = plane_grid(2 * cells + 1, 2 * cells + 1)
    vertices = np.vstack([below * [1, 0.5, 1] / below.max(), above * [1, 0.5, 1] / above.max() + [0, 0.5, 0]])
    first, row = len(below), np.arange(cells)
    faces = np.vstack([lower, upper + first])
    last = first - cells - 1
    closing = np.column_stack([last + row, first + 2 * row + 1, last + row + 1])
    one = np.arange(len(vertices))
    one[first : first + 2 * cells + 1 : 2] = np.arange(last, first)
    faces = np.vstack([one[faces], closing]).astype(np.int32)
    used, faces = np.unique(faces, return_inverse=True)
    return vertices[used], faces.reshape(-1, 3).astype(np.int32)


def stretched(angle, stretch):
    """Lengths times `stretch` along a direction."""
    along = np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])
    return np.eye(3) + (stretch**2 - 1) * along[:, :, None] * along[:, None, :]


@pytest.mark.parametrize(("mesh", "stretch", "points"), [(plane_grid(13, 13), 10, 25), (t_junctions(), 31.6, 79)])
def test_tensors_without_order_get_more_points(mesh, stretch, points):
    vertices, faces = mesh
    tensors = stretched(np.random.default_rng(0).uniform(0, np.pi, len(faces)), stretch)
    assert abs(vorogeo.FaceTensor(tensors).edge_lengths(vertices, faces).points - points) <= 1
    exact = vorogeo.exact_distance_field(vertices, faces, 8, metric=vorogeo.FaceTensor(tensors, points=2 * points))
    others = exact > 0
    field = vorogeo.exact_distance_field(vertices, faces, 8, metric=vorogeo.FaceTensor(tensors))
    error = np.abs(field - exact)[others] / exact[others]
    assert error.mean() < 1.2e-2
    assert error.max() < 6e-2


def test_tensors_that_no_points_suffice_for_are_refused():
    vertices, faces = t_junctions()
    tensors = stretched(np.random.default_rng(0).uniform(0, np.pi, len(faces)), 1000.0)
    refusal = r"The tensor of face \d+ makes its sides .* stretches lengths 1000 times .* `points`"
    with pytest.raises(vorogeo.InvalidInput, match=refusal):
        vorogeo.GeodesicIndex(vertices, faces, metric=vorogeo.FaceTensor(tensors))
    assert np.isfinite(
        vorogeo.exact_distance_field(vertices, faces, 8, metric=vorogeo.FaceTensor(tensors, points=3))
    ).all()
