"""Filters for matrices, regions, samplings, means, curves, isolines, cuts, disks, extents; points in every way."""

from __future__ import annotations

from typing import NamedTuple

import filters
import numpy as np
import pymeshlab
import pytest
import vorogeo
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from support import (
    arrays,
    exact_distances,
    fails_and_changes_nothing,
    grid,
    layer_count,
    length,
    mesh_set,
    select_vertices,
    side_by_side,
    sphere,
    tube,
)

VERTICES, FACES = grid(20, 15, 0.2)
SELECTED = [25, 100, 260, 330]
BESIDE = np.array([[0.31, 0.42, 0.0], [3.3, 2.55, 0.25], [2.07, 0.44, 0.0], [0.9, 2.73, 0.0]])


@pytest.fixture
def ms():
    """The grid with selected vertices, which no filter here changes, and a layer of points beside it."""
    result = mesh_set(VERTICES, FACES)
    select_vertices(result, SELECTED)
    result.add_mesh(pymeshlab.Mesh(BESIDE), set_as_current=False)
    yield result
    np.testing.assert_array_equal(result.mesh(0).vertex_matrix(), VERTICES)
    np.testing.assert_array_equal(result.mesh(0).face_matrix(), FACES)


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


class Given(NamedTuple):
    """Points of a task: the parameters, where they are on the surface, their numbers, and the farthest move."""

    parameters: dict
    at: np.ndarray
    numbers: list[int]
    moved: float


WAYS = {
    "selection": Given({}, VERTICES[SELECTED], SELECTED, 0.0),
    "layer": Given({"point_layer": 1}, BESIDE * [1, 1, 0], [0, 1, 2, 3], 0.25),
    "text": Given({"surface_points": as_text(BESIDE)}, BESIDE * [1, 1, 0], [0, 1, 2, 3], 0.0),
}


@pytest.fixture(params=WAYS)
def points(request):
    """Points of the grid, given in each way."""
    return WAYS[request.param]


def straight(a, b):
    """Distances in the plane, of all of `a` from all of `b`."""
    return np.linalg.norm(a[:, None] - b, axis=2)


@pytest.mark.parametrize("exact", [False, True])
def test_distance_matrix_is_returned_and_written(ms, points, tmp_path, exact):
    file = tmp_path / "matrix.npy"
    found = ms.apply_filter(filters.MATRIX, matrix_file=str(file), exact=exact, **points.parameters)
    matrix = found["distances"].reshape(found["rows"], found["columns"])
    np.testing.assert_array_equal(matrix, matrix.T)
    np.testing.assert_allclose(matrix, straight(points.at, points.at), rtol=1e-9 if exact else 0.01, atol=1e-12)
    np.testing.assert_array_equal(found["vertices"], points.numbers)
    assert found["snap_distance"] == pytest.approx(points.moved)
    np.testing.assert_array_equal(np.load(file), matrix)
    assert [path.name for path in tmp_path.iterdir()] == ["matrix.npy"]


def test_unreachable_pairs_are_infinite():
    ms = mesh_set(*side_by_side(sphere(2), sphere(2)))
    select_vertices(ms, [0, 200])
    np.testing.assert_array_equal(ms.apply_filter(filters.MATRIX)["distances"], [0, np.inf, np.inf, 0])


def test_pairs_within_radius(ms, points, tmp_path):
    file = tmp_path / "pairs.npy"
    between = straight(points.at, points.at)
    radius = np.median(between[between > 0]) + 1e-3
    found = ms.apply_filter(
        filters.PAIRS_WITHIN, radius=length(radius), matrix_file=str(file), exact=True, **points.parameters
    )
    first, second = np.nonzero(np.triu(between <= radius, 1))
    expected = np.column_stack(
        [np.take(points.numbers, first), np.take(points.numbers, second), between[first, second]]
    )
    table = np.column_stack([found["first"], found["second"], found["distances"]])
    np.testing.assert_allclose(table, expected, rtol=1e-9)
    assert found["pairs"] == len(expected)
    np.testing.assert_array_equal(np.load(file), table)


