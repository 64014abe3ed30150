"""Isolines lie where the field has their level, run through faces only, and end at borders only."""

from __future__ import annotations

import itertools

import ask
import numpy as np
import pytest
import table
from surfaces import Floats, Rng, Shape

CONVEX = ("plane", "repeats", "needles")


@pytest.mark.parametrize("name", CONVEX)
def test_isolines_of_a_distance_in_a_plane_are_circles(name: str, random: Rng) -> None:
    shape = table.named(name)
    source = int(random.choice(shape.sources))
    field = shape.fields([source])[0]
    levels = np.sort(random.uniform(0.1, 0.9, 4)) * field.max()
    lines = ask.isolines(shape, field, levels)
    np.testing.assert_allclose(shape.between(shape.vertices[[source]], lines.points)[0], lines.values, atol=1e-9)
    assert set(lines.values.tolist()) <= set(levels.tolist())
    np.testing.assert_array_equal(lines.values[lines.edges[:, 0]], lines.values[lines.edges[:, 1]])


def slope_and_plane(shape: Shape, random: Rng) -> tuple[Floats, Floats]:
    """A direction in space, and a field that is linear along it."""
    slope = random.normal(size=3)
    return slope, shape.vertices @ slope


@pytest.mark.parametrize("shape", table.SHAPES, ids=str)
def test_isolines_of_a_linear_field_are_plane_sections(shape: Shape, random: Rng) -> None:
    if shape.name.endswith("edge lengths"):
        shape = table.named("saddle")  # without positions, lines have none
    slope, field = slope_and_plane(shape, random)
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


@pytest.mark.parametrize("name", ["box", "cone", "prism"])
def test_isolines_end_at_borders_only(name: str, random: Rng) -> None:
    shape = table.named(name)
    _, field = slope_and_plane(shape, random)
    lines = ask.isolines(shape, field, np.quantile(field, [0.31, 0.67]), "linear")
    ends = lines.points[np.bincount(lines.edges.ravel(), minlength=len(lines.points)) == 1]
    if name == "box":
        assert not len(ends)
    elif name == "prism":
        np.testing.assert_allclose(np.abs(ends[:, 2] - 2), 2, atol=1e-9)
    else:
        np.testing.assert_allclose(ends[:, 2], shape.vertices[:, 2].min(), atol=1e-9)


def test_a_number_of_levels_is_spread_evenly_between_the_least_and_the_greatest_value() -> None:
    shape = table.named("plane")
    lines = ask.isolines(shape, shape.vertices[:, 0].copy(), 3, "linear")
    np.testing.assert_allclose(np.unique(lines.values), [0.5, 1.0, 1.5], atol=1e-12)
    np.testing.assert_allclose(lines.length, 3 * 1.5, rtol=1e-9)


def test_faces_with_a_value_that_is_not_finite_hold_no_lines() -> None:
    shape = table.named("parts")
    field = shape.fields([3])[0]
    lines = ask.isolines(shape, field, [0.4])
    assert len(lines.edges)
    assert (lines.points[:, 0] <= 1 + 1e-12).all()
    assert not len(ask.isolines(shape, np.full(len(field), np.inf), 3).points)
    assert not len(ask.isolines(shape, field, [7.0]).points)
