"""What cannot be answered is refused in a sentence that names the element; a refusal or cancelling changes nothing."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import ask
import numpy as np
import pytest
import table
import vorogeo

SHAPE = table.named("plane")
COUNT = len(SHAPE.vertices)


def meshes() -> dict[str, tuple[Any, Any, str]]:
    """Vertices and faces that are no mesh, and the sentence about them."""
    vertices, faces = SHAPE.vertices, SHAPE.faces
    spoilt = {value: vertices.copy() for value in (np.nan, np.inf)}
    for value, array in spoilt.items():
        array[17, 1] = value
    beyond, negative, huge = faces.copy(), faces.copy(), faces.astype(np.int64)
    beyond[5, 2], negative[5, 2], huge[5, 0] = COUNT, -1, 2**32
    return {
        "NaN": (spoilt[np.nan], faces, r"vertices\[17\].*not finite"),
        "infinity": (spoilt[np.inf], faces, r"vertices\[17\].*not finite"),
        "vertices in a plane": (vertices[:, :2], faces, r"vertices: has shape"),
        "vertices in one row": (vertices.ravel(), faces, r"vertices: has shape \(\d+,\)"),
        "vertices of several meshes": (vertices[None], faces, r"vertices: has shape \(1, \d+, 3\)"),
        "vertices of different lengths": ([[0, 0, 0], [1, 0]], faces, "vertices: cannot be read"),
        "complex vertices": (vertices + 0j, faces, "vertices: is not an array of numbers"),
        "vertices that are true or false": (vertices > 0, faces, "vertices: has type bool"),
        "an empty list": ([], faces, r"vertices: has shape \(0,\)"),
        "no rows": (np.empty((0, 3)), faces, "the mesh has no vertices"),
        "vertices that are text": ([["a", "b", "c"]], faces, "vertices: is not an array of numbers"),
        "no vertices": (None, faces, "vertices: is None"),
        "a vertex that is not there": (vertices, beyond, rf"faces\[5\]: names vertex {COUNT}"),
        "a negative vertex": (vertices, negative, r"faces\[5\]: names vertex -1"),
        "a vertex beyond 32 bits": (vertices, huge, r"faces\[5\]: names vertex 4294967296"),
        "edges": (vertices, faces[:, :2], r"faces: has shape \(\d+, 2\)"),
        "rows of five": (vertices, faces[:2].reshape(1, 6)[:, :5], "faces: has shape"),
        "rows of VTK": (vertices, np.insert(faces, 0, 3, axis=1), "faces: each row begins with 3, as in VTK"),
        "polygons and a side": (vertices, [*faces.tolist(), [0, 1]], rf"faces\[{len(faces)}\]: has 2 corners"),
        "a quad beyond": (
            vertices,
            [[0, 1, 2], [3, 4, COUNT, 5]],
            rf"faces\[1\]: names vertex {COUNT}, but the mesh has",
        ),
        "no faces": (vertices, None, "faces: is missing, and the only argument is a ndarray; give vertices and faces"),
        "faces that are true or false": (vertices, faces > 0, "faces: has type bool, not integer"),
        "faces that are real": (vertices, faces + 0.5, r"faces: has type float64, not integer: faces\[0\]\[0\] is \d"),
    }


@pytest.mark.parametrize("case", meshes())
def test_an_array_that_is_no_mesh(case: str) -> None:
    vertices, faces, sentence = meshes()[case]
    for question in (
        lambda: vorogeo.Surface(vertices, faces),
        lambda: vorogeo.GeodesicIndex(vertices, faces),
        lambda: vorogeo.estimate(vertices, faces),
        lambda: vorogeo.exact_distance_field(vertices, faces, 0),
        lambda: vorogeo.exact_path(vertices, faces, 0, 1),
    ):
        with ask.refused(sentence):
            question()


def test_a_mesh_without_faces_has_no_index() -> None:
    with ask.refused("no face"):
        vorogeo.GeodesicIndex(np.zeros((3, 3)), np.empty((0, 3), int))


def test_a_mesh_without_vertices_has_no_extent() -> None:
    with ask.refused("the mesh has no vertices"):
        vorogeo.Surface(np.empty((0, 3)), np.empty((0, 3), int)).extent()


Question = Callable[..., Any]
IDS: list[tuple[str, Any, str]] = [
    ("a vertex that is not there", COUNT, f"there is no vertex {COUNT}"),
    ("one of a list that is not there", [0, COUNT + 3], rf"\[1\]: there is no vertex {COUNT + 3}"),
    ("a negative vertex", -1, "there is no vertex -1"),
    ("a name", "first", "is not an array of numbers"),
    ("a part of a vertex", 1.5, "integer"),
    ("a face that is not there", vorogeo.SurfacePoints([9999], [[1.0, 0, 0]]), "9999"),
    ("weights that are not barycentric", vorogeo.SurfacePoints([0], [[0.9, 0.9, 0]]), "0.9"),
    ("weights that are NaN", vorogeo.SurfacePoints([0], [[np.nan, 0, 1]]), "not finite"),
]
ASKED: dict[str, Question] = {
    "exact field": lambda x: ask.field("exact", SHAPE, x),
    "index field": lambda x: ask.field("index", SHAPE, x),
    "quick field": lambda x: ask.field("quick", SHAPE, x),
    "exact distance": lambda x: ask.distance("exact", SHAPE, x, x),
    "index distance": lambda x: ask.distance("index", SHAPE, x, x),
    "exact path": lambda x: ask.path("exact", SHAPE, x, x),
    "index path": lambda x: ask.path("index", SHAPE, x, x),
    "function path": lambda x: ask.path("function", SHAPE, x, x),
    "matrix": lambda x: ask.matrix("pairs", SHAPE, x),
    "fields": lambda x: ask.fields("index", SHAPE, x),
    "nearest": lambda x: ask.nearest("index", SHAPE, x, [0], 1),
    "pairs within": lambda x: ask.pairs_within("index", SHAPE, x, 1.0),
    "voronoi": lambda x: ask.task("voronoi", "index", SHAPE, x),
    "disk": lambda x: ask.task("disk", "index", SHAPE, x, 1.0),
    "band": lambda x: ask.task("band", "index", SHAPE, x, 1.0),
    "polygon": lambda x: ask.task("polygon", "index", SHAPE, x),
    "sets": lambda x: ask.task("set_distances", "index", SHAPE, 0, x),
    "cut": lambda x: ask.surface(SHAPE).cut([x]),
    "eccentricity": lambda x: ask.task("eccentricity", "index", SHAPE, x),
    "samples": lambda x: ask.task("sample_farthest", "index", SHAPE, 3, start=x),
    "relaxed points": lambda x: ask.task("relax", "index", SHAPE, x),
}


@pytest.mark.parametrize("asked", ASKED)
@pytest.mark.parametrize(("kind", "points", "sentence"), IDS, ids=[row[0] for row in IDS])
def test_points_that_are_not_on_the_surface(asked: str, kind: str, points: Any, sentence: str) -> None:
    with ask.refused(sentence):
        ASKED[asked](points)


ARGUMENTS: dict[str, tuple[Callable[[], Any], str]] = {
    "no source": (lambda: ask.field("exact", SHAPE, []), "sources: is empty"),
    "no source of an index": (lambda: ask.field("index", SHAPE, []), "sources: is empty"),
    "no source of a function": (lambda: ask.field("function", SHAPE, []), "sources: is empty"),
    "no regions": (lambda: ask.task("voronoi", "index", SHAPE, []), "points: is empty"),
    "a negative limit": (lambda: ask.field("exact", SHAPE, 0, -1.0), "max_distance: -1.0 is negative"),
    "a negative limit of an index": (lambda: ask.field("index", SHAPE, 0, -1.0), "max_distance: -1.0 is negative"),
    "a limit that is NaN": (lambda: ask.fields("index", SHAPE, [0], max_distance=np.nan), "max_distance: is NaN"),
    "an offset below 0": (lambda: ask.field("exact", SHAPE, [0, 1], offsets=[0, -2]), r"offsets\[1\]: is -2"),
    "too few offsets": (lambda: ask.field("index", SHAPE, [0, 1], offsets=[0]), "offsets: has shape"),
    "an unknown method": (lambda: ask.field("automatic", SHAPE, 0, method="fast"), "method: 'fast' is unknown"),
    "a quick distance": (lambda: ask.distance("quick", SHAPE, 0, 1), "method: 'quick' is unknown"),
    "a quick path": (lambda: ask.path("quick", SHAPE, 0, 1), "method: 'quick' is unknown"),
    "an unknown way to a matrix": (lambda: ask.matrix("index", SHAPE, [0], entries="x"), "entries: 'x' is unknown"),
    "a method of the literature": (lambda: vorogeo.distance_field(*ask.mesh(SHAPE), 0, method="x"), "method: 'x'"),
    "whole numbers as result": (lambda: ask.field("exact", SHAPE, 0, dtype=np.int64), "dtype: int64 is not possible"),
    "a type that is none": (lambda: ask.matrix("pairs", SHAPE, [0], dtype="real"), "dtype: 'real'"),
    "pairs of other lengths": (lambda: ask.distance("exact", SHAPE, [0, 1], [2]), "source has 2 points, target 1"),
    "pairs of an index": (lambda: ask.distance("index", SHAPE, [0, 1], [2]), "source has 2 points, target 1"),
    "no neighbours": (lambda: ask.nearest("index", SHAPE, [0], [1], 0), "k: 0 is out of range"),
    "a radius below 0": (lambda: ask.pairs_within("index", SHAPE, [0], -1.0), "radius: -1.0 is negative"),
    "a radius that is NaN": (lambda: ask.task("disk", "index", SHAPE, 0, np.nan), "radius: is NaN"),
    "samples without an end": (lambda: ask.task("sample_farthest", "index", SHAPE), "Give a count of samples"),
    "disks of no radius": (lambda: ask.task("sample_poisson_disk", "index", SHAPE, 0.0), "radius: 0.0 is out of range"),
    "one field for an extent": (lambda: ask.task("extent", "index", SHAPE, fields=1), "fields: 1 is out of range"),
    "a start that is not there": (lambda: ask.task("extent", "index", SHAPE, start=COUNT), "start: "),
    "rounds below 0": (lambda: ask.task("relax", "index", SHAPE, [0], -1), "rounds: -1 is out of range"),
    "values of other vertices": (lambda: ask.isolines(SHAPE, np.zeros(3), [1.0]), "field: has 3 values"),
    "an unknown interpolation": (lambda: ask.isolines(SHAPE, np.ones(COUNT), [1.0], "cubic"), "interpolation: 'c"),
    "a place that is NaN": (lambda: ask.snapped("exact", SHAPE, [0, np.nan, 0]), r"points\[0\]"),
    "a place far away": (lambda: ask.snapped("index", SHAPE, [[0, 0, 0], [0, 0, 5]], 1.0), r"points\[1\]: is 5 away"),
    "no threads": (lambda: ask.new_index(SHAPE, threads=0), "threads: 0 is out of range"),
    "a delta of one": (lambda: ask.new_index(SHAPE, delta=1.0), "delta: 1.0 is out of range"),
    "a mask of other faces": (lambda: ask.new_surface(SHAPE, mask=[True]), "mask"),
    "a curve without an edge": (lambda: ask.field("exact", SHAPE, vorogeo.EdgeCurve([3])), "one edge at least"),
    "no function": (lambda: ask.task("voronoi", "index", SHAPE, [0], progress="yes"), "progress: 'yes'"),
}  # fmt: skip


@pytest.mark.parametrize("case", ARGUMENTS)
def test_an_argument_out_of_its_range(case: str) -> None:
    question, sentence = ARGUMENTS[case]
    before = ask.surface(SHAPE).last
    with ask.refused(sentence):
        question()
    assert ask.surface(SHAPE).last is before
    assert issubclass(vorogeo.InvalidInput, ValueError)


def cancel(_fraction: float, _text: str) -> bool:
    return False


BENT, MANY = table.named("bumpy"), range(50)
LONG: dict[str, Callable[[Any], Any]] = {
    "building an index": lambda on: on.build_index(progress=cancel),
    "an exact field": lambda on: ask.field("exact", BENT, 0, on=on, progress=cancel),
    "a quick field": lambda on: ask.field("quick", BENT, 0, on=on, progress=cancel),
    "an exact path": lambda on: ask.path("exact", BENT, 0, 200, progress=cancel),
    "paths": lambda on: ask.path("index", BENT, [0] * 50, [9] * 50, progress=cancel),
    "a matrix": lambda on: ask.matrix("pairs", BENT, MANY, progress=cancel),
    "fields": lambda on: ask.fields("index", BENT, MANY, progress=cancel),
    "nearest": lambda on: ask.nearest("index", BENT, MANY, MANY, 3, progress=cancel),
    "pairs within": lambda on: ask.pairs_within("index", BENT, MANY, 1.0, progress=cancel),
    "regions": lambda on: ask.task("voronoi", "index", BENT, MANY, progress=cancel),
    "farthest samples": lambda on: ask.task("sample_farthest", "index", BENT, 50, progress=cancel),
    "Poisson disks": lambda on: ask.task("sample_poisson_disk", "index", BENT, 0.05, progress=cancel),
    "extent": lambda on: ask.task("extent", "index", BENT, progress=cancel),
    "relaxation": lambda on: ask.task("relax", "index", BENT, MANY, progress=cancel),
}


@pytest.mark.parametrize("question", LONG)
def test_cancelling_raises_and_leaves_the_object_usable(question: str) -> None:
    fresh, before = ask.new_surface(BENT), ask.field("index", BENT, 3)
    with pytest.raises(vorogeo.Cancelled):
        LONG[question](fresh)
    assert fresh.index is None
    np.testing.assert_array_equal(ask.field("index", BENT, 3), before)
    np.testing.assert_array_equal(ask.field("exact", BENT, 3, on=fresh), ask.field("exact", BENT, 3))
