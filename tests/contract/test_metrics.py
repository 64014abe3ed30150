"""Metrics from slopes and curvatures; values that are no metric, and questions that one cannot answer, are refused."""

from __future__ import annotations

import ask
import numpy as np
import pytest
import table
import vorogeo

COARSE = table.named("cone")


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
