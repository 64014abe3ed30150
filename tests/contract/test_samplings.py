"""Each farthest sample is as far as possible from those before; Poisson-disk samples keep apart and leave no room."""

from __future__ import annotations

import ask
import numpy as np
import pytest
import table
from surfaces import Rng, Shape

#: Surfaces with a formula for any two vertices and a single component.
WHOLE = [shape for shape in table.UNROLLED if shape.name != "parts"]


@table.asked(ask.TASKS, WHOLE)
def test_each_sample_is_the_vertex_farthest_from_those_before(by: str, shape: Shape) -> None:
    found = ask.task("sample_farthest", by, shape, 9, start=[int(shape.sources[0])])
    assert found.vertices[0] == shape.sources[0]
    assert np.isinf(found.radius[0])
    fields = shape.fields(found.vertices)
    slack = 2 * ask.errors(by, shape).largest
    for i in range(1, 9):
        nearest = fields[:i].min(axis=0)
        assert nearest[found.vertices[i]] >= nearest.max() * (1 - slack) - 1e-9
        assert found.radius[i] == pytest.approx(nearest[found.vertices[i]], rel=slack)
    ask.assert_answers(by, shape, found.distance, fields.min(axis=0))
    assert found.covering_radius == pytest.approx(found.distance.max(), rel=1e-12)
    assert (np.diff(found.radius[1:]) <= slack * found.radius[1]).all()


@pytest.mark.parametrize("by", ask.TASKS)
def test_sampling_begins_with_points_anywhere(by: str, random: Rng) -> None:
    shape = table.named("plane")
    points = table.points_anywhere(shape, random, 2)
    found = ask.task("sample_farthest", by, shape, 6, start=[points, 7])
    assert found.vertices[2] == 7
    assert (found.vertices[:2] == -1).all()
    places = found.points.positions(shape.vertices, shape.faces)
    np.testing.assert_allclose(places[:2], points.positions(shape.vertices, shape.faces), atol=1e-12)
    np.testing.assert_allclose(places[2:], shape.vertices[found.vertices[2:]], atol=1e-12)


@table.asked(ask.TASKS, WHOLE)
def test_poisson_disk_samples_are_a_radius_apart_and_none_could_be_added(by: str, shape: Shape, random: Rng) -> None:
    width = shape.fields(shape.sources).max()
    radius = 0.25 * width
    samples = ask.task("sample_poisson_disk", by, shape, radius, seed=int(random.integers(2**32)))
    slack = 2 * ask.errors(by, shape).largest
    fields = shape.fields(samples)
    apart = fields[:, samples] + 2 * radius * np.eye(len(samples))
    assert apart.min() >= radius * (1 - slack)
    assert fields.min(axis=0).max() <= radius * (1 + slack)
    assert len(samples) > 2
