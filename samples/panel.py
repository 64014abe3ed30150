"""A PLY file that VoroGeo coloured: whether it shows a distance field or patches, and from where to look at it."""

from __future__ import annotations

import sys
from pathlib import Path

import mesh_input
import numpy as np


class Panel:
    """What one PLY file shows: a distance field (vertex quality) or patches (face colours)."""

    def __init__(self, file: Path) -> None:
        mesh_set = mesh_input.load(file)  # owns the mesh
        mesh = mesh_set.current_mesh()
        self.vertices, self.faces = mesh.vertex_matrix(), mesh.face_matrix()
        self.distance = mesh.vertex_scalar_array() if mesh.has_vertex_scalar() else None
        if self.distance is None and not mesh.has_face_color():
            sys.exit(
                f"{file} has neither a quality of its vertices nor colours of its faces; there is nothing to show."
            )
        self.colors = None if mesh.has_vertex_scalar() else (255 * mesh.face_color_matrix()[:, :3]).astype(np.uint8)

    def patch_borders(self) -> np.ndarray:
        """Edges between faces of different colours, as pairs of vertices."""
        assert self.colors is not None
        edges = np.sort(self.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        color = np.repeat(self.colors.astype(np.int64) @ [65536, 256, 1], 3)
        order = np.lexsort((edges[:, 1], edges[:, 0]))
        edges, color = edges[order], color[order]
        same_edge = (edges[1:] == edges[:-1]).all(axis=1)
        return edges[1:][same_edge & (color[1:] != color[:-1])]

    def view(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Directions to the camera, to the right and up; up is y, or z for a mesh that lies flat."""
        size = np.ptp(self.vertices, axis=0)
        flat = size[2] < 0.5 * min(size[0], size[1])
        direction, up = ([0.25, -0.8, 1.0], [0.0, 0.0, 1.0]) if flat else ([0.3, 0.3, 1.0], [0.0, 1.0, 0.0])
        direction = np.array(direction) / np.linalg.norm(direction)
        right = np.cross(up, direction) / np.linalg.norm(np.cross(up, direction))
        return direction, right, np.cross(direction, right)
