"""The filters for the index: build, describe, save, load; its files, and how long an index lives."""

from __future__ import annotations

import gc

import filters
import numpy as np
import pymeshlab
import pytest
import vorogeo
from support import fails_and_changes_nothing, field, grid, mesh_set, sphere


def test_index_values_describe_the_mesh_and_the_parameters():
    vertices, faces = sphere(4)
    ms = mesh_set(vertices, faces)
    result = ms.apply_filter(filters.INDEX, n1=12, n2=5)
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


def test_memory_budget_chooses_the_form():
    tables = mesh_set(*sphere(5)).apply_filter(filters.INDEX, n1=32, n2=2)
    graph = mesh_set(*sphere(5)).apply_filter(filters.INDEX, n1=32, n2=2, delta=0.05)
    assert tables["is_graph"] == 0
    assert graph["is_graph"] == 1
    assert graph["bytes"] < tables["bytes"]
    with pytest.raises(pymeshlab.PyMeshLabException, match="memory budget is 1 MiB, but the index of this mesh takes"):
        mesh_set(*sphere(5)).apply_filter(filters.INDEX, memory_budget=1)


def test_index_in_a_file_goes_on_where_it_was_stopped(tmp_path):
    file = tmp_path / "sphere.vgi"
    vertices, faces = sphere(4)
    with pytest.raises(vorogeo.Cancelled):
        vorogeo.GeodesicIndex(vertices, faces, file=file, progress=lambda done, _: done < 0.6, threads=1)
    assert [entry.name for entry in tmp_path.iterdir()] == ["sphere.vgi.unfinished"]
    before = mesh_set(vertices, faces).apply_filter(filters.INDEX)
    with pytest.raises(pymeshlab.PyMeshLabException, match="unfinished"):
        mesh_set(*sphere(3)).apply_filter(filters.INDEX, index_file=str(file))
    ms = mesh_set(vertices, faces)
    result = ms.apply_filter(filters.INDEX, index_file=str(file))
    assert [entry.name for entry in tmp_path.iterdir()] == ["sphere.vgi"]
    assert result["arcs"] == before["arcs"]
    # It is replaced by that of another mesh, as the user asks for it.
    mesh_set(*sphere(3)).apply_filter(filters.INDEX, index_file=str(file))
    assert vorogeo.GeodesicIndex.load(file, *sphere(3)).statistics.vertices == 642
    assert ms.apply_filter(filters.FROM_POINT, vertex_index=0, method="index")["index_reused"] == 1


def stretched(factor: float):
    """A mesh of its own for every test, so that no test finds the index of another."""
    vertices, faces = sphere(3)
    return mesh_set(vertices * np.array([1.0, 1.0, factor]), faces)


def test_description_before_and_after_building():
    ms = stretched(1.01)
    assert ms.apply_filter(filters.DESCRIBE_INDEX) == {"has_index": False}
    built = ms.apply_filter(filters.INDEX)
    assert ms.apply_filter(filters.DESCRIBE_INDEX) == {**built, "has_index": True}


def test_saved_index_is_loaded_for_the_same_mesh_in_another_document(tmp_path):
    file = tmp_path / "sphere.vgi"
    ms = stretched(1.03)
    ms.apply_filter(filters.FROM_POINT, vertex_index=5, method="index")
    expected = field(ms).copy()
    saved = ms.apply_filter(filters.SAVE_INDEX, index_file=str(file))
    assert saved["file_bytes"] == file.stat().st_size
    del ms
    gc.collect()
    ms = stretched(1.03)
    loaded = ms.apply_filter(filters.LOAD_INDEX, index_file=str(file))
    assert loaded["vertices"] == 642
    assert loaded["seconds"] == 0
    assert ms.apply_filter(filters.FROM_POINT, vertex_index=5, method="index")["index_reused"]
    np.testing.assert_array_equal(field(ms), expected)


def test_index_of_another_mesh_is_refused(tmp_path):
    file = tmp_path / "grid.vgi"
    mesh_set(*grid(7, 5, spacing=1.05)).apply_filter(filters.INDEX, index_file=str(file))
    ms = stretched(1.05)
    with fails_and_changes_nothing(ms, "another mesh"):
        ms.apply_filter(filters.LOAD_INDEX, index_file=str(file))
    assert not ms.apply_filter(filters.DESCRIBE_INDEX)["has_index"]


def test_index_is_freed_with_its_document():
    ms = stretched(1.08)
    ms.apply_filter(filters.INDEX)
    del ms
    gc.collect()
    assert not stretched(1.08).apply_filter(filters.DESCRIBE_INDEX)["has_index"]


def test_index_lives_as_long_as_one_document_uses_it():
    first, second = stretched(1.09), stretched(1.09)
    first.apply_filter(filters.INDEX)
    assert second.apply_filter(filters.FROM_POINT, vertex_index=0)["index_reused"]
    del first
    gc.collect()
    assert second.apply_filter(filters.DESCRIBE_INDEX)["has_index"]


def test_file_names_with_letters_of_other_languages(tmp_path):
    file = tmp_path / "größe мир.vgi"
    ms = stretched(1.10)
    ms.apply_filter(filters.INDEX)
    ms.apply_filter(filters.SAVE_INDEX, index_file=str(file))
    assert file.is_file()
    assert ms.apply_filter(filters.LOAD_INDEX, index_file=str(file))["vertices"] == 642