@pytest.mark.parametrize("exact", [False, True])
def test_nearest_points_of_a_layer(ms, points, exact, tmp_path):
    file = tmp_path / "nearest.npy"
    given = {"source_layer": 1, "exact": exact, **points.parameters}
    found = ms.apply_filter(filters.NEAREST, neighbour_number=3, matrix_file=str(file), **given)
    full = straight(points.at, BESIDE * [1, 1, 0])
    assert (found["rows"], found["columns"]) == (4, 3)
    assert found["snap_distance"] == pytest.approx(0.25)
    np.testing.assert_array_equal(found["vertices"], points.numbers)
    np.testing.assert_array_equal(found["nearest"].reshape(4, 3), np.argsort(full)[:, :3])
    distances = np.sort(full)[:, :3]
    np.testing.assert_allclose(found["distances"].reshape(4, 3), distances, rtol=1e-9 if exact else 1e-2, atol=1e-9)
    expected = np.column_stack([np.repeat(points.numbers, 3), found["nearest"], found["distances"]])
    np.testing.assert_array_equal(np.load(file), expected)
    more = ms.apply_filter(filters.NEAREST, neighbour_number=5, **given)
    np.testing.assert_array_equal(more["nearest"].reshape(4, 5)[:, 4], -1)
    assert np.isinf(more["distances"].reshape(4, 5)[:, 4]).all()


@pytest.mark.parametrize("exact", [False, True])
def test_distance_of_two_sets(ms, points, exact):
    found = ms.apply_filter(filters.SETS, source_layer=1, exact=exact, **points.parameters)
    full = straight(points.at, BESIDE * [1, 1, 0])
    to_second, to_first = full.min(axis=1), full.min(axis=0)
    near = {"rtol": 1e-9 if exact else 1e-2, "atol": 1e-9}
    np.testing.assert_allclose(found["distances"], to_second, **near)
    np.testing.assert_allclose(found["nearest"], full.min(), **near)
    np.testing.assert_allclose(found["mean"], (to_second.mean() + to_first.mean()) / 2, **near)
    np.testing.assert_allclose(found["hausdorff"], max(to_second.max(), to_first.max()), **near)
    np.testing.assert_array_equal(found["vertices"], points.numbers)
    assert found["snap_distance"] == pytest.approx(0.25)


def test_voronoi_regions_and_borders(ms, points):
    found = ms.apply_filter(filters.VORONOI, exact=True, **points.parameters)
    assert (layer_count(ms), ms.current_mesh_id()) == (3, 0)
    nearest = straight(VERTICES, points.at)
    region = ms.current_mesh().vertex_scalar_array().astype(int)
    np.testing.assert_allclose(nearest[np.arange(len(region)), region], nearest.min(axis=1))
    np.testing.assert_allclose(found["areas"].sum(), 12)
    assert found["regions"] == 4
    borders = ms.mesh(2)
    assert borders.edge_number() > 10
    two = np.sort(straight(borders.vertex_matrix(), points.at), axis=1)[:, :2]
    np.testing.assert_allclose(two[:, 0], two[:, 1], atol=1e-9)
    centre = straight(VERTICES[FACES].mean(axis=1), points.at)
    clear = np.sort(centre, axis=1)
    of_first = (clear[:, 1] - clear[:, 0] > 0.3) & (centre.argmin(axis=1) == 0)
    assert len(np.unique(ms.current_mesh().face_color_matrix()[of_first], axis=0)) == 1
    ms.apply_filter(filters.VORONOI, borders=False, **points.parameters)
    assert layer_count(ms) == 3


def test_farthest_samples_begin_with_the_points(ms, points):
    found = ms.apply_filter(filters.FARTHEST, sample_number=12, from_selection=True, exact=True, **points.parameters)
    samples = ms.current_mesh()
    assert layer_count(ms) == 3
    assert samples.vertex_number() == found["samples"] == 12
    assert samples.face_number() == 0
    at = samples.vertex_matrix()
    np.testing.assert_allclose(at[:4], points.at, atol=1e-12)
    np.testing.assert_array_equal(found["vertices"][:4], SELECTED if not points.parameters else [-1] * 4)
    np.testing.assert_array_equal(at[4:], VERTICES[found["vertices"][4:].astype(int)])
    np.testing.assert_allclose(straight(at[4:5], at[:4]).min(), straight(VERTICES, at[:4]).min(axis=1).max())
    np.testing.assert_allclose(found["covering_radius"], straight(VERTICES, at).min(axis=1).max())


def test_poisson_disk_sampling_is_spaced_and_maximal(ms):
    found = ms.apply_filter(filters.POISSON, radius=length(0.7), exact=True, seed=4)
    at = VERTICES[found["vertices"].astype(int)]
    assert straight(at, at)[np.triu_indices(len(at), 1)].min() >= 0.7 - 1e-6
    assert straight(VERTICES, at).min(axis=1).max() < 0.7 + 1e-6
    assert ms.current_mesh().vertex_number() == found["samples"] == len(at)


