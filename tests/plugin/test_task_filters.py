"""Filters for matrices, Voronoi regions, samplings, isolines, disks and extents: values, layers, bad input."""

from __future__ import annotations

import numpy as np
import pymeshlab
import pytest
from support import (
    DISK,
    EXACT_FROM_POINT,
    EXTENT,
    FARTHEST,
    ISOLINES,
    LLOYD,
    MATRIX,
    NEAREST,
    PAIRS_WITHIN,
    POISSON,
    VORONOI,
    arrays,
    exact_distances,
    fails_and_changes_nothing,
    grid,
    layer_count,
    length,
    mesh_set,
    select_vertices,
    side_by_side,
    sphere,
)

GRID = grid(20, 15, 0.2)
POINTS = [25, 100, 260, 330]


@pytest.fixture
def ms():
    result = mesh_set(*GRID)
    select_vertices(result, POINTS)
    return result


def straight(a, b):
    return np.linalg.norm(GRID[0][np.asarray(a, dtype=int)][:, None] - GRID[0][np.asarray(b, dtype=int)], axis=2)


@pytest.mark.parametrize("exact", [False, True])
def test_distance_matrix_is_returned_and_written(ms, tmp_path, exact):
    file = tmp_path / "matrix.npy"
    result = ms.apply_filter(MATRIX, matrix_file=str(file), exact=exact)
    matrix = result["distances"].reshape(result["rows"], result["columns"])
    np.testing.assert_array_equal(result["vertices"], POINTS)
    np.testing.assert_array_equal(matrix, matrix.T)
    np.testing.assert_allclose(matrix, straight(POINTS, POINTS), rtol=1e-12 if exact else 0.01)
    np.testing.assert_array_equal(np.load(file), matrix)
    assert [path.name for path in tmp_path.iterdir()] == ["matrix.npy"]


def test_unreachable_pairs_are_infinite():
    ms = mesh_set(*side_by_side(sphere(2), sphere(2)))
    select_vertices(ms, [0, 200])
    np.testing.assert_array_equal(ms.apply_filter(MATRIX)["distances"], [0, np.inf, np.inf, 0])


def test_pairs_within_radius(ms, tmp_path):
    file = tmp_path / "pairs.npy"
    distances = straight(POINTS, POINTS)
    radius = np.median(distances[distances > 0])
    result = ms.apply_filter(PAIRS_WITHIN, radius=length(radius + 1e-3), matrix_file=str(file), exact=True)
    expected = [(a, b) for i, a in enumerate(POINTS) for b in POINTS[i + 1 :] if straight([a], [b]) <= radius + 1e-3]
    assert list(zip(result["first"], result["second"], strict=True)) == expected
    assert result["pairs"] == len(expected)
    np.testing.assert_array_equal(
        np.load(file), np.column_stack([result["first"], result["second"], result["distances"]])
    )


def test_voronoi_regions_and_borders(ms):
    result = ms.apply_filter(VORONOI, exact=True)
    assert layer_count(ms) == 2
    assert ms.current_mesh_id() == 0
    nearest = straight(np.arange(len(GRID[0])), POINTS)
    region = ms.current_mesh().vertex_scalar_array().astype(int)
    np.testing.assert_allclose(nearest[np.arange(len(region)), region], nearest.min(axis=1))
    np.testing.assert_allclose(result["areas"].sum(), 12)
    assert result["regions"] == 4
    borders = ms.mesh(1)
    distances = np.linalg.norm(borders.vertex_matrix()[:, None] - GRID[0][POINTS], axis=2)
    two = np.sort(distances, axis=1)[:, :2]
    np.testing.assert_allclose(two[:, 0], two[:, 1], atol=1e-9)
    assert borders.edge_number() > 10
    colors = ms.current_mesh().face_color_matrix()
    centre = straight_to(GRID[0][GRID[1]].mean(axis=1), POINTS)
    clear = np.sort(centre, axis=1)
    sure = clear[:, 1] - clear[:, 0] > 0.3
    assert len(np.unique(colors[sure & (centre.argmin(axis=1) == 0)], axis=0)) == 1


def straight_to(positions, points):
    return np.linalg.norm(positions[:, None] - GRID[0][points], axis=2)


def test_voronoi_without_borders_adds_no_layer(ms):
    ms.apply_filter(VORONOI, borders=False)
    assert layer_count(ms) == 1


def test_farthest_point_sampling_is_a_layer_of_points(ms):
    result = ms.apply_filter(FARTHEST, sample_number=12, from_selection=True, exact=True)
    samples = ms.current_mesh()
    assert layer_count(ms) == 2
    assert samples.vertex_number() == result["samples"] == 12
    assert samples.face_number() == 0
    numbers = result["vertices"].astype(int)
    np.testing.assert_array_equal(numbers[:4], POINTS)
    np.testing.assert_array_equal(samples.vertex_matrix(), GRID[0][numbers])
    covering = straight(np.arange(len(GRID[0])), numbers).min(axis=1).max()
    np.testing.assert_allclose(result["covering_radius"], covering)


