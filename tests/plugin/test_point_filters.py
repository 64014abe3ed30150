"""Points anywhere on the surface in the filters: layers of points, points written as text, and bad ones."""

from __future__ import annotations

import numpy as np
import pymeshlab
import pytest
from support import (
    DISK,
    FARTHEST,
    LLOYD,
    MATRIX,
    NEAREST,
    PAIRS_WITHIN,
    PATH,
    TWO_POINTS,
    VORONOI,
    arrays,
    fails_and_changes_nothing,
    grid,
    layer_count,
    length,
    mesh_set,
    select_vertices,
)

VERTICES, FACES = grid(20, 15, 0.2)
POINTS = np.array([[0.31, 0.42, 0.0], [3.3, 2.55, 0.25], [2.07, 0.44, 0.0], [0.9, 2.73, 0.0]])
BETWEEN = np.linalg.norm((POINTS[:, None] - POINTS)[..., :2], axis=2)
MATRIX_FILTERS = [MATRIX, PAIRS_WITHIN, NEAREST, VORONOI, LLOYD, DISK]


@pytest.fixture
def ms():
    """The grid, and a layer of points beside it, which is not current."""
    result = mesh_set(VERTICES, FACES)
    result.add_mesh(pymeshlab.Mesh(POINTS), set_as_current=False)
    return result


def as_text(points):
    """The points of the plane as surface points of the grid."""
    entries = []
    for point in points:
        corners = VERTICES[FACES]
        edges = np.stack([corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]], axis=2)[:, :2]
        v, w = np.linalg.solve(edges, (point - corners[:, 0])[:, :2, None])[..., 0].T
        face = np.flatnonzero((v >= 0) & (w >= 0) & (v + w <= 1))[0]
        entries.append(" ".join(map(repr, (int(face), *np.array([1 - v - w, v, w])[:, face].tolist()))))
    return "; ".join(entries)


@pytest.mark.parametrize("exact", [False, True])
def test_matrix_of_a_layer_and_of_surface_points(ms, exact, tmp_path):
    file = tmp_path / "matrix.npy"
    found = ms.apply_filter(MATRIX, point_layer=1, exact=exact, matrix_file=str(file))
    tolerance = 1e-9 if exact else 1e-5
    np.testing.assert_allclose(found["distances"].reshape(4, 4), BETWEEN, rtol=tolerance, atol=1e-12)
    np.testing.assert_array_equal(np.load(file), found["distances"].reshape(4, 4))
    np.testing.assert_array_equal(found["vertices"], range(4))
    assert found["snap_distance"] == pytest.approx(0.25)
    written = ms.apply_filter(MATRIX, surface_points=as_text(POINTS), exact=exact)
    np.testing.assert_allclose(written["distances"].reshape(4, 4), BETWEEN, rtol=tolerance, atol=1e-12)
    assert written["snap_distance"] == 0


def test_pairs_of_a_layer(ms):
    radius = np.median(BETWEEN[BETWEEN > 0]) + 1e-3
    found = ms.apply_filter(PAIRS_WITHIN, point_layer=1, radius=length(radius), exact=True)
    first, second = np.nonzero(np.triu(radius >= BETWEEN, 1))
    np.testing.assert_array_equal(found["first"], first)
    np.testing.assert_array_equal(found["second"], second)
    np.testing.assert_allclose(found["distances"], BETWEEN[first, second], rtol=1e-9)


def test_nearest_points_of_points(ms):
    ms.add_mesh(pymeshlab.Mesh(np.array([[0.5, 0.5, 0.0], [3.0, 2.5, 0.1]])), set_as_current=False)
    found = ms.apply_filter(NEAREST, source_layer=1, point_layer=2, exact=True)
    np.testing.assert_array_equal(found["nearest"], [0, 1])
    np.testing.assert_allclose(found["distances"], [np.hypot(0.19, 0.08), np.hypot(0.3, 0.05)])
    assert found["snap_distance"] == pytest.approx(0.25)


@pytest.mark.parametrize("given", ["layer", "text"])
def test_voronoi_regions_of_points_in_faces(ms, given):
    points = {"point_layer": 1} if given == "layer" else {"surface_points": as_text(POINTS)}
    found = ms.apply_filter(VORONOI, exact=True, **points)
    assert found["regions"] == 4
    distances = np.linalg.norm((VERTICES[:, None] - POINTS)[..., :2], axis=2)
    region = ms.current_mesh().vertex_scalar_array().astype(int)
    np.testing.assert_allclose(distances[np.arange(len(region)), region], distances.min(axis=1))
    borders = ms.mesh(2).vertex_matrix()
    two = np.sort(np.linalg.norm((borders[:, None] - POINTS)[..., :2], axis=2), axis=1)[:, :2]
    np.testing.assert_allclose(two[:, 0], two[:, 1], atol=1e-9)


