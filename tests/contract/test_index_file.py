"""An index from its file or pickle answers as the one saved, to the last bit; any other file or mesh is refused."""

from __future__ import annotations

import copy
import pickle
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import ask
import numpy as np
import pytest
import table
import vorogeo
from surfaces import Rng, Shape

NAMES = ["bumpy", "parts", "book", "saddle by edge lengths", "shore", "plane with one FaceTensor", "half-plane"]
SHAPES = [table.named(name) for name in NAMES]


def pickled(answerer: Any) -> Any:
    """An object after a journey to another process."""
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


def moved_by_one_bit(shape: Shape) -> Shape:
    vertices = shape.vertices.copy()
    vertices[17, 0] = np.nextafter(vertices[17, 0], 9)
    return replace(shape, vertices=vertices)


OTHERS: dict[str, Callable[[Shape], Shape]] = {
    "one coordinate differs by one bit": moved_by_one_bit,
    "two faces are swapped": lambda shape: replace(shape, faces=shape.faces[np.r_[1, 0, 2 : len(shape.faces)]]),
    "a face is missing": lambda shape: replace(shape, faces=shape.faces[1:]),
    "there is one more vertex": lambda shape: replace(shape, vertices=np.vstack([shape.vertices, [[9.0, 9, 9]]])),
    "the metric is another": lambda shape: replace(shape, metric=vorogeo.VertexCost(np.ones(len(shape.vertices)))),
}


@pytest.mark.parametrize("other", OTHERS)
def test_a_file_is_refused_if(other: str, tmp_path: Path) -> None:
    shape, file = table.named("bumpy"), tmp_path / "index.vgi"
    ask.index(shape).save(file)
    with ask.refused("mesh|metric|length", vorogeo.IndexFileError):
        ask.loaded(file, OTHERS[other](shape))


def test_a_truncated_longer_or_foreign_file_is_refused(tmp_path: Path, random: Rng) -> None:
    shape, file = table.named("bumpy"), tmp_path / "index.vgi"
    ask.index(shape).save(file)
    whole = file.read_bytes()
    cuts = [0, 1, 7, 64, len(whole) - 1, *random.integers(0, len(whole), 12).tolist()]
    damaged = bytearray(whole)
    damaged[int(random.integers(64, len(whole)))] ^= 16
    for contents in [*(whole[:cut] for cut in cuts), whole + b"!", random.bytes(500), damaged]:
        file.write_bytes(contents)
        with pytest.raises(vorogeo.IndexFileError):
            ask.loaded(file, shape, mapped=False)
    with ask.refused("There is no index file", vorogeo.IndexFileError):
        ask.loaded(tmp_path / "other.vgi", shape)
    assert issubclass(vorogeo.IndexFileError, OSError)


def test_an_index_is_built_in_its_file_and_found_there_again(tmp_path: Path, random: Rng) -> None:
    shape, file = table.named("bumpy"), tmp_path / "index.vgi"
    made = ask.new_index(shape, file=file)
    assert_same_answers(made, ask.index(shape), shape, random)
    found = ask.new_index(shape, file=file)
    assert found.statistics.seconds == 0
    assert_same_answers(found, made, shape, random)
    with pytest.raises(vorogeo.IndexFileError):
        ask.new_index(table.named("plane"), file=file)


def test_saving_replaces_a_file_at_once_and_leaves_no_other(tmp_path: Path) -> None:
    shape, file = table.named("plane"), tmp_path / "index.vgi"
    file.write_bytes(b"an old file")
    ask.index(shape).save(str(file))
    assert [entry.name for entry in tmp_path.iterdir()] == ["index.vgi"]
    ask.loaded(str(file), shape)
    with pytest.raises(vorogeo.IndexFileError):
        ask.index(shape).save(tmp_path)
