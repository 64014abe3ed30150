"""Bad input: a sentence that says what is wrong and what to do, and an unchanged layer."""

from __future__ import annotations

import numpy as np
import pymeshlab
import pytest
from support import (
    ALL_FILTERS,
    EXACT_FROM_POINT,
    EXACT_FROM_SELECTION,
    FROM_BORDER,
    FROM_POINT,
    FROM_SELECTION,
    INDEX,
    PATCHES,
    TWO_POINTS,
    fails_and_changes_nothing,
    grid,
    length,
    mesh_set,
    sphere,
)

FIELDS = [FROM_POINT, FROM_SELECTION, FROM_BORDER, EXACT_FROM_POINT, EXACT_FROM_SELECTION]
FROM_A_POINT = [FROM_POINT, EXACT_FROM_POINT]


@pytest.mark.parametrize("name", ALL_FILTERS)
def test_layer_without_vertices(name):
    ms = mesh_set(*grid(3, 3))
    ms.apply_filter("set_selection_all")
    ms.apply_filter("meshing_remove_selected_vertices_and_faces")
    assert ms.current_mesh().vertex_number() == 0
    with pytest.raises(pymeshlab.PyMeshLabException, match=r"is empty: it has no vertices\. Load or create"):
        ms.apply_filter(name)


@pytest.mark.parametrize("name", ALL_FILTERS)
def test_no_layer(name):
    with pytest.raises(pymeshlab.PyMeshLabException):
        pymeshlab.MeshSet().apply_filter(name)


@pytest.mark.parametrize("name", ALL_FILTERS)
def test_point_cloud(name):
    ms = mesh_set(grid(3, 3)[0])
    with fails_and_changes_nothing(ms, "is a point cloud: it has vertices but no faces"):
        ms.apply_filter(name)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("name", ALL_FILTERS)
def test_coordinate_that_is_not_finite(name, value):
    vertices, faces = grid(3, 3)
    vertices[6, 1] = value
    ms = mesh_set(vertices, faces)
    with fails_and_changes_nothing(ms, "Vertex 6 has a coordinate that is NaN or infinite"):
        ms.apply_filter(name)


@pytest.mark.parametrize("name", [FROM_SELECTION, EXACT_FROM_SELECTION])
def test_empty_selection(name):
    ms = mesh_set(*grid(3, 3))
    with fails_and_changes_nothing(ms, "No vertex is selected. Select the vertices where distances shall start"):
        ms.apply_filter(name)


def test_surface_without_border():
    ms = mesh_set(*sphere(1))
    with fails_and_changes_nothing(ms, "The surface has no border"):
        ms.apply_filter(FROM_BORDER)


@pytest.mark.parametrize("number", [-2, 16, 2**31 - 1])
@pytest.mark.parametrize("name", FROM_A_POINT)
def test_start_vertex_out_of_range(name, number):
    """The parameter is named as the window shows it and as scripts call it."""
    ms = mesh_set(*grid(3, 3))
    with fails_and_changes_nothing(
        ms,
        f'"Start vertex" (vertex_index) is {number}, but the vertices of the current layer are numbered from 0 to 15',
    ):
        ms.apply_filter(name, vertex_index=number)


@pytest.mark.parametrize("number", [-2, 16])
@pytest.mark.parametrize("name", ["source", "target"])
def test_vertex_of_a_pair_out_of_range(name, number):
    ms = mesh_set(*grid(3, 3))
    with fails_and_changes_nothing(ms, f"({name}) is {number}, but the vertices"):
        ms.apply_filter(TWO_POINTS, **{name: number})


@pytest.mark.parametrize("name", FROM_A_POINT)
def test_start_point_that_is_not_finite(name):
    ms = mesh_set(*grid(3, 3))
    with fails_and_changes_nothing(ms, "(start_point) has a coordinate that is NaN or infinite"):
        ms.apply_filter(name, start_point=np.array([0, np.nan, 0]))


@pytest.mark.parametrize("value", [-0.5, np.nan, np.inf])
@pytest.mark.parametrize("name", FIELDS)
def test_bad_max_distance(name, value):
    ms = mesh_set(*grid(3, 3))
    ms.apply_filter("set_selection_all")
    with fails_and_changes_nothing(ms, f"(max_distance) is {value}"):
        ms.apply_filter(name, max_distance=length(value))


@pytest.mark.parametrize(
    ("parameter", "value", "message"),
    [
        ("n1", -1, "(n1) is -1. Give a positive number of patches"),
        ("n1", 1000, "first-layer patches, n1, is 1000; give one from 0"),
        ("n2", 1000, "second-layer patches, n2, is 1000; give one from 0"),
        ("n2", -7, "(n2) is -7. Give a positive number of patches"),
        ("delta", -0.5, "(delta) is -0.5. Give a number from 0 to below 1"),
        ("delta", 1.0, "(delta) is 1. Give a number from 0 to below 1"),
        ("delta", np.nan, "(delta) is nan. Give a number from 0 to below 1"),
        ("threads", -1, "(threads) is -1. Give a number from 1 to 1024, or 0 for one per core"),
        ("threads", 1025, "(threads) is 1025. Give a number from 1 to 1024"),
        ("threads", 2**31 - 1, "(threads) is 2147483647. Give a number from 1 to 1024"),
        ("seed", -1, "(seed) is -1. Give 0 or a positive number"),
    ],
)
def test_bad_index_parameter(parameter, value, message):
    ms = mesh_set(*grid(3, 3))
    with fails_and_changes_nothing(ms, message):
        ms.apply_filter(INDEX, **{parameter: value})


@pytest.mark.parametrize("layer", [0, 3, -1])
def test_bad_layer_of_patches(layer):
    ms = mesh_set(*grid(3, 3))
    with fails_and_changes_nothing(ms, f"(layer) is {layer}. The index has two layers"):
        ms.apply_filter(PATCHES, layer=layer)


def test_index_file_in_a_folder_that_does_not_exist(tmp_path):
    ms = mesh_set(*grid(3, 3))
    with fails_and_changes_nothing(ms, "cannot be written: there is no folder"):
        ms.apply_filter(INDEX, index_file=str(tmp_path / "nowhere" / "index.vgi"))


def test_index_file_that_is_a_folder(tmp_path):
    ms = mesh_set(*grid(3, 3))
    with fails_and_changes_nothing(ms, "is a folder; name a file in it"):
        ms.apply_filter(INDEX, index_file=str(tmp_path))


def test_index_file_on_a_full_or_forbidden_device():
    ms = mesh_set(*grid(3, 3))
    with fails_and_changes_nothing(ms, "/proc/vorogeo.vgi"):
        ms.apply_filter(INDEX, index_file="/proc/vorogeo.vgi")


def test_a_filter_that_failed_leaves_earlier_results_alone():
    ms = mesh_set(*grid(3, 3))
    ms.apply_filter(EXACT_FROM_POINT, vertex_index=3)
    with fails_and_changes_nothing(ms, "(vertex_index) is 99"):
        ms.apply_filter(EXACT_FROM_POINT, vertex_index=99)
