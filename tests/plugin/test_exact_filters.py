"""The exact filters against formulas and against pygeodesic."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support import (
    EXACT_FROM_POINT,
    EXACT_FROM_SELECTION,
    FROM_POINT,
    arrays,
    exact_distances,
    field,
    grid,
    load,
    mesh_set,
    select_vertices,
    sphere,
)


def test_flat_rectangle_gives_euclidean_distances_in_double_precision():
    vertices, faces = grid(20, 11, spacing=0.1)
    ms = mesh_set(vertices, faces)
    ms.apply_filter(EXACT_FROM_POINT, vertex_index=47)
    expected = np.linalg.norm(vertices - vertices[47], axis=1)
    np.testing.assert_allclose(field(ms), expected, rtol=1e-12, atol=1e-13)
    assert np.any(field(ms) != field(ms).astype(np.float32))


@settings(max_examples=25, deadline=None)
@given(source=st.integers(0, 12 * 9 - 1), height=st.floats(-2, 2), seed=st.integers(0, 1000))
def test_random_terrain_agrees_with_pygeodesic(source, height, seed):
    vertices, faces = grid(11, 8)
    vertices[:, 2] = height * np.random.default_rng(seed).random(len(vertices))
    ms = mesh_set(vertices, faces)
    ms.apply_filter(EXACT_FROM_POINT, vertex_index=source)
    np.testing.assert_allclose(field(ms), exact_distances(vertices, faces, [source]), rtol=1e-9)


@pytest.mark.parametrize("name", ["bunny10k_textured.obj", "spot", "fandisk", "homer"])
def test_real_meshes_agree_with_pygeodesic(real_mesh, name):
    ms = mesh_set(np.zeros((1, 3)))
    load(ms, real_mesh(name))
    vertices, faces = arrays(ms)
    source = len(vertices) // 3
    result = ms.apply_filter(EXACT_FROM_POINT, vertex_index=source)
    exact = exact_distances(vertices, faces, [source])
    np.testing.assert_allclose(field(ms), exact, rtol=1e-9)
    assert result["max_distance"] == pytest.approx(exact.max(), rel=1e-9)
    assert result["start_vertex"] == source
    assert result["reached_vertices"] == len(vertices)


def test_selection_gives_distance_from_the_nearest_selected_vertex():
    vertices, faces = sphere(3)
    sources = [0, 100, 333]
    ms = mesh_set(vertices, faces)
    select_vertices(ms, sources)
    result = ms.apply_filter(EXACT_FROM_SELECTION)
    np.testing.assert_allclose(field(ms), exact_distances(vertices, faces, sources), rtol=1e-9)
    assert result["source_vertices"] == len(sources)


@pytest.mark.parametrize("name", [EXACT_FROM_POINT, FROM_POINT])
def test_distances_start_at_the_nearest_point_of_the_surface(name):
    vertices, faces = grid(12, 12)
    vertices = np.concatenate([vertices, [[4.1, 6.2, 0.0]]])  # in no face
    ms = mesh_set(vertices, faces)
    result = ms.apply_filter(name, start_point=np.array([4.125, 6.25, 0.5]))
    assert result["start_vertex"] == -1
    corners = vertices[faces[result["start_face"]]]
    assert (corners.min(axis=0)[:2] <= [4.125, 6.25]).all()
    assert (corners.max(axis=0)[:2] >= [4.125, 6.25]).all()
    assert result["snap_distance"] == pytest.approx(0.5, rel=1e-12)
    expected = np.linalg.norm(vertices[:-1, :2] - [4.125, 6.25], axis=1)
    np.testing.assert_allclose(field(ms)[:-1], expected, rtol=1e-12 if name == EXACT_FROM_POINT else 1e-2)
    assert field(ms)[-1] == -1


@pytest.mark.parametrize("name", [EXACT_FROM_POINT, FROM_POINT])
def test_a_start_point_at_a_vertex_is_that_vertex(name):
    vertices, faces = grid(12, 12, spacing=0.1)  # in single precision, as points are passed on, 0.7 is another number
    ms = mesh_set(vertices, faces)
    result = ms.apply_filter(name, start_point=vertices[7 * 13 + 3])
    assert result["start_vertex"] == 7 * 13 + 3
    assert result["start_face"] == -1
    assert field(ms)[7 * 13 + 3] == 0


def test_default_start_point_is_the_corner_of_the_bounding_box():
    vertices, faces = grid(4, 4)
    ms = mesh_set(vertices, faces)
    assert ms.apply_filter(EXACT_FROM_POINT)["start_vertex"] == 0


def test_colours_run_from_red_at_the_source_to_blue_at_the_farthest_vertex():
    vertices, faces = grid(10, 3)
    ms = mesh_set(vertices, faces)
    ms.apply_filter(EXACT_FROM_POINT, vertex_index=0)
    colors = ms.current_mesh().vertex_color_matrix()
    np.testing.assert_allclose(colors[0], [1, 0, 0, 1])
    np.testing.assert_allclose(colors[-1], [0, 0, 1, 1])
