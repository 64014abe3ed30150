"""Convex hulls of points on a surface, against those of scipy where the surface is unrolled or seen from its centre."""

from __future__ import annotations

import ask
import numpy as np
import pytest
import table
import vorogeo
from scipy.spatial import ConvexHull
from surfaces import Floats, Rng, Shape


def assert_is_hull_of(found: vorogeo.GeodesicPolygon, places: Floats) -> None:
    """The hull has the corners, area and perimeter of the hull of these points of the plane."""
    hull = ConvexHull(places)
    in_doubt = list(set(found.corners) ^ set(hull.vertices))  # on a side, but for rounding
    assert (np.abs((places[in_doubt] @ hull.equations[:, :2].T + hull.equations[:, 2]).max(axis=1)) < 1e-9).all()
    assert found.area == pytest.approx(hull.volume, rel=1e-9)
    assert found.perimeter == pytest.approx(hull.area, rel=1e-9)
    assert found.gauss_bonnet == pytest.approx(0, abs=1e-7)  # of thousands of needles
    assert (found.angles < np.pi + 1e-6).all()


@table.asked(ask.TASKS, [shape for shape in table.LENGTHS if shape.name in ("plane", "needles", "repeats")])
def test_in_a_plane_it_is_the_hull_of_the_plane(by: str, shape: Shape, random: Rng) -> None:
    anywhere = table.points_anywhere(shape, random, 40)
    found = ask.task("convex_hull", by, shape, anywhere)
    assert_is_hull_of(found, anywhere.positions(shape.vertices, shape.faces)[:, :2])
    ids = random.permutation(len(shape.vertices))[:60]
    turned = ask.task("convex_hull", by, shape, ids)
    # Border vertices lie on straight lines, on which only the outermost are corners of a hull.
    assert turned.area == pytest.approx(ConvexHull(shape.vertices[ids, :2]).volume, rel=1e-9)


def test_on_a_tube_it_is_that_of_the_unrolled_points(random: Rng) -> None:
    shape = table.named("prism")
    side = 2 * np.sin(np.pi / 12)
    for _ in range(3):
        turn, height = random.uniform(0, 5.3, 25), random.uniform(0.5, 3.5, 25)  # of twelve sides
        corner, along = np.floor(turn), turn % 1
        ends = [np.cos(angle) + 1j * np.sin(angle) for angle in (corner * np.pi / 6, (corner + 1) * np.pi / 6)]
        place = ends[0] * (1 - along) + ends[1] * along
        points = ask.surface(shape).snap(np.column_stack([place.real, place.imag, height]))
        found = ask.task("convex_hull", "exact", shape, points)
        assert_is_hull_of(found, np.column_stack([side * turn, height]))


def test_on_a_sphere_it_is_that_of_the_points_seen_from_its_centre(random: Rng) -> None:
    step = np.arange(4000) + 0.5
    height, turn = 1 - step / 2000, np.pi * (1 + np.sqrt(5)) * step
    around = np.sqrt(1 - height**2)
    vertices = np.column_stack([around * np.cos(turn), around * np.sin(turn), height])
    faces = ConvexHull(vertices).simplices  # turned either way
    surface = vorogeo.Surface(vertices, faces)
    place = np.column_stack([random.uniform(-0.6, 0.6, (30, 2)), np.ones(30)])
    points = surface.snap(place / np.linalg.norm(place, axis=1)[:, None])
    found = surface.convex_hull(points)
    seen = points.positions(vertices, faces)
    hull = ConvexHull(seen[:, :2] / seen[:, 2:])
    # Faces are flat, not spherical: points that lie this close to a side of the hull may be corners or not.
    assert len(set(found.corners) ^ set(hull.vertices)) <= 2
    on_sphere = seen[hull.vertices] / np.linalg.norm(seen[hull.vertices], axis=1)[:, None]
    arcs = np.arccos((on_sphere * np.roll(on_sphere, -1, axis=0)).sum(axis=1))
    assert found.perimeter == pytest.approx(arcs.sum(), rel=2e-3)
    assert (found.angles <= np.pi + 1e-6).all()


def test_a_bumpy_surface_has_hulls_that_hold_their_points(random: Rng) -> None:
    shape = table.named("bumpy")
    surface = vorogeo.Surface(shape.vertices, shape.faces)
    middle = np.linalg.norm(shape.vertices[:, :2] - shape.vertices[:, :2].mean(axis=0), axis=1)
    points = random.choice(np.flatnonzero(middle < 0.35), 12, replace=False)
    found = surface.convex_hull(points)
    corners = points[found.corners]
    assert found.perimeter == pytest.approx(
        sum(surface.distance(a, b, method="exact") for a, b in zip(corners, np.roll(corners, -1), strict=True))
    )
    assert (found.angles <= np.pi + 1e-6).all()
    within = set(found.vertices) | {vertex for leg in found.legs for vertex in leg.vertices}
    assert set(points) <= within
