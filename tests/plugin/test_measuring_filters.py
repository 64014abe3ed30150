"""Filters to measure with: profiles, areas of regions, paths with guides, hulls, loops like a curve."""

from __future__ import annotations

import filters
import numpy as np
import pymeshlab
import pytest
import vorogeo
from support import fails_and_changes_nothing, grid, layer_count, mesh_set, sphere, tube

COLUMNS = ("length", "height", "angle", "curvature", "thickness")


def add_layer(ms: pymeshlab.MeshSet, points: np.ndarray) -> int:
    ms.add_mesh(pymeshlab.Mesh(np.asarray(points, float)), set_as_current=False)
    return layer_count(ms) - 1


def box(width: float, depth: float, height: float) -> tuple[np.ndarray, np.ndarray]:
    ms = pymeshlab.MeshSet()
    ms.create_cube()
    mesh = ms.current_mesh()
    return (mesh.vertex_matrix() + 0.5) * [width, depth, height], mesh.face_matrix()


def torus(around: int, across: int, outer: float, inner: float) -> tuple[np.ndarray, np.ndarray]:
    """Vertex i * across + j is the j-th of the i-th ring; j = 0 on the outer equator, across / 2 on the inner one."""
    i, j = (index.ravel() for index in np.meshgrid(np.arange(around), np.arange(across), indexing="ij"))
    u, v = 2 * np.pi * i / around, 2 * np.pi * j / across
    far = outer + inner * np.cos(v)
    vertices = np.column_stack([far * np.cos(u), far * np.sin(u), inner * np.sin(v)])

    def number(di: int, dj: int) -> np.ndarray:
        return (i + di) % around * across + (j + dj) % across

    corners = number(0, 0), number(1, 0), number(1, 1), number(0, 1)
    faces = np.concatenate([np.column_stack([corners[k] for k in three]) for three in ((0, 1, 2), (0, 2, 3))])
    return vertices, faces.astype(np.int32)


# ---- Profiles


@pytest.mark.parametrize("quality", [None, *COLUMNS])
def test_profile_of_a_line_down_a_roof(quality, tmp_path):
    """Up one side and down the other: 3 and 4 make 5."""
    vertices, faces = grid(8, 2)
    vertices = vertices * [1, 2, 0] + np.outer(3 - 0.75 * np.abs(vertices[:, 0] - 4), [0, 0, 1])
    ms = mesh_set(vertices, faces)
    ends = np.array([[0.5, 1.0, 0.375], [7.25, 3.0, 0.5625]])
    file = tmp_path / "table.csv"
    chosen = {} if quality is None else {"quality": quality.capitalize()}
    found = ms.apply_filter(filters.PROFILE, curve_layer=add_layer(ms, ends), csv_file=str(file), **chosen)
    assert found["length"][-1] == pytest.approx(np.hypot(6.75 * 1.25, 2), rel=1e-9)
    assert found["points"] == len(found["length"]) == len(found["height"])
    line = ms.current_mesh()
    at = line.vertex_matrix()
    np.testing.assert_allclose(at[[0, -1]], ends, atol=1e-9)
    np.testing.assert_allclose(np.diff(found["length"]), np.linalg.norm(np.diff(at, axis=0), axis=1), atol=1e-9)
    np.testing.assert_allclose(found["height"], at[:, 2], atol=1e-12)
    sides = np.abs(at[:, 0] - 4) > 1e-9
    np.testing.assert_allclose(found["angle"][sides], np.arctan(0.75), rtol=1e-9)
    np.testing.assert_allclose(found["angle"][~sides], 0, atol=1e-7)
    assert (found["curvature"] >= -1e-12).all()
    assert (found["thickness"] == np.inf).all()
    table = np.genfromtxt(file, delimiter=",", names=True)
    assert table.dtype.names == COLUMNS
    for name in COLUMNS:
        np.testing.assert_array_equal(table[name], found[name])
        np.testing.assert_array_equal(line.vertex_custom_scalar_attribute_array(name), found[name])
    shown = found[quality or "height"]
    np.testing.assert_array_equal(line.vertex_scalar_array(), np.where(np.isfinite(shown), shown, -1))


