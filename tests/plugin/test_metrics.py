"""The metric of the filters: against numpy and formulas, the cache and the kept cost, refusals."""

from __future__ import annotations

import filters
import numpy as np
import pytest
import vorogeo
from support import exact_distances, fails_and_changes_nothing, field, grid, mesh_set, sphere

COST = "1 + 0.5 * x"


def painted(cost=COST):
    """A grid whose quality is a cost."""
    vertices, faces = grid(16, 12)
    vertices[:, 2] = len(cost)  # a MeshSet that still exists may have an index of the same mesh
    ms = mesh_set(vertices, faces)
    ms.compute_scalar_by_function_per_vertex(q=cost)
    return ms, vertices, faces, vorogeo.VertexCost(1 + 0.5 * vertices[:, 0])


def test_quality_is_the_cost_and_is_kept():
    ms, vertices, faces, cost = painted()
    ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=5, metric="Vertex quality as cost")
    np.testing.assert_allclose(field(ms), vorogeo.exact_distance_field(vertices, faces, 5, metric=cost), rtol=1e-12)
    kept = ms.current_mesh().vertex_custom_scalar_attribute_array("metric_cost")
    np.testing.assert_array_equal(kept, cost.cost)
    # Applied again, from another point: the quality is the result, so the kept cost is the metric.
    ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=100, metric="Vertex quality as cost")
    np.testing.assert_allclose(field(ms), vorogeo.exact_distance_field(vertices, faces, 100, metric=cost), rtol=1e-12)
    # Painted anew: a new metric.
    ms.compute_scalar_by_function_per_vertex(q="3")
    ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=5, metric="Vertex quality as cost")
    np.testing.assert_allclose(field(ms), 3 * exact_distances(vertices, faces, [5]), rtol=1e-9)


@pytest.mark.parametrize(
    "cost", [COST, "1 + 10000 * exp(-((x - 6)^2 + (y - 6)^2) / 3)"], ids=["smooth", "splits faces"]
)
def test_an_index_belongs_to_its_metric(tmp_path, cost):
    ms, vertices, _, _ = painted(cost)
    chosen = {"metric": "Vertex quality as cost"}
    first = ms.apply_filter(filters.TWO_POINTS, source=0, target=150, method="index", **chosen)
    assert first["index_reused"] == 0
    assert ms.apply_filter(filters.TWO_POINTS, source=0, target=150, method="index", **chosen)["index_reused"] == 1
    plain = ms.apply_filter(filters.TWO_POINTS, source=0, target=150, method="index")
    assert plain["index_reused"] == 0
    assert plain["distance"] == pytest.approx(np.linalg.norm(vertices[150] - vertices[0]), rel=1e-3)
    assert ms.apply_filter(filters.DESCRIBE_INDEX, **chosen)["has_index"]
    file = tmp_path / "cost.vgi"
    ms.apply_filter(filters.SAVE_INDEX, index_file=str(file), **chosen)
    ms.compute_scalar_by_function_per_vertex(q="2 * q")
    assert not ms.apply_filter(filters.DESCRIBE_INDEX, **chosen)["has_index"]
    with fails_and_changes_nothing(ms, "built for another mesh"):
        ms.apply_filter(filters.LOAD_INDEX, index_file=str(file), **chosen)
    costly = ms.apply_filter(filters.TWO_POINTS, source=0, target=150, method="index", **chosen)
    assert costly["index_reused"] == 0
    assert costly["distance"] == pytest.approx(2 * first["distance"], rel=1e-3)
    ms.compute_scalar_by_function_per_vertex(q="0.5 * q")
    assert ms.apply_filter(filters.TWO_POINTS, source=0, target=150, method="index", **chosen)["index_reused"] == 1
    assert ms.apply_filter(filters.LOAD_INDEX, index_file=str(file), **chosen)["vertices"] == len(vertices)


def test_vertices_that_splits_add_are_points_in_faces():
    vertices, faces = np.array([[0, 0, 0], [2, 0, 0], [1, 0.5, 0], [1, -1, 0.0]]), np.array([[0, 1, 2], [1, 0, 3]])
    ms = mesh_set(vertices, faces)
    ms.compute_scalar_by_function_per_vertex(q="vi == 2 ? 4 : 5")  # in the first face 5 - 2 y
    chosen = {"metric": "Vertex quality as cost"}
    a = 2.5  # shortest paths are catenaries: 2.5 - y = a cosh((x - 0.5) / a)
    for _ in range(50):
        a = 2.5 / np.cosh(0.5 / a)
    exact = a * a * (1 / a + np.sinh(1 / a))
    ends = {"source": -1, "source_point": [1, 0, 0], "target": 0}
    assert ms.apply_filter(filters.TWO_POINTS, **ends, **chosen)["distance"] == pytest.approx(exact, rel=1e-3)
    start = ms.apply_filter(filters.EXACT_FROM_POINT, start_point=[1, 0, 0], **chosen)
    assert start["start_vertex"] == -1
    assert start["start_face"] in (0, 1)
    np.testing.assert_allclose(field(ms)[:3], [exact, exact, 2.25], rtol=1e-3)


