"""A field is the distance of every vertex from its nearest source: exact where it says so, else within its errors."""

from __future__ import annotations

import threading
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import ask
import numpy as np
import pytest
import table
import vorogeo
from surfaces import Rng, Shape

STEADY = [shape for shape in [*table.UNROLLED, *table.DRIFTS] if not ask.jumps(shape)]
#: Answerers that take other sources than vertices.
KINDS_OF_POINTS = ("exact", "index", "by index, exact", "quick")


@table.asked(ask.FIELDS, [*table.SHAPES, *table.DRIFTS])
def test_each_vertex_gets_its_distance_and_infinity_where_no_path_leads(by: str, shape: Shape) -> None:
    answer = np.array([ask.field(by, shape, int(source)) for source in shape.sources])
    ask.assert_answers(by, shape, answer, shape.fields(shape.sources))
    np.testing.assert_array_equal(answer[np.arange(len(shape.sources)), shape.sources], 0)


@table.asked([*KINDS_OF_POINTS, "function"], [*table.UNROLLED, *table.DRIFTS])
def test_of_several_sources_the_nearest_counts(by: str, shape: Shape) -> None:
    sources = np.r_[shape.sources, shape.sources[:1]]
    ask.assert_answers(by, shape, ask.field(by, shape, sources), shape.fields(sources).min(axis=0))


@table.asked(KINDS_OF_POINTS, STEADY)
def test_offsets_are_added_and_the_label_is_the_source_of_the_least_sum(by: str, shape: Shape, random: Rng) -> None:
    points = table.points_anywhere(shape, random, 2)
    each = np.vstack([shape.fields(points), shape.fields(shape.sources)])
    offsets = random.uniform(0, 0.2 * each[np.isfinite(each)].max(), len(each))
    sums = each + offsets[:, None]
    answer, label = ask.labelled_field(by, shape, [points, shape.sources], offsets=offsets)
    ask.assert_answers(by, shape, answer, sums.min(axis=0))
    reached = np.isfinite(sums.min(axis=0))
    assert (label[~reached] == -1).all()
    of_label = sums[label[reached], np.flatnonzero(reached)]
    slack = 2 * ask.errors(by, shape).largest
    assert (of_label <= sums.min(axis=0)[reached] * (1 + slack) + 1e-12).all()


@table.asked(["exact", "function"], table.DRIFTS)
def test_distances_to_the_sources_are_those_of_the_ways_there(by: str, shape: Shape) -> None:
    answer = np.array([ask.field(by, shape, int(source), to=True) for source in shape.sources])
    ask.assert_answers(by, shape, answer, shape.between(shape.chart, shape.charted(shape.sources)).T)


@table.asked([*KINDS_OF_POINTS, "function"], [*table.UNROLLED, *table.DRIFTS])
def test_a_limit_makes_what_is_farther_infinite_and_leaves_the_rest(by: str, shape: Shape) -> None:
    source = int(shape.sources[1])
    expected = shape.fields([source])[0]
    limit = 0.4 * expected[np.isfinite(expected)].max()
    answer, slack = ask.field(by, shape, source, limit), ask.errors(by, shape).largest
    assert (answer[np.isfinite(answer)] <= limit).all()
    assert np.isinf(answer[expected > limit * (1 + slack)]).all()
    assert np.isfinite(answer[expected < limit * (1 - min(slack, 0.9))]).all()
    inside = np.isfinite(answer)
    np.testing.assert_allclose(answer[inside], expected[inside], rtol=slack, atol=1e-12)


@pytest.mark.parametrize("by", KINDS_OF_POINTS)
def test_a_curve_along_edges_is_one_source_never_too_near(by: str) -> None:
    shape = table.named("plane")
    side = np.flatnonzero(shape.vertices[:, 0] == 0)
    spacing, errors = 0.02, ask.errors(by, shape)
    answer, label = ask.labelled_field(by, shape, [vorogeo.EdgeCurve(side, spacing)])
    expected = shape.vertices[:, 0]
    assert (answer >= expected * (1 - errors.largest) - 1e-12).all()
    assert (answer <= expected * (1 + errors.largest) + spacing / 2).all()
    assert (label == 0).all()


