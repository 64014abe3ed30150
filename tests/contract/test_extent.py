"""The bounds of diameter and radius hold what they bound; an eccentricity is the greatest distance of a component."""

from __future__ import annotations

import ask
import numpy as np
import pytest
import table
from surfaces import Floats, Shape

WHOLE = [shape for shape in table.UNROLLED if shape.name != "parts"]


def all_distances(shape: Shape) -> Floats:
    """The distances of all vertices from all."""
    return shape.between(shape.chart, shape.chart)


@pytest.mark.parametrize("fields", [2, 6])
@table.asked(ask.TASKS, WHOLE)
def test_diameter_and_radius_lie_between_their_bounds(by: str, shape: Shape, fields: int) -> None:
    extent, matrix = ask.task("extent", by, shape, fields=fields), all_distances(shape)
    slack = ask.errors(by, shape).largest
    farthest = matrix.max(axis=1)
    assert extent.diameter[0] * (1 - slack) <= matrix.max() <= extent.diameter[1] * (1 + slack)
    assert extent.radius[0] * (1 - slack) <= farthest.min() <= extent.radius[1] * (1 + slack)
    assert matrix[extent.ends] == pytest.approx(extent.diameter[0], rel=slack)
    assert farthest[extent.centre] == pytest.approx(extent.radius[1], rel=slack)
    assert 2 <= extent.fields <= fields


@table.asked(ask.TASKS, table.UNROLLED)
def test_the_eccentricity_is_the_greatest_distance_within_the_component(by: str, shape: Shape) -> None:
    distances, farthest = ask.task("eccentricity", by, shape, shape.sources)
    matrix = shape.fields(shape.sources)
    greatest = np.where(np.isfinite(matrix), matrix, 0).max(axis=1)
    np.testing.assert_allclose(distances, greatest, rtol=ask.errors(by, shape).largest)
    reached = matrix[np.arange(len(farthest)), farthest]
    np.testing.assert_allclose(reached, greatest, rtol=2 * ask.errors(by, shape).largest)


@pytest.mark.parametrize("by", ask.TASKS)
def test_the_extent_is_that_of_the_component_of_its_start(by: str) -> None:
    shape = table.named("parts")
    half = (len(shape.vertices) - 1) // 2
    for start, low in ((5, 0), (half + 5, half)):
        extent = ask.task("extent", by, shape, start=start, fields=40)
        assert all(low <= vertex < low + half for vertex in (*extent.ends, extent.centre))
        assert extent.diameter[0] == pytest.approx(np.sqrt(2), rel=ask.errors(by, shape).largest)
