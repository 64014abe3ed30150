"""Medians, spreads and errors of measurements, as plain dictionaries that go into the JSON files of results."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

import methods
from measure import Line, Result

Summary = dict[str, Any]
#: The figures of errors that tables show.
ERRORS = ("mean", "p99", "over", "under")


def of_line(line: Line) -> Summary | None:
    """The spread of a line of core_bench."""
    return spread(line.values, line.cpu)


def spread(values: Sequence[float], cpu: Sequence[float] = ()) -> Summary | None:
    """Median, p99, quartiles and range of measurements, and the same of processor time; None without any."""
    if not len(values):
        return None
    array = np.asarray(values, float)
    return {
        "median": float(np.median(array)),
        "p99": float(np.quantile(array, 0.99)),
        "q1": float(np.quantile(array, 0.25)),
        "q3": float(np.quantile(array, 0.75)),
        "min": float(array.min()),
        "max": float(array.max()),
        "count": len(array),
        "cpu": spread(cpu),
    }


def errors(found: NDArray[np.float64], exact: NDArray[np.float64]) -> Summary | None:
    """Relative errors in percent where the exact distance is positive and finite.

    `missing` is the share of distances that are NaN, infinite or negative, in percent; they count in no other figure.
    `over` and `under` are the largest errors to either side, both positive.
    """
    compared = (exact > 0) & np.isfinite(exact)
    if not compared.any():
        return None
    found, exact = found[compared], exact[compared]
    there = np.isfinite(found) & (found >= 0) & (found < 1e3 * exact.max())
    if not there.any():
        return {"missing": 100.0}
    error = 100 * (found[there] - exact[there]) / exact[there]
    size = np.abs(error)
    return {
        "mean": float(size.mean()),
        "p99": float(np.quantile(size, 0.99)),
        "over": float(max(error.max(), 0.0)),
        "under": float(max(-error.min(), 0.0)),
        "missing": float(100 * (1 - there.mean())),
    }


def of_method(
    result: Result, exact_fields: NDArray[np.float64], exact_pairs: NDArray[np.float64], first_near: int
) -> Summary:
    """The figures of a method; its pairs are far ones, near ones from the number `first_near` on."""
    description = methods.description(result.name)
    summary: Summary = {
        "title": description.title,
        "package": description.package,
        "version": result.version,
        "exact": description.exact,
        "prepared": result.prepared,
        "peak_bytes": result.peak_bytes,
        "failure": result.failure,
        "field": spread(result.field_seconds, result.field_cpu),
        "field_sources": 0 if result.fields is None else len(result.fields),
        "many": spread(result.many, result.many_cpu),
    }
    if result.fields is not None and len(result.fields):
        summary["field_error"] = errors(result.fields, exact_fields[: len(result.fields)])
    distances = np.array(result.pair_distances)
    for name, part in (("far", slice(0, first_near)), ("near", slice(first_near, None))):
        summary[name] = spread(result.pair_seconds[part], result.pair_cpu[part])
        if len(distances[part]):
            summary[f"{name}_error"] = errors(distances[part], exact_pairs[: len(distances)][part])
    return summary
