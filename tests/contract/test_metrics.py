"""Metrics from slopes and curvatures; values that are no metric, and questions that one cannot answer, are refused."""

from __future__ import annotations

import ask
import numpy as np
import pytest
import surfaces
import table
import vorogeo
from surfaces import Floats, Shape

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
    with ask.refused("this mesh has no positions"):
        ask.new_surface(table.named("saddle by edge lengths"), gap=0.1)


def walled() -> Shape:
    """A square with a wall from below, up to three quarters of its height, and a moat round its upper left corner."""
    vertices, faces = surfaces.plain_grid(17, 17, 1, 1)
    x, y, _ = vertices[faces].mean(axis=1).T
    wall = (x > 7 / 16) & (x < 8 / 16) & (y < 12 / 16)
    moat = (x < 3 / 16) & (y > 13 / 16) & ((x > 2 / 16) | (y < 14 / 16))
    tips = np.array([[7 / 16, 12 / 16, 0], [8 / 16, 12 / 16, 0]])

    def between(a: Floats, b: Floats) -> Floats:
        """From points left of the wall and below its tips."""
        slope = (b[None, :, 1] - a[:, None, 1]) / np.maximum(b[None, :, 0] - a[:, None, 0], 1e-9)
        sees = (b[None, :, 0] <= 7 / 16) | (a[:, None, 1] + slope * (7 / 16 - a[:, None, 0]) >= 12 / 16)
        to_first = surfaces.straight(a, tips[:1])
        low = b[None, :, 1] < 12 / 16
        round_tips = np.where(low, 1 / 16 + surfaces.straight(tips[1:], b), surfaces.straight(tips[:1], b))
        length = np.where(sees, surfaces.straight(a, b), to_first + round_tips)
        return np.where((b[None, :, 0] <= 2 / 16) & (b[None, :, 1] >= 14 / 16), np.inf, length)

    cost = vorogeo.FaceCost(np.where(wall | moat, np.inf, 1.0))
    return surfaces.shape(
        "walled", (vertices, faces), between, metric=cost, sources=np.array([17 + 5, 5 * 17 + 6], np.int32)
    )


WALLED = walled()
FIRST = int(WALLED.sources[0])


@pytest.mark.parametrize("by", ["exact", "index", "by index, exact", "automatic", "function"])
def test_paths_go_round_faces_of_infinite_cost_and_along_their_edges(by: str) -> None:
    expected = WALLED.fields(WALLED.sources)
    answer = np.array([ask.field(by, WALLED, int(source)) for source in WALLED.sources])
    ask.assert_answers(by, WALLED, answer, expected)
    targets = np.flatnonzero(np.isfinite(expected[0]))[::9]
    ask.assert_answers(by, WALLED, ask.distance(by, WALLED, FIRST, targets), expected[0, targets])
    island = np.isinf(expected[0])
    assert ask.distance(by, WALLED, FIRST, int(np.flatnonzero(island)[0])) == np.inf


def test_islands_that_no_path_reaches_are_counted() -> None:
    island = np.isinf(WALLED.fields([FIRST])[0])
    surface = ask.new_surface(WALLED)
    surface.distance_field(FIRST, 0.1)
    assert surface.last.unreached == island.sum() == 9
    surface.distance_field([FIRST, int(np.flatnonzero(island)[0])])
    assert surface.last.unreached == 0
    regions = surface.voronoi([0, 16])
    np.testing.assert_array_equal(regions.vertex_region == -1, island)
    area = np.isfinite(np.asarray(WALLED.metric.cost)).sum() / 512 - 4 / 256
    assert regions.area.sum() == pytest.approx(area, rel=1e-9)


