"""Vertices without a distance: quality -1, grey, and counted by their reason."""

from __future__ import annotations

import numpy as np
import pytest
from support import (
    EXACT_FROM_POINT,
    EXACT_FROM_SELECTION,
    FROM_BORDER,
    FROM_POINT,
    FROM_SELECTION,
    TWO_POINTS,
    field,
    grid,
    length,
    mesh_set,
    select_vertices,
    side_by_side,
    sphere,
)

GREY = np.array([160, 160, 160, 255]) / 255


@pytest.mark.parametrize("name", [FROM_POINT, EXACT_FROM_POINT])
def test_another_component_and_isolated_vertices_are_unreachable(name):
    vertices, faces = side_by_side(grid(5, 5), grid(3, 3))
    vertices = np.concatenate([vertices, [[50.0, 0, 0]]])
    ms = mesh_set(vertices, faces)
    result = ms.apply_filter(name, vertex_index=0)
    assert result["reached_vertices"] == 36
    assert result["unreachable_vertices"] == 17
    assert result["vertices_beyond_max_distance"] == 0
    assert result["max_distance"] == pytest.approx(50**0.5, rel=1e-3)
    np.testing.assert_array_equal(field(ms)[36:], -1)
    assert np.all(field(ms)[:36] >= 0)
    colors = ms.current_mesh().vertex_color_matrix()
    np.testing.assert_allclose(colors[36:], np.tile(GREY, (17, 1)))
    np.testing.assert_allclose(colors[35], [0, 0, 1, 1])  # the ramp ends at the farthest vertex that was reached


@pytest.mark.parametrize("name", [FROM_SELECTION, EXACT_FROM_SELECTION])
def test_a_source_in_each_component_reaches_everything(name):
    ms = mesh_set(*side_by_side(grid(5, 5), grid(3, 3)))
    select_vertices(ms, [0, 36])
    result = ms.apply_filter(name)
    assert result["unreachable_vertices"] == 0
    assert result["source_vertices"] == 2
    assert np.all(field(ms) >= 0)


@pytest.mark.parametrize("name", [FROM_POINT, EXACT_FROM_POINT])
def test_vertices_beyond_max_distance_are_counted_apart(name):
    vertices, faces = side_by_side(grid(40, 2), grid(3, 3))
    ms = mesh_set(vertices, faces)
    result = ms.apply_filter(name, vertex_index=0, max_distance=length(10.5))
    true = np.linalg.norm(vertices[:123], axis=1)
    np.testing.assert_array_equal(field(ms)[:123] >= 0, true <= 10.5)
    np.testing.assert_array_equal(field(ms)[:123][true > 10.5], -1)
    assert result["vertices_beyond_max_distance"] == np.count_nonzero(true > 10.5)
    assert result["reached_vertices"] == np.count_nonzero(true <= 10.5)
    assert result["unreachable_vertices"] == 16
    assert result["max_distance"] <= 10.5


def test_component_without_border_is_unreachable_from_the_border():
    ms = mesh_set(*side_by_side(grid(4, 4), sphere(1)))
    result = ms.apply_filter(FROM_BORDER)
    assert result["source_vertices"] == 16
    assert result["unreachable_vertices"] == 42
    assert field(ms)[12] == pytest.approx(2)  # the middle of the square


def test_distance_between_components_is_infinite():
    ms = mesh_set(*side_by_side(grid(4, 4), grid(4, 4)))
    assert ms.apply_filter(TWO_POINTS, source=0, target=30)["distance"] == float("inf")
