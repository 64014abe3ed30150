"""The distance of two points: that of the field, the same in both directions, infinite where no path leads."""

from __future__ import annotations

import ask
import numpy as np
import pytest
import table
from surfaces import Rng, Shape


def some_pairs(shape: Shape, random: Rng, count: int = 12) -> tuple[np.ndarray, np.ndarray]:
    """Sources from which the formula holds, and targets anywhere."""
    return random.choice(shape.sources, count), random.integers(0, len(shape.vertices), count).astype(np.int32)


@table.asked(ask.DISTANCES, [*table.SHAPES, *table.DRIFTS])
def test_k_pairs_get_their_distances(by: str, shape: Shape, random: Rng) -> None:
    source, target = some_pairs(shape, random)
    expected = np.array([shape.matrix([a], [b])[0, 0] for a, b in zip(source, target, strict=True)])
    ask.assert_answers(by, shape, ask.distance(by, shape, source, target), expected)


@table.asked(ask.DISTANCES, [*table.SHAPES, *table.DRIFTS])
def test_a_single_pair_gets_a_number_that_is_the_one_in_a_list(by: str, shape: Shape, random: Rng) -> None:
    source, target = some_pairs(shape, random, 4)
    several = ask.distance(by, shape, source, target)
    for a, b, length in zip(source, target, several, strict=True):
        answer = ask.distance(by, shape, int(a), int(b))
        assert isinstance(answer, float)
        assert answer == pytest.approx(length, rel=0 if by == "index" else 1e-12)


@table.asked(ask.DISTANCES, table.SHAPES[::2])
def test_the_distance_from_a_point_to_itself_is_zero(by: str, shape: Shape) -> None:
    everywhere = np.arange(0, len(shape.vertices), 7)
    np.testing.assert_array_equal(ask.distance(by, shape, everywhere, everywhere), 0)
    lone = len(shape.vertices) - 1
    assert ask.distance(by, shape, lone, lone) == 0


@table.asked(ask.DISTANCES, [*table.UNROLLED, *table.DRIFTS])
def test_points_lie_anywhere_in_faces_and_on_edges(by: str, shape: Shape, random: Rng) -> None:
    source, target = (table.points_anywhere(shape, random, 8) for _ in "ab")
    expected = np.diag(shape.between(shape.charted(source), shape.charted(target)))
    ask.assert_answers(by, shape, ask.distance(by, shape, source, target), expected)
    vertex = int(shape.sources[0])
    mixed = ask.distance(by, shape, [source[0], vertex], [vertex, target[0]])
    to_vertex = shape.between(shape.charted(source[:1]), shape.charted([vertex]))[0, 0]
    from_vertex = shape.between(shape.charted([vertex]), shape.charted(target[:1]))[0, 0]
    ask.assert_answers(by, shape, mixed, np.array([to_vertex, from_vertex]))


@table.asked(["exact", "index"], [table.named(name) for name in ("plane", "prism", "cone", "parts")])
def test_places_in_space_are_moved_to_the_nearest_point_of_the_surface(by: str, shape: Shape, random: Rng) -> None:
    places = table.points_anywhere(shape, random, 6).positions(shape.vertices, shape.faces)
    snapped = ask.snapped(by, shape, places)
    np.testing.assert_allclose(snapped.positions(shape.vertices, shape.faces), places, atol=1e-9)
    np.testing.assert_allclose(snapped.snap_distance, 0, atol=1e-9)
    above = ask.snapped(by, table.named("plane"), [0.7, 0.6, 0.25])
    np.testing.assert_allclose(above.snap_distance, 0.25, rtol=1e-12)


@pytest.mark.parametrize("by", ask.DISTANCES)
def test_no_pairs_have_no_distances(by: str) -> None:
    assert np.shape(ask.distance(by, table.named("plane"), np.empty(0, int), np.empty(0, int))) == (0,)