def test_vertices_of_infinite_cost_bar_their_faces() -> None:
    barred = [100, 101, 118, 120]
    cost, mask = np.ones(len(WALLED.vertices)), ~np.isin(WALLED.faces, barred).any(axis=1)
    cost[barred] = np.inf
    mesh = WALLED.vertices, WALLED.faces
    surface, masked = vorogeo.Surface(*mesh, metric=vorogeo.VertexCost(cost)), vorogeo.Surface(*mesh, mask=mask)
    np.testing.assert_allclose(surface.distance_field(3), masked.distance_field(3), rtol=1e-12)
    assert surface.last.unreached == masked.last.unreached == len(barred)
    face = int(np.flatnonzero(~mask)[0])
    with ask.refused(f"Face {face} does not exist or is left out of the surface .it is masked or impassable"):
        surface.distance(0, vorogeo.SurfacePoints(np.array([face], np.int32), np.array([[0.2, 0.3, 0.5]])))


def test_costs_of_grade_are_functions_or_tables() -> None:
    vertices, faces = surfaces.plain_grid(9, 9, 1, 1)
    for grade in (0.08, 1 / 12, 0.1):
        tilted = vertices + np.outer(vertices[:, 0], [0, 0, grade])
        length = np.linalg.norm(tilted - tilted[0], axis=1)
        field = vorogeo.Surface(tilted, faces, metric=vorogeo.slope_cost(tilted, faces, penalty=vorogeo.wheelchair))
        assert np.isfinite(field.distance_field(0)[1:]).all() == (grade < 0.09)
        table = vorogeo.slope_cost(tilted, faces, penalty=[[0, 1], [0.2, 3], [0.3, np.inf]])
        answer = vorogeo.exact_distance_field(tilted, faces, 0, metric=table)
        np.testing.assert_allclose(answer, (1 + 10 * grade) * length, rtol=1e-9)
        rows = np.array([[-1, 4], [0, 1], [0.2, 3]])
        by_table = vorogeo.hiking_time(tilted, faces, rows)
        by_function = vorogeo.hiking_time(tilted, faces, lambda g, r=rows: np.interp(g, *r.T, 9e9, 9e9))
        np.testing.assert_allclose(by_table.drift, by_function.drift, rtol=1e-12)
        np.testing.assert_allclose(by_table.tensors, by_function.tensors, rtol=1e-12)
    steep = vertices + np.outer(vertices[:, 0], [0, 0, 0.25])
    beyond = vorogeo.slope_cost(steep, faces, penalty=[[0, 1], [0.2, 3], [0.3, np.inf]])
    assert np.isinf(np.asarray(beyond.cost)).all()
    np.testing.assert_allclose(vorogeo.naismith([-0.3, 0, 0.1]), [0.72, 0.72, 0.72 + 600 / 1000])
    for law in (vorogeo.tobler, vorogeo.naismith, vorogeo.wheelchair, vorogeo.climbing_cost()):
        with ask.refused("grade: is not an array of numbers .it is .*; give rises by length on the map"):
            law("a")
    for table, sentence in (
        ([[0, 1], [0.1, np.nan]], "penalty.1.: is .0.1, nan."),
        ([[0, 1], [0, 2]], "penalty.1.: is .0.0, 2.0."),
        ([[0, -1]], "penalty.0.: is .0.0, -1.0."),
        ([[0, 1, 2]], "penalty: has shape .1, 3."),
        (lambda grade: -grade, "penalty: returns other values"),
    ):
        with ask.refused(sentence):
            vorogeo.slope_cost(vertices, faces, penalty=table)


def test_winds_may_be_unknown_where_a_mask_leaves_faces_out() -> None:
    vertices, faces = surfaces.plain_grid(9, 9, 1, 1)
    wind = np.tile([0.3, 0.0, 0.0], (len(faces), 1))
    mask = vertices[faces].mean(axis=1)[:, 1] < 0.5
    wind[~mask] = np.nan
    metric = vorogeo.travel_time(vertices, faces, wind)
    field = vorogeo.Surface(vertices, faces, metric=metric, mask=mask).distance_field(0)
    assert field[8] == pytest.approx(1 / 1.3, rel=1e-9)
    with ask.refused(f"The drift of face {np.flatnonzero(~mask)[0]} is not finite; give .* a finite wind"):
        vorogeo.Surface(vertices, faces, metric=metric)
    with ask.refused("wind: has shape"):
        vorogeo.travel_time(vertices, faces, [np.nan, 0, 0])
