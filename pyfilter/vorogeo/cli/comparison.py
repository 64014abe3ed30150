"""The command compare: errors and times of methods, or of a field made elsewhere, against the exact field."""

from __future__ import annotations

import time
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import InvalidInput
from ..geodesic_methods import GeodesicMethod, MethodWarning, methods
from ..mesh_input import MeshInput
from .job import MeshTask
from .outputs import Result


@dataclass
class _Compared:
    """A field and what it took; no times are known of one that was made elsewhere."""

    name: str
    values: NDArray[np.float64]
    prepared: float | None = None
    took: float | None = None


def compare(task: MeshTask) -> Result:
    """Errors and times of the index, of chosen methods or of a field made elsewhere, against the exact field."""
    sources = task.points("from")
    began = time.perf_counter()
    exact = task.plain.distance_field(sources, method="exact")
    exact_took = time.perf_counter() - began
    left_out: list[str] = []
    if task.options.get("with"):
        fields = [_from_file(task.options["with"], exact.shape)]
    else:
        names = task.options.get("methods") or ["vorogeo"]
        if "all" in names:
            fields, left_out = _all_fields(task, sources)
        else:
            fields = [_field(task, name, sources) for name in dict.fromkeys(names)]
    lines = [f"exact field in {exact_took:.3f} s"]
    if len(fields) == 1:
        lines[0] += f"; {_sentence(fields[0], exact)}"
    else:
        lines += [*_table(fields, exact), *left_out]
    values = np.stack([one.values for one in fields]) if len(fields) > 1 else fields[0].values
    with np.errstate(invalid="ignore"):  # not a number where neither reaches
        arrays: dict[str, NDArray[Any]] = {"distance": values, "exact": exact, "error": values - exact}
    if len(fields) > 1:
        arrays["method"] = np.array([one.name for one in fields])
    per_vertex = "error" if len(fields) == 1 else ""
    rows = [_row(one, exact) for one in fields]
    summary = {"exact_seconds": exact_took, "methods": rows, "left_out": left_out}
    return Result("error", arrays, task.shown_mesh, per_vertex, text="\n".join(lines), summary=summary)


def _from_file(file: str, shape: tuple[int, ...]) -> _Compared:
    values = np.load(file).astype(float)
    if values.shape != shape:
        raise InvalidInput(f"{file}: has shape {values.shape}; give one distance for each of {shape[0]} vertices.")
    return _Compared(file, values)


def _all_fields(task: MeshTask, sources: Any) -> tuple[list[_Compared], list[str]]:
    """Fields of all methods that work on this mesh, and a line for each of the others."""
    fields, left_out = [], []
    for name in methods:
        try:
            fields.append(_field(task, name, sources))
        except InvalidInput as error:
            if not isinstance(sources, np.ndarray):  # no method but the index begins there
                raise
            left_out.append(f"left out: {error}")
    return fields, left_out


def _field(task: MeshTask, name: str, sources: Any) -> _Compared:
    began = time.perf_counter()
    answer: Callable[[Any], NDArray[np.float64]]
    if name == "vorogeo":
        answer = task.index.distance_field  # the index of the options, not one with default settings
    elif not isinstance(sources, np.ndarray):
        raise InvalidInput(f"--from: {name} begins at vertices; give ids, or leave out --methods.")
    else:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", MethodWarning)  # the table shows what they warn of
            faces = MeshInput.read(task.vertices, task.faces, task.mask).measured_faces
            answer = GeodesicMethod(task.vertices, faces, name, metric=task.metric).distance_field
    between = time.perf_counter()
    values = answer(sources)
    ended = time.perf_counter()
    return _Compared("index" if name == "vorogeo" else name, values, between - began, ended - between)


def _errors(one: _Compared, exact: NDArray[np.float64]) -> tuple[float, float, float, int]:
    """Mean, 99th percentile and largest relative error in percent, and vertices that one of both did not reach."""
    used = np.isfinite(exact) & (exact > 0) & np.isfinite(one.values)
    error = np.abs(one.values[used] / exact[used] - 1) * 100 if used.any() else np.zeros(1)
    missed = int((np.isfinite(exact) != np.isfinite(one.values)).sum())
    return float(error.mean()), float(np.percentile(error, 99)), float(error.max()), missed


def _row(one: _Compared, exact: NDArray[np.float64]) -> dict[str, Any]:
    """The same with their names, for JSON."""
    errors = dict(zip(("mean", "p99", "largest", "missed"), _errors(one, exact), strict=True))
    return {"method": one.name, "prepared_seconds": one.prepared, "field_seconds": one.took, **errors}


def _sentence(one: _Compared, exact: NDArray[np.float64]) -> str:
    mean, p99, largest, missed = _errors(one, exact)
    took = "" if one.took is None else f" in {one.took:.4f} s"
    return (
        f"{one.name}{took}: mean error {mean:.4g} %, 99 % of errors below {p99:.4g} %, largest {largest:.4g} %; "
        f"reached by one of the two only: {missed}"
    )


def _table(fields: list[_Compared], exact: NDArray[np.float64]) -> list[str]:
    lines = [
        f"{'method':<14}{'prepared s':>11}{'field s':>9}{'mean %':>10}{'99 % %':>10}{'largest %':>11}{'missed':>8}"
    ]
    for one in fields:
        mean, p99, largest, missed = _errors(one, exact)
        lines.append(
            f"{one.name:<14}{one.prepared:>11.3f}{one.took:>9.4f}{mean:>10.3g}{p99:>10.3g}{largest:>11.3g}{missed:>8}"
        )
    return lines
