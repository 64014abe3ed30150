"""The table of methods, and methods of the literature in the comparison, against pygeodesic."""

from __future__ import annotations

import csv

import numpy as np
import pytest
from support import (
    COMPARISON,
    METHOD_TABLE,
    arrays,
    exact_distances,
    fails_and_changes_nothing,
    field,
    grid,
    length,
    mesh_set,
    side_by_side,
    sphere,
)


def test_figures_are_those_of_the_methods(tmp_path):
    ms = mesh_set(*sphere(3))
    file = tmp_path / "table.csv"
    result = ms.apply_filter(METHOD_TABLE, methods="mmp, dijkstra, heat(delaunay=1)", sources=2, csv_file=str(file))
    assert (result["methods"], result["sources"]) == (3, 2)
    assert result["max_error"][0] == 0
    assert 0.01 < result["mean_error"][1] < 0.2
    assert result["mean_error"][1] < result["p99_error"][1] <= result["max_error"][1]
    assert np.all(result["field_seconds"] > 0)
    assert np.all(result["bytes"] > 1000)
    assert np.isnan(result["pair_seconds"][2])
    rows = list(csv.DictReader(file.open(newline="")))
    assert [row["method"] for row in rows] == ["mmp", "dijkstra", "heat(delaunay=1)"]
    np.testing.assert_allclose([float(row["mean_error"]) for row in rows], result["mean_error"], rtol=1e-8)
    assert rows[0]["error_bound"] == "exact"


def test_edge_paths_of_a_rectangle_have_a_closed_form():
    vertices, faces = grid(9, 6)
    result = mesh_set(vertices, faces).apply_filter(METHOD_TABLE, methods="dijkstra", sources=1)
    small, large = np.sort(vertices[1:, :2], axis=1).T
    expected = (large - small + np.sqrt(2) * small) / np.hypot(small, large) - 1
    assert result["mean_error"][0] == pytest.approx(expected.mean(), rel=1e-9)


@pytest.mark.parametrize(
    ("parameters", "words"),
    [
        ({"methods": "walking"}, "The method walking is not known"),
        ({"methods": "svg(K)"}, "The list of methods cannot be read"),
        ({"sources": 0}, "Give 1 or more"),
        ({"csv_file": "/nowhere/table.csv"}, "/nowhere"),
    ],
)
def test_what_is_refused_is_named(parameters, words):
    ms = mesh_set(*sphere(1))
    with fails_and_changes_nothing(ms, words):
        ms.apply_filter(METHOD_TABLE, **parameters)


def test_the_comparison_offers_the_methods_of_the_literature():
    ms = mesh_set(*sphere(3))
    vertices, faces = arrays(ms)
    result = ms.apply_filter(COMPARISON, vertex_index=7, method="Window tree, ordered and filtered (ICH)")
    assert result["max_error"] < 1e-9
    result = ms.apply_filter(COMPARISON, vertex_index=7, method="Virtual sources (GSP)")
    assert 1e-6 < result["mean_error"] < 0.02
    assert exact_distances(vertices, faces, [7]).shape == field(ms).shape


def test_waves_across_gaps_take_the_gap_of_the_filter():
    ms = mesh_set(*side_by_side(grid(5, 5), grid(5, 5)))
    vertices = arrays(ms)[0]
    gap = vertices[36:, 0].min() - vertices[:36, 0].max()
    result = ms.apply_filter(
        COMPARISON, vertex_index=0, method="Waves across gaps (Campen, Kobbelt)", gap=length(1.5 * gap)
    )
    assert result["compared_vertices"] == 71
    assert 1e-6 < result["mean_error"] < 0.1
