"""The parameters gap and bridge_folds, on two plates beside each other."""

from __future__ import annotations

import filters
import numpy as np
import pytest
from support import field, grid, length, mesh_set

GAP = 1e-3


@pytest.fixture
def plates():
    """Two rectangles of 5 x 5 cells with a gap between them."""
    vertices, faces = grid(5, 5)
    moved = vertices + np.array([vertices[:, 0].max() + GAP, 0, 0])
    return np.vstack([vertices, moved]), np.vstack([faces, faces + len(vertices)])


@pytest.mark.parametrize("name", [filters.EXACT_FROM_POINT, filters.FROM_POINT])
def test_fields_cross_the_gap(name, plates):
    vertices, faces = plates
    ms = mesh_set(vertices, faces)
    result = ms.apply_filter(name, vertex_index=0, gap=length(2 * GAP))
    assert result["unreachable_vertices"] == 0
    straight = np.linalg.norm(vertices - vertices[0], axis=1)
    np.testing.assert_allclose(field(ms), straight, rtol=1e-2, atol=1e-6)
    assert ms.current_mesh().face_number() == len(faces)
    assert ms.apply_filter(name, vertex_index=0)["unreachable_vertices"] == len(vertices) // 2


def test_the_index_of_another_gap_is_not_used(plates):
    vertices, faces = plates
    ms = mesh_set(vertices, faces)
    ms.apply_filter(filters.INDEX, gap=length(2 * GAP))
    far = len(vertices) - 1
    without = ms.apply_filter(filters.TWO_POINTS, source=0, target=far, method="index")
    assert without["distance"] == np.inf
    assert without["index_reused"] is False
    within = ms.apply_filter(filters.TWO_POINTS, source=0, target=far, gap=length(2 * GAP))
    assert within["distance"] == pytest.approx(np.linalg.norm(vertices[far] - vertices[0]), rel=1e-3)
    assert within["index_reused"] is True


def test_steps_of_a_path_over_the_gap_are_selected(plates):
    vertices, faces = plates
    ms = mesh_set(vertices, faces)
    result = ms.apply_filter(filters.PATH, source=0, target=len(vertices) - 1, exact=True, gap=length(2 * GAP))
    assert result["steps_over_gaps"] > 0
    assert GAP <= result["gap_length"] <= 2 * GAP
    assert ms.current_mesh().selected_vertex_number() == result["steps_over_gaps"]
