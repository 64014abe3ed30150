# The compiled extension; arguments are checked by the modules that call it.
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .metrics import CoreSides

def lengths_by_cost(
    vertices: NDArray[np.float64], faces: NDArray[np.int32], cost: NDArray[np.float64]
) -> tuple[NDArray[np.float64], int, int, Any]: ...
def lengths_by_tensor(
    vertices: NDArray[np.float64], faces: NDArray[np.int32], tensors: NDArray[np.float64]
) -> tuple[NDArray[np.float64], int, int, Any]: ...
def sides_by_face_cost(
    vertices: NDArray[np.float64], faces: NDArray[np.int32], cost: NDArray[np.float64]
) -> NDArray[np.float64]: ...
def sides_by_face_tensor(
    vertices: NDArray[np.float64], faces: NDArray[np.int32], tensors: NDArray[np.float64]
) -> NDArray[np.float64]: ...
def edge_points_for(vertices: NDArray[np.float64], faces: NDArray[np.int32], sides: NDArray[np.float64]) -> int: ...
def slope_cost(
    vertices: NDArray[np.float64], faces: NDArray[np.int32], x: float, y: float, z: float, penalty: float
) -> NDArray[np.float64]: ...
def curvature_tensors(
    vertices: NDArray[np.float64], faces: NDArray[np.int32], weight: float
) -> NDArray[np.float64]: ...
def estimate(
    vertices: NDArray[np.float64],
    faces: NDArray[np.int32],
    sides: CoreSides | None,
    threads: int,
    memory_budget: int,
    progress: Callable[[float, str], object] | None,
) -> dict[str, Any]: ...
def check_mesh(vertices: NDArray[np.float64], faces: NDArray[np.int32], gap: float, folds: bool) -> dict[str, Any]: ...
def available_memory_bytes() -> int: ...

class OutputFile:
    @staticmethod
    def make(file: str | os.PathLike[str], what: str, head: bytes, size: int) -> OutputFile: ...
    @property
    def temporary(self) -> Path: ...
    def finish(self) -> None: ...
    def discard(self) -> None: ...

class Method:
    @staticmethod
    def prepare(
        name: str,
        vertices: NDArray[np.float64],
        faces: NDArray[np.int32],
        sides: CoreSides | None,
        options: dict[str, float],
        progress: Callable[[float, str], object] | None,
    ) -> Method: ...
    def field(self, sources: NDArray[np.int32]) -> NDArray[np.float64]: ...
    def pair(self, source: int, target: int) -> float: ...
    def bytes(self) -> int: ...

def describe_methods() -> list[dict[str, Any]]: ...
def method_warning(
    name: str,
    vertices: NDArray[np.float64],
    faces: NDArray[np.int32],
    sides: CoreSides | None,
) -> str: ...

_Progress = Callable[[float, str], object] | None
_Ids = NDArray[np.int32]
_Floats = NDArray[np.float64]
_Reals = NDArray[np.float64] | NDArray[np.float32]

class Points:
    def __init__(self, vertex: _Ids, face: _Ids, weights: _Floats) -> None: ...

_Answered = tuple[str, float, float, str]
_PathArrays = tuple[_Floats, _Ids, NDArray[np.int64], _Floats, _Ids, _Ids, _Floats, _Ids]