def test_layers_lie_where_the_sampled_layer_lies(ms):
    matrix = np.array([[2, 0, 0, 5], [0, 2, 0, 6], [0, 0, 2, 7], [0, 0, 0, 1.0]])
    ms.apply_filter("set_matrix", transformmatrix=matrix, freeze=False)
    ms.apply_filter(filters.POISSON, radius=length(1.0))
    local = ms.current_mesh().vertex_matrix().copy()
    ms.apply_filter("apply_matrix_freeze")
    np.testing.assert_allclose(ms.current_mesh().vertex_matrix(), 2 * local + [5, 6, 7])


def test_lloyd_relaxation_lowers_the_energy(ms, points):
    found = ms.apply_filter(filters.LLOYD, rounds=8, exact=True, **points.parameters)
    assert found["energy_after"] < found["energy_before"]
    assert 1 <= found["rounds"] <= 8
    np.testing.assert_array_equal(ms.current_mesh().vertex_matrix(), VERTICES[found["vertices"].astype(int)])


@pytest.mark.parametrize("median", [False, True])
def test_mean_of_points_of_the_plane(ms, points, median):
    found = ms.apply_filter(filters.MEAN, median=median, **points.parameters)
    assert (layer_count(ms), ms.current_mesh().vertex_number()) == (3, 1)
    at = ms.current_mesh().vertex_matrix()[0]
    steps = points.at - at
    distance = np.linalg.norm(steps, axis=1)
    pull = steps / distance[:, None] if median else steps
    np.testing.assert_allclose(pull.sum(axis=0), 0, atol=1e-6)  # what the least sum is known by
    assert found["energy"] == pytest.approx((distance ** (1 if median else 2)).sum(), rel=1e-9)
    assert (found["vertex"], found["snap_distance"]) == (-1, pytest.approx(points.moved))
    corners = VERTICES[FACES[found["face"]]]
    assert (corners.min(axis=0) <= at + 1e-9).all()
    assert (at <= corners.max(axis=0) + 1e-9).all()


def test_mean_at_a_vertex_and_of_two_components():
    ms = mesh_set(*side_by_side((VERTICES, FACES), (VERTICES, FACES)))
    found = ms.apply_filter(filters.MEAN, surface_points="110; 111; 112")
    assert (found["vertex"], found["face"]) == (111, -1)
    ms.set_current_mesh(0)
    with fails_and_changes_nothing(ms, "No path leads from point 0 (vertex 7) to point 1 (vertex 400)"):
        ms.apply_filter(filters.MEAN, surface_points="7; 400")


def test_disk_selects_vertices_and_faces(ms, points):
    for around, at in ((points.parameters, points.at), ({"vertex_index": 170}, VERTICES[[170]])):
        select_vertices(ms, SELECTED)
        found = ms.apply_filter(filters.DISK, radius=length(0.5), exact=True, **around)
        inside = straight(VERTICES, at).min(axis=1) <= 0.5
        np.testing.assert_array_equal(ms.current_mesh().vertex_selection_array(), inside)
        np.testing.assert_array_equal(ms.current_mesh().face_selection_array(), inside[FACES].all(axis=1))
        assert found["selected_vertices"] == inside.sum()


def test_area_of_disks_of_the_plane(ms, points):
    radius = 0.15  # the disks are apart; of those around vertices on the upper border half is there
    disks = np.where(points.at[:, 1] > 3 - 1e-9, 0.5, 1.0).sum()
    found = ms.apply_filter(filters.AREA, radius=length(radius), exact=True, **points.parameters)
    assert found["area"] == pytest.approx(disks * np.pi * radius**2, rel=1e-4)
    assert found["border_length"] == pytest.approx(disks * 2 * np.pi * radius, rel=1e-4)
    assert found["snap_distance"] == pytest.approx(points.moved)
    found = ms.apply_filter(filters.AREA, radius=length(1.2), vertex_index=7 * 21 + 10, exact=True)
    assert found["area"] == pytest.approx(np.pi * 1.2**2, rel=1e-4)


@pytest.mark.parametrize("exact", [False, True])
def test_area_of_a_band_round_a_line(ms, exact):
    line, width = np.array([[1.0, 1.1, 0.2], [2.6, 1.9, 0.1]]), 0.3
    ms.add_mesh(pymeshlab.Mesh(vertex_matrix=line, edge_matrix=np.array([[0, 1]])), set_as_current=False)
    found = ms.apply_filter(filters.BAND, curve_layer=2, width=length(width), spacing=length(0.01), exact=exact)
    along = np.linalg.norm((line[1] - line[0])[:2])
    assert found["area"] == pytest.approx(2 * width * along + np.pi * width**2, rel=1e-3)
    assert found["border_length"] == pytest.approx(2 * along + 2 * np.pi * width, rel=3e-3)
    assert found["snap_distance"] == pytest.approx(0.2)


