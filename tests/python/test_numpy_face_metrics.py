"""Metrics that jump at edges, on numpy arrays: against Snell's law, scipy and exact distances; refusals."""

from __future__ import annotations

import numpy as np
import pytest
import vorogeo
from scipy.optimize import minimize, minimize_scalar

from sample_meshes import bent_grid, plane_grid


def layered(borders, values, cells=40):
    """A square cut by horizontal lines, and the value of the layer of each face."""
    vertices, faces = plane_grid(cells + 1, cells + 1)
    middle = vertices[faces].mean(axis=1)[:, 1]
    return vertices, faces, np.asarray(values)[np.searchsorted(borders, middle)]


def test_two_half_planes_refract():
    vertices, faces, cost = layered([0.5], [3.0, 1.0])
    metric = vorogeo.FaceCost(cost)
    field = vorogeo.exact_distance_field(vertices, faces, 4 * 41 + 6, metric=metric)  # (0.15, 0.1)
    source = vertices[4 * 41 + 6]
    above = vertices[:, 1] > 0.5
    exact = np.array(
        [
            minimize_scalar(
                lambda x, p=p: 3 * np.hypot(x - source[0], 0.5 - source[1]) + np.hypot(p[0] - x, p[1] - 0.5),
                bounds=(0, 1),
                method="bounded",
                options={"xatol": 1e-10},
            ).fun
            for p in vertices[above]
        ]
    )
    error = np.abs(field[above] - exact) / exact
    assert error.mean() < 1e-3
    assert error.max() < 5e-3
    targets = np.flatnonzero(above)[[5, 300, 700]]
    for path, length in zip(
        vorogeo.exact_path(vertices, faces, [4 * 41 + 6] * 3, targets, metric=metric), exact[[5, 300, 700]], strict=True
    ):
        assert length * (1 - 1e-9) <= path.length <= length * (1 + 1e-3)
        assert not path.certified


def test_three_layers_of_tensors():
    tensors = [np.diag([4.0, 1, 1]), np.array([[2.0, 1, 0], [1, 3, 0], [0, 0, 1]]), np.eye(3)]
    vertices, faces, metric = layered([0.25, 0.75], tensors)
    path = vorogeo.exact_path(vertices, faces, 41 * 2 + 4, 41 * 38 + 34, metric=vorogeo.FaceTensor(metric))
    ends = vertices[[41 * 2 + 4, 41 * 38 + 34], :2]

    def length(x):
        points = np.array([ends[0], [x[0], 0.25], [x[1], 0.75], ends[1]])
        return sum(np.sqrt(v @ g[:2, :2] @ v) for v, g in zip(np.diff(points, axis=0), tensors, strict=True))

    exact = minimize(length, [0.3, 0.6], method="Nelder-Mead", options={"xatol": 1e-10, "fatol": 1e-14}).fun
    assert path.length == pytest.approx(exact, rel=1e-3)
    assert path.length >= exact * (1 - 1e-9)


def test_one_cost_is_the_length_in_space():
    vertices, faces = bent_grid(30, 20)
    exact = vorogeo.exact_distance_field(vertices, faces, 7)
    field = vorogeo.exact_distance_field(vertices, faces, 7, metric=vorogeo.FaceCost(np.full(len(faces), 2.0)))
    others = exact > 0
    error = np.abs(field / 2 - exact)[others] / exact[others]
    assert error.mean() < 1e-3
    assert error.max() < 5e-3
    plain = vorogeo.exact_path(vertices, faces, 7, 580)
    assert plain.certified
    assert plain.length == pytest.approx(exact[580], rel=1e-9)
    assert np.linalg.norm(np.diff(plain.points, axis=0), axis=1).sum() == pytest.approx(plain.length, rel=1e-9)


def test_random_costs_are_symmetric_and_refused_by_an_index():
    vertices, faces = bent_grid(30, 20)
    metric = vorogeo.FaceCost(np.random.default_rng(3).uniform(1, 5, len(faces)))
    one = vorogeo.exact_path(vertices, faces, 0, 599, metric=metric)
    back = vorogeo.exact_path(vertices, faces, 599, 0, metric=metric)
    assert one.length == pytest.approx(back.length, rel=2e-3)
    assert vorogeo.exact_distance_field(vertices, faces, 0, metric=metric)[599] == pytest.approx(one.length, rel=5e-3)
    for call in (
        lambda: vorogeo.GeodesicIndex(vertices, faces, metric=metric),
        lambda: vorogeo.distance_field(vertices, faces, 0, metric=metric),
    ):
        with pytest.raises(vorogeo.InvalidInput, match="a FaceCost jumps at edges"):
            call()


def test_what_is_no_face_metric_is_refused():
    vertices, faces = plane_grid(4, 4)

    def refused(metric, match):
        with pytest.raises(vorogeo.InvalidInput, match=match):
            vorogeo.exact_distance_field(vertices, faces, 0, metric=metric)

    refused(vorogeo.FaceCost(np.where(np.arange(len(faces)) == 5, 0, 1.0)), "Face 5 has the cost 0")
    refused(vorogeo.FaceCost(np.ones(3)), "There are 3 costs, but the mesh has 18 faces")
    refused(vorogeo.FaceTensor(np.tile(-np.eye(3), (18, 1, 1))), "The tensor of face 0 is not positive on the plane")
    with pytest.raises(vorogeo.InvalidInput, match="points"):
        vorogeo.FaceCost(np.ones(18), points=0)