class Surface:
    @staticmethod
    def without_index(
        vertices: _Floats,
        faces: _Ids,
        sides: CoreSides | None,
        threads: int,
        memory_budget: int,
        gap: float,
        folds: bool,
    ) -> Surface: ...
    @staticmethod
    def build(
        vertices: _Floats,
        faces: _Ids,
        sides: CoreSides | None,
        first_layer_patches: int,
        second_layer_patches: int,
        delta: float,
        threads: int,
        seed: int,
        memory_budget: int,
        gap: float,
        folds: bool,
        file: str | None,
        progress: _Progress,
    ) -> Surface: ...
    @staticmethod
    def load(
        file: str | os.PathLike[str],
        vertices: _Floats,
        faces: _Ids,
        sides: CoreSides | None,
        threads: int,
        gap: float,
        folds: bool,
        mapped: bool,
    ) -> Surface: ...
    def has_index(self) -> bool: ...
    def build_index(self, progress: _Progress) -> None: ...
    def save(self, file: str | os.PathLike[str]) -> None: ...
    def face_patches(self, layer: int) -> _Ids: ...
    def statistics(self) -> dict[str, Any]: ...
    def vertex_distance(self, source: int, target: int) -> float: ...
    def snap(self, points: _Floats) -> tuple[_Ids, _Floats, _Floats]: ...
    def along_edges(self, ends: _Ids, spacing: float) -> tuple[_Ids, _Ids, _Floats]: ...
    def field(
        self, sources: Points, offsets: _Floats, max_distance: float, method: int, progress: _Progress
    ) -> tuple[_Floats, _Ids, _Answered]: ...
    def paths(
        self, sources: Points, targets: Points, method: int, exact: bool, certify: bool, progress: _Progress
    ) -> tuple[_PathArrays, _Answered]: ...
    def distances(
        self, sources: Points, targets: Points, method: int, progress: _Progress
    ) -> tuple[_Floats, _Answered]: ...
    def use_landmarks(self, count: int, progress: _Progress) -> int: ...

def fill_matrix(
    surface: Surface, rows: Points, columns: Points, entries: int, method: int, out: _Reals, progress: _Progress
) -> _Answered: ...
def fill_square_matrix(
    surface: Surface, points: Points, entries: int, method: int, out: _Reals, progress: _Progress
) -> _Answered: ...
def fill_fields(
    surface: Surface, sources: Points, max_distance: float, method: int, out: _Reals, progress: _Progress
) -> _Answered: ...
def pairs_within(
    surface: Surface, points: Points, radius: float, method: int, max_bytes: int, progress: _Progress
) -> tuple[NDArray[np.int64], _Ids, _Floats, _Answered]: ...
def pairs_within_others(
    surface: Surface, points: Points, others: Points, radius: float, method: int, max_bytes: int, progress: _Progress
) -> tuple[NDArray[np.int64], _Ids, _Floats, _Answered]: ...
def nearest(
    surface: Surface, set: Points, queries: Points, count: int, method: int, progress: _Progress
) -> tuple[_Ids, _Floats, _Answered]: ...
def voronoi(
    surface: Surface, points: Points, method: int, progress: _Progress
) -> tuple[_Ids, _Floats, _Ids, _Floats, _Floats, _Ids, _Ids, _Answered]: ...
def isolines(surface: Surface, field: _Floats, levels: _Floats, interpolation: int) -> tuple[_Floats, _Ids, _Ids]: ...
def sample_farthest(
    surface: Surface, count: int, radius: float, start: Points, seed: int, method: int, progress: _Progress
) -> tuple[tuple[_Ids, _Ids, _Floats], _Floats, _Floats, float, _Answered]: ...
def sample_poisson_disk(
    surface: Surface, radius: float, seed: int, method: int, progress: _Progress
) -> tuple[_Ids, _Answered]: ...
def disk(surface: Surface, sources: Points, radius: float, method: int) -> tuple[_Ids, _Floats, _Ids, _Answered]: ...
def eccentricity(
    surface: Surface, points: Points, method: int, progress: _Progress
) -> tuple[_Floats, _Ids, _Answered]: ...
def extent(
    surface: Surface, start: int, max_fields: int, method: int, progress: _Progress
) -> tuple[tuple[float, float], tuple[int, int], tuple[float, float], int, int, _Answered]: ...
def relax(
    surface: Surface, points: Points, rounds: int, method: int, progress: _Progress
) -> tuple[tuple[_Ids, _Ids, _Floats], _Floats, _Answered]: ...