@pytest.mark.parametrize("edges", [None, [[0, 1], [1, 2]], [[2, 1], [0, 1]]])
def test_a_band_follows_the_shortest_paths_between_far_points(edges):
    """Over the ridge of a roof, which is laid out flat: a straight band, though the line in space runs below."""
    vertices, faces = grid(20, 15, 0.2)
    vertices[:, 2] = -np.abs(vertices[:, 0] - 2)
    ms = mesh_set(vertices, faces)
    slope, width = np.sqrt(2), 0.3
    line = np.array([[1.0, 0.8, -1.0], [3.0, 1.6, -1.0], [3.4, 1.76, -1.4]])  # laid out on one straight line
    lines = {} if edges is None else {"edge_matrix": np.array(edges)}
    ms.add_mesh(pymeshlab.Mesh(vertex_matrix=line, **lines), set_as_current=False)
    found = ms.apply_filter(filters.BAND, curve_layer=1, width=length(width), spacing=length(0.01), exact=True)
    along = np.hypot(2.4 * slope, 0.96)
    assert found["area"] == pytest.approx(2 * width * along + np.pi * width**2, rel=1e-3)
    assert found["border_length"] == pytest.approx(2 * along + 2 * np.pi * width, rel=3e-3)
    assert found["snap_distance"] == pytest.approx(0, abs=1e-6)


def test_area_of_a_band_round_selected_edges():
    """The ridge of a roof: a strip on either side, as long as the ridge."""
    vertices, faces = grid(20, 15, 0.2)
    vertices[:, 2] = -np.abs(vertices[:, 0] - 2)
    ms = mesh_set(vertices, faces)
    ms.apply_filter("compute_selection_crease_per_edge", angledegneg=-30, angledegpos=30)
    found = ms.apply_filter(filters.BAND, width=length(0.5), spacing=length(0.01))
    assert found["area"] == pytest.approx(3, rel=1e-3)
    assert found["border_length"] == pytest.approx(6, rel=1e-3)


CORNERS = BESIDE[[0, 2, 1, 3]] * [1, 1, 0]  # in an order in which sides do not cross


def is_in_polygon(points):
    """Strictly inside, to the left of all sides of CORNERS."""
    sides = np.roll(CORNERS, -1, axis=0) - CORNERS
    steps = points[..., None, :] - CORNERS
    return (sides[:, 0] * steps[..., 1] - sides[:, 1] * steps[..., 0] > 1e-12).all(axis=-1)


@pytest.mark.parametrize("by", ["layer", "text"])
@pytest.mark.parametrize("cut_out", [False, True])
def test_polygon_of_the_plane(by, cut_out):
    ms = with_attributes(VERTICES, FACES, VERTICES[:, 0])
    ms.add_mesh(pymeshlab.Mesh(BESIDE[[0, 2, 1, 3]]), set_as_current=False)
    given = {"point_layer": 1} if by == "layer" else {"surface_points": as_text(CORNERS)}
    found = ms.apply_filter(filters.POLYGON, cut_out=cut_out, **given)
    after, before = np.roll(CORNERS, -1, axis=0), np.roll(CORNERS, 1, axis=0)
    area = (CORNERS[:, 0] * after[:, 1] - CORNERS[:, 1] * after[:, 0]).sum() / 2
    perimeter = np.linalg.norm(after - CORNERS, axis=1).sum()
    assert found["area"] == pytest.approx(area, rel=1e-9)
    assert found["perimeter"] == pytest.approx(perimeter, rel=1e-9)
    ahead, back = after - CORNERS, before - CORNERS
    cosine = (ahead * back).sum(axis=1) / np.linalg.norm(ahead, axis=1) / np.linalg.norm(back, axis=1)
    np.testing.assert_allclose(found["angles"], np.arccos(cosine), rtol=1e-9)
    assert abs(found["curvature"]) + abs(found["gauss_bonnet"]) < 1e-9
    assert found["snap_distance"] == pytest.approx(0.25 if by == "layer" else 0)
    np.testing.assert_array_equal(found["vertices"], range(4))
    inside = is_in_polygon(VERTICES[FACES]).all(axis=1)
    np.testing.assert_array_equal(ms.mesh(0).face_selection_array(), inside)
    assert found["selected_faces"] == inside.sum()
    border = ms.mesh(2)
    assert border.edge_number() == border.vertex_number() - 1
    assert border.vertex_scalar_array()[-1] == pytest.approx(perimeter, rel=1e-9)
    np.testing.assert_allclose(border.vertex_matrix()[[0, -1]], CORNERS[[0, 0]], atol=1e-9)
    assert (layer_count(ms), ms.current_mesh_id()) == ((4, 3) if cut_out else (3, 2))
    if cut_out:
        part = ms.mesh(3)
        assert areas(part.vertex_matrix(), part.face_matrix()).sum() == pytest.approx(area, rel=1e-9)
        assert is_in_polygon(part.vertex_matrix()[part.face_matrix()].mean(axis=1)).all()
        assert_attributes_are_kept(part, ms.mesh(0))


