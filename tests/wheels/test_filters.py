"""The filters in PyMeshLab, asked with nothing but numpy: for systems where what other tests need does not exist."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import vorogeo

pymeshlab = pytest.importorskip("pymeshlab")

COLUMNS, ROWS = 24, 17
FROM_POINT = "compute_scalar_by_vorogeo_distance_from_given_point_per_vertex"
X, Y = (axis.ravel().astype(float) for axis in np.meshgrid(np.arange(COLUMNS), np.arange(ROWS)))


@pytest.fixture
def mesh_set() -> Any:
    """A flat rectangle of unit squares: every distance is Euclidean."""
    corner = (np.arange(ROWS - 1)[:, None] * COLUMNS + np.arange(COLUMNS - 1)).ravel()
    lower = np.column_stack([corner, corner + 1, corner + COLUMNS + 1])
    upper = np.column_stack([corner, corner + COLUMNS + 1, corner + COLUMNS])
    made = pymeshlab.MeshSet()
    made.add_mesh(pymeshlab.Mesh(np.column_stack([X, Y, 0 * X]), np.vstack([lower, upper])))
    return made


def from_vertex(number: int) -> Any:
    """The distances of all vertices from one."""
    return np.hypot(X - X[number], Y - Y[number])


def test_all_filters_are_there():
    filters = vorogeo.load_plugin()
    assert len(filters) == len(set(filters)) >= 40
    assert set(filters) <= set(pymeshlab.filter_list())
    assert all(hasattr(pymeshlab.MeshSet, name) for name in filters)


def test_fields_exact_and_from_an_index(mesh_set):
    start = int(np.random.default_rng().integers(len(X)))
    mesh_set.apply_filter(FROM_POINT, vertex_index=start)
    np.testing.assert_allclose(mesh_set.current_mesh().vertex_scalar_array(), from_vertex(start), atol=1e-9)
    mesh_set.compute_geodesic_index_by_vorogeo(n1=3, n2=3)
    mesh_set.apply_filter(FROM_POINT, vertex_index=start)
    np.testing.assert_allclose(mesh_set.current_mesh().vertex_scalar_array(), from_vertex(start), rtol=0.02)


def test_points_and_paths(mesh_set):
    a, b = np.random.default_rng().choice(len(X), 2, replace=False).tolist()
    found = mesh_set.get_vorogeo_distance_between_points(source=a, target=b)
    assert found["distance"] == pytest.approx(from_vertex(a)[b])
    path = mesh_set.generate_polyline_by_vorogeo_geodesic_path(source=a, target=b)
    assert path["length"] == pytest.approx(from_vertex(a)[b])
    line = mesh_set.current_mesh().vertex_matrix()
    np.testing.assert_allclose(line[[0, -1], :2], [[X[a], Y[a]], [X[b], Y[b]]], atol=1e-9)


def test_a_refusal_crosses_to_python_and_changes_nothing(mesh_set):
    with pytest.raises(pymeshlab.PyMeshLabException, match=rf"is {len(X)}, .* from 0 to {len(X) - 1}"):
        mesh_set.apply_filter(FROM_POINT, vertex_index=len(X))
    assert not mesh_set.current_mesh().has_vertex_scalar() or not mesh_set.current_mesh().vertex_scalar_array().any()


@pytest.mark.parametrize("method", ["Fast marching (MeshLab)", "Heat method (MeshLab)"])
def test_methods_of_the_host_are_compared_with_the_exact_one(mesh_set, method):
    found = mesh_set.compute_scalar_by_geodesic_method_comparison_per_vertex(vertex_index=0, method=method)
    assert 0 < found["mean_error"] < 0.1
