"""Where a way back costs something else, tasks take the ways from points or, if asked, to them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import ask
import numpy as np
import pytest
import table
import vorogeo
from surfaces import Floats, Ids, Rng, Shape

BOTH = pytest.mark.parametrize("to", [False, True], ids=["from", "to"])
SHAPES = [*table.DRIFTS, table.named("plane")]  # where both ways cost the same, they are answered alike
asked = table.asked(["exact", "automatic"], SHAPES)


def ways(shape: Shape, points: Any, to: bool) -> Floats:
    """The costs of the ways from points to all vertices, or `to` the points; a row for each point."""
    chart = shape.charted(points)
    return shape.between(shape.chart, chart).T if to else shape.between(chart, shape.chart)


def some_points(shape: Shape, random: Rng, count: int) -> Ids:
    return random.choice(len(shape.vertices), count, replace=False).astype(np.int32)


@BOTH
@asked
def test_regions_are_those_reached_first_or_from_which_a_point_is_reached_first(
    by: str, shape: Shape, to: bool, random: Rng
) -> None:
    for points in (shape.sources, table.points_anywhere(shape, random, 4)):
        expected = ways(shape, points, to)
        regions = ask.task("voronoi", by, shape, points, to=to)
        ask.assert_answers(by, shape, regions.distance, expected.min(axis=0))
        reached = np.isfinite(expected.min(axis=0))
        of_region = expected[regions.vertex_region[reached], np.flatnonzero(reached)]
        np.testing.assert_allclose(of_region, expected.min(axis=0)[reached], rtol=2 * shape.slack, atol=1e-9)
        np.testing.assert_array_equal(regions.vertex_region == -1, ~reached)
        assert (regions.face_region[table.is_face(shape)] >= -1).all()


@BOTH
@asked
def test_disks_bands_and_eccentricities(by: str, shape: Shape, to: bool) -> None:
    source = int(shape.sources[1])
    expected = ways(shape, [source], to)[0]
    finite = np.isfinite(expected)
    radius = 0.4 * expected[finite].max() * (1 + 1e-7)
    disk = ask.task("disk", by, shape, source, radius, to=to)
    np.testing.assert_array_equal(disk.vertices, np.flatnonzero(expected <= radius))
    np.testing.assert_allclose(disk.distances, expected[disk.vertices], rtol=shape.slack, atol=1e-12)
    farthest, vertex = ask.task("eccentricity", by, shape, [source], to=to)
    assert farthest[0] == pytest.approx(expected[finite].max(), rel=shape.slack)
    assert expected[vertex[0]] == pytest.approx(farthest[0], rel=shape.slack)


@BOTH
@asked
def test_fields_and_the_nearest_points(by: str, shape: Shape, to: bool, random: Rng) -> None:
    ask.assert_answers(by, shape, ask.fields(by, shape, shape.sources, to=to), ways(shape, shape.sources, to))
    for counts in ((12, 5), (5, 12)):  # by a field of each query, and of each point
        points, queries = (some_points(shape, random, count) for count in counts)
        distances, places = ask.nearest(by, shape, points, queries, 3, to=to)
        matrix = ways(shape, points, to)[:, queries].T
        ask.assert_answers(by, shape, distances, np.sort(matrix, axis=1)[:, :3])
        there = places >= 0
        of_place = np.take_along_axis(matrix, np.maximum(places, 0), axis=1)
        np.testing.assert_allclose(of_place[there], distances[there], rtol=2 * shape.slack, atol=1e-9)


@asked
def test_matrices_hold_the_ways_from_rows_to_columns(by: str, shape: Shape, random: Rng) -> None:
    points = some_points(shape, random, 7)
    expected = shape.matrix(points, points)
    ask.assert_answers(by, shape, ask.matrix(by, shape, points), expected)
    for others in (points[:3], some_points(shape, random, 11)):  # fewer columns than rows, and more
        ask.assert_answers(by, shape, ask.matrix(by, shape, points, others), shape.matrix(points, others))
    radius = float(np.quantile(expected[np.isfinite(expected)], 0.6)) * (1 + 1e-7)
    pairs = ask.pairs_within(by, shape, points, radius)
    within = (expected <= radius) & ~np.eye(len(points), dtype=bool)
    np.testing.assert_array_equal(np.isfinite(pairs), within)
    np.testing.assert_allclose(pairs[within], expected[within], rtol=shape.slack)
    # No detour through another point is shorter.
    found = ask.matrix(by, shape, points)
    detours = (found[:, :, None] + found[None, :, :]).min(axis=1)
    assert (found <= detours * (1 + 2 * shape.slack) + 1e-12).all()


@BOTH
@asked
def test_farthest_samples_cover_the_surface(by: str, shape: Shape, to: bool) -> None:
    start = [int(shape.sources[0])]
    samples = ask.task("sample_farthest", by, shape, 6, start=start, to=to)
    rows, of_faces = ways(shape, samples.vertices, to), np.unique(shape.faces)
    ask.assert_answers(by, shape, samples.distance, rows.min(axis=0))
    assert samples.covering_radius == pytest.approx(rows[:, of_faces].min(axis=0).max(), rel=shape.slack)
    for k in range(1, 6):
        before = rows[:k].min(axis=0)
        assert samples.radius[k] == pytest.approx(before[samples.vertices[k]], rel=shape.slack)
        assert np.isinf(samples.radius[k]) or before[of_faces].max() <= samples.radius[k] * (1 + 2 * shape.slack)


@pytest.mark.parametrize("shape", table.DRIFTS, ids=str)
def test_a_drift_the_other_way_swaps_from_and_to(shape: Shape) -> None:
    metric = shape.metric
    assert isinstance(metric, vorogeo.FaceRanders)
    against = vorogeo.FaceRanders(metric.tensors, -np.asarray(metric.drift))
    back = vorogeo.Surface(shape.vertices, shape.faces, metric=against)
    there, here = ask.task("voronoi", "exact", shape, shape.sources), back.voronoi(shape.sources, to=True)
    np.testing.assert_array_equal(there.vertex_region, here.vertex_region)
    np.testing.assert_allclose(there.area, here.area, rtol=1e-9)
    np.testing.assert_allclose(
        ask.matrix("exact", shape, shape.sources), back.distance_matrix(shape.sources).T, rtol=1e-12, atol=1e-12
    )


#: Questions that make no sense there, or are not solved, by the first words of their refusal.
REFUSED: dict[str, Callable[[vorogeo.Surface], Any]] = {
    "Indexes": lambda s: s.build_index(),
    "Poisson-disk samplings": lambda s: s.sample_poisson_disk(0.5),
    "Lloyd relaxations": lambda s: s.relax([0, 5]),
    "Clusters": lambda s: s.k_medoids(2, [0, 5, 9]),
    "Medoids": lambda s: s.medoid([0, 5, 9]),
    "Means and medians": lambda s: s.frechet_mean([0, 5, 9]),
    "Distances of two sets": lambda s: s.set_distances([0], [5]),
    "Diameter and centre": lambda s: s.extent(),
    "Polygons": lambda s: s.polygon([0, 5, 60]),
    "Directions": lambda s: s.log_map(3),
    "Cut loci": lambda s: s.cut_locus(3),
    "Loops": lambda s: s.girth(3),
    "Signed distances": lambda s: s.signed_distance(np.arange(len(s.faces)) < 9),
}


@pytest.mark.parametrize("what", REFUSED)
@pytest.mark.parametrize("shape", table.DRIFTS[:1], ids=str)
def test_what_needs_both_ways_alike_is_refused_by_its_name(what: str, shape: Shape) -> None:
    with ask.refused(f"{what} need ways back that cost the same, and this metric goes one way"):
        REFUSED[what](ask.new_surface(shape))


def test_winds_and_slopes_of_faces_without_area_are_those_along_them() -> None:
    shape = table.named("plane")
    vertices, faces = shape.vertices, shape.faces
    row = np.flatnonzero(vertices[:, 1] == vertices[:, 1].min())[:3]
    more = np.vstack([faces, row[np.newaxis]]).astype(faces.dtype)
    windy = [vorogeo.travel_time(vertices, of, (0.2, 0.0, 1.5), 1.0) for of in (faces, more)]
    on_foot = [vorogeo.hiking_time(vertices, of) for of in (faces, more)]
    for (without, given), cost in ((windy, None), (on_foot, vorogeo.tobler(0.0))):
        field, expected = (
            vorogeo.Surface(vertices, of, metric=metric).distance_field(int(shape.sources[0]))
            for of, metric in ((more, given), (faces, without))
        )
        np.testing.assert_allclose(field, expected, rtol=1e-9)
        if cost is not None:
            length = shape.fields(shape.sources[:1])[0]
            np.testing.assert_allclose(field, cost * length, rtol=1e-9)