def test_polygon_around_a_corner_of_a_box():
    """A triangle with three right angles more than the plane has: the curvature of the corner is pi / 2."""
    ms = mesh_set(np.eye(4, 3, -1), np.array([[0, 1, 2], [0, 2, 3], [0, 3, 1]]))
    found = ms.apply_filter(filters.POLYGON, surface_points="0 0.5 0.5 0; 0 0.5 0 0.5; 1 0.5 0 0.5")
    assert found["curvature"] == pytest.approx(np.pi / 2, rel=1e-9)
    np.testing.assert_allclose(found["angles"], np.pi / 2, rtol=1e-9)
    assert found["area"] == pytest.approx(3 / 8, rel=1e-9)
    assert found["perimeter"] == pytest.approx(4.5**0.5, rel=1e-9)


@pytest.mark.parametrize("closed", [False, True])
def test_path_through_points_in_their_order(ms, points, closed):
    found = ms.apply_filter(filters.PATH_THROUGH, closed=closed, **points.parameters)
    passed = points.at[[0, 1, 2, 3, 0]] if closed else points.at
    legs = np.linalg.norm(np.diff(passed, axis=0), axis=1)
    assert found["length"] == pytest.approx(legs.sum(), rel=1e-9)
    assert found["certified"]
    assert found["snap_distance"] == pytest.approx(points.moved)
    path = ms.current_mesh()
    assert path.edge_number() == found["points"] - 1
    along = path.vertex_scalar_array()
    for place, walked in zip(passed, np.concatenate([[0], np.cumsum(legs)]), strict=True):
        there = np.linalg.norm(path.vertex_matrix() - place, axis=1) < 1e-9
        assert np.abs(along[there] - walked).min() < 1e-9


@pytest.mark.parametrize("closed", [False, True])
def test_a_smooth_curve_in_the_plane_is_a_spline(ms, closed):
    """That of Catmull and Rom, by cubic Bezier curves."""
    through = BESIDE * [0.5, 0.5, 1] + [1, 1, 0]
    ms.add_mesh(pymeshlab.Mesh(through), set_as_current=False)
    found = ms.apply_filter(filters.SMOOTH, point_layer=2, closed=closed, samples=5)
    p = through * [1, 1, 0]
    onwards, back = np.roll(p, -1, axis=0) - p, np.roll(p, 1, axis=0) - p
    direction = (onwards - back) / 2
    if not closed:
        direction[0], direction[-1] = onwards[0], -back[-1]
    t = np.arange(5)[:, None] / 5
    parts = []
    for i, j in zip(range(4 if closed else 3), (1, 2, 3, 0), strict=False):
        control = p[i], p[i] + direction[i] / 3, p[j] - direction[j] / 3, p[j]
        parts.append(sum(c * (1 - t) ** (3 - k) * t**k * (1, 3, 3, 1)[k] for k, c in enumerate(control)))
    samples = np.concatenate([*parts, p[[0 if closed else 3]]])
    curve = ms.current_mesh()
    np.testing.assert_allclose(straight(samples, curve.vertex_matrix()).min(axis=1), 0, atol=1e-9)
    length_between = np.linalg.norm(np.diff(samples, axis=0), axis=1).sum()
    assert found["length"] == pytest.approx(length_between, rel=1e-9)
    assert curve.vertex_scalar_array()[-1] == pytest.approx(length_between, rel=1e-9)
    assert found["snap_distance"] == pytest.approx(0.25)


