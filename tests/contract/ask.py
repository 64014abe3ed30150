"""How each answerer is asked each question, and its promised errors: the only file here that knows these calls."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
import pytest
import vorogeo
from numpy.typing import NDArray
from surfaces import Floats, Ids, Shape

#: Who answers which question. "exact", "automatic" and "quick" ask a Surface, "function" a free function; "index",
#: "fields" and "pairs" read from an index, and "by index, exact" asks an index for exact answers.
FIELDS = ("exact", "automatic", "index", "by index, exact", "quick", "function")
DISTANCES = ("exact", "automatic", "index", "by index, exact", "function")
PATHS = ("exact", "automatic", "index", "by index, exact", "function")
MATRICES = ("pairs", "fields", "by index, exact", "exact", "automatic")
TASKS = ("index", "by index, exact", "exact", "automatic")

Points = Any


@dataclass(frozen=True)
class Errors:
    """Relative errors of an answer, at most."""

    mean: float
    largest: float


#: Twice those of docs/figures.md: of an index, also with values of faces, and of quick fields on the worst mesh.
_INDEX = Errors(4e-4, 2e-2)
_INDEX_OF_JUMPS = Errors(1.7e-3, 4.6e-2)
_QUICK = Errors(1e-3, 1e-2)
_ERRORS = {"index": _INDEX, "pairs": _INDEX, "fields": _INDEX, "quick": _QUICK}


def errors(by: str, shape: Shape) -> Errors:
    """What an answerer promises on a surface."""
    own = _ERRORS.get(by, Errors(0.0, 0.0))
    if own is _INDEX and jumps(shape):
        own = _INDEX_OF_JUMPS
    return Errors(own.mean + shape.slack / 2, own.largest + shape.slack)


def is_exact(by: str) -> bool:
    """Whether an answerer has no errors of its own."""
    return by not in _ERRORS


def jumps(shape: Shape) -> bool:
    """Whether the metric of a surface jumps at edges: the values of its faces differ."""
    metric = shape.metric
    values = {vorogeo.FaceCost: "cost", vorogeo.FaceTensor: "tensors"}.get(type(metric))
    return values is not None and np.ptp(getattr(metric, values), axis=0).max() > 0


def can_answer(by: str, shape: Shape) -> bool:
    """Whether an answerer takes the metric of a surface."""
    if isinstance(shape.metric, vorogeo.FaceRanders):
        return by in ("exact", "automatic", "function")
    return by != "quick" or not jumps(shape)


def assert_answers(by: str, shape: Shape, answer: Any, expected: Floats) -> None:
    """Distances are the expected ones as closely as their answerer promises, and infinite or zero where those are."""
    answer, expected = np.asarray(answer, float), np.asarray(expected, float)
    assert answer.shape == expected.shape
    np.testing.assert_array_equal(np.isinf(answer), np.isinf(expected))
    near = np.isfinite(expected) & (expected < 1e-9 * np.max(expected, where=np.isfinite(expected), initial=1.0))
    np.testing.assert_allclose(answer[near], 0, atol=1e-9)
    far = np.isfinite(expected) & ~near
    error = np.abs(answer[far] / expected[far] - 1)
    promised = errors(by, shape)
    assert error.max(initial=0) <= promised.largest
    assert error.size < 100 or error.mean() <= promised.mean


def mesh(shape: Shape) -> tuple[Floats | None, Ids]:
    """The arrays of a surface; lengths of edges need no positions."""
    return (None if isinstance(shape.metric, vorogeo.EdgeLengths) else shape.vertices), shape.faces


def new_surface(shape: Shape, **options: Any) -> vorogeo.Surface:
    """A surface that has answered nothing yet."""
    return vorogeo.Surface(*mesh(shape), metric=shape.metric, **options)


def new_index(shape: Shape, **options: Any) -> vorogeo.GeodesicIndex:
    """An index with several patches, since on one patch every answer is exact."""
    return vorogeo.GeodesicIndex(*mesh(shape), metric=shape.metric, patches=(3, 3), **options)


@cache
def surface(shape: Shape) -> vorogeo.Surface:
    """The surface that all tests share."""
    return new_surface(shape)


@cache
def index(shape: Shape) -> vorogeo.GeodesicIndex:
    """The index that all tests share."""
    return new_index(shape)


def loaded(file: Any, shape: Shape, **options: Any) -> vorogeo.GeodesicIndex:
    """The index of a file."""
    return vorogeo.GeodesicIndex.load(file, *mesh(shape), metric=shape.metric, **options)


def object_of(by: str, shape: Shape) -> Any:
    """The object that answers: a shared one, except for automatic answers, which depend on earlier questions."""
    if by == "automatic":
        return new_surface(shape)
    return surface(shape) if by in ("exact", "quick") else index(shape)


def choice(by: str) -> dict[str, Any]:
    """The option by which an object is told how to answer."""
    return {"exact": {"method": "exact"}, "quick": {"method": "quick"}, "by index, exact": {"method": "exact"}}.get(
        by, {}
    )


def field(by: str, shape: Shape, sources: Any, limit: float | None = None, on: Any = None, **options: Any) -> Any:
    """The distances of all vertices from the nearest source; `on`: another object than the shared one."""
    if by == "function":
        return vorogeo.exact_distance_field(*mesh(shape), sources, limit, metric=shape.metric, **options)
    return (on or object_of(by, shape)).distance_field(sources, limit, **choice(by), **options)


def labelled_field(by: str, shape: Shape, sources: Any, **options: Any) -> tuple[Floats, Ids]:
    """The field, and which source is the nearest; no free function does that."""
    return field(by, shape, sources, return_labels=True, **options)


def snapped(by: str, shape: Shape, places: Any, limit: float | None = None) -> vorogeo.SurfacePoints:
    """The points of the surface that are nearest to places in space."""
    return object_of(by, shape).snap(places, limit)


def distance(by: str, shape: Shape, source: Points, target: Points) -> Any:
    """The distance of two points, or of each of k pairs."""
    if by == "function":
        paths = path(by, shape, source, target)
        return np.array([each.length for each in paths]) if isinstance(paths, list) else paths.length
    return object_of(by, shape).distance(source, target, **choice(by))


def path(by: str, shape: Shape, source: Points, target: Points, **options: Any) -> Any:
    """The shortest path of two points, or of each of k pairs; from an index the refined path."""
    if by == "function":
        return vorogeo.exact_path(*mesh(shape), source, target, metric=shape.metric, **options)
    if by == "by index, exact":
        return index(shape).exact_path(source, target, **options)
    return object_of(by, shape).path(source, target, **choice(by), **options)


def matrix(by: str, shape: Shape, points: Points, others: Points | None = None, on: Any = None, **options: Any) -> Any:
    """The distances of all points, or of all points from all others."""
    how = {"entries": by} if by in ("pairs", "fields") else choice(by)
    return (on or object_of(by, shape)).distance_matrix(points, others, **how, **options)


def fields(by: str, shape: Shape, sources: Points, **options: Any) -> Any:
    """The field of each source."""
    return object_of(by, shape).fields(sources, **choice(by), **options)


def nearest(by: str, shape: Shape, points: Points, queries: Points, k: int, **options: Any) -> tuple[Floats, Ids]:
    """Distances and positions of the k nearest points of each query."""
    return object_of(by, shape).nearest(points, queries, k, **choice(by), **options)


def pairs_within(
    by: str, shape: Shape, points: Points, radius: float, others: Points | None = None, **options: Any
) -> Floats:
    """All pairs at most a radius apart as a full matrix; NaN where there is none."""
    sparse = object_of(by, shape).pairs_within(points, radius, others, as_arrays=True, **choice(by), **options)
    full = np.full(sparse.shape, np.nan)
    full[np.repeat(np.arange(sparse.shape[0]), np.diff(sparse.indptr)), sparse.indices] = sparse.data
    return full


def task(name: str, by: str, shape: Shape, *arguments: Any, on: Any = None, **options: Any) -> Any:
    """A task by its name: voronoi, disk, relax, sample_farthest, sample_poisson_disk, eccentricity, extent."""
    return getattr(on or object_of(by, shape), name)(*arguments, **choice(by), **options)


def isolines(shape: Shape, values: Floats, levels: Sequence[float] | int, interpolation: str = "distance") -> Any:
    """The lines on which a field has these values."""
    return index(shape).isolines(values, levels, interpolation)


def bridged(by: str, mesh: tuple[Floats, Ids], gap: float, folds: bool = False, metric: Any = None) -> Any:
    """A surface or an index whose gaps are bridged."""
    if by in ("index", "by index, exact"):
        return vorogeo.GeodesicIndex(*mesh, patches=(3, 3), gap=gap, bridge_folds=folds, metric=metric)
    return vorogeo.Surface(*mesh, gap=gap, bridge_folds=folds, metric=metric)


def gap_field(
    by: str, mesh: tuple[Floats, Ids], source: int, gap: float, folds: bool = False, metric: Any = None
) -> NDArray[Any]:
    """A field on a mesh whose gaps are bridged."""
    if by == "function":
        return vorogeo.exact_distance_field(*mesh, source, gap=gap, bridge_folds=folds, metric=metric)
    return bridged(by, mesh, gap, folds, metric).distance_field(source, **choice(by))


def refused(sentence: str, kind: type[Exception] = vorogeo.InvalidInput) -> Any:
    """Expects an error of this kind whose message holds this sentence."""
    return pytest.raises(kind, match=sentence)
