# The compiled extension; arguments are checked by the modules that call it.
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .metrics import CoreSides

class Index:
    @staticmethod
    def build(
        vertices: NDArray[np.float64],
        faces: NDArray[np.int32],
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
        progress: Callable[[float, str], object] | None,
    ) -> Index: ...
    @staticmethod
    def load(
        file: str | os.PathLike[str],
        vertices: NDArray[np.float64],
        faces: NDArray[np.int32],
        sides: CoreSides | None,
        threads: int,
        gap: float,
        folds: bool,
        mapped: bool,
    ) -> Index: ...
    def distance(self, source: int, target: int) -> float: ...
    def distances(self, sources: NDArray[np.int32], targets: NDArray[np.int32]) -> NDArray[np.float64]: ...
    def distance_field(self, sources: NDArray[np.int32], max_distance: float) -> NDArray[np.float64]: ...
    def face_patches(self, layer: int) -> NDArray[np.int32]: ...
    def save(self, file: str | os.PathLike[str]) -> None: ...
    def statistics(self) -> dict[str, Any]: ...

def exact_distance_field(
    vertices: NDArray[np.float64],
    faces: NDArray[np.int32],
    sides: CoreSides | None,
    sources: NDArray[np.int32],
    max_distance: float,
    threads: int,
    gap: float,
    folds: bool,
) -> NDArray[np.float64]: ...
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

def paths_without_index(
    vertices: _Floats,
    faces: _Ids,
    sides: CoreSides | None,
    sources: Points,
    targets: Points,
    gap: float,
    folds: bool,
    progress: _Progress,
) -> tuple[_Floats, _Ids, NDArray[np.int64], _Floats, _Ids, _Ids, _Floats, _Ids]: ...
def fill_matrix(
    index: Index, rows: Points, columns: Points, method: int, exact: bool, out: _Reals, progress: _Progress
) -> None: ...
def fill_square_matrix(
    index: Index, points: Points, method: int, exact: bool, out: _Reals, progress: _Progress
) -> None: ...
def fill_fields(
    index: Index, sources: Points, max_distance: float, exact: bool, out: _Reals, progress: _Progress
) -> None: ...
def pair_distances(index: Index, sources: Points, targets: Points, progress: _Progress) -> _Floats: ...
def pairs_within(
    index: Index | Surface, points: Points, radius: float, exact: bool, max_bytes: int, progress: _Progress
) -> tuple[NDArray[np.int64], _Ids, _Floats]: ...
def pairs_within_others(
    index: Index, points: Points, others: Points, radius: float, exact: bool, max_bytes: int, progress: _Progress
) -> tuple[NDArray[np.int64], _Ids, _Floats]: ...
def nearest(
    index: Index, set: Points, queries: Points, count: int, exact: bool, progress: _Progress
) -> tuple[_Ids, _Floats]: ...
def voronoi(
    index: Index, points: Points, exact: bool, progress: _Progress
) -> tuple[_Ids, _Floats, _Ids, _Floats, _Floats, _Ids, _Ids]: ...
def isolines(index: Index, field: _Floats, levels: _Floats, interpolation: int) -> tuple[_Floats, _Ids, _Ids]: ...
def sample_farthest(
    index: Index, count: int, radius: float, start: Points, seed: int, exact: bool, progress: _Progress
) -> tuple[tuple[_Ids, _Ids, _Floats], _Floats, _Floats, float]: ...
def sample_poisson_disk(index: Index, radius: float, seed: int, exact: bool, progress: _Progress) -> _Ids: ...
def disk(index: Index, sources: Points, radius: float, exact: bool) -> tuple[_Ids, _Floats, _Ids]: ...
def eccentricity(index: Index, points: Points, exact: bool, progress: _Progress) -> tuple[_Floats, _Ids]: ...
def extent(
    index: Index, start: int, max_fields: int, exact: bool, progress: _Progress
) -> tuple[tuple[float, float], tuple[int, int], tuple[float, float], int, int]: ...
def relax(
    index: Index, points: Points, rounds: int, exact: bool, progress: _Progress
) -> tuple[tuple[_Ids, _Ids, _Floats], _Floats]: ...

_Answered = tuple[str, float, float, str]
_PathArrays = tuple[_Floats, _Ids, NDArray[np.int64], _Floats, _Ids, _Ids, _Floats, _Ids]

class Surface:
    def __init__(
        self,
        vertices: _Floats,
        faces: _Ids,
        sides: CoreSides | None,
        threads: int,
        memory_budget: int,
        gap: float,
        folds: bool,
        index: Index | None,
    ) -> None: ...
    def snap(self, points: _Floats) -> tuple[_Ids, _Floats, _Floats]: ...
    def along_edges(self, ends: _Ids, spacing: float) -> tuple[_Ids, _Ids, _Floats]: ...
    def field(
        self, sources: Points, offsets: _Floats, max_distance: float, method: int, progress: _Progress
    ) -> tuple[_Floats, _Ids, _Answered]: ...
    def paths(
        self, sources: Points, targets: Points, method: int, exact: bool, progress: _Progress
    ) -> tuple[_PathArrays, _Answered]: ...
    def distances(
        self, sources: Points, targets: Points, method: int, progress: _Progress
    ) -> tuple[_Floats, _Answered]: ...
    def index(self) -> Index | None: ...
    def build_index(self, progress: _Progress) -> Index: ...

class Paths:
    def __init__(self, index: Index) -> None: ...
    def snap(self, points: _Floats) -> tuple[_Ids, _Floats, _Floats]: ...
    def paths(
        self, sources: Points, targets: Points, exact: bool, certify: bool, progress: _Progress
    ) -> _PathArrays: ...
    def use_landmarks(self, count: int, progress: _Progress) -> int: ...
    def field(self, sources: Points, offsets: _Floats, max_distance: float, exact: bool) -> tuple[_Floats, _Ids]: ...
    def along_edges(self, ends: _Ids, spacing: float) -> tuple[_Ids, _Ids, _Floats]: ...
