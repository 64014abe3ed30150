"""Cutting leaves a surface as it is, in more faces; bands hold the area within a distance."""

from __future__ import annotations

import ask
import numpy as np
import pytest
import table
import vorogeo
from surfaces import Floats, Ids, Shape

LENGTHS = table.LENGTHS


def areas(vertices: Floats, faces: Ids) -> Floats:
    """The area of each face in space."""
    corner = vertices[faces]
    return np.linalg.norm(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1) / 2


def assert_same_surface(shape: Shape, cut: vorogeo.CutMesh) -> None:
    """Each face keeps its area, and new vertices lie where their points say."""
    count = len(shape.vertices)
    np.testing.assert_array_equal(cut.vertices[:count], shape.vertices)
    np.testing.assert_allclose(
        cut.points.positions(shape.vertices, shape.faces), cut.vertices[count:], atol=1e-12, rtol=0
    )
    parts = np.bincount(cut.input_faces, areas(cut.vertices, cut.faces), len(shape.faces))
    expected = areas(shape.vertices, shape.faces) * table.is_face(shape)
    np.testing.assert_allclose(parts, expected, atol=1e-12 * expected.sum(), rtol=0)


@pytest.mark.parametrize("shape", LENGTHS, ids=str)
def test_a_cut_at_levels_leaves_the_surface_as_it_is(shape: Shape) -> None:
    field = ask.field("exact", shape, shape.sources[:1])
    cut = ask.surface(shape).cut_at_levels(field, 4)
    assert_same_surface(shape, cut)
    finite = np.isfinite(field[shape.faces[cut.input_faces]]).all(axis=1)
    np.testing.assert_array_equal(cut.region == -1, ~finite)
    assert set(cut.region[finite].tolist()) == set(range(5))
    vertices, faces, kept = cut.part(2)
    np.testing.assert_array_equal(vertices, cut.vertices[kept])
    assert areas(vertices, faces).sum() == pytest.approx(areas(cut.vertices, cut.faces)[cut.region == 2].sum())


@pytest.mark.parametrize("shape", LENGTHS, ids=str)
def test_a_cut_along_paths_leaves_the_surface_as_it_is(shape: Shape) -> None:
    paths = [path for path in ask.path("exact", shape, shape.sources[0], shape.sources[1:]) if len(path.points)]
    cut = ask.surface(shape).cut(paths)
    assert_same_surface(shape, cut)
    alone = ask.surface(shape).cut(paths[0])
    ends = alone.vertices[alone.edges]
    assert np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum() == pytest.approx(paths[0].length, rel=1e-9)
    assert (alone.side == 1).any()
    assert (alone.side == -1).any()


def test_lines_and_cuts_can_be_cancelled() -> None:
    shape = table.named("plane")
    surface = ask.surface(shape)
    for question in (
        lambda: surface.cut(surface.path(0, 50), progress=lambda *_: False),
        lambda: surface.cut_at_levels(shape.vertices[:, 0], 3, progress=lambda *_: False),
        lambda: surface.isolines(shape.vertices[:, 0], 3, progress=lambda *_: False),
        lambda: surface.convex_hull([0, 50, 90, 130], progress=lambda *_: False),
        lambda: surface.path_through([0, 50, 90], guides=True, progress=lambda *_: False),
    ):
        with pytest.raises(vorogeo.Cancelled):
            question()


@pytest.mark.parametrize("by", ask.TASKS)
def test_the_disk_of_a_plane_has_the_area_of_a_circle(by: str) -> None:
    shape = table.named("plane")
    middle = ask.surface(shape).snap(shape.vertices.mean(axis=0))
    size = np.ptp(shape.vertices, axis=0)[:2].min()
    radius = 0.3 * size
    error = 2e-2 if by == "index" else 1e-6
    assert ask.task("disk_area", by, shape, middle, radius) == pytest.approx(np.pi * radius**2, rel=error)
    band = ask.task("band", by, shape, middle, radius)
    assert band.area == pytest.approx(np.pi * radius**2, rel=error)
    assert band.border_length == pytest.approx(2 * np.pi * radius, rel=error)


def test_a_band_around_a_curve_has_ends_that_are_half_disks() -> None:
    x, y = np.meshgrid(np.linspace(0, 4, 41), np.linspace(0, 2, 21))
    vertices = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    corner = (np.arange(20)[:, None] * 41 + np.arange(40)).ravel()
    faces = np.vstack(
        [np.column_stack([corner, corner + 1, corner + 42]), np.column_stack([corner, corner + 42, corner + 41])]
    )
    curve = vorogeo.EdgeCurve(10 * 41 + np.arange(10, 31), spacing=0.01)  # from x = 1 to x = 3
    band = vorogeo.Surface(vertices, faces).band(curve, 0.5)
    sag = 2 * 2 * 0.01**2 / (8 * 0.5)
    assert band.area == pytest.approx(2 * 2 * 0.5 + np.pi * 0.25, abs=sag + 1e-6)
    assert band.border_length == pytest.approx(4 + np.pi, rel=1e-3)


