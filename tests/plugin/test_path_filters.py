"""Filters for paths, loops, girths, directions, and distances from points, lines, edges and both sides of curves."""

from __future__ import annotations

import colorsys

import filters
import numpy as np
import pymeshlab
import pytest
from support import (
    exact_distances,
    fails_and_changes_nothing,
    field,
    grid,
    layer_count,
    length,
    mesh_set,
    side_by_side,
    sphere,
    tube,
)


def test_path_between_points_of_the_plane():
    vertices, faces = grid(12, 9)
    ms = mesh_set(vertices, faces)
    source, target = np.array([0.25, 0.5, 2.0]), np.array([10.5, 7.75, 0.0])
    result = ms.apply_filter(filters.PATH, source_point=source, target_point=target)
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
        result = ms.apply_filter(filters.PATH, source=5, target=target, method="index", exact=True, certify=certify)
        assert result["length"] == pytest.approx(exact[target], rel=1e-9)
        assert result["certified"] or not certify
        ms.set_current_mesh(0)


def test_no_path_is_no_layer():
    ms = mesh_set(*side_by_side(grid(4, 4), grid(4, 4)))
    result = ms.apply_filter(filters.PATH, source=0, target=ms.current_mesh().vertex_number() - 1)
    assert result["length"] == np.inf
    assert result["points"] == 0
    assert layer_count(ms) == 1


def test_no_path_through_points_of_two_components_is_refused():
    ms = mesh_set(*side_by_side(grid(4, 4), grid(4, 4)))
    with fails_and_changes_nothing(ms, "No path leads from point 1 (vertex 3) to point 2 (vertex 40)"):
        ms.apply_filter(filters.PATH_THROUGH, surface_points="0; 3; 40")
    assert layer_count(ms) == 1


def around(count, height, swing):
    """Places around a tube, in its order: up and down twice."""
    turn = 2 * np.pi * (np.arange(count) + 0.3) / count
    return np.column_stack([np.cos(turn), np.sin(turn), height + swing * np.sin(2 * turn)])


@pytest.mark.parametrize("lines", ["closed", "open", "none", "with an end of its own"])
def test_a_curve_round_a_tube_is_pulled_tight(lines):
    """Straight all the way round is the way round at right angles to the axis, wherever it is."""
    ms = mesh_set(*tube([1.0] * 9, sides=10))
    count = 40
    order = np.random.default_rng(3).permutation(count)  # the order of edges and vertices does not matter
    place, at = around(count, 4.0, 1.5), np.argsort(order)
    edges = np.column_stack([at, at[(np.arange(count) + 1) % count]])[order]
    if lines == "open":
        edges = edges[1:]
    if lines == "none":
        ms.add_mesh(pymeshlab.Mesh(place))
    elif lines == "with an end of its own":
        steps = np.arange(count)
        ms.add_mesh(
            pymeshlab.Mesh(
                vertex_matrix=np.concatenate([place, place[:1]]), edge_matrix=np.column_stack([steps, steps + 1])
            )
        )
    else:
        ms.add_mesh(pymeshlab.Mesh(vertex_matrix=place[order], edge_matrix=edges))
    ms.set_current_mesh(0)
    found = ms.apply_filter(filters.TIGHT, curve_layer=1)
    assert found["length"] == pytest.approx(20 * np.sin(np.pi / 10), rel=1e-9)
    assert 0 < found["snap_distance"] < 1 - np.cos(np.pi / 10) + 1e-9
    assert (layer_count(ms), ms.current_mesh_id()) == (3, 2)
    loop = ms.current_mesh()
    assert loop.edge_number() == loop.vertex_number() - 1 == found["points"] - 1
    assert np.ptp(loop.vertex_matrix()[:, 2]) < 1e-3  # what is that much longer is so by its square
    np.testing.assert_allclose(loop.vertex_scalar_array()[-1], found["length"], rtol=1e-12)