@table.asked(ask.FIELDS, table.SHAPES[::3])
def test_single_precision_is_the_rounded_field(by: str, shape: Shape) -> None:
    source = int(shape.sources[0])
    answer = ask.field(by, shape, source, dtype=np.float32)
    assert answer.dtype == np.float32
    np.testing.assert_array_equal(answer, ask.field(by, shape, source, dtype=float).astype(np.float32))


@pytest.mark.parametrize("by", ["exact", "index", "by index, exact", "quick"])
def test_threads_that_ask_one_object_get_what_one_thread_gets(by: str) -> None:
    shape = table.named("bumpy")
    sources = list(map(int, shape.sources))
    alone = [ask.field(by, shape, source) for source in sources]
    together = threading.Barrier(len(sources))

    def answer(source: int) -> object:
        together.wait()
        return ask.field(by, shape, source)

    with ThreadPoolExecutor(len(sources)) as pool:
        np.testing.assert_array_equal(list(pool.map(answer, sources)), alone)


@pytest.mark.parametrize("shape", table.LENGTHS, ids=str)
def test_automatic_answers_are_as_good_as_what_they_say_they_are(shape: Shape) -> None:
    surface = ask.new_surface(shape)
    expected = shape.fields(shape.sources)
    for _ in range(2):
        for source, distances in zip(shape.sources, expected, strict=True):
            answer = ask.field("automatic", shape, int(source), on=surface)
            ask.assert_answers("index" if surface.last.by == "index" else "exact", shape, answer, distances)
            assert surface.last.by == ("exact" if surface.index is None else "index")
        surface.build_index()


@pytest.mark.parametrize("by", [*KINDS_OF_POINTS, "function"])
def test_arrays_of_any_type_and_layout_are_neither_changed_nor_kept(by: str) -> None:
    base = table.named("plane")
    vertices = base.vertices.astype(np.float32).astype(float)
    expected = ask.field(by, replace(base, vertices=vertices), 7)
    for points, corners in (
        (vertices.astype(np.float32), base.faces.astype(np.uint16)),
        (np.asfortranarray(vertices), base.faces.astype(np.int64)[::-1].copy()[::-1]),
        (vertices.tolist(), base.faces.tolist()),
        (np.hstack([vertices, vertices])[:, 3:], np.repeat(base.faces, 2, axis=0)[::2]),
        (vertices.astype(">f8"), base.faces.astype(">u8")),
        (vertices.astype(np.longdouble), base.faces.astype(np.int16)),
        (vertices, base.faces.astype(float)),
    ):
        shape, before = replace(base, vertices=points, faces=corners), (np.array(points), np.array(corners))
        np.testing.assert_array_equal(ask.field(by, shape, 7), expected)
        np.testing.assert_array_equal(points, before[0])
        np.testing.assert_array_equal(corners, before[1])
        if by != "function":
            points[5], corners[5] = points[6], corners[6]
            np.testing.assert_array_equal(ask.field(by, shape, 7), expected)


@pytest.mark.parametrize("by", ["exact", "index", "quick", "function"])
def test_a_mask_leaves_the_surface_of_the_faces_that_it_keeps(by: str) -> None:
    shape = table.named("bumpy")
    mask = (np.abs(shape.vertices[shape.faces].mean(axis=1)[:, :2] - 0.8) > 0.3).any(axis=1)
    if by == "function":
        answer = ask.field(by, shape, 0, mask=mask)
    else:
        answer = ask.field(by, shape, 0, on=(ask.new_index if by == "index" else ask.new_surface)(shape, mask=mask))
    without = replace(shape, name="with a hole", faces=shape.faces[mask])
    ask.assert_answers(by, shape, answer, ask.field("function", without, 0))