def test_thickness_of_a_box_and_the_answers_of_the_package():
    vertices, faces = box(2, 3, 5)
    ms = mesh_set(vertices, faces)
    top = np.array([[0.25, 0.5, 5], [1.5, 1.0, 5], [1.75, 2.5, 5]])
    found = ms.apply_filter(filters.PROFILE, curve_layer=add_layer(ms, top))
    np.testing.assert_allclose(found["thickness"], 5, rtol=1e-12)
    np.testing.assert_allclose(found["angle"], 0, atol=1e-7)
    assert found["length"][-1] == pytest.approx(np.linalg.norm(np.diff(top, axis=0), axis=1).sum(), rel=1e-12)

    vertices, faces = sphere(3)
    ms, surface = mesh_set(vertices, faces), vorogeo.Surface(vertices, faces)
    ms.apply_filter(filters.PATH_THROUGH, surface_points="3; 77; 400")
    ms.set_current_mesh(0)
    found = ms.apply_filter(filters.PROFILE, curve_layer=1, up=np.array([1.0, 2.0, -1.0]))
    expected = surface.profile(surface.path_through([3, 77, 400]), up=[1, 2, -1])
    for name in COLUMNS:
        np.testing.assert_allclose(found[name], getattr(expected, name), rtol=1e-6, atol=1e-6, err_msg=name)


@pytest.mark.parametrize(
    ("numbers", "message"),
    [
        ("quality=5", r"\(quality\) is 5. Give length, height, angle, curvature or thickness, or 0 to 4"),
        ("quality=-1", r"\(quality\) is -1"),
    ],
)
def test_what_no_profile_has_is_refused(numbers, message):
    ms = mesh_set(*grid(2, 2))
    with pytest.raises(Exception, match=message):
        ms.apply_filter("probe_apply", filter=filters.PROFILE, numbers=numbers)


def test_a_profile_needs_a_direction_and_leaves_no_file_without_one(tmp_path):
    ms = mesh_set(*grid(4, 4))
    curve, file = add_layer(ms, [[0, 0, 0], [3, 3, 0]]), tmp_path / "table.csv"
    with fails_and_changes_nothing(ms, "The direction upwards has length 0"):
        ms.apply_filter(filters.PROFILE, curve_layer=curve, up=np.zeros(3), csv_file=str(file))
    assert (layer_count(ms), file.exists()) == (2, False)


# ---- Areas of regions


def test_area_of_selected_faces_and_volume_of_a_closed_surface():
    vertices, faces = grid(8, 6)
    ms = mesh_set(vertices, faces)
    ms.apply_filter("compute_selection_by_condition_per_face", condselect="(x0 + x1 + x2) < 9")
    found = ms.apply_filter(filters.REGION)
    assert (found["area"], found["border_length"]) == (pytest.approx(18, rel=1e-12), pytest.approx(18, rel=1e-12))
    assert np.isnan(found["volume"])
    ms = mesh_set(*box(2, 3, 5))
    ms.apply_filter("set_selection_all")
    found = ms.apply_filter(filters.REGION)
    assert (found["area"], found["border_length"], found["volume"]) == pytest.approx((62, 0, 30), rel=1e-12)
    assert layer_count(ms) == 1


@pytest.mark.parametrize("closed", [False, True])
def test_area_inside_a_curve(closed):
    vertices, faces = grid(8, 6)
    ms = mesh_set(vertices, faces)
    corners = np.array([[1.25, 1.0, 0.5], [6.0, 1.5, 0.5], [4.0, 5.25, 0.5]])
    curve = add_layer(ms, np.vstack([corners, corners[:1]]) if closed else corners)
    found = ms.apply_filter(filters.REGION, curve_layer=curve)
    a, b, c = corners
    assert found["area"] == pytest.approx(np.linalg.norm(np.cross(b - a, c - a)) / 2, rel=1e-9)
    assert found["border_length"] == pytest.approx(sum(np.linalg.norm(np.roll(corners, 1, 0) - corners, axis=1)))
    assert found["snap_distance"] == pytest.approx(0.5)


def test_area_inside_a_path_is_that_of_the_package():
    vertices, faces = sphere(3)
    ms, surface = mesh_set(vertices, faces), vorogeo.Surface(vertices, faces)
    polygon = surface.path_through([3, 77, 400], closed=True)
    ms.apply_filter(filters.PATH_THROUGH, surface_points="3; 77; 400", closed=True)
    ms.set_current_mesh(0)
    found, expected = ms.apply_filter(filters.REGION, curve_layer=1), surface.area(inside=polygon)
    assert found["area"] == pytest.approx(expected.area, rel=1e-9)
    assert found["border_length"] == pytest.approx(polygon.length, rel=1e-9)