def test_selected_edges_are_pulled_tight():
    """Those of the neck of an hourglass stay where they are: its faces open there on both sides."""
    ms = mesh_set(*tube([2.0, 1.0, 2.0], sides=24))
    ms.apply_filter("compute_selection_crease_per_edge", angledegneg=-30, angledegpos=30)
    found = ms.apply_filter(filters.TIGHT)
    assert found["length"] == pytest.approx(48 * np.sin(np.pi / 24), rel=1e-9)
    assert found["snap_distance"] == 0
    np.testing.assert_allclose(ms.current_mesh().vertex_matrix()[:, 2], 1, atol=1e-9)


RING = around(6, 4.0, 0.0)
NEXT = np.column_stack([np.arange(6), (np.arange(6) + 1) % 6])
NO_CURVES = [
    (RING, [*NEXT, [0, 3]], "The curve branches: vertex 0 of layer 1 has 3 of its edges. Leave two of them."),
    (
        np.concatenate([RING, around(6, 5.0, 0.0)]),
        [*NEXT, *NEXT + 6],
        "The curve is in several parts: vertex 0 of layer 1 is on one of them, vertex 6 of layer 1 on another.",
    ),
    (RING[[0, 0, 0]], [[0, 1], [1, 2]], "The lines of layer 1 have no length"),
    (np.where(np.arange(6)[:, None] == 2, np.nan, RING), NEXT, "Vertex 2 of layer 1: "),
    (RING[:3], [[0, 1], [1, 2], [0, 2]], "The curve slips off: pulled tight, it contracts to a point"),
    (RING + [10, 0, 0] * (np.arange(6) > 2)[:, None], NEXT, "No path leads from point "),
]


@pytest.mark.parametrize(("places", "edges", "message"), NO_CURVES)
def test_what_is_no_closed_curve_is_refused(places, edges, message):
    ms = mesh_set(*side_by_side(tube([1.0] * 9), tube([1.0] * 9)))
    ms.add_mesh(pymeshlab.Mesh(vertex_matrix=np.asarray(places, float), edge_matrix=np.asarray(edges)))
    ms.set_current_mesh(0)
    with fails_and_changes_nothing(ms, message):
        ms.apply_filter(filters.TIGHT, curve_layer=1)
    assert layer_count(ms) == 2


def test_the_shortest_loop_through_a_point():
    """Round a tube at right angles to its axis."""
    vertices, faces = tube([1.0] * 9, sides=10)
    ms = mesh_set(vertices, faces)
    found = ms.apply_filter(filters.LOOP, start_point=[0.9, 0.1, 3.3])
    assert found["length"] == pytest.approx(20 * np.sin(np.pi / 10), rel=1e-9)
    assert (found["start_vertex"], found["answered_by"]) == (-1, 2)
    assert found["snap_distance"] > 0
    assert (layer_count(ms), ms.current_mesh_id()) == (2, 1)
    np.testing.assert_allclose(ms.current_mesh().vertex_matrix()[:, 2], 3.3, atol=1e-3)
    ms.set_current_mesh(0)
    assert ms.apply_filter(filters.LOOP, vertex_index=42)["start_vertex"] == 42


def prism():
    """Over an L, which is 8 round, ten high."""
    corners = np.array([[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2.0]])
    i, j = np.arange(6), np.roll(np.arange(6), -1)
    sides = np.concatenate([np.column_stack([i, j, j + 6]), np.column_stack([i, j + 6, i + 6])])
    fan = np.array([[0, k, k + 1] for k in range(1, 5)])
    vertices = np.column_stack([np.tile(corners, (2, 1)), np.repeat([0.0, 10.0], 6)])
    return vertices, np.concatenate([sides, fan[:, ::-1], fan + 6]).astype(np.int32)