@pytest.mark.parametrize("degrees", [0, 120])
def test_cut_locus_of_points_of_the_plane(ms, points, degrees):
    """The borders of their Voronoi regions, where two of them are seen in different directions."""
    found = ms.apply_filter(filters.CUT_LOCUS, min_angle=degrees, **points.parameters)
    lines = ms.current_mesh()
    assert lines.edge_number() == found["segments"] > 10
    at = lines.vertex_matrix()
    apart = straight(at, points.at)
    nearest = np.argsort(apart, axis=1)[:, :2]
    two = np.take_along_axis(apart, nearest, axis=1)
    np.testing.assert_allclose(two, np.repeat(lines.vertex_scalar_array()[:, None], 2, axis=1), atol=1e-9)
    ways = (points.at[nearest] - at[:, None]) / two[..., None]
    meeting = np.sort(apart, axis=1)[:, 2] - two[:, 1] < 1e-9  # of three lines
    seen = np.degrees(np.arccos(np.clip((ways[:, 0] * ways[:, 1]).sum(axis=1), -1, 1)))
    is_end = np.bincount(lines.edge_matrix().ravel(), minlength=len(at)) == 1
    assert seen[~meeting & is_end].min() >= degrees - 1e-6
    assert found["snap_distance"] == pytest.approx(points.moved)
    ms.set_current_mesh(0)
    borders = ms.apply_filter(filters.VORONOI, exact=True, **points.parameters)["border_length"]
    assert (found["length"] < 0.95 * borders) == (degrees > 0)
    if degrees == 0:
        assert found["length"] == pytest.approx(borders, rel=1e-6)


def test_numpy_writes_points_as_the_filters_read_them(ms):
    index = vorogeo.GeodesicIndex(*arrays(ms))
    points = index.snap(BESIDE)
    found = ms.apply_filter(filters.MATRIX, surface_points=points.to_text())
    np.testing.assert_allclose(found["distances"].reshape(4, 4), index.distance_matrix(points), rtol=1e-12)


def test_two_points_by_text_and_in_space(ms):
    found = ms.apply_filter(filters.TWO_POINTS, surface_points=as_text(BESIDE[[0, 3]]))
    assert found["distance"] == pytest.approx(np.linalg.norm(BESIDE[0] - BESIDE[3]), rel=1e-12)
    found = ms.apply_filter(filters.TWO_POINTS, source=-1, target=-1, source_point=BESIDE[0], target_point=BESIDE[1])
    assert found["distance"] == pytest.approx(np.linalg.norm((BESIDE[0] - BESIDE[1])[:2]), rel=1e-6)
    assert found["target_snap_distance"] == pytest.approx(0.25, rel=1e-6)


def test_isolines_of_a_distance_are_circles(ms):
    centre = 7 * 21 + 10
    ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=centre)
    found = ms.apply_filter(filters.ISOLINES, values="0.5 1.2")
    lines = ms.current_mesh()
    radius = np.linalg.norm(lines.vertex_matrix() - VERTICES[centre], axis=1)
    np.testing.assert_allclose(radius, lines.vertex_scalar_array(), atol=1e-9)
    np.testing.assert_allclose(found["length"], 2 * np.pi * 1.7, rtol=0.01)
    assert lines.edge_number() == found["segments"]
    np.testing.assert_array_equal(found["values"], [0.5, 1.2])


def test_isolines_end_where_no_distance_is():
    ms = mesh_set(*side_by_side(sphere(3), sphere(2)))
    ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=0)
    assert len(ms.apply_filter(filters.ISOLINES, line_number=3)["values"]) == 3
    assert ms.current_mesh().vertex_matrix()[:, 0].max() <= 1


def areas(vertices, faces):
    """Of triangles."""
    a, b, c = vertices[faces].transpose(1, 0, 2)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def with_attributes(vertices, faces, quality):
    """A layer whose attributes are linear functions of the place or constant; by face the number of the face."""
    numbers = np.arange(len(faces), dtype=float)
    ms = pymeshlab.MeshSet()
    mesh = pymeshlab.Mesh(
        vertex_matrix=vertices,
        face_matrix=faces,
        v_scalar_array=quality,
        f_scalar_array=numbers,
        v_color_matrix=np.column_stack([(vertices[:, :2] + 1) / 5, np.full((len(vertices), 2), 0.63)]),
        f_color_matrix=np.tile([0.2, 0.4, 0.6, 1.0], (len(faces), 1)),
    )
    ms.add_mesh(mesh)
    ms.compute_texcoord_by_function_per_vertex(u="x", v="y")
    corners = {f"{to}{i}": f"{of}{i} + fi" for i in range(3) for to, of in ("ux", "vy")}
    ms.compute_texcoord_by_function_per_wedge(**corners)
    return ms


