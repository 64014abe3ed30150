"""What PyMeshLab itself never does: cancelling, no progress function, deleted elements in the layer."""

from __future__ import annotations

import filters
import numpy as np
import pymeshlab
import pytest
from support import (
    arrays,
    assert_close_to_exact,
    exact_distances,
    fails_and_changes_nothing,
    field,
    grid,
    layer_count,
    mesh_for,
    mesh_set,
    select_vertices,
    sphere,
)

# What these filters need beyond a surface with a selection.
NEEDED = {
    filters.FROM_LAYER: "source_layer=1",
    filters.NEAREST: "source_layer=1",
    filters.FROM_EDGES: "from_border=true",
    filters.SETS: "source_layer=1",
    filters.TIGHT: "curve_layer=1",
    filters.CUT_CURVE: "curve_layer=1",
    filters.SIGNED: "curve_layer=1",
    filters.BAND: "curve_layer=1",
    filters.PROFILE: "curve_layer=1",
    filters.REGION: "curve_layer=1",
    filters.POLYGON: "point_layer=1",
}


def surface_for(name: str, size: float):
    """A mesh of its own for every test, so that no test finds the index of another, and a layer of points."""
    vertices, faces = mesh_for(name)
    vertices = vertices * size
    ms = mesh_set(vertices, faces)
    select_vertices(ms, [0, 50])
    ms.add_mesh(pymeshlab.Mesh(vertices[[3, 31, 143]]), "points", set_as_current=False)
    return ms


def rectangle(size: float):
    """The same for all filters but girths and loops."""
    return surface_for("", size)


@pytest.mark.parametrize("name", filters.ALL_FILTERS)
def test_cancelled_filter_changes_nothing(name):
    ms = surface_for(name, 1.0 + filters.ALL_FILTERS.index(name) / 64)
    for _ in range(2):
        with fails_and_changes_nothing(ms, "Cancelled: nothing was changed."):
            ms.apply_filter("probe_apply", filter=name, numbers=NEEDED.get(name, ""), calls_allowed=0)
        assert layer_count(ms) == 2
        ms.apply_filter(filters.INDEX)  # for the second time


@pytest.mark.parametrize("name", filters.ALL_FILTERS)
def test_filter_works_without_a_progress_function(name):
    ms = surface_for(name, 2.0)
    numbers = NEEDED.get(name, "")
    result = ms.apply_filter("probe_apply", filter=name, numbers=numbers, without_callback=True)
    assert result["probe_calls"] == 0


@pytest.mark.parametrize("name", filters.ALL_FILTERS)
def test_progress_only_grows(name):
    ms = surface_for(name, 3.0 + filters.ALL_FILTERS.index(name) / 64)
    result = ms.apply_filter("probe_apply", filter=name, numbers=NEEDED.get(name, ""))
    assert result["probe_calls"] > 0
    assert not result["probe_percentage_fell"]
    assert 0 <= result["probe_last_percentage"] <= 100


@pytest.mark.parametrize("name", [filters.FROM_POINT, filters.EXACT_FROM_POINT])
def test_deleted_elements_are_skipped(name):
    ms = rectangle(4.0)
    start = 100  # of the 169 vertices before the deletion
    deleted = [0, 30, 31, 44]
    result = ms.apply_filter(
        "probe_apply",
        filter=name,
        numbers=f"vertex_index={start}",
        deleted_vertices=";".join(map(str, deleted)),
        deleted_faces="200;230",
    )
    assert ms.current_mesh().vertex_number() == 165
    assert result["start_vertex"] == start
    exact = exact_distances(*arrays(ms), [start - len(deleted)])
    assert_close_to_exact(field(ms), exact, mean=0.0001, largest=0.005)


@pytest.mark.parametrize("name", [filters.FROM_SELECTION, filters.EXACT_FROM_SELECTION])
def test_deleted_vertices_are_no_sources(name):
    ms = rectangle(5.0)
    result = ms.apply_filter("probe_apply", filter=name, deleted_vertices="0")
    assert result["source_vertices"] == 1
    assert field(ms)[49] == 0


def test_deleted_elements_make_a_border():
    ms = rectangle(1.0)
    result = ms.apply_filter("probe_apply", filter=filters.FROM_BORDER, deleted_vertices="84")  # the middle
    assert result["source_vertices"] == 4 * 12 + 6


