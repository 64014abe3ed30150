"""The filters that answer from the index, against exact distances."""

from __future__ import annotations

import numpy as np
import pymeshlab
import pytest
import vorogeo
from support import (
    EXACT_FROM_POINT,
    EXACT_FROM_SELECTION,
    FROM_BORDER,
    FROM_POINT,
    FROM_SELECTION,
    INDEX,
    TWO_POINTS,
    arrays,
    assert_close_to_exact,
    exact_distances,
    field,
    grid,
    load,
    mesh_set,
    select_vertices,
    sphere,
)


# Twice the errors in percent of docs/figures.md: mean, 99th percentile, largest.
@pytest.mark.parametrize(
    ("name", "documented"),
    [
        ("bunny10k_textured.obj", (0.0151, 0.118, 1.08)),
        ("fandisk", (0.0097, 0.096, 1.25)),
        ("rocker_arm", (0.0118, 0.093, 0.55)),
        ("homer", (0.0081, 0.064, 0.68)),
    ],
)
def test_field_of_real_meshes_is_close_to_exact(real_mesh, name, documented):
    ms = mesh_set(np.zeros((1, 3)))
    load(ms, real_mesh(name))
    vertices, faces = arrays(ms)
    for source in (17, len(vertices) // 2):
        ms.apply_filter(FROM_POINT, vertex_index=source, method="index")
        exact = exact_distances(vertices, faces, [source])
        mean, p99, largest = (2 * percent / 100 for percent in documented)
        assert_close_to_exact(field(ms), exact, mean=mean, largest=largest)
        others = exact > 0
        assert np.quantile(np.abs(field(ms)[others] / exact[others] - 1), 0.99) <= p99


def test_field_agrees_with_the_exact_filter_on_a_sphere():
    ms = mesh_set(*sphere(4))
    ms.apply_filter(EXACT_FROM_POINT, vertex_index=5)
    exact = field(ms).copy()
    ms.apply_filter(FROM_POINT, vertex_index=5, method="index")
    assert_close_to_exact(field(ms), exact, mean=0.0004, largest=0.01)


def test_field_keeps_double_precision():
    ms = mesh_set(*sphere(2))
    ms.apply_filter(FROM_POINT, vertex_index=5, method="index")
    assert np.any(field(ms) != field(ms).astype(np.float32))


def test_selection_gives_distance_from_the_nearest_selected_vertex():
    ms = mesh_set(*sphere(4))
    select_vertices(ms, [3, 500, 2000])
    ms.apply_filter(EXACT_FROM_SELECTION)
    exact = field(ms).copy()
    result = ms.apply_filter(FROM_SELECTION, method="index")
    assert result["source_vertices"] == 3
    assert_close_to_exact(field(ms), exact, mean=0.0001, largest=0.005)


def test_border_of_a_rectangle():
    vertices, faces = grid(30, 12)
    ms = mesh_set(vertices, faces)
    result = ms.apply_filter(FROM_BORDER, method="index")
    x, y = vertices[:, 0], vertices[:, 1]
    expected = np.minimum(np.minimum(x, 30 - x), np.minimum(y, 12 - y))
    assert_close_to_exact(field(ms), expected, mean=0.0001, largest=0.005)
    assert result["source_vertices"] == 2 * (30 + 12)
    assert result["max_distance"] == pytest.approx(6, rel=0.001)


def test_two_vertices_agree_with_the_exact_filter_and_are_symmetric():
    vertices, faces = sphere(4)
    ms = mesh_set(vertices, faces)
    exact = exact_distances(vertices, faces, [7])
    rng = np.random.default_rng(1)
    for target in rng.choice(np.arange(8, len(vertices)), 40, replace=False):
        there = ms.apply_filter(TWO_POINTS, source=7, target=int(target), method="index")["distance"]
        back = ms.apply_filter(TWO_POINTS, source=int(target), target=7, method="index")["distance"]
        assert there == back
        assert there == pytest.approx(exact[target], rel=0.02)


def test_a_vertex_is_at_distance_zero_from_itself():
    assert mesh_set(*sphere(2)).apply_filter(TWO_POINTS, source=9, target=9)["distance"] == 0


def test_index_values_describe_the_mesh_and_the_parameters():
    vertices, faces = sphere(4)
    ms = mesh_set(vertices, faces)
    result = ms.apply_filter(INDEX, n1=12, n2=5)
    assert set(result) == {
        "vertices", "first_layer_patches", "second_layer_patches", "first_layer_border_vertices",
        "second_layer_border_vertices", "is_graph", "arcs_before_pruning", "arcs", "bytes", "seconds",
        "expected_fields",
    }  # fmt: skip
    assert result["vertices"] == len(vertices)
    assert result["first_layer_patches"] == 12
    assert result["second_layer_patches"] > 12
    assert 0 < result["first_layer_border_vertices"] < result["second_layer_border_vertices"] < len(vertices)
    assert 0 < result["arcs"] <= result["arcs_before_pruning"]
    assert result["bytes"] > 0
    assert result["seconds"] > 0


def test_index_is_the_same_for_every_number_of_threads():
    counts = []
    for threads in (1, 2):
        result = mesh_set(*sphere(4)).apply_filter(INDEX, threads=threads, seed=3)
        del result["seconds"]
        counts.append(result)
    assert counts[0] == counts[1]


def test_memory_budget_chooses_the_form():
    tables = mesh_set(*sphere(5)).apply_filter(INDEX, n1=32, n2=2)
    graph = mesh_set(*sphere(5)).apply_filter(INDEX, n1=32, n2=2, delta=0.05)
    assert tables["is_graph"] == 0
    assert graph["is_graph"] == 1
    assert graph["bytes"] < tables["bytes"]
    with pytest.raises(pymeshlab.PyMeshLabException, match="memory budget is 1 MiB, but the index of this mesh takes"):
        mesh_set(*sphere(5)).apply_filter(INDEX, memory_budget=1)
    with pytest.raises(pymeshlab.PyMeshLabException, match=r"\(memory_budget\) is -1"):
        mesh_set(*sphere(5)).apply_filter(INDEX, memory_budget=-1)


def test_delta_leaves_out_arcs():
    arcs = [mesh_set(*sphere(4)).apply_filter(INDEX, delta=delta)["arcs"] for delta in (0.0, 0.02)]
    assert arcs[1] < arcs[0]


def test_index_file_is_written(tmp_path):
    file = tmp_path / "sphere.vgi"
    result = mesh_set(*sphere(3)).apply_filter(INDEX, index_file=str(file))
    assert file.stat().st_size > 100
    assert [entry.name for entry in tmp_path.iterdir()] == ["sphere.vgi"]
    assert result["vertices"] == 642


def test_index_in_a_file_goes_on_where_it_was_stopped(tmp_path):
    file = tmp_path / "sphere.vgi"
    vertices, faces = sphere(4)
    with pytest.raises(vorogeo.Cancelled):
        vorogeo.GeodesicIndex(vertices, faces, file=file, progress=lambda done, _: done < 0.6, threads=1)
    assert [entry.name for entry in tmp_path.iterdir()] == ["sphere.vgi.unfinished"]
    before = mesh_set(vertices, faces).apply_filter(INDEX)
    with pytest.raises(pymeshlab.PyMeshLabException, match="unfinished"):
        mesh_set(*sphere(3)).apply_filter(INDEX, index_file=str(file))
    ms = mesh_set(vertices, faces)
    result = ms.apply_filter(INDEX, index_file=str(file))
    assert [entry.name for entry in tmp_path.iterdir()] == ["sphere.vgi"]
    assert result["arcs"] == before["arcs"]
    # It is replaced by that of another mesh, as the user asks for it.
    mesh_set(*sphere(3)).apply_filter(INDEX, index_file=str(file))
    assert vorogeo.GeodesicIndex.load(file, *sphere(3)).statistics.vertices == 642
    assert ms.apply_filter(FROM_POINT, vertex_index=0, method="index")["index_reused"] == 1


# Twice the errors in percent of docs/figures.md: mean and largest.
@pytest.mark.parametrize(
    ("name", "source", "mean", "largest"),
    [("cow.obj", 100, 0.0079, 0.52), ("greek_helmet", 2500, 0.0058, 0.21), ("office_chair", 100, 0.0001, 0.001)],
)
def test_meshes_with_components_borders_and_non_manifold_edges(real_mesh, name, source, mean, largest):
    ms = mesh_set(np.zeros((1, 3)))
    load(ms, real_mesh(name))
    exact_result = ms.apply_filter(EXACT_FROM_POINT, vertex_index=source)
    exact = field(ms).copy()
    result = ms.apply_filter(FROM_POINT, vertex_index=source, method="index")
    np.testing.assert_array_equal(field(ms) == -1, exact == -1)
    assert result["unreachable_vertices"] == exact_result["unreachable_vertices"] == np.count_nonzero(exact == -1)
    reached = exact > 0
    errors = np.abs(field(ms)[reached] / exact[reached] - 1)
    assert errors.mean() <= 2 * mean / 100
    assert errors.max() <= 2 * largest / 100
