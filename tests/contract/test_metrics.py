"""Metrics scale, stretch and refract as their formulas say, and agree with one another where they mean the same."""

from __future__ import annotations

from dataclasses import replace

import ask
import metric_surfaces
import numpy as np
import pytest
import table
import vorogeo
from surfaces import Rng, Shape
from vorogeo.metrics import Metric

WAYS = ("exact", "index", "function")
COARSE = table.named("cone")
BENT = table.named("bumpy")


def with_metric(shape: Shape, metric: Metric | None) -> Shape:
    """The surface in another metric."""
    return replace(shape, name=f"{shape} in {type(metric).__name__}", metric=metric)


def constant(kind: str, shape: Shape, factor: float) -> Metric:
    """A metric in which every path costs its length times a factor."""
    count = len(shape.faces) if kind.startswith("Face") else len(shape.vertices)
    if kind.endswith("Tensor"):
        return getattr(vorogeo, kind)(np.broadcast_to(factor**2 * np.eye(3), (count, 3, 3)))
    if kind.endswith("Cost"):
        return getattr(vorogeo, kind)(np.full(count, factor))
    corner = shape.vertices[shape.faces]
    return vorogeo.EdgeLengths(factor * np.linalg.norm(corner[:, [2, 0, 1]] - corner[:, [1, 2, 0]], axis=2))


KINDS = {"EdgeLengths": 1e-9, "VertexCost": 1e-9, "VertexTensor": 1e-9, "FaceCost": metric_surfaces.OF_FACES,
         "FaceTensor": metric_surfaces.OF_FACE_TENSORS}  # fmt: skip


@pytest.mark.parametrize("by", WAYS)
@pytest.mark.parametrize("kind", KINDS)
def test_one_cost_everywhere_is_the_length_times_it(by: str, kind: str, random: Rng) -> None:
    factor = float(random.uniform(0.1, 10))
    shape = with_metric(COARSE, constant(kind, COARSE, factor))
    slack = KINDS[kind] + ask.errors(by, COARSE).largest
    for source in map(int, COARSE.sources):
        expected = factor * COARSE.fields([source])[0]
        np.testing.assert_allclose(ask.field(by, shape, source), expected, rtol=slack, atol=1e-9)
    target = len(COARSE.vertices) - 1
    assert ask.path(by, shape, 1, target).length == pytest.approx(
        factor * COARSE.matrix([1], [target])[0, 0], rel=KINDS[kind] + 3e-3
    )


@pytest.mark.parametrize("by", WAYS)
@pytest.mark.parametrize("kind", ["VertexTensor", "FaceTensor"])
def test_a_tensor_is_the_length_on_the_stretched_mesh(by: str, kind: str) -> None:
    count = len(BENT.faces) if kind.startswith("Face") else len(BENT.vertices)
    tensors = np.broadcast_to(metric_surfaces.TENSOR, (count, 3, 3))
    shape = with_metric(BENT, getattr(vorogeo, kind)(tensors))
    stretched = replace(BENT, vertices=BENT.vertices @ metric_surfaces.STRETCH.T)
    slack = KINDS[kind] + ask.errors(by, BENT).largest
    for source in map(int, BENT.sources[:2]):
        expected = ask.field("exact", stretched, source)
        np.testing.assert_allclose(ask.field(by, shape, source), expected, rtol=slack, atol=1e-9)


