"""Geodesic Voronoi regions tile the surface by the nearest point; disks hold what is within a radius."""

from __future__ import annotations

import ask
import numpy as np
import pytest
import table
from surfaces import Floats, Rng, Shape

#: Surfaces measured in space, where areas and borders can be computed from positions.
FLAT = [shape for shape in table.UNROLLED if shape.metric is None]


def area_of_faces(shape: Shape) -> Floats:
    """The area of each face in space; 0 for a face that is left out."""
    corner = shape.vertices[shape.faces]
    crossed = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    return np.linalg.norm(crossed, axis=1) / 2 * table.is_face(shape)


@table.asked(ask.TASKS, table.UNROLLED)
def test_each_vertex_belongs_to_its_nearest_point(by: str, shape: Shape, random: Rng) -> None:
    for points in (shape.sources, table.points_anywhere(shape, random, 4)):
        fields = shape.fields(points)
        regions = ask.task("voronoi", by, shape, points)
        ask.assert_answers(by, shape, regions.distance, fields.min(axis=0))
        reached = np.isfinite(fields.min(axis=0))
        np.testing.assert_array_equal(regions.vertex_region == -1, ~reached)
        of_region = fields[regions.vertex_region[reached], np.flatnonzero(reached)]
        slack = 2 * ask.errors(by, shape).largest
        assert (of_region <= fields.min(axis=0)[reached] * (1 + slack) + 1e-9).all()


@table.asked(ask.TASKS, [s for s in table.SHAPES if s.metric is None])
def test_regions_tile_what_their_points_reach(by: str, shape: Shape) -> None:
    regions = ask.task("voronoi", by, shape, shape.sources)
    areas = area_of_faces(shape)
    assert regions.area.sum() == pytest.approx(areas.sum(), rel=1e-9)
    assert (regions.area > 0).all()
    np.testing.assert_array_equal(regions.face_region == -1, ~table.is_face(shape))
    assert len(regions.face_region) == len(shape.faces)


@table.asked(ask.TASKS, table.UNROLLED)
def test_a_disk_holds_what_is_within_its_radius(by: str, shape: Shape) -> None:
    sources = shape.sources[:2]
    expected = shape.fields(sources).min(axis=0)
    radius = 0.37 * expected[np.isfinite(expected)].max()
    disk = ask.task("disk", by, shape, sources, radius)
    slack = ask.errors(by, shape).largest
    inside = np.isin(np.arange(len(expected)), disk.vertices)
    assert (expected[inside] <= radius * (1 + slack)).all()
    assert (expected[~inside] >= radius * (1 - slack)).all()
    np.testing.assert_allclose(disk.distances, expected[disk.vertices], rtol=slack, atol=1e-12)
    assert (disk.distances <= radius).all()
    within = np.isin(shape.faces, disk.vertices).all(axis=1) & table.is_face(shape)
    np.testing.assert_array_equal(disk.faces, np.flatnonzero(within))


@table.asked(ask.TASKS, [s for s in FLAT if s.name != "parts"])
def test_relaxation_never_raises_the_energy(by: str, shape: Shape) -> None:
    relaxed = ask.task("relax", by, shape, [0, 1, 2, 3], 4)
    assert relaxed.energy[-1] < relaxed.energy[0]
    assert (np.diff(relaxed.energy) <= 0).all()
    assert len(set(relaxed.vertices.tolist())) == 4
    still = ask.task("relax", by, shape, [0, 1, 2, 3], 0)
    np.testing.assert_array_equal(still.vertices, [0, 1, 2, 3])
