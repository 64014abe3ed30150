"""The calls of pygeodesic's own tests, answered by vorogeo: one path, and the distances of all vertices."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import vorogeo
from numpy.typing import ArrayLike, NDArray


def read_mesh_from_file(name: str) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
    """Vertices and faces behind a line with the numbers of both."""
    lines = Path(name).read_text().splitlines()
    vertices = int(lines[0].split()[0])
    return np.loadtxt(lines[1 : 1 + vertices]), np.loadtxt(lines[1 + vertices :], dtype=np.int32)


class PyGeodesicAlgorithmExact:
    """Exact distances on one mesh."""

    def __init__(self, points: ArrayLike, faces: ArrayLike) -> None:
        self.surface = vorogeo.Surface(points, faces)

    def geodesicDistance(self, source: int, target: int) -> tuple[float, NDArray[np.float64]]:  # noqa: N802
        """Length and points of a shortest path, target first."""
        path = self.surface.path(source, target, method="exact")
        return path.length, path.points[::-1]

    def geodesicDistances(self, sources: ArrayLike) -> tuple[NDArray[np.float64], None]:  # noqa: N802
        """Distances of all vertices from the nearest source."""
        return self.surface.distance_field(sources, method="exact"), None
