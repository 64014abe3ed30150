"""The comparison and the table of methods, against the built-in filters, closed forms and pygeodesic."""

from __future__ import annotations

import csv

import filters
import numpy as np
import pytest
from support import (
    arrays,
    exact_distances,
    fails_and_changes_nothing,
    field,
    grid,
    host_version,
    length,
    mesh_set,
    select_vertices,
    side_by_side,
    sphere,
)

METHODS = INDEX, EXACT, MARCHING, HEAT, EDGES = (
    "VoroGeo index",
    "Exact (VoroGeo)",
    "Fast marching (MeshLab)",
    "Heat method (MeshLab)",
    "Shortest edge path (Dijkstra)",
)
NO_HEAT = pytest.mark.skipif(host_version() == "2022.02", reason="MeshLab 2022.02 has no heat method")


def compare(ms, method: str, reference: str = EXACT, source: int = 0) -> dict:
    return ms.apply_filter(filters.COMPARISON, vertex_index=source, method=method, reference=reference)


def test_edge_paths_on_a_rectangle_have_a_closed_form():
    """From a corner the best edge path takes diagonals as long as it can; the true distance is straight."""
    vertices, faces = grid(9, 6)
    ms = mesh_set(vertices, faces)
    result = compare(ms, EDGES)
    small, large = np.sort(vertices[1:, :2], axis=1).T
    expected = (large - small + np.sqrt(2) * small) / np.hypot(small, large) - 1
    np.testing.assert_allclose(field(ms)[1:], expected, rtol=1e-9, atol=1e-12)
    assert result["max_error"] == pytest.approx(expected.max(), rel=1e-9)
    assert result["mean_error"] == pytest.approx(expected.mean(), rel=1e-9)
    assert result["mean_signed_error"] == pytest.approx(expected.mean(), rel=1e-9)
    assert result["rms_error"] == pytest.approx(np.sqrt((expected**2).mean()), rel=1e-9)
    assert result["p99_error"] == pytest.approx(np.sort(expected)[int(np.ceil(0.99 * len(expected))) - 1], rel=1e-9)


def test_fast_marching_is_that_of_the_built_in_filter():
    ms = mesh_set(*sphere(3))
    vertices, faces = arrays(ms)
    name = "compute_scalar_by_geodesic_distance_from_given_point_per_vertex"
    ms.apply_filter(name, startpoint=vertices[7], maxdistance=length(100.0))
    exact = exact_distances(vertices, faces, [7])
    others = exact > 0
    expected = field(ms)[others] / exact[others] - 1
    compare(ms, MARCHING, source=7)
    np.testing.assert_allclose(field(ms)[others], expected, atol=1e-6)
    assert np.abs(expected).max() > 1e-4


@NO_HEAT
def test_heat_is_that_of_the_built_in_filter():
    ms = mesh_set(*sphere(3))
    vertices, faces = arrays(ms)
    select_vertices(ms, [7])
    ms.apply_filter("compute_scalar_by_heat_geodesic_distance_from_selection_per_vertex")
    exact = exact_distances(vertices, faces, [7])
    others = exact > 0
    expected = field(ms)[others] / exact[others] - 1
    result = compare(ms, HEAT, source=7)
    np.testing.assert_allclose(field(ms)[others], expected, atol=1e-5)
    assert result["method_build_seconds"] > 0


@pytest.mark.skipif(host_version() != "2022.02", reason="this MeshLab has the heat method")
def test_heat_is_refused_where_there_is_none():
    ms = mesh_set(*sphere(2))
    with fails_and_changes_nothing(ms, "MeshLab 2022.02 has no heat method"):
        compare(ms, HEAT)


def test_index_against_exact_and_the_other_way_round():
    ms = mesh_set(*sphere(4))
    forth = compare(ms, INDEX, EXACT, 100)
    a = field(ms).copy()
    back = compare(ms, EXACT, INDEX, 100)
    np.testing.assert_allclose((1 + a) * (1 + field(ms)), 1, atol=1e-9)
    assert 0 < forth["mean_error"] < 5e-4
    assert back["mean_signed_error"] == pytest.approx(-forth["mean_signed_error"], rel=0.01)
    assert forth["method_build_seconds"] > 0
    assert back["reference_build_seconds"] == 0  # the index was reused


def test_colours_tell_too_short_from_too_long():
    ms = mesh_set(*grid(9, 6))
    compare(ms, EDGES)
    red, _, blue = ms.current_mesh().vertex_color_matrix()[:, :3].T
    assert np.all(red[field(ms) > 0.01] > blue[field(ms) > 0.01])
    compare(ms, EXACT, EDGES)
    red, _, blue = ms.current_mesh().vertex_color_matrix()[:, :3].T
    assert np.all(red[field(ms) < -0.01] < blue[field(ms) < -0.01])
    same = np.abs(field(ms)) < 1e-12
    same[0] = False  # the source is not compared
    np.testing.assert_allclose(ms.current_mesh().vertex_color_matrix()[same, :3], 221 / 255, atol=0.01)


@pytest.mark.parametrize("method", [INDEX, MARCHING, EDGES])
def test_other_components_are_not_compared(method):
    first, second = grid(6, 6), sphere(1)
    ms = mesh_set(*side_by_side(first, second))
    result = compare(ms, method)
    assert result["compared_vertices"] == 48
    assert result["vertices_by_one_method_only"] == 0
    np.testing.assert_array_equal(field(ms)[49:], 0)
    np.testing.assert_allclose(255 * ms.current_mesh().vertex_color_matrix()[49:, :3], 160)


def test_figures_are_those_of_the_methods(tmp_path):
    ms = mesh_set(*sphere(3))
    file = tmp_path / "table.csv"
    result = ms.apply_filter(
        filters.METHOD_TABLE, methods="mmp, dijkstra, heat(delaunay=1)", sources=2, csv_file=str(file)
    )
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


def test_the_comparison_offers_the_methods_of_the_literature():
    ms = mesh_set(*sphere(3))
    result = ms.apply_filter(filters.COMPARISON, vertex_index=7, method="Window tree, ordered and filtered (ICH)")
    assert result["max_error"] < 1e-9
    result = ms.apply_filter(filters.COMPARISON, vertex_index=7, method="Virtual sources (GSP)")
    assert 1e-6 < result["mean_error"] < 0.02


def test_waves_across_gaps_take_the_gap_of_the_filter():
    ms = mesh_set(*side_by_side(grid(5, 5), grid(5, 5)))
    vertices = arrays(ms)[0]
    gap = vertices[36:, 0].min() - vertices[:36, 0].max()
    result = ms.apply_filter(
        filters.COMPARISON, vertex_index=0, method="Waves across gaps (Campen, Kobbelt)", gap=length(1.5 * gap)
    )
    assert result["compared_vertices"] == 71
    assert 1e-6 < result["mean_error"] < 0.1
