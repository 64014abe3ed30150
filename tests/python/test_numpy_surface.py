"""What answers a vorogeo.Surface, what it says of that, and vorogeo.estimate."""

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid


def test_every_question_says_what_answered_it():
    surface = vorogeo.Surface(*bent_grid(30, 20))
    assert surface.last is None
    assert "no index yet" in repr(surface)
    questions = [
        lambda **how: surface.distance(3, 77, **how),
        lambda **how: surface.distance([3], [77], **how),
        lambda **how: surface.path(3, 77, **how),
        lambda **how: surface.distance_field(3, **how),
        lambda **how: surface.fields([3], **how),
        lambda **how: surface.voronoi([3, 77], **how),
    ]
    for method in ("exact", "index"):
        for ask in questions:
            ask(method=method)
            assert surface.last.by == method
            assert surface.last.seconds > 0
            surface.last = None
    surface.distance(3, 77)
    assert surface.last.by == "index"
    assert "with an index" in repr(surface)
    assert isinstance(surface.index, vorogeo.GeodesicIndex)
    assert surface.build_index().distance(5, 77) == surface.distance(5, 77)


def test_no_points_build_no_index():
    surface = vorogeo.Surface(*bent_grid(12, 9))
    for ask in (
        lambda: surface.distances([], [], method="index"),
        lambda: surface.path([], [], method="index"),
        lambda: surface.distance_matrix([], method="index"),
        lambda: surface.fields([], method="index"),
        lambda: surface.nearest([3], [], method="index"),
        lambda: surface.pairs_within([], 1.0, method="index"),
        lambda: surface.eccentricity([], method="index"),
    ):
        ask()
        assert surface.index is None


def test_estimates_are_those_of_the_index():
    mesh = bent_grid(50, 40)
    guess = vorogeo.estimate(*mesh)
    statistics = vorogeo.GeodesicIndex(*mesh).statistics
    assert 0.5 < guess.bytes / statistics.bytes < 2
    assert guess.form == statistics.form
    assert 0 < guess.build_seconds <= guess.core_seconds
    assert guess.exact_field_seconds > 0
    assert guess.field_seconds > 0
    with pytest.raises(vorogeo.InvalidInput, match="no face"):
        vorogeo.estimate(np.zeros((3, 3)), np.empty((0, 3), int))
