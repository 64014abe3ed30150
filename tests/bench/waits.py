"""How long one waits: fields on one and on two threads, and the slowest of many questions of two points."""

from __future__ import annotations

import argparse
import statistics
import time
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
import vorogeo

import meshes
import tables

FIELDS = 5
FIELD_HEADING = (
    "mesh | vertices | exact, 1 thread | 2 threads | times faster | quick, 1 thread | 2 threads | times faster"
)
PAIR_HEADING = "mesh | question | median | mean | 95 % below | 99 % below | of the median"
#: What is asked of two vertices, and whether an index answers.
QUESTIONS: dict[str, tuple[bool, Callable[[Any, int, int], object]]] = {
    "distance, no index": (False, lambda s, a, b: s.distance(a, b, method="exact")),
    "path, no index": (False, lambda s, a, b: s.path(a, b, method="exact")),
    "distance": (True, lambda s, a, b: s.distance(a, b, method="index")),
    "refined path": (True, lambda s, a, b: s.path(a, b, method="index")),
}


def options(parser: argparse.ArgumentParser) -> None:
    """Which meshes, how many pairs."""
    parser.add_argument("meshes", nargs="*", default=["bunny", "igea"], metavar="MESH", help="default: bunny igea")
    parser.add_argument("--pairs", type=int, default=400, help="of random vertices (400)")


def run(options: argparse.Namespace) -> dict[str, str]:
    """Measure the meshes one by one."""
    fields, pairs = [], []
    for name in options.meshes:
        file = meshes.find(name)
        if not file:
            continue
        mesh = meshes.load(file)
        fields.append(field_row(file.stem, mesh))
        pairs += pair_rows(file.stem, mesh, options.pairs)
        print(" | ".join(fields[-1]), *(" | ".join(row) for row in pairs[-len(QUESTIONS) :]), sep="\n", flush=True)
    return {"threads": tables.table(FIELD_HEADING, fields), "waits": tables.table(PAIR_HEADING, pairs)}


def seconds(ask: Callable[..., object], *arguments: object, **options: object) -> float:
    """By the clock."""
    start = time.perf_counter()
    ask(*arguments, **options)
    return time.perf_counter() - start


def field_row(name: str, mesh: meshes.Mesh) -> list[str]:
    """The row of a mesh: medians of fields of surfaces that have answered before."""
    sources = np.random.default_rng(3).integers(0, len(mesh[0]), FIELDS).tolist()
    surfaces = [vorogeo.Surface(*mesh, threads=threads) for threads in (1, 2)]
    row = [name, f"{len(mesh[0]):,}"]
    for method in ("exact", "quick"):
        one, two = (
            statistics.median([seconds(s.distance_field, i, method=method) for i in [0, *sources]][1:])
            for s in surfaces
        )
        row += [tables.duration(one), tables.duration(two), tables.number(one / two)]
    return row


def pair_rows(name: str, mesh: meshes.Mesh, count: int) -> list[list[str]]:
    """The rows of a mesh: each question of the same pairs on one thread, one by one."""
    pairs = np.random.default_rng(4).integers(0, len(mesh[0]), (count, 2)).tolist()
    surfaces = [vorogeo.Surface(*mesh, threads=1), vorogeo.GeodesicIndex(*mesh, threads=1)]
    for by_index, ask in QUESTIONS.values():  # what is made for the first question is no wait for others
        ask(surfaces[by_index], *pairs[0])
    return [
        [name, question, *spread(seconds(ask, surfaces[by_index], a, b) for a, b in pairs)]
        for question, (by_index, ask) in QUESTIONS.items()
    ]


def spread(times: Iterable[float]) -> list[str]:
    """Median, mean, and how long the slowest take."""
    found = np.array(list(times))
    median, p95, p99 = np.percentile(found, [50, 95, 99])
    return [*map(tables.duration, (median, found.mean(), p95, p99)), tables.number(p99 / median)]