def test_poisson_disk_sampling_is_spaced_and_maximal(ms):
    result = ms.apply_filter(POISSON, radius=length(0.7), exact=True, seed=4)
    numbers = result["vertices"].astype(int)
    apart = straight(numbers, numbers)[np.triu_indices(len(numbers), 1)]
    assert apart.min() >= 0.7 - 1e-6
    assert straight(np.arange(len(GRID[0])), numbers).min(axis=1).max() < 0.7 + 1e-6
    assert ms.current_mesh().vertex_number() == result["samples"] == len(numbers)


def test_layers_lie_where_the_sampled_layer_lies(ms):
    matrix = np.array([[2, 0, 0, 5], [0, 2, 0, 6], [0, 0, 2, 7], [0, 0, 0, 1.0]])
    ms.apply_filter("set_matrix", transformmatrix=matrix, freeze=False)
    ms.apply_filter(POISSON, radius=length(1.0))
    local = ms.current_mesh().vertex_matrix().copy()
    ms.apply_filter("apply_matrix_freeze")
    np.testing.assert_allclose(ms.current_mesh().vertex_matrix(), 2 * local + [5, 6, 7])


def test_lloyd_relaxation_lowers_the_energy():
    ms = mesh_set(*GRID)
    select_vertices(ms, [0, 1, 2, 3])
    result = ms.apply_filter(LLOYD, rounds=8, exact=True)
    assert result["energy_after"] < 0.3 * result["energy_before"]
    assert 1 <= result["rounds"] <= 8
    np.testing.assert_array_equal(ms.current_mesh().vertex_matrix(), GRID[0][result["vertices"].astype(int)])


def test_isolines_of_a_distance_are_circles(ms):
    centre = 7 * 21 + 10
    ms.apply_filter(EXACT_FROM_POINT, vertex_index=centre)
    result = ms.apply_filter(ISOLINES, values="0.5 1.2")
    lines = ms.current_mesh()
    radius = np.linalg.norm(lines.vertex_matrix() - GRID[0][centre], axis=1)
    np.testing.assert_allclose(radius, lines.vertex_scalar_array(), atol=1e-9)
    np.testing.assert_allclose(result["length"], 2 * np.pi * 1.7, rtol=0.01)
    assert lines.edge_number() == result["segments"]
    np.testing.assert_array_equal(result["values"], [0.5, 1.2])


def test_isolines_end_where_no_distance_is():
    ms = mesh_set(*side_by_side(sphere(3), sphere(2)))
    ms.apply_filter(EXACT_FROM_POINT, vertex_index=0)
    result = ms.apply_filter(ISOLINES, line_number=3)
    assert len(result["values"]) == 3
    assert ms.current_mesh().vertex_matrix()[:, 0].max() <= 1


def test_disk_selects_vertices_and_faces(ms):
    result = ms.apply_filter(DISK, vertex_index=170, radius=length(0.9), exact=True)
    inside = np.linalg.norm(GRID[0] - GRID[0][170], axis=1) <= 0.9
    mesh = ms.current_mesh()
    np.testing.assert_array_equal(mesh.vertex_selection_array(), inside)
    np.testing.assert_array_equal(mesh.face_selection_array(), inside[GRID[1]].all(axis=1))
    assert result["selected_vertices"] == inside.sum()


def test_disk_grows_the_selection(ms):
    ms.apply_filter(DISK, radius=length(0.5), exact=True)
    inside = straight(np.arange(len(GRID[0])), POINTS).min(axis=1) <= 0.5
    np.testing.assert_array_equal(ms.current_mesh().vertex_selection_array(), inside)


def test_diameter_and_centre_bounds_hold(ms):
    vertices, faces = sphere(2)
    ms = mesh_set(vertices, faces)
    eccentricity = [exact_distances(vertices, faces, [v]).max() for v in range(len(vertices))]
    for fields in (2, 10):
        result = ms.apply_filter(EXTENT, fields=fields, exact=True)
        assert result["diameter_lower"] - 1e-9 <= max(eccentricity) <= result["diameter_upper"] + 1e-9
        assert result["radius_lower"] - 1e-9 <= min(eccentricity) <= result["radius_upper"] + 1e-9
        np.testing.assert_allclose(eccentricity[result["centre"]], result["radius_upper"])
        assert result["fields"] <= fields


