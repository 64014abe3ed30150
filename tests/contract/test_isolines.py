"""Isolines lie where the field has their level, and cross every edge whose ends lie on both sides of it."""

from __future__ import annotations

import itertools

import ask
import numpy as np
import pytest
import table
import vorogeo
from surfaces import Floats, Rng, Shape


def test_isolines_of_a_distance_in_a_plane_are_circles(random: Rng) -> None:
    shape = table.named("repeats")
    source = int(random.choice(shape.sources))
    field = shape.fields([source])[0]
    levels = np.sort(random.uniform(0.1, 0.9, 4)) * field.max()
    lines = ask.isolines(shape, field, levels)
    np.testing.assert_allclose(shape.between(shape.vertices[[source]], lines.points)[0], lines.values, atol=1e-9)
    assert set(lines.values.tolist()) <= set(levels.tolist())
    np.testing.assert_array_equal(lines.values[lines.edges[:, 0]], lines.values[lines.edges[:, 1]])


@pytest.mark.parametrize("shape", table.SHAPES, ids=str)
def test_isolines_of_a_linear_field_are_plane_sections(shape: Shape, random: Rng) -> None:
    if shape.name.endswith("edge lengths"):
        shape = table.named("saddle")  # without positions, lines have none
    slope = random.normal(size=3)
    field = shape.vertices @ slope
    levels = np.quantile(field, [0.2, 0.5, 0.9])
    lines = ask.isolines(shape, field, levels, "linear")
    np.testing.assert_allclose(lines.points @ slope, lines.values, atol=1e-9)
    for level in levels:
        crossed = crossed_edges(shape, field, level)
        on_level = np.abs(lines.values - level) < 1e-12
        assert on_level.sum() >= len(crossed)


def crossed_edges(shape: Shape, field: Floats, level: float) -> set[tuple[int, int]]:
    """The edges whose ends lie on both sides of a level."""
    sides = itertools.chain.from_iterable(
        shape.faces[table.is_face(shape)][:, pair] for pair in ([0, 1], [1, 2], [0, 2])
    )
    return {
        (min(a, b), max(a, b))
        for a, b in (map(int, side) for side in sides)
        if (field[a] - level) * (field[b] - level) < 0
    }


def test_isolines_can_be_cancelled_on_the_way_and_leave_what_answered_last() -> None:
    shape = table.named("plane")
    surface = ask.surface(shape)
    surface.distance(0, 5)
    last = surface.last
    reports: list[float] = []

    def until_the_third(done: float, _: str) -> bool:
        reports.append(done)
        return len(reports) < 3

    with pytest.raises(vorogeo.Cancelled):
        surface.isolines(shape.vertices[:, 0], 40_000, progress=until_the_third)
    assert reports == sorted(reports)
    surface.isolines(shape.vertices[:, 0], 3)
    assert surface.last == last


def test_a_number_of_levels_is_spread_evenly_between_the_least_and_the_greatest_value() -> None:
    shape = table.named("plane")
    lines = ask.isolines(shape, shape.vertices[:, 0].copy(), 3, "linear")
    np.testing.assert_allclose(np.unique(lines.values), [0.5, 1.0, 1.5], atol=1e-12)
    np.testing.assert_allclose(lines.length, 3 * 1.5, rtol=1e-9)
