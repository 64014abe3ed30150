"""An index is reused as long as the mesh is the same, and never after an edit."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from support import (
    FROM_POINT,
    INDEX,
    PATCHES,
    TWO_POINTS,
    arrays,
    assert_close_to_exact,
    exact_distances,
    field,
    grid,
    mesh_set,
    select_vertices,
    sphere,
)

_sizes = itertools.count(1)


def new_sphere(subdivisions: int = 3) -> tuple[np.ndarray, np.ndarray]:
    """A sphere of a size of its own: the plugin keeps indexes between tests."""
    vertices, faces = sphere(subdivisions)
    return vertices * (1 + next(_sizes) / 16), faces


def apply_and_compare(ms, source: int = 0, reused: bool = False) -> None:
    """The field is right for the mesh as it is now, and the index was reused or not as stated."""
    result = ms.apply_filter(FROM_POINT, vertex_index=source, method="index")
    assert result["index_reused"] == reused
    vertices, faces = arrays(ms)
    faces = np.unique(faces, axis=0)  # the independent solver takes no repeated face
    assert_close_to_exact(field(ms), exact_distances(vertices, faces, [source]), mean=0.0001, largest=0.005)


def test_unchanged_mesh_reuses_the_index():
    ms = mesh_set(*new_sphere())
    apply_and_compare(ms)
    apply_and_compare(ms, source=5, reused=True)
    assert ms.apply_filter(TWO_POINTS, source=1, target=2)["index_reused"]
    assert ms.apply_filter(PATCHES)["index_reused"]


def test_index_of_the_build_filter_is_used_and_replaced():
    ms = mesh_set(*new_sphere())
    ms.apply_filter(INDEX, n1=6)
    assert ms.apply_filter(PATCHES)["patches"] == 6
    ms.apply_filter(INDEX, n1=9)
    result = ms.apply_filter(PATCHES)
    assert result["patches"] == 9
    assert result["index_reused"]


def test_stretching_the_mesh():
    ms = mesh_set(*new_sphere())
    apply_and_compare(ms)
    ms.apply_filter("compute_matrix_from_scaling_or_normalization", axisx=2.5, uniformflag=False)
    apply_and_compare(ms)


def test_moving_one_vertex_by_the_smallest_step():
    vertices, faces = new_sphere()
    apply_and_compare(mesh_set(vertices, faces))
    vertices[77, 0] = np.nextafter(vertices[77, 0], np.inf)
    apply_and_compare(mesh_set(vertices, faces))


def test_subdividing_the_mesh():
    ms = mesh_set(*new_sphere(2))
    apply_and_compare(ms)
    ms.apply_filter("meshing_surface_subdivision_midpoint", iterations=1)
    assert ms.current_mesh().vertex_number() == 642
    apply_and_compare(ms)


def test_deleting_faces():
    ms = mesh_set(*grid(12, 12))
    apply_and_compare(ms)
    ms.apply_filter("compute_selection_by_condition_per_face", condselect="(x0 > 3) && (x0 < 5) && (y0 < 8)")
    ms.apply_filter("meshing_remove_selected_faces")
    ms.apply_filter("meshing_remove_unreferenced_vertices")
    apply_and_compare(ms)


def test_deleting_vertices():
    ms = mesh_set(*new_sphere())
    apply_and_compare(ms)
    select_vertices(ms, [200, 201])
    ms.apply_filter("meshing_remove_selected_vertices")
    apply_and_compare(ms)


def test_turning_a_left_out_face_into_a_proper_one():
    vertices, faces = grid(6, 6)
    hole = 20
    repeated = faces.copy()
    repeated[hole] = repeated[hole + 1]
    apply_and_compare(mesh_set(vertices, repeated), source=10)
    apply_and_compare(mesh_set(vertices, faces), source=10)


def test_undoing_an_edit_finds_the_old_index():
    vertices, faces = new_sphere()
    original = mesh_set(vertices, faces)  # while it lives, its index is kept
    apply_and_compare(original)
    apply_and_compare(mesh_set(vertices * [1, 1, 2], faces))
    apply_and_compare(mesh_set(vertices, faces), reused=True)


def test_indexes_of_four_meshes_are_kept():
    meshes = [mesh_set(*new_sphere(2)) for _ in range(5)]
    for ms in meshes:
        assert not ms.apply_filter(FROM_POINT, method="index")["index_reused"]
    for ms in meshes[1:]:
        assert ms.apply_filter(FROM_POINT, method="index")["index_reused"]
    assert not meshes[0].apply_filter(FROM_POINT, method="index")["index_reused"]


@pytest.mark.parametrize("layer", [1, 2])
def test_colours_and_selection_are_no_edit(layer):
    ms = mesh_set(*new_sphere(2))
    apply_and_compare(ms)
    ms.apply_filter("compute_normal_per_vertex")
    select_vertices(ms, [1])
    ms.apply_filter(PATCHES, layer=layer)
    apply_and_compare(ms, reused=True)