def assert_attributes_are_kept(part, whole):
    """Those of with_attributes()."""
    at, corners = part.vertex_matrix(), part.face_matrix()
    np.testing.assert_allclose(part.vertex_normal_matrix(), np.tile([0, 0, 1], (len(at), 1)), atol=1e-9)
    colors = part.vertex_color_matrix() * 255
    np.testing.assert_allclose(colors[:, :2], (at[:, :2] + 1) * 51, atol=2)  # rounded before and after
    np.testing.assert_array_equal(np.unique(colors[:, 2:], axis=0), whole.vertex_color_matrix()[:1, 2:] * 255)
    np.testing.assert_allclose(part.vertex_tex_coord_matrix(), at[:, :2], atol=1e-6)
    face = part.face_scalar_array().astype(int)
    expected = at[corners].reshape(-1, 3)[:, :2] + face.repeat(3)[:, None]
    np.testing.assert_allclose(part.wedge_tex_coord_matrix(), expected, atol=1e-4)
    np.testing.assert_array_equal(part.face_color_matrix(), whole.face_color_matrix()[face])
    # Each face lies in the one whose number it has: to the left of its edges.
    a, b, c = whole.vertex_matrix()[whole.face_matrix()[face]][..., :2].transpose(1, 0, 2)
    for tail, head in ((a, b), (b, c), (c, a)):
        edge, step = (head - tail)[:, None], at[corners][..., :2] - tail[:, None]
        assert (edge[..., 0] * step[..., 1] - edge[..., 1] * step[..., 0] > -1e-9).all()


def test_a_cut_along_isolines_makes_parts_of_the_plane():
    centre = 7 * 21 + 10
    distance = np.linalg.norm(VERTICES - VERTICES[centre], axis=1)
    ms = with_attributes(VERTICES, FACES, distance)
    found = ms.apply_filter(filters.CUT, values="1.2 0.5 1.2")
    assert found["parts"] == 3
    assert (layer_count(ms), ms.current_mesh_id()) == (4, 3)
    np.testing.assert_array_equal(found["regions"], [0, 1, 2])
    np.testing.assert_array_equal(found["values"], [0.5, 1.2])
    parts = [ms.mesh(i) for i in (1, 2, 3)]
    sizes = [areas(part.vertex_matrix(), part.face_matrix()).sum() for part in parts]
    assert sum(sizes) == pytest.approx(12, rel=1e-9)
    np.testing.assert_allclose(sizes[:2], np.pi * np.array([0.25, 1.44 - 0.25]), rtol=0.02)
    for part, (low, high) in zip(parts, [(0, 0.5), (0.5, 1.2), (1.2, 9)], strict=True):
        assert_attributes_are_kept(part, ms.mesh(0))
        radius = np.linalg.norm(part.vertex_matrix() - VERTICES[centre], axis=1)
        assert low - 1e-9 <= radius.min()
        assert radius.max() <= high + 1e-9
        np.testing.assert_allclose(part.vertex_scalar_array(), radius, atol=0.025)  # linear between vertices
    np.testing.assert_array_equal(ms.mesh(0).vertex_matrix(), VERTICES)


def test_a_cut_by_quality_where_the_metric_splits_faces():
    vertices, faces = np.array([[0, 0, 0], [2, 0, 0], [1, 0.5, 0], [1, -1, 0.0]]), np.array([[0, 1, 2], [1, 0, 3]])
    ms = with_attributes(vertices, faces, np.array([5.0, 5, 2, 5]))
    found = ms.apply_filter(filters.CUT, values="3", is_distance=False, metric="Vertex quality as cost")
    np.testing.assert_array_equal(found["regions"], [0, 1])
    sizes = [areas(ms.mesh(i).vertex_matrix(), ms.mesh(i).face_matrix()).sum() for i in (1, 2)]
    # Below 3 is a third of the height of the upper face.
    np.testing.assert_allclose(sizes, [0.5 / 9, 1.5 - 0.5 / 9], rtol=1e-9)
    for i in (1, 2):
        assert_attributes_are_kept(ms.mesh(i), ms.mesh(0))


def test_what_has_no_distance_is_a_part_of_its_own():
    ms = mesh_set(*side_by_side(sphere(3), sphere(2)))
    ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=0)
    found = ms.apply_filter(filters.CUT, values="1")
    np.testing.assert_array_equal(found["regions"], [0, 1, -1])
    assert ms.current_mesh().face_number() == len(sphere(2)[1])
    assert ms.current_mesh().vertex_matrix()[:, 0].min() > 5


def test_a_cut_along_a_line_from_border_to_border():
    ms = with_attributes(VERTICES, FACES, VERTICES[:, 0])
    line = pymeshlab.Mesh(vertex_matrix=np.array([[0, 1.1, 0], [4, 1.3, 0.0]]), edge_matrix=np.array([[0, 1]]))
    ms.add_mesh(line, set_as_current=False)
    found = ms.apply_filter(filters.CUT_CURVE, curve_layer=1)
    assert found["parts"] == 2
    assert (layer_count(ms), ms.current_mesh_id()) == (4, 3)
    sizes = []
    for i in (2, 3):
        part = ms.mesh(i)
        assert part.face_number() == found["faces"][i - 2]
        sizes.append(areas(part.vertex_matrix(), part.face_matrix()).sum())
        assert_attributes_are_kept(part, ms.mesh(0))
        above = part.vertex_matrix()[:, 1] - (1.1 + 0.05 * part.vertex_matrix()[:, 0])
        assert min(above.max(), -above.min()) < 1e-9
    np.testing.assert_allclose(sorted(sizes), [4 * 1.2, 4 * 1.8], rtol=1e-9)