@pytest.mark.parametrize("by", WAYS)
def test_edge_lengths_need_no_positions(by: str) -> None:
    shape = with_metric(BENT, constant("EdgeLengths", BENT, 1.0))
    np.testing.assert_allclose(ask.field(by, shape, 5), ask.field(by, BENT, 5), rtol=ask.errors(by, BENT).largest)
    path = ask.path(by, shape, 5, 300)
    assert np.isnan(path.points).all()
    assert path.length == pytest.approx(ask.path("exact", BENT, 5, 300).length, rel=3e-3)


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "EdgeLengths"])
def test_any_metric_is_symmetric_and_lies_between_its_least_and_greatest_cost(kind: str, random: Rng) -> None:
    count = len(COARSE.faces) if kind.startswith("Face") else len(COARSE.vertices)
    cost = random.uniform(1, 3, count)
    values = cost[:, None, None] * np.eye(3) if kind.endswith("Tensor") else cost
    shape, most = with_metric(COARSE, getattr(vorogeo, kind)(values)), cost.max() ** (0.5 if kind.endswith("r") else 1)
    source, target = random.integers(0, len(COARSE.vertices), (2, 20))
    lengths = ask.distance("exact", COARSE, source, target)
    for by in ("exact", "index"):
        there, back = ask.distance(by, shape, source, target), ask.distance(by, shape, target, source)
        # A path that refracts may take another row of edges in each direction.
        apart = np.abs(there - back) / np.maximum(back, 1e-12)
        assert apart.max() <= (0 if by == "index" else 10 * KINDS[kind])
        assert apart.mean() <= (0 if by == "index" else 2 * KINDS[kind])
        assert (there >= lengths * (1 - 0.02)).all()
        assert (there <= most * lengths * (1 + 0.02)).all()


def test_level_ground_costs_its_length_and_a_wall_one_and_the_penalty() -> None:
    flat, tube = table.named("plane"), table.named("prism")
    np.testing.assert_allclose(np.asarray(vorogeo.slope_cost(flat.vertices, flat.faces, penalty=5).cost), 1)
    np.testing.assert_allclose(np.asarray(vorogeo.slope_cost(tube.vertices, tube.faces, penalty=5).cost), 6)
    tensors = np.asarray(vorogeo.curvature_tensor(flat.vertices, flat.faces, 3).tensors)
    np.testing.assert_allclose(tensors, np.broadcast_to(np.eye(3), tensors.shape), atol=1e-9)


BAD = {
    "Vertex 0 has the cost 0": lambda n, m: vorogeo.VertexCost(np.r_[0.0, np.ones(n - 1)]),
    "Vertex 2 has the cost nan": lambda n, m: vorogeo.VertexCost(np.r_[1, 1, np.nan, np.ones(n - 3)]),
    "but the mesh has .* vertices": lambda n, m: vorogeo.VertexCost(np.ones(n + 1)),
    "Face 1 has the cost -1": lambda n, m: vorogeo.FaceCost(np.r_[1.0, -1.0, np.ones(m - 2)]),
    "but the mesh has .* faces": lambda n, m: vorogeo.FaceCost(np.ones(m - 1)),
    "The tensor of vertex 0 is not positive": lambda n, m: vorogeo.VertexTensor(np.zeros((n, 3, 3))),
    "The tensor of face 0 is not finite": lambda n, m: vorogeo.FaceTensor(np.full((m, 3, 3), np.nan)),
    "EdgeLengths: has .* rows": lambda n, m: vorogeo.EdgeLengths(np.ones((m - 1, 3))),
    "Face 0 has the side lengths 1, 1, 3": lambda n, m: vorogeo.EdgeLengths(np.tile([1.0, 1.0, 3.0], (m, 1))),
    "metric: is a type": lambda n, m: vorogeo.VertexCost,
    "metric: is a str": lambda n, m: "cost",
}


@pytest.mark.parametrize("sentence", BAD)
def test_values_that_are_no_metric_are_refused_by_name(sentence: str) -> None:
    for question in (vorogeo.Surface, vorogeo.GeodesicIndex):
        with ask.refused(sentence):
            question(COARSE.vertices, COARSE.faces, metric=BAD[sentence](len(COARSE.vertices), len(COARSE.faces)))


def test_questions_that_a_metric_cannot_answer_are_refused() -> None:
    shore = table.named("shore")
    with ask.refused("this metric jumps at edges"):
        ask.surface(shore).distance_field(0, method="quick")
    with ask.refused("leave out the gap or the metric"):
        ask.new_surface(shore, gap=0.1)