def test_farthest_points_begin_with_a_layer(ms):
    found = ms.apply_filter(FARTHEST, sample_number=7, from_selection=True, point_layer=1, exact=True)
    samples = ms.current_mesh().vertex_matrix()
    np.testing.assert_allclose(samples[:4, :2], POINTS[:, :2], atol=1e-12)
    np.testing.assert_array_equal(found["vertices"][:4], -1)
    np.testing.assert_array_equal(samples[4:], VERTICES[found["vertices"][4:].astype(int)])
    farthest = np.linalg.norm((VERTICES[:, None] - POINTS)[..., :2], axis=2).min(axis=1).max()
    np.testing.assert_allclose(np.linalg.norm((samples[4] - POINTS)[:, :2], axis=1).min(), farthest)


def test_relaxation_begins_anywhere(ms):
    found = ms.apply_filter(LLOYD, point_layer=1, rounds=5, exact=True)
    assert found["energy_after"] < found["energy_before"]
    assert ms.current_mesh().vertex_number() == 4


def test_disk_around_a_point_in_a_face(ms):
    ms.apply_filter(DISK, surface_points=as_text(POINTS[:1]), radius=length(0.9), exact=True)
    inside = np.linalg.norm(VERTICES - POINTS[0], axis=1) <= 0.9
    np.testing.assert_array_equal(ms.current_mesh().vertex_selection_array(), inside)


def test_two_points_by_text_and_in_space(ms):
    found = ms.apply_filter(TWO_POINTS, surface_points=as_text(POINTS[[0, 3]]))
    assert found["distance"] == pytest.approx(BETWEEN[0, 3], rel=1e-12)
    found = ms.apply_filter(TWO_POINTS, source=-1, target=-1, source_point=POINTS[0], target_point=POINTS[1])
    assert found["distance"] == pytest.approx(BETWEEN[0, 1], rel=1e-6)
    assert found["target_snap_distance"] == pytest.approx(0.25, rel=1e-6)
    found = ms.apply_filter(PATH, surface_points=as_text(POINTS[[0, 1]]))
    assert found["length"] == pytest.approx(BETWEEN[0, 1], rel=1e-12)


def test_numpy_writes_points_as_the_filters_read_them(ms):
    vorogeo = pytest.importorskip("vorogeo")
    index = vorogeo.GeodesicIndex(*arrays(ms))
    points = index.snap(POINTS)
    found = ms.apply_filter(MATRIX, surface_points=points.to_text())
    np.testing.assert_allclose(found["distances"].reshape(4, 4), index.distance_matrix(points), rtol=1e-12)


@pytest.mark.parametrize("name", MATRIX_FILTERS)
@pytest.mark.parametrize(
    ("parameters", "message"),
    [
        ({"surface_points": "17; two"}, '"two", point 1 of'),
        ({"surface_points": "17 0.5"}, "is not a surface point"),
        ({"surface_points": ";"}, "holds no point"),
        ({"surface_points": "99999"}, "is 99999, but the vertices of the current layer are numbered"),
        ({"surface_points": "700 0.2 0.3 0.5"}, "names face 700"),
        ({"surface_points": "7 0.2 0.3 0.6"}, "point 0 of"),
        ({"surface_points": "7 nan 0.3 0.6"}, "point 0 of"),
        ({"point_layer": 9}, "(point_layer) is 9, but there is no such layer"),
        ({"point_layer": 1, "max_snap_distance": length(0.1)}, "Vertex 1 of layer 1 is 0.25"),
        ({"point_layer": 2}, "Layer 2 has no vertex"),
    ],
)
def test_bad_points_are_named(ms, name, parameters, message):
    ms.add_mesh(pymeshlab.Mesh(POINTS))  # to become a layer without vertices
    ms.apply_filter("set_selection_all")
    ms.apply_filter("meshing_remove_selected_vertices")
    ms.set_current_mesh(0)
    select_vertices(ms, [3])
    if name == NEAREST:
        ms.add_mesh(pymeshlab.Mesh(VERTICES[:3]), set_as_current=False)
        parameters = {"source_layer": 3, **parameters}
    count = layer_count(ms)
    with fails_and_changes_nothing(ms, message):
        ms.apply_filter(name, **parameters)
    assert layer_count(ms) == count


@pytest.mark.parametrize("name", [PATH, TWO_POINTS])
def test_two_points_are_two(ms, name):
    with fails_and_changes_nothing(ms, "holds 3 points. Give two"):
        ms.apply_filter(name, surface_points="1; 2; 3")
