"""A matrix holds the distances of all pairs: symmetric to the last bit, in the type and place asked for."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import ask
import numpy as np
import pytest
import table
import vorogeo
from surfaces import Rng, Shape


@table.asked(ask.MATRICES, table.SHAPES)
def test_a_matrix_with_others_holds_the_distance_of_each_pair(by: str, shape: Shape, random: Rng) -> None:
    others = random.integers(0, len(shape.vertices), 40)
    answer = ask.matrix(by, shape, shape.sources, others)
    ask.assert_answers(by, shape, answer, shape.matrix(shape.sources, others))


@table.asked(ask.MATRICES, table.UNROLLED)
def test_a_square_matrix_is_symmetric_to_the_last_bit_with_a_zero_diagonal(by: str, shape: Shape, random: Rng) -> None:
    points = random.integers(0, len(shape.vertices), 15)
    points[3] = points[9]
    answer = ask.matrix(by, shape, points)
    np.testing.assert_array_equal(answer, answer.T)
    np.testing.assert_array_equal(np.diag(answer), 0)
    assert answer[3, 9] == 0
    ask.assert_answers(by, shape, answer, shape.matrix(points, points))


@table.asked(ask.TASKS, table.SHAPES)
def test_fields_hold_the_field_of_each_source(by: str, shape: Shape) -> None:
    answer = ask.fields(by, shape, shape.sources)
    alone = [ask.field(by, shape, int(source)) for source in shape.sources]
    ask.assert_answers(by, shape, answer, shape.fields(shape.sources))
    np.testing.assert_allclose(answer, alone, rtol=0 if by == "index" else shape.slack, atol=1e-12)


@table.asked(["pairs", "by index, exact"], table.UNROLLED)
def test_points_lie_anywhere_in_faces_and_on_edges(by: str, shape: Shape, random: Rng) -> None:
    points = table.points_anywhere(shape, random, 6)
    mixed = [points, [int(shape.sources[0])]]
    chart = np.vstack([shape.charted(points), shape.charted(shape.sources[:1])])
    answer, expected = ask.matrix(by, shape, mixed), shape.between(chart, chart)
    np.testing.assert_array_equal(np.isinf(answer), np.isinf(expected))
    finite = np.isfinite(expected)
    np.testing.assert_allclose(answer[finite], expected[finite], rtol=ask.errors(by, shape).largest, atol=1e-7)
    np.testing.assert_array_equal(answer, answer.T)


def call(question: str, by: str, shape: Shape, **options: Any) -> Any:
    """A matrix of 5 points, or their fields."""
    points = shape.sources
    return (
        ask.matrix(by, shape, points, **options) if question == "matrix" else ask.fields(by, shape, points, **options)
    )


QUESTIONS = [("matrix", "pairs"), ("matrix", "by index, exact"), ("fields", "index"), ("fields", "by index, exact")]


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize(("question", "by"), QUESTIONS)
def test_the_result_has_the_type_asked_for_and_fills_an_array_given_for_it(question: str, by: str, dtype: type) -> None:
    shape = table.named("bumpy")
    expected = call(question, by, shape)
    out = np.full(expected.shape, np.nan, dtype)
    assert call(question, by, shape, out=out) is out
    np.testing.assert_array_equal(out, expected.astype(dtype))
    np.testing.assert_array_equal(call(question, by, shape, dtype=dtype), out)
    assert call(question, by, shape, dtype=dtype).dtype == dtype


@pytest.mark.parametrize(("question", "by"), QUESTIONS)
def test_a_file_for_the_result_is_a_npy_file(question: str, by: str, tmp_path: Path) -> None:
    shape, file = table.named("bumpy"), tmp_path / "result.npy"
    file.write_bytes(b"an old file")
    answer = call(question, by, shape, out=file, dtype="float32")
    np.testing.assert_array_equal(np.load(file), call(question, by, shape, dtype="float32"))
    np.testing.assert_array_equal(answer, np.load(file))
    assert [entry.name for entry in tmp_path.iterdir()] == ["result.npy"]


@pytest.mark.parametrize(("question", "by"), QUESTIONS)
def test_what_does_not_fit_is_refused_before_it_is_computed(question: str, by: str, tmp_path: Path) -> None:
    shape = table.named("bumpy")
    with ask.refused("allowed. Give", vorogeo.NotEnoughMemory):
        call(question, by, shape, max_bytes=100)
    with ask.refused("out: "):
        call(question, by, shape, out=np.empty((2, 2)))
    with ask.refused("out: "):
        call(question, by, shape, out=tmp_path / "no folder" / "result.npy")
    assert list(tmp_path.iterdir()) == []
    assert vorogeo.matrix_bytes(5, 7, "float32") == 5 * 7 * 4


@pytest.mark.parametrize("by", ask.MATRICES)
def test_no_points_have_an_empty_matrix_and_threads_do_not_matter(by: str, random: Rng) -> None:
    shape = table.named("parts")
    points = random.integers(0, len(shape.vertices), 20)
    one, four = (ask.matrix(by, shape, points, on=ask.new_index(shape, threads=threads)) for threads in (1, 4))
    np.testing.assert_array_equal(one, four)
    assert ask.matrix(by, shape, []).shape == (0, 0)
    assert ask.matrix(by, shape, [1, 2], []).shape == (2, 0)
