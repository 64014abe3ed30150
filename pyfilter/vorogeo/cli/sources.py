"""Points and metrics named on the command line: vertex ids, positions, or files that hold these or values."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..brain import vertex_values
from ..errors import InvalidInput
from ..mesh_files import read_mesh
from ..metrics import (
    FaceCost,
    FaceTensor,
    Metric,
    VertexCost,
    VertexTensor,
    climbing_cost,
    curvature_tensor,
    hiking_time,
    naismith,
    slope_cost,
    tobler,
    travel_time,
)
from ..points import Points, SurfacePoints

_TABLES = (".npy", ".txt", ".csv", ".dat")
"""Endings of files that hold numbers."""


def points_of(name: str, words: list[str], snap: Callable[[Any], SurfacePoints], scale: float) -> Points:
    """The points; positions, in the unit of the file, are moved by `snap` to the nearest point of the surface."""
    found: list[Points] = [_points_of_word(name, word, snap, scale) for word in words]
    if all(isinstance(part, np.ndarray) for part in found):
        return np.concatenate([np.atleast_1d(np.asarray(part)) for part in found])
    return list(found)  # type: ignore[return-value]


def _points_of_word(name: str, word: str, snap: Callable[[Any], SurfacePoints], scale: float) -> Points:
    try:
        return np.array([int(word)])
    except ValueError:
        pass
    if word.count(",") == 2:
        try:
            return snap(scale * np.array([float(number) for number in word.split(",")]))
        except ValueError as error:
            raise InvalidInput(f"{name} {word}: {error}") from None
    path = Path(word)
    if not path.is_file():
        raise InvalidInput(
            f"{name} {word}: is neither a vertex id, nor a position x,y,z, nor a file with ids or positions."
        )
    values = numbers_in(path) if path.suffix.lower() in _TABLES else read_mesh(path)[0]
    if values.ndim == 2 and values.shape[1] == 3:
        return snap(scale * values.astype(float))
    if (values.ndim == 2 and values.shape[1] == 1) or values.ndim <= 1:
        ids = np.atleast_1d(values.squeeze())
        if (ids == np.round(ids)).all():
            return ids.astype(np.int64)
    raise InvalidInput(f"{name} {word}: holds numbers of shape {values.shape}; give one column of ids or x, y, z.")


def numbers_in(file: str | Path) -> NDArray[Any]:
    """The numbers of an array or of a table."""
    path = Path(file)
    try:
        if path.suffix.lower() == ".npy":
            return np.asarray(np.load(path, allow_pickle=False))
        text = path.read_text().replace(",", " ").replace(";", " ").splitlines()
        return np.array([[float(number) for number in line.split()] for line in text if line.strip()])
    except ValueError as error:
        raise InvalidInput(f"{path}: is no table of numbers ({error}); give rows of equal length.") from None


def values_in(name: str, file: str) -> NDArray[Any]:
    """What an array, a table or a file of values of vertices holds; a column is a list."""
    if not os.path.isfile(file):
        raise InvalidInput(f"{name} {file}: there is no such file.")
    values = numbers_in(file) if file.lower().endswith(_TABLES) else vertex_values(file)[0]
    return values[:, 0] if values.ndim == 2 and values.shape[1] == 1 else values


def metric_of(options: dict[str, Any], vertices: NDArray[np.float64], faces: NDArray[np.int32]) -> Metric | None:
    """What paths cost on this mesh; None is their length."""
    if options.get("metric"):
        return _metric_from_file(options["metric"], vertices, faces)
    if options.get("slope_penalty") is not None:
        return slope_cost(vertices, faces, penalty=options["slope_penalty"])
    if options.get("hiking") is not None:
        pace = options["hiking"]
        known = {"tobler": tobler, "naismith": naismith}
        return hiking_time(vertices, faces, known[pace] if isinstance(pace, str) else climbing_cost(*pace))
    if options.get("curvature_weight") is not None:
        return curvature_tensor(vertices, faces, options["curvature_weight"])
    return None


def _metric_from_file(file: str, vertices: NDArray[np.float64], faces: NDArray[np.int32]) -> Metric:
    values, count, face_count = values_in("--metric", file), len(vertices), len(faces)
    if values.shape == (count,):
        return VertexCost(values)
    if values.shape == (count, 3, 3):
        return VertexTensor(values)
    if values.shape == (face_count,):
        return FaceCost(values)
    if values.shape == (face_count, 3, 3):
        return FaceTensor(values)
    if values.shape == (face_count, 3):
        return travel_time(vertices, faces, values)
    raise InvalidInput(
        f"--metric {file}: holds numbers of shape {values.shape}; give a cost for each of the {count} vertices or "
        f"{face_count} faces, a tensor of shape (3, 3) for each, or a wind of shape (3,) for each face."
    )