def test_slope_penalty_and_curvature():
    vertices, faces = grid(10, 10)
    vertices[:, 2] = 0.75 * vertices[:, 0]
    ms = mesh_set(vertices, faces)
    ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=0, metric="Slope penalty", slope_penalty=5)
    np.testing.assert_allclose(field(ms), 4 * exact_distances(vertices, faces, [0]), rtol=1e-6)
    chosen = {"metric": "Slope penalty", "slope_penalty": 5, "vertex_index": 0}
    assert ms.apply_filter(filters.EXACT_FROM_POINT, steepest_grade=0.76, **chosen)["unreachable_vertices"] == 0
    np.testing.assert_allclose(field(ms), 4 * exact_distances(vertices, faces, [0]), rtol=1e-6)
    barred = ms.apply_filter(filters.EXACT_FROM_POINT, steepest_grade=0.74, **chosen)
    assert barred["unreachable_vertices"] == len(vertices) - 1
    angle = vertices[:, 0] * np.pi / 10
    tube = np.column_stack([3 * np.cos(angle), 3 * np.sin(angle), vertices[:, 1]])  # half a cylinder
    ms = mesh_set(tube, faces)
    ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=55, metric="Along curvature", curvature_weight=3)
    along = field(ms)
    assert along[55 + 22] == pytest.approx(2, rel=0.02)  # two rows up
    assert along[55 + 2] == pytest.approx(2 * 2 * 6 * np.sin(np.pi / 20), rel=0.05)  # two columns round: twice
    ms = mesh_set(*sphere(2))
    ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=0, metric="Along curvature", curvature_weight=3)
    assert field(ms).max() == pytest.approx(np.pi, rel=0.2)


def test_path_and_regions_in_the_metric():
    ms, vertices, faces, cost = painted()
    index = vorogeo.GeodesicIndex(vertices, faces, metric=cost)
    chosen = {"metric": "Vertex quality as cost"}
    found = ms.apply_filter(filters.PATH, source=0, target=220, exact=True, **chosen)
    assert found["length"] == pytest.approx(index.exact_path(0, 220).length, rel=1e-9)
    assert field(ms).max() == pytest.approx(found["length"], rel=1e-9)  # along the path
    ms.set_current_mesh(0)
    regions = ms.apply_filter(filters.VORONOI, surface_points="0; 220", borders=False, exact=True, **chosen)
    np.testing.assert_allclose(regions["areas"], index.voronoi([0, 220], method="exact").area, rtol=1e-9)
    kept = ms.current_mesh().vertex_custom_scalar_attribute_array("metric_cost")
    np.testing.assert_array_equal(kept, cost.cost)


def test_quality_of_faces_is_a_cost_that_jumps():
    vertices, faces = grid(16, 12)
    ms = mesh_set(vertices, faces)
    ms.compute_scalar_by_function_per_face(q="1 + (x0 + x1 + x2) / 30")
    cost = vorogeo.FaceCost(ms.current_mesh().face_scalar_array())
    chosen = {"metric": "Face quality as cost"}
    exact = vorogeo.exact_distance_field(vertices, faces, 5, metric=cost)
    ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=5, **chosen)
    np.testing.assert_allclose(field(ms), exact, rtol=1e-12)
    pair = ms.apply_filter(filters.TWO_POINTS, source=5, target=150, method="index", **chosen)
    assert pair["distance"] == pytest.approx(exact[150], rel=5e-3)
    assert ms.apply_filter(filters.TWO_POINTS, source=0, target=150, method="index", **chosen)["index_reused"] == 1
    assert ms.apply_filter(filters.PATH, source=5, target=150, **chosen)["length"] == pytest.approx(
        exact[150], rel=5e-3
    )
    ms.set_current_mesh(0)
    # Painted anew: another index, although edges are as long in the cheaper of their faces.
    middle = vertices[faces].mean(axis=1)[:, 0]
    dear = int(np.argmin(abs(middle - middle.max() / 2)))
    ms.compute_scalar_by_function_per_face(q=f"1 + 50 * (fi == {dear})")
    first = ms.apply_filter(filters.TWO_POINTS, source=5, target=150, method="index", **chosen)
    ms.compute_scalar_by_function_per_face(q=f"1 + 90 * (fi == {dear})")
    assert first["index_reused"] == 0
    assert ms.apply_filter(filters.TWO_POINTS, source=5, target=150, method="index", **chosen)["index_reused"] == 0
    ms.compute_scalar_by_function_per_face(q=f"1 + 50 * (fi == {dear})")
    assert ms.apply_filter(filters.TWO_POINTS, source=5, target=150, method="index", **chosen)["index_reused"] == 1
    ms.compute_scalar_by_function_per_face(q="x0 - 1")
    with fails_and_changes_nothing(ms, "but face 0 has quality"):
        ms.apply_filter(filters.FROM_POINT, vertex_index=5, **chosen)
