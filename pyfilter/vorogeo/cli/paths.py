"""Paths over the surface as results: their points one after the other, as arrays, a table or lines."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..results import GeodesicPath
from .job import MeshTask
from .outputs import Result, format_of


def lines_of(task: MeshTask, paths: list[GeodesicPath]) -> Result:
    """The points of paths, one path after the other."""
    begin = np.concatenate([[0], np.cumsum([len(one.points) for one in paths])])
    points = np.concatenate([one.points for one in paths]) / task.scale
    arrays: dict[str, NDArray[Any]] = {
        "points": points,
        "path": np.repeat(np.arange(len(paths)), np.diff(begin)),
        "length": np.array([one.length for one in paths]),
        "certified": np.array([one.certified for one in paths]),
        "face": np.concatenate([one.surface_points.faces for one in paths]),
        "barycentric": np.concatenate([one.surface_points.barycentric for one in paths]),
        "vertex": np.concatenate([one.vertices for one in paths]),
    }
    joined = np.flatnonzero(arrays["path"][1:] == arrays["path"][:-1])
    text = "\n".join(f"{one.length:.12g}" for one in paths)
    result = Result("points", arrays, task.shown_mesh, lines=(points, np.column_stack([joined, joined + 1])), text=text)
    result.summary = {name: arrays[name] for name in ("length", "certified")}
    if format_of(task.target) == ".csv":
        columns = [arrays["path"], points, arrays["face"], arrays["barycentric"]]
        result.arrays = {"points": np.column_stack(columns)}
        result.columns = ["path", "x", "y", "z", "face", "weight1", "weight2", "weight3"]
    return result
