# The compiled extension; arguments are checked by the modules that call it.
import os
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

class Index:
    @staticmethod
    def build(
        vertices: NDArray[np.float64],
        faces: NDArray[np.int32],
        first_layer_patches: int,
        second_layer_patches: int,
        delta: float,
        threads: int,
        seed: int,
        progress: Callable[[float, str], object] | None,
    ) -> Index: ...
    @staticmethod
    def load(
        file: str | os.PathLike[str], vertices: NDArray[np.float64], faces: NDArray[np.int32], threads: int
    ) -> Index: ...
    def distance(self, source: int, target: int) -> float: ...
    def distances(self, sources: NDArray[np.int32], targets: NDArray[np.int32]) -> NDArray[np.float64]: ...
    def distance_field(self, sources: NDArray[np.int32], max_distance: float) -> NDArray[np.float64]: ...
    def face_patches(self, layer: int) -> NDArray[np.int32]: ...
    def save(self, file: str | os.PathLike[str]) -> None: ...
    def statistics(self) -> dict[str, Any]: ...

def exact_distance_field(
    vertices: NDArray[np.float64], faces: NDArray[np.int32], sources: NDArray[np.int32], max_distance: float
) -> NDArray[np.float64]: ...
def check_mesh(vertices: NDArray[np.float64], faces: NDArray[np.int32]) -> dict[str, Any]: ...
