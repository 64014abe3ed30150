"""A path runs over faces between exactly the points asked for, and is as long as their distance."""

from __future__ import annotations

import itertools
from typing import Any

import ask
import numpy as np
import pytest
import table
import vorogeo
from surfaces import Rng, Shape

#: By how much a refined path may be too long (it is never too short): twice the largest error in docs/figures.md.
REFINED = 3e-3


def assert_is_path(shape: Shape, path: Any, source: Any, target: Any) -> None:
    """The ends, the faces and the length of a path, from its points alone."""
    positions = path.surface_points.positions(shape.vertices, shape.faces)
    np.testing.assert_allclose(path.points, positions, atol=1e-9)
    for end, place in ((source, path.points[0]), (target, path.points[-1])):
        vertex = not isinstance(end, vorogeo.SurfacePoints)
        given = shape.vertices[end] if vertex else end.positions(shape.vertices, shape.faces)[0]
        np.testing.assert_allclose(place, given, atol=1e-12)
    at_vertex = path.vertices >= 0
    np.testing.assert_allclose(path.points[at_vertex], shape.vertices[path.vertices[at_vertex]], atol=1e-12)
    points = zip(path.surface_points.faces, path.surface_points.barycentric, strict=True)
    holding = [faces_with(shape, point) for point in points]
    assert all(one & other for one, other in itertools.pairwise(holding))
    assert not path.over_gap.any()


def faces_with(shape: Shape, point: tuple[Any, Any]) -> set[int]:
    """The faces that hold a point: those with all corners whose weight is not 0."""
    face, weights = point
    corners = shape.faces[face][weights > 1e-12]
    return set(np.flatnonzero(np.isin(shape.faces, corners).sum(axis=1) >= len(corners)).tolist())


def slack(by: str, shape: Shape) -> float:
    """By how much a path may be too long."""
    return shape.slack + (REFINED if by == "index" else 0)


@table.asked(ask.PATHS, [*table.SHAPES, *table.DRIFTS])
def test_paths_between_vertices_are_shortest(by: str, shape: Shape, random: Rng) -> None:
    source = random.choice(shape.sources, 6)
    target = random.integers(0, len(shape.vertices), 6)
    for a, b, path in zip(source, target, ask.path(by, shape, source, target), strict=True):
        expected = shape.matrix([a], [b])[0, 0]
        if np.isinf(expected):
            assert path.length == np.inf
            assert path.points.shape == (0, 3)
            continue
        assert expected * (1 - shape.slack) - 1e-9 <= path.length <= expected * (1 + slack(by, shape)) + 1e-9
        if isinstance(shape.metric, vorogeo.EdgeLengths):
            assert np.isnan(path.points).all()
        else:
            assert_is_path(shape, path, a, b)
        if shape.metric is None:
            steps = np.linalg.norm(np.diff(path.points, axis=0), axis=1)
            assert steps.sum() == pytest.approx(path.length, rel=1e-12, abs=1e-12)


@table.asked(ask.PATHS, [s for s in table.UNROLLED if s.metric is None])
def test_paths_between_points_in_faces_are_shortest(by: str, shape: Shape, random: Rng) -> None:
    source, target = (table.points_anywhere(shape, random, 5) for _ in "ab")
    expected = np.diag(shape.between(shape.charted(source), shape.charted(target)))
    for i, path in enumerate(ask.path(by, shape, source, target)):
        if np.isfinite(expected[i]):
            assert expected[i] * (1 - 1e-9) <= path.length <= expected[i] * (1 + ask.errors(by, shape).largest) + 1e-9
            assert_is_path(shape, path, source[i], target[i])
        else:
            assert path.length == np.inf


@table.asked(["exact", "index", "by index, exact", "function"], [*table.SHAPES, *table.DRIFTS])
def test_exact_paths_are_certified_unless_the_metric_jumps(by: str, shape: Shape, random: Rng) -> None:
    target = random.permutation(len(shape.vertices))[:5]
    for path in ask.path(by, shape, np.full(5, shape.sources[0]), target):
        if np.isfinite(path.length) and path.length > 0:
            assert path.certified == (by != "index" and not ask.jumps(shape))


@pytest.mark.parametrize("by", ask.PATHS)
def test_one_point_each_gets_one_path_and_lists_get_a_list(by: str) -> None:
    shape = table.named("prism")
    single, several = ask.path(by, shape, 0, 100), ask.path(by, shape, [0, 3], [100, 50])
    assert isinstance(single, vorogeo.GeodesicPath)
    assert [type(path) for path in several] == [vorogeo.GeodesicPath] * 2
    assert several[0].length == pytest.approx(single.length, rel=1e-12)
    assert ask.path(by, shape, [], []) == []
