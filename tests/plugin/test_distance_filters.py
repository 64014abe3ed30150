"""The filters that write distance fields, or tell one distance: starts, methods, what is reached and returned."""

from __future__ import annotations

import filters
import numpy as np
import pymeshlab
import pytest
from support import (
    arrays,
    assert_close_to_exact,
    exact_distances,
    field,
    grid,
    length,
    load,
    mesh_set,
    select_vertices,
    side_by_side,
    sphere,
)

INDEX, EXACT, QUICK = 1, 2, 3
GREY = np.array([160, 160, 160, 255]) / 255


def scaled_sphere(factor: float):
    """A mesh of its own, so that no test finds the index of another, and distances from vertex 5."""
    vertices, faces = sphere(3)
    return mesh_set(vertices * factor, faces), exact_distances(vertices * factor, faces, [5])


def method_of(name: str) -> dict[str, str]:
    """The exact filters have no choice."""
    return {} if name in (filters.EXACT_FROM_POINT, filters.EXACT_FROM_SELECTION) else {"method": "index"}


# ---- Values


@pytest.mark.parametrize("name", ["bunny10k_textured.obj", "cow.obj", "office_chair"])
def test_real_meshes_exact_and_from_the_index(real_mesh, name):
    """With components, borders and edges of several faces, which pygeodesic takes only in part."""
    ms = mesh_set(np.zeros((1, 3)))
    load(ms, real_mesh(name))
    vertices, faces = arrays(ms)
    source = len(vertices) // 3
    result = ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=source)
    exact = field(ms).copy()
    assert result["start_vertex"] == source
    assert result["max_distance"] == exact.max()
    assert result["reached_vertices"] + result["unreachable_vertices"] == len(vertices)
    if name == "bunny10k_textured.obj":
        np.testing.assert_allclose(exact, exact_distances(vertices, faces, [source]), rtol=1e-9)
    found = ms.apply_filter(filters.FROM_POINT, vertex_index=source, method="index")
    assert found["unreachable_vertices"] == result["unreachable_vertices"] == np.count_nonzero(exact == -1)
    reached = exact > 0
    errors = np.abs(field(ms)[reached] / exact[reached] - 1)
    assert errors.mean() < 5e-4
    assert errors.max() < 0.025


@pytest.mark.parametrize("name", filters.FROM_A_SELECTION)
def test_selection_gives_distance_from_the_nearest_selected_vertex(name):
    vertices, faces = sphere(3)
    sources = [0, 100, 333]
    ms = mesh_set(vertices, faces)
    select_vertices(ms, sources)
    result = ms.apply_filter(name, **method_of(name))
    exact = exact_distances(vertices, faces, sources)
    np.testing.assert_allclose(field(ms), exact, rtol=1e-9 if name == filters.EXACT_FROM_SELECTION else 0.005)
    assert np.any(field(ms) != field(ms).astype(np.float32))  # quality has the precision of the host
    assert result["source_vertices"] == len(sources)


def test_border_of_a_rectangle():
    vertices, faces = grid(30, 12)
    ms = mesh_set(vertices, faces)
    result = ms.apply_filter(filters.FROM_BORDER, method="index")
    x, y = vertices[:, 0], vertices[:, 1]
    expected = np.minimum(np.minimum(x, 30 - x), np.minimum(y, 12 - y))
    assert_close_to_exact(field(ms), expected, mean=0.0001, largest=0.005)
    assert result["source_vertices"] == 2 * (30 + 12)
    assert result["max_distance"] == pytest.approx(6, rel=0.001)


def test_colours_run_from_red_at_the_source_to_blue_at_the_farthest_vertex():
    ms = mesh_set(*grid(10, 3))
    ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=0)
    colors = ms.current_mesh().vertex_color_matrix()
    np.testing.assert_allclose(colors[0], [1, 0, 0, 1])
    np.testing.assert_allclose(colors[-1], [0, 0, 1, 1])


# ---- Where distances start


@pytest.mark.parametrize("name", filters.FROM_A_POINT)
def test_distances_start_at_the_nearest_point_of_the_surface(name):
    vertices, faces = grid(12, 12)
    vertices = np.concatenate([vertices, [[4.1, 6.2, 0.0]]])  # in no face
    ms = mesh_set(vertices, faces)
    result = ms.apply_filter(name, start_point=np.array([4.125, 6.25, 0.5]))
    assert (result["start_vertex"], result["source_vertices"]) == (-1, 0)
    corners = vertices[faces[result["start_face"]]]
    assert (corners.min(axis=0)[:2] <= [4.125, 6.25]).all()
    assert (corners.max(axis=0)[:2] >= [4.125, 6.25]).all()
    assert result["snap_distance"] == pytest.approx(0.5, rel=1e-12)
    expected = np.linalg.norm(vertices[:-1, :2] - [4.125, 6.25], axis=1)
    np.testing.assert_allclose(field(ms)[:-1], expected, rtol=1e-12 if name == filters.EXACT_FROM_POINT else 1e-2)
    assert field(ms)[-1] == -1


