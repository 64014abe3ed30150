"""The parameter method of the distance filters: what answers, what it returns and leaves behind."""

from __future__ import annotations

import numpy as np
import pymeshlab
import pytest
from support import (
    DESCRIBE_INDEX,
    EXACT_FROM_POINT,
    FROM_BORDER,
    FROM_EDGES,
    FROM_POINT,
    FROM_SELECTION,
    PATH,
    TWO_POINTS,
    exact_distances,
    fails_and_changes_nothing,
    field,
    grid,
    mesh_set,
    select_vertices,
    sphere,
)

INDEX, EXACT, QUICK = 1, 2, 3


def scaled_sphere(factor: float):
    vertices, faces = sphere(3)
    return mesh_set(vertices * factor, faces), exact_distances(vertices * factor, faces, [5])


def test_automatic_is_exact_without_an_index_and_takes_one_that_is_there():
    ms, exact = scaled_sphere(1.71)
    result = ms.apply_filter(FROM_POINT, vertex_index=5)
    assert result["answered_by"] == EXACT
    assert "index_reused" not in result
    np.testing.assert_allclose(field(ms), exact, rtol=1e-9)
    assert not ms.apply_filter(DESCRIBE_INDEX)["has_index"]
    built = ms.apply_filter(FROM_POINT, vertex_index=5, method="index")
    assert built["answered_by"] == INDEX
    assert not built["index_reused"]
    assert built["index_seconds"] > 0
    again = ms.apply_filter(FROM_POINT, vertex_index=5)
    assert again["answered_by"] == INDEX
    assert again["index_reused"]
    assert again["index_seconds"] == 0


def test_quick_is_close_to_exact_and_leaves_no_index():
    ms, exact = scaled_sphere(1.72)
    result = ms.apply_filter(FROM_POINT, vertex_index=5, method="quick")
    assert result["answered_by"] == QUICK
    others = exact > 0
    assert np.abs(field(ms)[others] / exact[others] - 1).mean() < 0.01
    assert not ms.apply_filter(DESCRIBE_INDEX)["has_index"]


def test_automatic_builds_an_index_when_exact_answers_took_as_long():
    vertices, faces = sphere(2)
    ms = mesh_set(vertices * 1.73, faces)
    for _ in range(5000):
        result = ms.apply_filter(FROM_POINT, vertex_index=5)
        if result["answered_by"] == INDEX:
            break
    assert result["answered_by"] == INDEX
    assert ms.apply_filter(DESCRIBE_INDEX)["has_index"]


@pytest.mark.parametrize(("method", "number"), [("index", INDEX), ("exact", EXACT), ("quick", QUICK)])
def test_all_distance_filters_have_it(method, number):
    ms = mesh_set(*grid(9, 7))
    select_vertices(ms, [3])
    for name, arguments in ((FROM_SELECTION, {}), (FROM_BORDER, {}), (FROM_EDGES, {"from_border": True})):
        assert ms.apply_filter(name, method=method, **arguments)["answered_by"] == number


def test_two_points_and_paths_are_exact_without_an_index():
    ms, exact = scaled_sphere(1.74)
    result = ms.apply_filter(TWO_POINTS, source=5, target=400)
    assert result["answered_by"] == EXACT
    assert result["distance"] == pytest.approx(exact[400], rel=1e-9)
    path = ms.apply_filter(PATH, source=5, target=400)
    assert path["answered_by"] == EXACT
    assert path["certified"]
    assert path["length"] == pytest.approx(exact[400], rel=1e-9)
    ms.set_current_mesh(0)
    assert not ms.apply_filter(DESCRIBE_INDEX)["has_index"]


@pytest.mark.parametrize("name", [TWO_POINTS, PATH])
def test_quick_has_no_pairs(name):
    ms = mesh_set(*grid(4, 4))
    with fails_and_changes_nothing(ms, "The quick method computes fields only"):
        ms.apply_filter(name, source=0, target=5, method="quick")


def test_another_method_is_refused():
    with pytest.raises(pymeshlab.InvalidEnumException, match="Enum 'fast' not found"):
        mesh_set(*grid(4, 4)).apply_filter(FROM_POINT, vertex_index=0, method="fast")
    with pytest.raises(pymeshlab.PyMeshLabException):
        mesh_set(*grid(4, 4)).apply_filter(EXACT_FROM_POINT, vertex_index=0, method="exact")