def test_a_cut_along_a_closed_curve_leaves_other_components_out():
    """Round a tube of ten sides."""
    vertices, faces = tube([1.0] * 7, sides=10)
    ms = mesh_set(*side_by_side((vertices, faces), sphere(2)))
    turn = 2 * np.pi * np.arange(30) / 30
    ring = np.column_stack([np.cos(turn), np.sin(turn), np.full(30, 2.3)])
    ms.add_mesh(
        pymeshlab.Mesh(vertex_matrix=ring, edge_matrix=np.column_stack([np.arange(30), np.roll(np.arange(30), -1)])),
        set_as_current=False,
    )
    assert ms.apply_filter(filters.CUT_CURVE, curve_layer=1)["parts"] == 2
    around = 20 * np.sin(np.pi / 10)
    sizes = [areas(ms.mesh(i).vertex_matrix(), ms.mesh(i).face_matrix()).sum() for i in (2, 3)]
    np.testing.assert_allclose(sorted(sizes), [2.3 * around, 3.7 * around], rtol=1e-9)


def test_a_curve_that_divides_nothing_is_refused(ms):
    line = pymeshlab.Mesh(vertex_matrix=np.array([[1, 1.1, 0], [3, 1.3, 0.0]]), edge_matrix=np.array([[0, 1]]))
    ms.add_mesh(line, set_as_current=False)
    with fails_and_changes_nothing(ms, "The curve does not divide the surface: the same part lies on both sides"):
        ms.apply_filter(filters.CUT_CURVE, curve_layer=2)
    assert layer_count(ms) == 3


def test_diameter_and_centre_bounds_hold():
    vertices, faces = sphere(2)
    ms = mesh_set(vertices, faces)
    eccentricity = [exact_distances(vertices, faces, [v]).max() for v in range(len(vertices))]
    for fields in (2, 10):
        found = ms.apply_filter(filters.EXTENT, fields=fields, exact=True)
        assert found["diameter_lower"] - 1e-9 <= max(eccentricity) <= found["diameter_upper"] + 1e-9
        assert found["radius_lower"] - 1e-9 <= min(eccentricity) <= found["radius_upper"] + 1e-9
        np.testing.assert_allclose(eccentricity[found["centre"]], found["radius_upper"])
        assert found["fields"] <= fields


def patches_by_color(faces: np.ndarray, colors: np.ndarray) -> np.ndarray:
    """Number of the connected set of equally coloured faces that each face lies in (faces meet at a vertex)."""
    corner_face = np.repeat(np.arange(len(faces)), 3)
    shares = coo_matrix((np.ones(faces.size), (corner_face, faces.ravel()))).tocsr()
    pairs = (shares @ shares.T).tocoo()
    same = np.all(colors[pairs.row] == colors[pairs.col], axis=1)
    graph = coo_matrix((np.ones(same.sum()), (pairs.row[same], pairs.col[same])), shape=(len(faces), len(faces)))
    return connected_components(graph, directed=False)[1]


@pytest.mark.parametrize("layer", [1, 2])
@pytest.mark.parametrize("mesh", [sphere(4), grid(50, 20)], ids=["sphere", "rectangle"])
def test_each_patch_is_one_connected_region_of_a_clear_colour(mesh, layer):
    vertices, faces = mesh
    ms = mesh_set(vertices, np.concatenate([faces, faces[:1]]))
    built = ms.apply_filter(filters.INDEX, n1=15, n2=6)
    result = ms.apply_filter(filters.PATCHES, layer=layer)
    assert result["patches"] == built["first_layer_patches" if layer == 1 else "second_layer_patches"]
    colors = ms.current_mesh().face_color_matrix() * 255
    np.testing.assert_allclose(colors[-1], [160, 160, 160, 255])  # a repeated face is in no patch
    assert patches_by_color(faces, colors[:-1]).max() + 1 == result["patches"]
    unique = np.unique(colors[:-1, :3], axis=0)
    assert len(unique) == result["colors"] >= 4
    assert straight(unique, unique)[~np.eye(len(unique), dtype=bool)].min() >= 60
    assert np.ptp(unique, axis=1).min() > 50  # no grey of any lightness
    np.testing.assert_array_equal(ms.current_mesh().vertex_scalar_array(), 0)