@pytest.mark.parametrize("name", [filters.INDEX, filters.PATCHES])
def test_deleted_faces_have_no_patch(name):
    result = rectangle(6.0).apply_filter("probe_apply", filter=name, deleted_faces="3;4;5")
    assert result["vertices" if name == filters.INDEX else "patches"] > 0


def test_parts_leave_deleted_elements_out():
    ms = rectangle(6.5)
    ms.compute_scalar_by_function_per_vertex(q="x + 2 * y")
    deleted = {"deleted_vertices": "0;30", "deleted_faces": "200;230"}
    assert ms.apply_filter("probe_apply", filter=filters.CUT, numbers="line_number=3", **deleted)["parts"] == 4
    vertices = np.vstack([ms.mesh(i).vertex_matrix() for i in range(2, 6)])
    quality = np.concatenate([ms.mesh(i).vertex_scalar_array() for i in range(2, 6)])
    np.testing.assert_allclose(quality, vertices @ [1, 2, 0], atol=1e-9)


@pytest.mark.parametrize(
    ("name", "parameter"),
    [(filters.FROM_POINT, "vertex_index"), (filters.EXACT_FROM_POINT, "vertex_index"), (filters.TWO_POINTS, "target")],
)
def test_deleted_vertex_is_refused_as_start(name, parameter):
    ms = rectangle(7.0)
    with pytest.raises(Exception, match=rf"\({parameter}\) is 30, but this vertex was deleted"):
        ms.apply_filter("probe_apply", filter=name, numbers=f"{parameter}=30", deleted_vertices="30")


def test_all_faces_deleted_is_a_point_cloud():
    ms = rectangle(8.0)
    faces = ";".join(map(str, range(ms.current_mesh().face_number())))
    with pytest.raises(Exception, match="is a point cloud"):
        ms.apply_filter("probe_apply", filter=filters.FROM_POINT, deleted_faces=faces)


def test_not_finite_vertex_is_named_by_its_number_in_the_host():
    vertices, faces = grid(4, 4)
    vertices[9] = np.nan
    with pytest.raises(Exception, match="Vertex 9 has a coordinate"):
        mesh_set(vertices, faces).apply_filter("probe_apply", filter=filters.FROM_POINT, deleted_vertices="1;2")


def test_places_that_the_core_names_have_the_numbers_of_the_host():
    """Two squares that have vertex 2 in common, and apart from them a triangle; before these, deleted elements."""
    vertices = [[9, 9, 9], [8, 8, 8], [0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [-1, 0, 0], [-1, -1, 0], [0, -1, 0]]
    vertices += [[5, 0, 0], [6, 0, 0], [5, 1, 0]]
    faces = [[0, 1, 2], [2, 3, 4], [2, 4, 5], [2, 6, 7], [2, 7, 8], [9, 10, 11]]
    for name, numbers, selected, message in [
        (filters.DIRECTIONS, "vertex_index=2", [3], "There are no directions at vertex 2: its faces"),
        (filters.MEAN, "", [3, 10], "from point 0 \\(vertex 3\\) to point 1 \\(vertex 10\\)"),
    ]:
        ms = mesh_set(np.array(vertices, dtype=float), np.array(faces, dtype=np.int32))
        select_vertices(ms, selected)
        with pytest.raises(Exception, match=message):
            ms.apply_filter("probe_apply", filter=name, numbers=numbers, deleted_vertices="0;1")


@pytest.mark.parametrize("name", [filters.INDEX, filters.FROM_POINT, filters.EXACT_FROM_POINT, filters.COMPARISON])
def test_window_is_never_without_progress_for_long(name):
    """What reports nothing itself, such as MeshLab's own methods, leaves the thread that reports to the host free."""
    vertices, faces = sphere(6)
    ms = mesh_set(vertices * (1 + filters.ALL_FILTERS.index(name) / 64), faces)
    numbers = (
        "method=4;reference=2" if name == filters.COMPARISON else "vertex_index=3" if name != filters.INDEX else ""
    )
    result = ms.apply_filter("probe_apply", filter=name, numbers=numbers)
    assert result["probe_longest_silence"] < 1.0


def test_error_beside_the_window_arrives_there(tmp_path):
    file = tmp_path / "no.vgi"
    file.write_bytes(b"VGI" * 100)
    with fails_and_changes_nothing(ms := mesh_set(*grid(9, 8)), "no.vgi"):
        ms.apply_filter(filters.LOAD_INDEX, index_file=str(file))