@pytest.mark.parametrize("normal", [[0, 0, 0], [0, 0, -2]])
def test_girth_of_a_prism(normal):
    ms = mesh_set(*prism())
    found = ms.apply_filter(filters.GIRTH, start_point=[0, 0.75, 4.125], normal=np.array(normal, float))
    tape = 6 + 2**0.5  # straight across the hollow
    for name, expected in (("section", 8), ("tape", tape), ("loop", 8)):
        assert found[f"{name}_length"] == pytest.approx(expected, rel=1e-6), name
    np.testing.assert_allclose(np.abs(found["normal"]), [0, 0, 1], atol=1e-4)
    assert (found["start_vertex"], found["snap_distance"]) == (-1, pytest.approx(0, abs=1e-6))
    assert (layer_count(ms), ms.current_mesh_id()) == (4, 3)
    for layer, expected in ((1, tape), (2, 8), (3, 8)):
        line = ms.mesh(layer)
        assert line.edge_number() == line.vertex_number() - 1
        assert line.vertex_scalar_array().max() == pytest.approx(expected, rel=1e-6)
        np.testing.assert_allclose(line.vertex_matrix()[[0, -1], 2], 4.125, atol=1e-3)
        np.testing.assert_allclose(line.vertex_matrix()[0], line.vertex_matrix()[-1], atol=1e-9)


def test_a_loop_that_slips_off_is_no_layer():
    ms = mesh_set(*sphere(3))
    found = ms.apply_filter(filters.GIRTH, start_point=[0.6, 0.08, 0.796], normal=[0, 0, 1])
    assert found["loop_length"] == 0
    assert found["section_length"] == pytest.approx(2 * np.pi * np.hypot(0.6, 0.08), rel=0.03)
    assert found["tape_length"] <= found["section_length"] + 1e-9
    assert layer_count(ms) == 3


@pytest.mark.parametrize("per_wedge", [False, True])
@pytest.mark.parametrize(("radius", "rotation", "scale", "rings"), [(0, 0, 1, 0), (2.25, -30, 0.5, 7)])
def test_directions_in_the_plane(radius, rotation, scale, rings, per_wedge):
    vertices, faces = grid(12, 9, 0.5)
    centre = 4 * 13 + 6
    ms = mesh_set(vertices, faces)
    picture = {"rotation": rotation, "scale": scale, "rings": rings, "per_wedge": per_wedge}
    found = ms.apply_filter(filters.DIRECTIONS, vertex_index=centre, radius=length(radius), **picture)
    # The frame: from the vertex to the next corner of the last face that has it.
    last = faces[np.flatnonzero((faces == centre).any(axis=1))[-1]]
    x = vertices[np.roll(last, -1)[last == centre][0]] - vertices[centre]
    x /= np.linalg.norm(x)
    steps = vertices - vertices[centre]
    vector = np.column_stack([steps @ x, steps @ [-x[1], x[0], 0]])
    distance = np.linalg.norm(steps, axis=1)
    reached = distance <= (radius or np.inf)
    assert found["reached_vertices"] == reached.sum()
    assert found["vertices_beyond_max_distance"] == (~reached).sum()
    assert found["max_distance"] == pytest.approx(distance[reached].max(), rel=1e-12)
    assert (found["start_vertex"], found["snap_distance"]) == (centre, 0)
    assert max(found["mean_distortion"], found["max_distortion"]) < 1e-9
    mesh = ms.current_mesh()
    largest = radius or distance.max()
    back = np.radians(-rotation)  # the picture turns one way, what is seen in it the other
    turned = vector @ np.array([[np.cos(back), np.sin(back)], [-np.sin(back), np.cos(back)]])
    place = np.where(reached[:, None], 0.5 + turned / (2 * largest * scale), 0)
    if per_wedge:
        place = np.where(reached[faces].all(axis=1)[:, None, None], place[faces], 0).reshape(-1, 2)
        np.testing.assert_allclose(mesh.wedge_tex_coord_matrix(), place, atol=1e-6)
    else:
        np.testing.assert_allclose(mesh.vertex_tex_coord_matrix(), place, atol=1e-6)
    assert mesh.has_vertex_tex_coord() != per_wedge
    angle = np.arctan2(vector[:, 1], vector[:, 0])
    others = reached & (distance > 0)
    np.testing.assert_allclose(np.exp(1j * field(ms)[others]), np.exp(1j * angle[others]), atol=1e-9)
    assert field(ms)[reached].min() >= 0
    np.testing.assert_array_equal(field(ms)[~reached], -1)
    colors = mesh.vertex_color_matrix() * 255
    np.testing.assert_allclose(colors[~reached], np.tile([160, 160, 160, 255], (np.sum(~reached), 1)))
    is_dark = np.floor(rings * distance / largest)[others] % 2 == 1
    wheel = [
        colorsys.hsv_to_rgb(turn / (2 * np.pi), 0.75, 0.82 if dark else 1)
        for turn, dark in zip(field(ms)[others], is_dark, strict=True)
    ]
    np.testing.assert_allclose(colors[others, :3], 255 * np.array(wheel), atol=1.01)


