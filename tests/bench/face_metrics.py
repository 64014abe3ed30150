"""Metrics that jump at edges against formulas: fields and pairs of an index, fields without one, with defaults.

Usage: tests/bench/face_metrics.sh [--cells N] [--pairs K]
"""

from __future__ import annotations

import argparse

import numpy as np
import vorogeo

import summary
import tables
import weighted_shapes

COLUMNS = "surface | answer | mean error | p99 | too long | too short"


def errors_of(shape: weighted_shapes.Shape, pairs: int) -> list[list[str]]:
    """Errors in percent of an index, of pairs of it, and without one."""
    index = vorogeo.GeodesicIndex(shape.vertices, shape.faces, metric=shape.metric)
    known = np.flatnonzero(np.isfinite(shape.exact) & (shape.exact > 0))
    chosen = np.random.default_rng(0).choice(known, min(pairs, len(known)), replace=False)
    answers = {
        "field of the index": (index.distance_field(shape.source)[known], known),
        "pairs of the index": (index.distance(np.full(len(chosen), shape.source), chosen), chosen),
        "field without an index": (
            vorogeo.exact_distance_field(shape.vertices, shape.faces, shape.source, metric=shape.metric)[known],
            known,
        ),
    }
    rows = []
    for answer, (found, targets) in answers.items():
        errors = summary.errors(np.asarray(found), shape.exact[targets])
        assert errors is not None
        figures = [f"{errors[key]:.2g} %" for key in ("mean", "p99", "over", "under")]
        rows.append([shape.name if not rows else "", answer, *figures])
    return rows


def main() -> None:
    """Prints the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cells", type=int, default=100, help="the surfaces have twice its square of faces")
    parser.add_argument("--pairs", type=int, default=1000)
    options = parser.parse_args()
    rows = [row for shape in weighted_shapes.all_shapes(options.cells) for row in errors_of(shape, options.pairs)]
    print(tables.table(COLUMNS, rows))


if __name__ == "__main__":
    main()
