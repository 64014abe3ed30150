"""Metrics on numpy arrays: against formulas, against positions, across all questions; refusals."""

from __future__ import annotations

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid, plane_grid


def sides_of(vertices, faces):
    """The sides in space, each opposite its corner."""
    return np.linalg.norm(vertices[faces[:, [2, 0, 1]]] - vertices[faces[:, [1, 2, 0]]], axis=2)


def half_plane(cells):
    """A grid over [0, 1] x [0.5, 1.5] and the cost 1 / y, whose distances are those of the hyperbolic plane."""
    vertices, faces = plane_grid(cells + 1, cells + 1)
    vertices[:, 1] += 0.5
    return vertices, faces, 1 / vertices[:, 1]


def hyperbolic(p, q):
    return np.arccosh(1 + ((p - q) ** 2).sum(-1) / (2 * p[..., 1] * q[..., 1]))


@pytest.fixture(scope="module")
def wavy():
    vertices, faces = bent_grid(40, 30)
    return vertices, faces, vorogeo.EdgeLengths(sides_of(vertices, faces))


def test_without_positions_regions_have_their_areas_and_places_in_space_are_refused(wavy):
    vertices, faces, metric = wavy
    surface = vorogeo.Surface(None, faces, metric=metric)
    regions = [one.voronoi([0, 600, 1199], method="exact") for one in (surface, vorogeo.Surface(vertices, faces))]
    np.testing.assert_allclose(regions[0].area, regions[1].area, rtol=1e-12)
    np.testing.assert_array_equal(regions[0].face_region, regions[1].face_region)
    for question in (lambda: surface.snap([0, 0, 0]), lambda: surface.relax([0, 600], rounds=1)):
        with pytest.raises(vorogeo.InvalidInput, match="no positions"):
            question()


def test_cost_of_the_hyperbolic_plane_falls_with_the_square_of_the_edge():
    errors = []
    for cells in (20, 40, 80, 160):
        vertices, faces, cost = half_plane(cells)
        source = cells // 2 * (cells + 1) + cells // 2
        found = vorogeo.exact_distance_field(vertices, faces, source, metric=vorogeo.VertexCost(cost))
        exact = hyperbolic(vertices, vertices[source])
        # Where the shortest path stays in the square.
        inside = np.linalg.norm(vertices - vertices[source], axis=1) < 0.4
        errors.append(np.abs(found - exact)[inside].max() / exact[inside].max())
    assert errors[-1] < 2e-4
    assert np.log2(errors[0] / errors[-1]) / 3 > 1.7


@pytest.mark.parametrize("method", ["fast_marching", "heat", "gsp", "dijkstra", "mmp"])
def test_methods_take_metrics(method):
    vertices, faces, cost = half_plane(40)
    source = 20 * 41 + 20
    found = vorogeo.distance_field(vertices, faces, source, method, metric=vorogeo.VertexCost(cost))
    exact = hyperbolic(vertices, vertices[source])
    inside = np.linalg.norm(vertices - vertices[source], axis=1) < 0.4
    far = inside & (exact > 0.1)
    assert (np.abs(found - exact)[far] / exact[far]).mean() < (0.2 if method == "dijkstra" else 0.03)


def test_masked_faces_need_no_lengths(wavy):
    vertices, faces, _ = wavy
    lengths = sides_of(vertices, faces)
    kept = vertices[faces].mean(axis=1)[:, 0] < 1.2
    lengths[~kept] = np.nan
    found = vorogeo.exact_distance_field(None, faces, 0, metric=vorogeo.EdgeLengths(lengths), mask=kept)
    np.testing.assert_allclose(found, vorogeo.exact_distance_field(vertices, faces, 0, mask=kept), atol=1e-12)


def test_extreme_costs_end_in_right_answers(wavy):
    vertices, faces, _ = wavy
    cost = np.where(np.random.default_rng(0).random(len(vertices)) < 0.5, 1.0, 1e6)
    metric = vorogeo.VertexCost(cost)
    lengths, shortened, split, *_ = metric.edge_lengths(vertices, faces)
    assert split > 0
    assert shortened < 10 * len(faces)  # at an edge that is nearly for free, parts of all sizes would need it
    assert (2 * lengths.max(axis=1) <= lengths.sum(axis=1) * (1 + 1e-12)).all()
    field = vorogeo.exact_distance_field(vertices, faces, 0, metric=metric)
    back = vorogeo.exact_distance_field(vertices, faces, 1199, metric=metric)
    assert field[1199] == pytest.approx(back[0], rel=1e-9)
    assert np.isfinite(field).all()


def test_what_is_no_metric_is_refused(wavy):
    vertices, faces, _ = wavy
    lengths = sides_of(vertices, faces)

    def refused(metric, match, vertices=vertices):
        with pytest.raises(vorogeo.InvalidInput, match=match):
            vorogeo.exact_distance_field(vertices, faces, 0, metric=metric() if callable(metric) else metric)

    refused(lambda: vorogeo.VertexCost(np.full(len(vertices), 1 + 2j)), "VertexCost: is not an array of numbers")
    refused(lambda: vorogeo.VertexCost(np.ones((3, 2))), r"VertexCost: has shape \(3, 2\)")
    refused(lambda: vorogeo.VertexTensor(np.eye(3)), "VertexTensor: has shape")
    refused(vorogeo.VertexTensor(np.tile(-np.eye(3), (len(vertices), 1, 1))), "not positive on the plane of face 0")
    torn = lengths.copy()
    torn[5] *= 1.1
    refused(vorogeo.EdgeLengths(torn), "disagree on the length of their edge")
    refused(vorogeo.VertexCost(np.ones(len(vertices))), "vertices: is None", vertices=None)
    for bad, match in ((2**40, r"faces\[3\]: names a vertex beyond"), (-5, r"faces\[3\]: names vertex -5")):
        named = faces.astype(np.int64)
        named[3, 1] = bad
        with pytest.raises(vorogeo.InvalidInput, match=match):
            vorogeo.exact_distance_field(None, named, 0, metric=vorogeo.EdgeLengths(lengths))
    with pytest.raises(vorogeo.InvalidInput, match="penalty"):
        vorogeo.slope_cost(vertices, faces, penalty=-1)
    with pytest.raises(vorogeo.InvalidInput, match="faces: cannot be read as an array"):
        vorogeo.exact_distance_field(None, [[0, 1, 2], [1, 2]], 0, metric=vorogeo.EdgeLengths(lengths))