# ---- Guides, hulls, and loops like a curve


def test_guides_lead_round_a_tube_and_are_straight_when_unrolled():
    sides = 12
    vertices, faces = tube([1.0] * 9, sides)
    ms = mesh_set(vertices, faces)
    side = 2 * np.sin(np.pi / sides)
    # Nine of the twelve sides, though three lead there the other way.
    found = ms.apply_filter(filters.PATH_THROUGH, surface_points="24; 41; 57; 81", guides=True)
    assert found["length"] == pytest.approx(np.hypot(9 * side, 4), rel=1e-9)
    assert not found["certified"]
    expected = vorogeo.Surface(vertices, faces).path_through([24, 41, 57, 81], guides=True)
    assert found["length"] == pytest.approx(expected.length, rel=1e-12)
    ms.set_current_mesh(0)
    found = ms.apply_filter(filters.PATH_THROUGH, surface_points="24; 40; 56", guides=True, closed=True)
    assert found["length"] == pytest.approx(sides * side, rel=1e-9)


def test_convex_hull_of_points_of_the_plane():
    vertices, faces = grid(8, 6)
    ms = mesh_set(vertices, faces)
    points = np.array([[3.0, 3.0, 0], [1.25, 1.0, 0], [4.0, 5.25, 0], [3.5, 2.5, 0], [6.0, 1.5, 0]])
    found = ms.apply_filter(filters.POLYGON, point_layer=add_layer(ms, points), convex_hull=True, cut_out=True)
    corners = points[[1, 4, 2]]
    assert sorted(found["vertices"]) == [1, 2, 4]
    a, b, c = corners
    assert found["area"] == pytest.approx(np.linalg.norm(np.cross(b - a, c - a)) / 2, rel=1e-9)
    assert found["perimeter"] == pytest.approx(sum(np.linalg.norm(np.roll(corners, 1, 0) - corners, axis=1)))
    assert found["angles"].sum() == pytest.approx(np.pi, rel=1e-9)
    assert layer_count(ms) == 4


def test_convex_hull_is_that_of_the_package():
    vertices, faces = sphere(3)
    points = np.flatnonzero((vertices[:, 2] > 0.7) & (vertices[:, 0] > -0.2))[::5].tolist()
    expected = vorogeo.Surface(vertices, faces).convex_hull(points)
    found = mesh_set(vertices, faces).apply_filter(
        filters.POLYGON, surface_points="; ".join(map(str, points)), convex_hull=True
    )
    assert found["area"] == pytest.approx(expected.area, rel=1e-9)
    np.testing.assert_array_equal(found["vertices"], expected.corners)


def test_a_loop_like_a_curve_goes_round_what_that_goes_round():
    """Through a point of the inner equator of a torus, which is a geodesic; the shortest loop goes across."""
    around, across = 24, 12
    vertices, faces = torus(around, across, 3, 1.5)
    ms = mesh_set(vertices, faces)
    at = across // 2
    meridian = across * 3 * np.sin(np.pi / across)
    shortest = ms.apply_filter(filters.LOOP, vertex_index=at)["length"]
    assert 0.98 * meridian < shortest < meridian + 1e-9  # along diagonals, it is a little shorter
    assert shortest == pytest.approx(vorogeo.Surface(vertices, faces).shortest_loop(at).length, rel=1e-12)
    ms.set_current_mesh(0)
    equator = add_layer(ms, vertices[across * np.arange(around) + 1] * 1.001)  # beside the outer one
    found = ms.apply_filter(filters.LOOP, vertex_index=at, curve_layer=equator)
    assert found["length"] == pytest.approx(around * 3 * np.sin(np.pi / around), rel=1e-9)
    assert 0 < found["curve_snap_distance"] < 0.01
    assert found["start_vertex"] == at


def test_a_profile_follows_a_path_of_another_filter():
    vertices, faces = tube([1.0] * 6, 24)
    ms = mesh_set(vertices, faces)
    path = ms.apply_filter(filters.PATH, source=0, target=132)
    ms.set_current_mesh(0)
    found = ms.apply_filter(filters.PROFILE, curve_layer=1, quality="Length")
    assert found["length"][-1] == pytest.approx(path["length"], rel=1e-9)
    slope = np.cos(np.arcsin(5 / path["length"]))
    inner = found["curvature"][2:-2]  # of a helix, but for the ends at the rims
    np.testing.assert_allclose(inner.mean(), slope**2, rtol=0.05)