def test_distortion_of_directions_from_a_corner():
    """Three right angles around it are scaled to a full turn: sides of sqrt(2) become sqrt(3), edges at it stay."""
    ms = mesh_set(np.eye(4, 3, -1), np.array([[0, 1, 2], [0, 2, 3], [0, 3, 1]]))
    found = ms.apply_filter(filters.DIRECTIONS, vertex_index=0, radius=length(0))
    assert found["max_distortion"] == pytest.approx(1.5**0.5 - 1, rel=1e-12)
    assert found["mean_distortion"] == pytest.approx((3**0.5 - 2**0.5) / (1 + 2**0.5), rel=1e-12)


@pytest.mark.parametrize("method", ["index", "exact"])
def test_distance_from_a_layer_of_points(method):
    vertices, faces = grid(20, 20, 0.5)
    ms = mesh_set(vertices, faces)
    points = np.array([[1.3, 2.1, 0.0], [7.7, 8.2, 0.4]])
    ms.add_mesh(pymeshlab.Mesh(points))
    ms.set_current_mesh(0)
    result = ms.apply_filter(filters.FROM_LAYER, source_layer=1, method=method)
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
    ms.apply_filter(filters.FROM_LAYER, source_layer=1, method="exact", spacing=length(spacing))
    t = np.clip((vertices - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
    distances = np.linalg.norm(vertices - (a + t[:, None] * (b - a)), axis=1)
    assert (field(ms) >= distances - 1e-6).all()
    assert (field(ms) <= distances + spacing / 2 + 1e-6).all()


@pytest.mark.parametrize("method", ["index", "exact"])
def test_distance_from_the_border_as_a_curve(method):
    vertices, faces = grid(12, 8)
    ms = mesh_set(vertices, faces)
    result = ms.apply_filter(filters.FROM_EDGES, from_border=True, method=method)
    x, y = vertices[:, 0], vertices[:, 1]
    np.testing.assert_allclose(field(ms), np.min([x, 12 - x, y, 8 - y], axis=0), atol=1e-9)
    assert result["source_edges"] == 40


RECTANGLE = np.array([[1.1, 0.7, 0], [2.9, 0.7, 0], [2.9, 2.3, 0], [1.1, 2.3, 0]])


@pytest.mark.parametrize("lines", ["closed", "open", "none"])
def test_signed_distance_from_a_rectangle(lines):
    vertices, faces = grid(20, 15, 0.2)
    far = sphere(1)
    ms = mesh_set(*side_by_side((vertices, faces), far))
    edges = {"closed": [[2, 3], [0, 1], [3, 0], [1, 2]], "open": [[2, 3], [0, 1], [1, 2]]}
    chosen = {"edge_matrix": np.array(edges[lines])} if lines in edges else {}
    ms.add_mesh(pymeshlab.Mesh(vertex_matrix=RECTANGLE + np.array([0, 0, 0.1]), **chosen), set_as_current=False)
    found = ms.apply_filter(filters.SIGNED, curve_layer=1)
    beyond = np.abs(vertices[:, :2] - [2, 1.5]) - [0.9, 0.8]
    expected = np.linalg.norm(np.maximum(beyond, 0), axis=1) + np.minimum(beyond.max(axis=1), 0)
    np.testing.assert_allclose(field(ms)[: len(vertices)], expected, atol=1e-6)
    np.testing.assert_array_equal(field(ms)[len(vertices) :], 0)
    assert found["min_distance"] == pytest.approx(expected.min(), abs=1e-6)
    assert found["max_distance"] == pytest.approx(expected.max(), abs=1e-6)
    assert found["unreachable_vertices"] == len(far[0])
    assert found["snap_distance"] == pytest.approx(0.1)
    color = ms.current_mesh().vertex_color_matrix() * 255
    np.testing.assert_allclose(color[len(vertices) :], np.tile([160, 160, 160, 255], (len(far[0]), 1)))
    np.testing.assert_allclose(color[expected.argmax()], [0, 0, 255, 255])
    deep = color[: len(vertices)][expected < -0.3]
    assert (deep[:, 0] > deep[:, 2]).all()  # from red to green


def test_signed_distance_from_two_rectangles():
    """Between the outer one and the inner one it is inside."""
    vertices, faces = grid(20, 15, 0.2)
    ms = mesh_set(vertices, faces)
    inner = (RECTANGLE - [2, 1.5, 0]) / 3 + [2, 1.5, 0]
    steps = np.arange(4)
    ring = np.column_stack([steps, (steps + 1) % 4])
    lines = pymeshlab.Mesh(vertex_matrix=np.vstack([RECTANGLE, inner]), edge_matrix=np.vstack([ring, ring[1:] + 4]))
    ms.add_mesh(lines, set_as_current=False)  # the inner one is open
    found = ms.apply_filter(filters.SIGNED, curve_layer=1)
    beyond = np.abs(vertices[:, :2] - [2, 1.5])
    outer, hole = (
        np.linalg.norm(np.maximum(off, 0), axis=1) + np.minimum(off.max(axis=1), 0)
        for off in (beyond - [0.9, 0.8], beyond - [0.3, 0.8 / 3])
    )
    expected = np.maximum(outer, -hole)
    np.testing.assert_allclose(field(ms), expected, atol=1e-6)
    assert found["min_distance"] == pytest.approx(expected.min(), abs=1e-6)


def test_signed_distance_from_a_region():
    vertices, faces = grid(12, 8)
    ms = mesh_set(vertices, faces)
    ms.apply_filter("compute_selection_by_condition_per_face", condselect="(x0 < 5.5) && (x1 < 5.5) && (x2 < 5.5)")
    found = ms.apply_filter(filters.SIGNED)
    np.testing.assert_allclose(field(ms), vertices[:, 0] - 5, atol=1e-5)
    assert (found["min_distance"], found["snap_distance"]) == (pytest.approx(-5, abs=1e-5), 0)
    ms.apply_filter("set_selection_all")
    with fails_and_changes_nothing(ms, "The region has no border on the surface: all faces of each component"):
        ms.apply_filter(filters.SIGNED)


def test_curves_that_cross_have_no_sides():
    ms = mesh_set(*grid(20, 15, 0.2))
    steps = np.arange(4)
    ring = np.column_stack([steps, (steps + 1) % 4])
    both = np.vstack([RECTANGLE, RECTANGLE + np.array([0.53, 0.37, 0])])
    ms.add_mesh(pymeshlab.Mesh(vertex_matrix=both, edge_matrix=np.vstack([ring, ring + 4])), set_as_current=False)
    with fails_and_changes_nothing(ms, "Curves 0 and 1 cross or touch at "):
        ms.apply_filter(filters.SIGNED, curve_layer=1)


def test_a_curve_that_crosses_itself_has_no_sides():
    ms = mesh_set(*grid(20, 15, 0.2))
    ms.add_mesh(pymeshlab.Mesh(RECTANGLE[[0, 2, 1, 3]]), set_as_current=False)
    with fails_and_changes_nothing(ms, "Curve 0 crosses or touches itself at "):
        ms.apply_filter(filters.SIGNED, curve_layer=1)
