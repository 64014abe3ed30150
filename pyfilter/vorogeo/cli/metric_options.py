"""The metric of the command line: values from a file, or what follows from the shape of the mesh."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..brain import vertex_values
from ..errors import InvalidInput
from ..face_metrics import FaceCost, FaceTensor
from ..metrics import Metric, VertexCost, VertexTensor, curvature_tensor, slope_cost
from .sources import TABLES, numbers_in


def metric_of(options: dict[str, Any], vertices: NDArray[np.float64], faces: NDArray[np.int32]) -> Metric | None:
    """What paths cost on this mesh; None is their length.

    Raises
    ------
    InvalidInput
        If the file holds neither a cost nor a tensor for each vertex or face, or a number is out of range.
    """
    if options.get("metric"):
        return _from_file(options["metric"], len(vertices), len(faces))
    if options.get("slope_penalty") is not None:
        return slope_cost(vertices, faces, penalty=options["slope_penalty"])
    if options.get("curvature_weight") is not None:
        return curvature_tensor(vertices, faces, options["curvature_weight"])
    return None


def _from_file(file: str, count: int, face_count: int) -> Metric:
    if not os.path.isfile(file):
        raise InvalidInput(f"--metric {file}: there is no such file.")
    values = numbers_in(file) if file.lower().endswith(TABLES) else vertex_values(file)[0]
    if values.ndim == 2 and values.shape[1] == 1:
        values = values[:, 0]
    if values.shape == (count,):
        return VertexCost(values)
    if values.shape == (count, 3, 3):
        return VertexTensor(values)
    if values.shape == (face_count,):
        return FaceCost(values)
    if values.shape == (face_count, 3, 3):
        return FaceTensor(values)
    raise InvalidInput(
        f"--metric {file}: holds numbers of shape {values.shape}; give a cost for each of the {count} vertices or "
        f"{face_count} faces, or a tensor of shape (3, 3) for each."
    )
