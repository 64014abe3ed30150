"""An index from its file or pickle answers as the one saved, to the last bit; that of another mesh is refused."""

from __future__ import annotations

import copy
import pickle
from pathlib import Path
from typing import Any

import ask
import numpy as np
import pytest
import table
import vorogeo
from surfaces import Rng, Shape

NAMES = ["bumpy", "parts", "saddle by edge lengths", "shore", "plane with one FaceTensor", "half-plane"]
SHAPES = [table.named(name) for name in NAMES]


def pickled(answerer: Any) -> Any:
    """An object as another process would receive it."""
    return pickle.loads(pickle.dumps(answerer))


def assert_same_answers(one: Any, other: Any, shape: Shape, random: Rng) -> None:
    """Two indexes answer alike, to the last bit."""
    source, target = random.integers(0, len(shape.vertices), (2, 30))
    np.testing.assert_array_equal(one.distance(source, target), other.distance(source, target))
    np.testing.assert_array_equal(one.distance_field(source[:3]), other.distance_field(source[:3]))
    np.testing.assert_array_equal(one.distance_matrix(source[:5]), other.distance_matrix(source[:5]))
    for first, second in zip(*(made.path(source[:5], target[:5]) for made in (one, other)), strict=True):
        np.testing.assert_array_equal(first.points, second.points)
        assert first.length == second.length


@pytest.mark.parametrize("shape", SHAPES, ids=str)
def test_a_saved_and_a_pickled_index_answer_alike_to_the_last_bit(shape: Shape, tmp_path: Path, random: Rng) -> None:
    index, file = ask.index(shape), tmp_path / "an index.vgi"
    index.save(file)
    for mapped in (True, False):
        assert_same_answers(ask.loaded(file, shape, mapped=mapped), index, shape, random)
    for other in (pickled(index), copy.deepcopy(index)):
        assert_same_answers(other, index, shape, random)
    again = tmp_path / "again.vgi"
    ask.loaded(file, shape).save(again)
    assert again.read_bytes() == file.read_bytes()


@pytest.mark.parametrize("shape", SHAPES, ids=str)
def test_a_pickled_surface_answers_alike_and_keeps_its_index(shape: Shape) -> None:
    surface, source = ask.new_surface(shape), int(shape.sources[0])
    exact = ask.field("exact", shape, source, on=surface)
    np.testing.assert_array_equal(ask.field("exact", shape, source, on=pickled(surface)), exact)
    surface.build_index()
    copied = pickled(surface)
    assert copied.index is not None
    np.testing.assert_array_equal(
        ask.field("automatic", shape, source, on=copied), ask.field("automatic", shape, source, on=surface)
    )


def test_an_index_is_built_in_its_file_and_found_there_again(tmp_path: Path, random: Rng) -> None:
    shape, file = table.named("bumpy"), tmp_path / "index.vgi"
    made = ask.new_index(shape, file=file)
    assert_same_answers(made, ask.index(shape), shape, random)
    found = ask.new_index(shape, file=file)
    assert found.statistics.seconds == 0
    assert_same_answers(found, made, shape, random)
    for question in (ask.new_index, lambda other, file: ask.loaded(file, other)):
        with ask.refused("another mesh", vorogeo.IndexFileError):
            question(table.named("plane"), file=file)
    with ask.refused("There is no index file", vorogeo.IndexFileError):
        ask.loaded(tmp_path / "other.vgi", shape)