@pytest.mark.parametrize("exact", [False, True])
def test_nearest_points_of_a_layer(ms, exact, tmp_path):
    vertices = GRID[0]
    points = np.array([[0.31, 0.42, 0.0], [3.3, 2.55, 0.25], [2.0, 0.4, 0.0], [0.9, 2.7, 0.0]])
    ms.add_mesh(pymeshlab.Mesh(points), set_as_current=False)
    file = tmp_path / "nearest.npy"
    found = ms.apply_filter(NEAREST, source_layer=1, neighbour_number=3, matrix_file=str(file), exact=exact)
    full = np.linalg.norm((vertices[POINTS][:, None] - points)[..., :2], axis=2)
    assert (found["rows"], found["columns"]) == (4, 3)
    assert found["snap_distance"] == pytest.approx(0.25)
    np.testing.assert_array_equal(found["vertices"], POINTS)
    np.testing.assert_array_equal(found["nearest"].reshape(4, 3), np.argsort(full)[:, :3])
    distances = np.sort(full)[:, :3]
    np.testing.assert_allclose(found["distances"].reshape(4, 3), distances, rtol=1e-9 if exact else 1e-2)
    table = np.load(file)
    np.testing.assert_array_equal(table[:, 0], np.repeat(POINTS, 3))
    np.testing.assert_array_equal(table[:, 1:], np.column_stack([found["nearest"], found["distances"]]))
    more = ms.apply_filter(NEAREST, source_layer=1, neighbour_number=5, exact=exact)
    np.testing.assert_array_equal(more["nearest"].reshape(4, 5)[:, 4], -1)
    assert np.isinf(more["distances"].reshape(4, 5)[:, 4]).all()


@pytest.mark.parametrize(
    ("parameters", "message"),
    [
        ({"source_layer": 7}, "(source_layer) is 7, but there is no such layer"),
        ({"source_layer": 0}, "the current layer itself"),
        ({"source_layer": 1, "neighbour_number": 0}, "(neighbour_number) is 0"),
        ({"source_layer": 1, "max_snap_distance": length(0.1)}, "Vertex 0 of layer 1 is 0.5"),
        ({"source_layer": 1, "matrix_file": "/nowhere/x.npy"}, "no folder"),
    ],
)
def test_bad_input_of_nearest_points(ms, parameters, message):
    ms.add_mesh(pymeshlab.Mesh(np.array([[1.0, 1.0, 0.5]])), set_as_current=False)
    with fails_and_changes_nothing(ms, message):
        ms.apply_filter(NEAREST, **parameters)


@pytest.mark.parametrize("name", [MATRIX, PAIRS_WITHIN, NEAREST, VORONOI, LLOYD, DISK])
def test_an_empty_selection_is_an_error(name):
    ms = mesh_set(*GRID)
    with fails_and_changes_nothing(ms, "No vertex is selected"):
        ms.apply_filter(name)
    assert layer_count(ms) == 1


@pytest.mark.parametrize(
    ("name", "parameters", "message"),
    [
        (PAIRS_WITHIN, {"radius": length(-1)}, "(radius) is -1"),
        (POISSON, {"radius": length(0)}, "(radius) is 0"),
        (POISSON, {"seed": -1}, "(seed) is -1"),
        (FARTHEST, {"sample_number": 0}, "(sample_number) is 0"),
        (FARTHEST, {"radius": length(-2)}, "(radius) is -2"),
        (LLOYD, {"rounds": -1}, "(rounds) is -1"),
        (DISK, {"vertex_index": 9999}, "(vertex_index) is 9999"),
        (DISK, {"radius": length(-1)}, "(radius) is -1"),
        (EXTENT, {"fields": 1}, "(fields) is 1"),
        (ISOLINES, {"values": "1 two"}, "(values) holds 'two'"),
        (ISOLINES, {"line_number": 0}, "(line_number) is 0"),
        (MATRIX, {"matrix_file": "/nowhere/x.npy"}, "cannot be written"),
    ],
)
def test_bad_parameters_are_named(ms, name, parameters, message):
    with fails_and_changes_nothing(ms, message):
        ms.apply_filter(name, **parameters)
    assert layer_count(ms) == 1


@pytest.mark.parametrize("name", [MATRIX, PAIRS_WITHIN, VORONOI, FARTHEST, POISSON, LLOYD, EXTENT])
def test_cancelling_leaves_everything_as_it_was(ms, name):
    ms.apply_filter("compute_geodesic_index_by_vorogeo")
    with fails_and_changes_nothing(ms, "Cancelled"):
        ms.apply_filter("probe_apply", filter=name, calls_allowed=0)
    assert layer_count(ms) == 1


def test_mesh_of_the_layer_is_not_changed(ms):
    for name in (MATRIX, PAIRS_WITHIN, VORONOI, EXTENT):
        ms.apply_filter(name)
    np.testing.assert_array_equal(arrays(ms)[0], GRID[0])
    np.testing.assert_array_equal(arrays(ms)[1], GRID[1])