@pytest.mark.parametrize("name", filters.FROM_A_POINT)
def test_a_start_point_at_a_vertex_is_that_vertex(name):
    vertices, faces = grid(12, 12, spacing=0.1)  # in single precision, as points are passed on, 0.7 is another number
    ms = mesh_set(vertices, faces)
    result = ms.apply_filter(name, start_point=vertices[7 * 13 + 3])
    assert (result["start_vertex"], result["start_face"], result["source_vertices"]) == (7 * 13 + 3, -1, 1)
    assert field(ms)[7 * 13 + 3] == 0
    assert ms.apply_filter(name)["start_vertex"] == 0  # by default the corner of the bounding box


# ---- Vertices without a distance: quality -1, grey, and counted by their reason


@pytest.mark.parametrize("name", filters.FROM_A_POINT)
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
    assert ms.apply_filter(filters.TWO_POINTS, source=0, target=40)["distance"] == float("inf")


@pytest.mark.parametrize("name", filters.FROM_A_POINT)
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
    result = ms.apply_filter(filters.FROM_BORDER)
    assert (result["source_vertices"], result["unreachable_vertices"]) == (16, 42)
    assert field(ms)[12] == pytest.approx(2)  # the middle of the square


# ---- The parameter method


def test_automatic_is_exact_without_an_index_and_takes_one_that_is_there():
    ms, exact = scaled_sphere(1.71)
    result = ms.apply_filter(filters.FROM_POINT, vertex_index=5)
    assert result["answered_by"] == EXACT
    assert "index_reused" not in result
    np.testing.assert_allclose(field(ms), exact, rtol=1e-9)
    assert ms.apply_filter(filters.TWO_POINTS, source=5, target=400)["answered_by"] == EXACT
    path = ms.apply_filter(filters.PATH, source=5, target=400)
    assert path["answered_by"] == EXACT
    assert path["certified"]
    ms.set_current_mesh(0)
    assert not ms.apply_filter(filters.DESCRIBE_INDEX)["has_index"]
    built = ms.apply_filter(filters.FROM_POINT, vertex_index=5, method="index")
    assert (built["answered_by"], built["index_reused"]) == (INDEX, False)
    assert built["index_seconds"] > 0
    again = ms.apply_filter(filters.FROM_POINT, vertex_index=5)
    assert (again["answered_by"], again["index_reused"], again["index_seconds"]) == (INDEX, True, 0)


def test_quick_is_close_to_exact_and_leaves_no_index():
    ms, exact = scaled_sphere(1.72)
    result = ms.apply_filter(filters.FROM_POINT, vertex_index=5, method="quick")
    assert result["answered_by"] == QUICK
    others = exact > 0
    assert np.abs(field(ms)[others] / exact[others] - 1).mean() < 0.001
    assert not ms.apply_filter(filters.DESCRIBE_INDEX)["has_index"]


def test_automatic_builds_an_index_when_exact_answers_took_as_long():
    vertices, faces = sphere(4)
    ms = mesh_set(vertices * 1.73, faces)
    for _ in range(5000):
        result = ms.apply_filter(filters.FROM_POINT, vertex_index=5)
        if result["answered_by"] == INDEX:
            break
    assert result["answered_by"] == INDEX
    assert ms.apply_filter(filters.DESCRIBE_INDEX)["has_index"]


@pytest.mark.parametrize(("method", "number"), [("index", INDEX), ("exact", EXACT), ("quick", QUICK)])
def test_all_distance_filters_have_it(method, number):
    ms = mesh_set(*grid(9, 7))
    select_vertices(ms, [3])
    for name, arguments in (
        (filters.FROM_SELECTION, {}),
        (filters.FROM_BORDER, {}),
        (filters.FROM_EDGES, {"from_border": True}),
    ):
        assert ms.apply_filter(name, method=method, **arguments)["answered_by"] == number


def test_another_method_is_refused():
    with pytest.raises(pymeshlab.InvalidEnumException, match="Enum 'fast' not found"):
        mesh_set(*grid(4, 4)).apply_filter(filters.FROM_POINT, vertex_index=0, method="fast")
    with pytest.raises(pymeshlab.PyMeshLabException):
        mesh_set(*grid(4, 4)).apply_filter(filters.EXACT_FROM_POINT, vertex_index=0, method="exact")