def test_a_path_is_a_source_like_a_curve(random: np.random.Generator) -> None:
    """The band around a segment of length L in a plane: 2 L w + pi w^2 and 2 L + 2 pi w."""
    shape = table.named("plane")
    low, size = shape.vertices.min(axis=0), np.ptp(shape.vertices, axis=0)
    surface, width = ask.surface(shape), 0.1 * size[:2].min()
    ends = low + size * np.column_stack([random.uniform(0.2, 0.8, (2, 2)), np.zeros(2)])
    path = surface.path(*[surface.snap(end) for end in ends])
    length = np.linalg.norm(ends[1] - ends[0])
    band = surface.band(path, width, method="exact")
    dents = 2 / 3200
    assert band.area == pytest.approx(2 * length * width + np.pi * width**2, rel=dents)
    assert band.border_length == pytest.approx(2 * length + 2 * np.pi * width, rel=20 * dents)
    assert surface.disk_area(path, width, method="exact") == band.area
    along = np.clip((shape.vertices - ends[0]) @ (ends[1] - ends[0]) / max(length**2, 1e-300), 0, 1)
    away = np.linalg.norm(shape.vertices - ends[0] - np.outer(along, ends[1] - ends[0]), axis=1)
    field, label = surface.distance_field([0, path], method="exact", return_labels=True)
    typical = np.median(np.linalg.norm(np.diff(shape.vertices[shape.faces], axis=1), axis=2))
    from_corner = np.linalg.norm(shape.vertices - shape.vertices[0], axis=1)
    assert (field >= np.minimum(away, from_corner) - 1e-9).all()
    assert (field <= np.minimum(away, from_corner) + 0.25 * typical).all()
    np.testing.assert_array_equal(label[away > from_corner + typical], 0)
    np.testing.assert_array_equal(label[from_corner > away + typical], 1)
    apart = surface.set_distances(path, [0], method="exact")
    assert away[0] - 1e-9 <= apart.nearest <= away[0] + 0.25 * typical
    none = vorogeo.GeodesicPath(
        path.points[:0], np.inf, path.vertices[:0], path.surface_points[:0], False, path.over_gap[:0]
    )
    with pytest.raises(vorogeo.InvalidInput, match=r"sources\[1\]: is a path without points"):
        surface.band([3, none], width)
    with pytest.raises(vorogeo.InvalidInput, match=r"sources\[0\]: is a path of length .*, too long for points"):
        surface.disk_area(path, 1e-5 * length)


@pytest.mark.parametrize("by", ["exact", "by index, exact", "index", "automatic"])
def test_a_polygon_of_a_plane_is_the_flat_one(by: str) -> None:
    shape = table.named("plane")
    low, size = shape.vertices.min(axis=0), np.ptp(shape.vertices, axis=0)
    corners = low + size * [[0.1, 0.2, 0], [0.9, 0.15, 0], [0.7, 0.8, 0], [0.3, 0.85, 0]]
    polygon = ask.task("polygon", by, shape, ask.surface(shape).snap(corners))
    x, y, _ = corners.T
    area = abs(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))) / 2
    assert polygon.area == pytest.approx(area, rel=1e-9)
    assert polygon.perimeter == pytest.approx(np.linalg.norm(corners - np.roll(corners, -1, axis=0), axis=1).sum())
    assert polygon.angles.sum() == pytest.approx(2 * np.pi)
    assert polygon.gauss_bonnet == pytest.approx(0, abs=1e-9)
    cut = ask.surface(shape).cut(polygon.legs)
    parts = np.bincount(cut.region, areas(cut.vertices, cut.faces))
    assert sorted(parts) == pytest.approx(sorted([area, size[0] * size[1] - area]))


@pytest.mark.parametrize("margin", [0.05, 0.0])
def test_the_inside_of_a_polygon_is_the_side_without_border(margin: float) -> None:
    shape = table.named("plane")
    low, size = shape.vertices.min(axis=0), np.ptp(shape.vertices, axis=0)
    corners = low + size * np.abs(np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]) - [margin, margin, 0])
    polygon = ask.surface(shape).polygon(ask.surface(shape).snap(corners))
    assert polygon.area == pytest.approx((1 - 2 * margin) ** 2 * size[0] * size[1], rel=1e-9)
    assert polygon.angles == pytest.approx(np.full(4, np.pi / 2))
    assert polygon.gauss_bonnet == pytest.approx(0, abs=1e-9)


def test_a_disk_of_almost_no_radius_has_almost_no_area() -> None:
    shape = table.named("plane")
    surface = ask.surface(shape)
    for radius in (1e-9, 1e-15, 1e-16, 1e-300):
        assert 0 <= surface.disk_area(surface.snap(shape.vertices.mean(axis=0)), radius) <= 1e-15


def test_sets_are_as_far_apart_as_their_points() -> None:
    shape = table.named("plane")
    first, second = shape.sources[:2], shape.sources[2:]
    found = ask.task("set_distances", "exact", shape, first, second)
    expected = shape.between(shape.vertices[first], shape.vertices[second])
    np.testing.assert_allclose(found.to_second, expected.min(axis=1), rtol=1e-9)
    np.testing.assert_allclose(found.to_first, expected.min(axis=0), rtol=1e-9)
    assert found.nearest == pytest.approx(expected.min())
    assert found.hausdorff == pytest.approx(max(expected.min(axis=1).max(), expected.min(axis=0).max()))
