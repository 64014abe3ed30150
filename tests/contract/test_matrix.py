"""A matrix holds the distances of all pairs: symmetric to the last bit, in the type and place asked for."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import ask
import numpy as np
import pytest
import table
import vorogeo
from surfaces import Shape


@pytest.mark.parametrize(("by", "shape"), table.rows(ask.MATRICES, table.SHAPES))
def test_a_matrix_with_others_holds_the_distance_of_each_pair(
    by: str, shape: Shape, random: np.random.Generator
) -> None:
    others = random.integers(0, len(shape.vertices), 40)
    answer = ask.matrix(by, shape, shape.sources, others)
    ask.assert_answers(by, shape, answer, shape.matrix(shape.sources, others))


@pytest.mark.parametrize(("by", "shape"), table.rows(ask.MATRICES, table.UNROLLED))
def test_a_square_matrix_is_symmetric_to_the_last_bit_with_a_zero_diagonal(
    by: str, shape: Shape, random: np.random.Generator
) -> None:
    points = random.integers(0, len(shape.vertices), 15)
    points[3] = points[9]
    answer = ask.matrix(by, shape, points)
    np.testing.assert_array_equal(answer, answer.T)
    np.testing.assert_array_equal(np.diag(answer), 0)
    assert answer[3, 9] == 0
    ask.assert_answers(by, shape, answer, shape.matrix(points, points))


@pytest.mark.parametrize("shape", table.SHAPES, ids=str)
def test_a_matrix_by_pairs_holds_the_very_numbers_of_distance(shape: Shape, random: np.random.Generator) -> None:
    points, others = random.integers(0, len(shape.vertices), (2, 8))
    answer = ask.matrix("pairs", shape, points, others)
    alone = [[ask.distance("index", shape, int(a), int(b)) for b in others] for a in points]
    np.testing.assert_array_equal(answer, alone)


@pytest.mark.parametrize(("by", "shape"), table.rows(ask.TASKS, table.SHAPES))
def test_fields_hold_the_field_of_each_source(by: str, shape: Shape) -> None:
    answer = ask.fields(by, shape, shape.sources)
    alone = [ask.field(by, shape, int(source)) for source in shape.sources]
    ask.assert_answers(by, shape, answer, shape.fields(shape.sources))
    np.testing.assert_allclose(answer, alone, rtol=0 if by == "index" else shape.slack, atol=1e-12)


@pytest.mark.parametrize("by", ask.TASKS)
def test_fields_with_a_limit_are_infinite_beyond_it(by: str) -> None:
    shape = table.named("prism")
    whole = ask.fields(by, shape, shape.sources)
    limit = 0.5 * whole.max()
    answer = ask.fields(by, shape, shape.sources, max_distance=limit)
    assert answer[np.isfinite(answer)].max() <= limit
    slack = ask.errors(by, shape).largest
    clear = np.abs(whole - limit) > slack * limit
    np.testing.assert_array_equal(np.isfinite(answer)[clear], (whole <= limit)[clear])


@pytest.mark.parametrize(("by", "shape"), table.rows(["pairs", "by index, exact"], table.UNROLLED))
def test_points_lie_anywhere_in_faces_and_on_edges(by: str, shape: Shape, random: np.random.Generator) -> None:
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


@pytest.mark.parametrize(("question", "by"), QUESTIONS)
def test_single_precision_is_the_rounded_matrix(question: str, by: str) -> None:
    shape = table.named("bumpy")
    answer = call(question, by, shape, dtype="float32")
    assert answer.dtype == np.float32
    np.testing.assert_array_equal(answer, call(question, by, shape).astype(np.float32))


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize(("question", "by"), QUESTIONS)
def test_an_array_for_the_result_is_filled_and_returned(question: str, by: str, dtype: type) -> None:
    shape = table.named("bumpy")
    expected = call(question, by, shape)
    out = np.full(expected.shape, np.nan, dtype)
    assert call(question, by, shape, out=out) is out
    np.testing.assert_array_equal(out, expected.astype(dtype))


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
    with ask.refused("allowed by max_bytes", vorogeo.NotEnoughMemory):
        call(question, by, shape, max_bytes=100)
    with ask.refused("out: "):
        call(question, by, shape, out=np.empty((2, 2)))
    with ask.refused("out: "):
        call(question, by, shape, out=tmp_path / "no folder" / "result.npy")
    assert list(tmp_path.iterdir()) == []
    assert vorogeo.matrix_bytes(5, 7, "float32") == 5 * 7 * 4


@pytest.mark.parametrize("by", ask.MATRICES)
def test_no_points_have_an_empty_matrix(by: str) -> None:
    shape = table.named("plane")
    assert ask.matrix(by, shape, []).shape == (0, 0)
    assert ask.matrix(by, shape, [1, 2], []).shape == (2, 0)


@pytest.mark.parametrize("by", ask.MATRICES)
def test_matrices_do_not_depend_on_threads(by: str, random: np.random.Generator) -> None:
    shape = table.named("parts")
    points = random.integers(0, len(shape.vertices), 20)
    answers = []
    for threads in (1, 4):
        how = {"exact": True} if by == "by index, exact" else {"method": by}
        answers.append(ask.new_index(shape, threads=threads).distance_matrix(points, **how))
    np.testing.assert_array_equal(*answers)
