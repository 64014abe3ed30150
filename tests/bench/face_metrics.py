"""Metrics that jump at edges against formulas: fields and pairs of an index, fields without one, with defaults."""

from __future__ import annotations

import argparse

import numpy as np
import vorogeo

import summary
import tables
import weighted_shapes

HEADING = (
    "% | no index: mean | p99 | long | short | index, field: mean | p99 | long | short | pairs: mean | p99 | long "
    "| short"
)


def options(parser: argparse.ArgumentParser) -> None:
    """How large, how many."""
    parser.add_argument("--cells", type=int, default=100, help="the surfaces have twice its square of faces")
    parser.add_argument("--pairs", type=int, default=1000)


def run(options: argparse.Namespace) -> dict[str, str]:
    """A row for each surface."""
    rows = [errors_of(shape, options.pairs) for shape in weighted_shapes.all_shapes(options.cells)]
    return {"face metrics": tables.table(HEADING, rows)}


def errors_of(shape: weighted_shapes.Shape, pairs: int) -> list[str]:
    """Errors in percent without an index, of fields and of pairs of one."""
    index = vorogeo.GeodesicIndex(shape.vertices, shape.faces, metric=shape.metric)
    known = np.flatnonzero(np.isfinite(shape.exact) & (shape.exact > 0))
    chosen = np.random.default_rng(0).choice(known, min(pairs, len(known)), replace=False)
    exact = vorogeo.exact_distance_field(shape.vertices, shape.faces, shape.source, metric=shape.metric)
    answers = (
        (exact[known], known),
        (index.distance_field(shape.source)[known], known),
        (index.distance(np.full(len(chosen), shape.source), chosen), chosen),
    )
    found = [summary.errors(np.asarray(answer), shape.exact[targets]) for answer, targets in answers]
    return [shape.name, *(tables.percent(each, key) for each in found for key in summary.ERRORS)]
