"""The k nearest points and all pairs within a radius are what sorting the whole matrix gives."""

from __future__ import annotations

import ask
import numpy as np
import pytest
import table
from surfaces import Rng, Shape

SET = 12


def points_and_queries(shape: Shape, random: Rng) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Points of a set, the sources of the formula as queries, and their distances."""
    points = random.choice(len(shape.vertices), SET, replace=False).astype(np.int32)
    return points, shape.sources, shape.matrix(shape.sources, points)


@table.asked(ask.TASKS, table.SHAPES)
def test_the_nearest_are_the_first_of_all_sorted_by_distance(by: str, shape: Shape, random: Rng) -> None:
    points, queries, matrix = points_and_queries(shape, random)
    distances, places = ask.nearest(by, shape, points, queries, 4)
    assert distances.shape == places.shape == (len(queries), 4)
    ask.assert_answers(by, shape, distances, np.sort(matrix, axis=1)[:, :4])
    np.testing.assert_array_equal(places == -1, np.isinf(distances))
    there = places >= 0
    of_place = np.take_along_axis(matrix, np.maximum(places, 0), axis=1)
    np.testing.assert_allclose(of_place[there], distances[there], rtol=ask.errors(by, shape).largest, atol=1e-9)
    assert (distances[:, 1:] >= distances[:, :-1]).all()


@table.asked(ask.TASKS, table.UNROLLED)
def test_pairs_within_a_radius_are_the_small_entries_of_the_matrix(by: str, shape: Shape, random: Rng) -> None:
    points = random.choice(len(shape.vertices), SET, replace=False).astype(np.int32)
    matrix = shape.matrix(points, points)
    radius = np.quantile(matrix[np.isfinite(matrix)], 0.5) * (1 + 1e-7)
    answer = ask.pairs_within(by, shape, points, radius)
    slack = ask.errors(by, shape).largest
    off = ~np.eye(SET, dtype=bool)
    assert np.isnan(np.diag(answer)).all()
    assert np.isfinite(answer[off & (matrix <= radius * (1 - slack))]).all()
    assert np.isnan(answer[matrix > radius * (1 + slack)]).all()
    stored = np.isfinite(answer)
    np.testing.assert_allclose(answer[stored], matrix[stored], rtol=slack)
    np.testing.assert_array_equal(answer, answer.T)


@table.asked(ask.TASKS, table.SHAPES[::2])
def test_pairs_with_others_are_read_from_fields_that_end_at_the_radius(by: str, shape: Shape, random: Rng) -> None:
    points, queries, matrix = points_and_queries(shape, random)
    radius = float(np.median(matrix[np.isfinite(matrix)]))
    fields = ask.fields(by, shape, queries, max_distance=radius)[:, points]
    answer = ask.pairs_within(by, shape, queries, radius, points)
    np.testing.assert_array_equal(np.nan_to_num(answer, nan=np.inf), fields)


@pytest.mark.parametrize("by", ask.TASKS)
def test_a_radius_of_zero_holds_repeated_points_and_no_points_no_pairs(by: str) -> None:
    shape = table.named("plane")
    answer = ask.pairs_within(by, shape, [4, 9, 4], 0.0)
    np.testing.assert_array_equal(np.argwhere(answer == 0), [[0, 2], [2, 0]])
    assert ask.pairs_within(by, shape, [], 1.0).shape == (0, 0)
    assert ask.nearest(by, shape, [], [3], 2)[1].tolist() == [[-1, -1]]


@pytest.mark.parametrize("by", ask.TASKS)
def test_points_and_queries_lie_anywhere(by: str, random: Rng) -> None:
    shape = table.named("plane")
    points, queries = (table.points_anywhere(shape, random, 6) for _ in "ab")
    matrix = shape.between(shape.charted(queries), shape.charted(points))
    distances, _ = ask.nearest(by, shape, points, queries, 3)
    ask.assert_answers(by, shape, distances, np.sort(matrix, axis=1)[:, :3])
