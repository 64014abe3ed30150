"""The filters for shortest paths and for sources that are points, lines or edges."""

from __future__ import annotations

import numpy as np
import pymeshlab
import pytest
from support import (
    FROM_EDGES,
    FROM_LAYER,
    PATH,
    exact_distances,
    field,
    grid,
    layer_count,
    length,
    mesh_set,
    side_by_side,
    sphere,
)


def test_path_between_points_of_the_plane():
    vertices, faces = grid(12, 9)
    ms = mesh_set(vertices, faces)
    source, target = np.array([0.25, 0.5, 2.0]), np.array([10.5, 7.75, 0.0])
    result = ms.apply_filter(PATH, source_point=source, target_point=target)
    straight = np.linalg.norm((source - target)[:2])
    assert result["length"] == pytest.approx(straight, rel=1e-6)
    assert result["source_snap_distance"] == pytest.approx(2.0, rel=1e-6)
    assert result["target_snap_distance"] == pytest.approx(0.0, abs=1e-6)
    assert layer_count(ms) == 2
    path = ms.current_mesh()
    assert path.edge_number() == result["points"] - 1
    along = path.vertex_scalar_array()
    assert along[0] == 0
    assert along[-1] == pytest.approx(straight, rel=1e-6)


@pytest.mark.parametrize("certify", [False, True])
def test_exact_path_on_a_sphere(certify):
    vertices, faces = sphere(3)
    ms = mesh_set(vertices, faces)
    exact = exact_distances(vertices, faces, [5])
    for target in (0, 100, 600):
        result = ms.apply_filter(PATH, source=5, target=target, method="index", exact=True, certify=certify)
        assert result["length"] == pytest.approx(exact[target], rel=1e-9)
        assert result["certified"] or not certify
        ms.set_current_mesh(0)


def test_no_path_is_no_layer():
    ms = mesh_set(*side_by_side(grid(4, 4), grid(4, 4)))
    result = ms.apply_filter(PATH, source=0, target=ms.current_mesh().vertex_number() - 1)
    assert result["length"] == np.inf
    assert result["points"] == 0
    assert layer_count(ms) == 1


@pytest.mark.parametrize("method", ["index", "exact"])
def test_distance_from_a_layer_of_points(method):
    vertices, faces = grid(20, 20, 0.5)
    ms = mesh_set(vertices, faces)
    points = np.array([[1.3, 2.1, 0.0], [7.7, 8.2, 0.4]])
    ms.add_mesh(pymeshlab.Mesh(points))
    ms.set_current_mesh(0)
    result = ms.apply_filter(FROM_LAYER, source_layer=1, method=method)
    distances = np.linalg.norm((vertices[:, None] - points)[..., :2], axis=2)
    np.testing.assert_allclose(field(ms), distances.min(axis=1), rtol=1e-9 if method == "exact" else 5e-3)
    assert result["snap_distance"] == pytest.approx(0.4)
    assert result["source_points"] == 2
    label = ms.current_mesh().vertex_custom_scalar_attribute_array("nearest_source")
    clear = np.abs(distances[:, 0] - distances[:, 1]) > 0.1
    np.testing.assert_array_equal(label[clear], distances.argmin(axis=1)[clear])


def test_distance_from_a_line():
    vertices, faces = grid(20, 20, 0.5)
    ms = mesh_set(vertices, faces)
    a, b = np.array([2.2, 3.1, 0.0]), np.array([7.4, 3.9, 0.0])
    ms.add_mesh(pymeshlab.Mesh(vertex_matrix=np.array([a, b]), edge_matrix=np.array([[0, 1]])))
    ms.set_current_mesh(0)
    spacing = 0.05
    ms.apply_filter(FROM_LAYER, source_layer=1, method="exact", spacing=length(spacing))
    t = np.clip((vertices - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
    distances = np.linalg.norm(vertices - (a + t[:, None] * (b - a)), axis=1)
    assert (field(ms) >= distances - 1e-6).all()
    assert (field(ms) <= distances + spacing / 2 + 1e-6).all()


@pytest.mark.parametrize("method", ["index", "exact"])
def test_distance_from_the_border_as_a_curve(method):
    vertices, faces = grid(12, 8)
    ms = mesh_set(vertices, faces)
    result = ms.apply_filter(FROM_EDGES, from_border=True, method=method)
    x, y = vertices[:, 0], vertices[:, 1]
    np.testing.assert_allclose(field(ms), np.min([x, 12 - x, y, 8 - y], axis=0), atol=1e-9)
    assert result["source_edges"] == 40
