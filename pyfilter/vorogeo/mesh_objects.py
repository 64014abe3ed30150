"""Vertices and triangles of the meshes of other packages, told apart by their attributes; polygons become fans."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _arguments as check
from .errors import InvalidInput
from .results import MeshArrays

_CORNERS = {"triangle": 3, "quad": 4, "polygon": None}
"""Blocks of meshio that are faces."""
_ROUNDING = 1e-9  # of a polygon's area: triangles of collinear corners may be turned over by so much


def mesh_arrays(mesh: Any, faces: Any = None) -> MeshArrays:
    """Vertices and triangles of a mesh of another package, or of arrays whose faces are polygons.

    Parameters
    ----------
    mesh : object, or array_like of shape (n, 3)
        A `Surface`, trimesh.Trimesh, pyvista.PolyData, meshio.Mesh, pymeshlab.Mesh or triangle mesh of Open3D, or a
        pair of vertices and faces; or vertices, with `faces`. Arrays may be any that NumPy reads, such as tensors of
        torch and jax on the CPU, whatever their layout.
    faces : array_like of int of shape (m, 3) or (m, 4), or sequence of polygons, optional
        Vertex ids. A polygon becomes a fan of triangles, in the order of the polygons: from its first corner, or from
        the one where it turns inwards if that fan would not fill it. Values of faces are then those of triangles.

    Returns
    -------
    MeshArrays
        `vertices`, in their order, and `faces`, as a tuple of these two.

    Raises
    ------
    InvalidInput
        (a ValueError) If it is none of these; or has elements that are refused, naming them.

    Warns
    -----
    UserWarning
        If triangles of a polygon overlap, since no such fan fills it.
    """
    vertices, triangles = arrays_of(mesh, faces)
    points = check.vertices(vertices)
    return MeshArrays(points, check.faces(triangles, len(points)))


def arrays_of(mesh: Any, faces: Any) -> tuple[Any, Any]:
    """Vertices and triangles, not checked yet and possibly the caller's own arrays; only polygons are checked here."""
    vertices, polygons = (mesh, faces) if faces is not None else _parts(mesh)
    return vertices, polygons if vertices is None else _triangles(polygons, vertices)


def _parts(mesh: Any) -> tuple[Any, Any]:
    """Vertices and faces of an object."""
    if isinstance(mesh, tuple) and len(mesh) == 2:
        return mesh
    if hasattr(mesh, "vertex_matrix"):  # pymeshlab
        return mesh.vertex_matrix(), mesh.face_matrix()
    if hasattr(mesh, "point_sets"):  # meshio
        return of_meshio(mesh)
    if hasattr(mesh, "n_strips"):  # pyvista
        return _of_pyvista(mesh)
    if hasattr(mesh, "triangle") and hasattr(mesh, "vertex"):  # open3d.t
        return mesh.vertex["positions"].numpy(), mesh.triangle["indices"].numpy()
    faces = getattr(mesh, "faces" if hasattr(mesh, "faces") else "triangles", None)  # trimesh, Surface; open3d
    if faces is None or not hasattr(mesh, "vertices"):
        raise InvalidInput(
            f"faces: is missing, and the only argument is a {type(mesh).__name__}; give vertices and faces, or a mesh "
            "of trimesh, PyVista (PolyData: others have extract_surface()), meshio, PyMeshLab or Open3D."
        )
    return np.asarray(mesh.vertices), np.asarray(faces)


def _of_pyvista(mesh: Any) -> tuple[Any, Any]:
    listed = np.asarray(mesh.faces)
    if mesh.n_strips or len(listed) % 4 or (listed[::4] != 3).any():
        mesh = mesh.triangulate()
        listed = np.asarray(mesh.faces)
    return mesh.points, listed.reshape(-1, 4)[:, 1:]


def of_meshio(mesh: Any) -> tuple[Any, Any]:
    """Points, with z = 0 if they have two coordinates, and triangles of all blocks that are faces."""
    points = np.asarray(mesh.points)
    if points.ndim == 2 and points.shape[1] == 2:
        points = np.column_stack([points, np.zeros(len(points))])
    blocks = [np.asarray(block.data) for block in mesh.cells if block.type in _CORNERS and len(block.data)]
    if not blocks:
        return points, np.empty((0, 3), np.int32)
    return points, np.concatenate([_fans(block.astype(np.int64), points, "cells") for block in blocks])


def _triangles(faces: Any, vertices: Any) -> Any:
    """Triangles that fill the faces; input without quads or polygons is returned as it is, to be checked later."""
    wanted = "the vertex ids of each polygon as integers"
    sizes = [len(face) for face in faces] if _is_list_of_lists(faces) else []
    if len(set(sizes)) > 1 or (sizes and sizes[0] > 3):
        small = next((row for row, size in enumerate(sizes) if size < 3), None)
        if small is not None:
            raise InvalidInput(f"faces[{small}]: has {sizes[small]} corners; give three or more.")
        corners = check.numbers("faces", [vertex for face in faces for vertex in face], wanted)
    else:
        shape: tuple[int, ...] = getattr(faces, "shape", ())
        if len(shape) != 2 or shape[1] != 4:
            return faces
        sizes, corners = [4] * shape[0], check.numbers("faces", faces, wanted).ravel()
    points = check.vertices(vertices, finite=False)
    count, corners = np.array(sizes, np.int64), check.integers("faces", corners, wanted)
    if (count == 4).all() and (corners[::4] == 3).all() and (corners == 3).sum() > len(count):
        raise InvalidInput("faces: each row begins with 3, as in VTK, where it is a count; give faces[:, 1:].")
    beyond = np.flatnonzero((corners < 0) | (corners >= len(points)))
    if beyond.size:
        row = int(np.searchsorted(np.cumsum(count), beyond[0], side="right"))
        raise InvalidInput(f"faces[{row}]: names vertex {corners[beyond[0]]}, but {check.vertex_range(len(points))}.")
    begin, by_size = np.cumsum(count) - count, np.argsort(count, kind="stable")
    polygon, fans = [np.empty(0, np.int64)], [np.empty((0, 3), np.int64)]
    for rows in np.split(by_size, np.flatnonzero(np.diff(count[by_size])) + 1) if len(count) else ():
        size = count[rows[0]]
        fans.append(_fans(corners[begin[rows, None] + np.arange(size)], points, "faces", rows))
        polygon.append(np.repeat(rows, size - 2))
    return np.concatenate(fans)[np.argsort(np.concatenate(polygon), kind="stable")]


def _is_list_of_lists(faces: Any) -> bool:
    return isinstance(faces, (list, tuple)) and all(hasattr(face, "__len__") for face in faces)


def _fans(polygons: NDArray[Any], points: NDArray[Any], name: str, rows: NDArray[Any] | None = None) -> NDArray[Any]:
    """Triangles of polygons with equally many corners; `rows`: their numbers for a warning."""
    corners = polygons.shape[1]
    if corners > 3 and polygons.min(initial=0) >= 0 and polygons.max(initial=-1) < len(points):
        turned = np.flatnonzero(_overlap(points[polygons]))
        if turned.size:
            polygons = polygons.copy()
            polygons[turned] = _from_the_inward_corner(polygons[turned], points)
            still = turned[_overlap(points[polygons[turned]])]
            if still.size:
                row = int(still[0] if rows is None else rows[still[0]])
                warnings.warn(
                    f"{name}[{row}]: is a polygon that no fan of triangles fills, so its triangles overlap (one of "
                    f"{len(still)}); give triangles instead.",
                    stacklevel=2,
                )
    fans = [polygons[:, [0, k, k + 1]] for k in range(1, corners - 1)]
    return np.stack(fans, axis=1).reshape(-1, 3)


def _overlap(corners: NDArray[Any]) -> NDArray[np.bool_]:
    """Which polygons of shape (m, k, 3) have fans from their first corner with triangles of both orientations."""
    arms = corners[:, 1:] - corners[:, :1]
    normals = np.cross(arms[:, :-1], arms[:, 1:])
    whole = normals.sum(axis=1)
    along = np.einsum("mkd,md->mk", normals, whole)
    found: NDArray[np.bool_] = (along < -_ROUNDING * (whole**2).sum(axis=1, keepdims=True)).any(axis=1)
    return found


def _from_the_inward_corner(polygons: NDArray[Any], points: NDArray[Any]) -> NDArray[Any]:
    """The same polygons, beginning at the corner where they turn inwards most."""
    corners = points[polygons]
    sides = np.roll(corners, -1, axis=1) - corners
    turns = np.cross(np.roll(sides, 1, axis=1), sides)
    arms = corners - corners[:, :1]
    normal = np.cross(arms[:, :-1], arms[:, 1:]).sum(axis=1)
    first = np.einsum("mkd,md->mk", turns, normal).argmin(axis=1)
    steps = (first[:, None] + np.arange(polygons.shape[1])) % polygons.shape[1]
    return np.take_along_axis(polygons, steps, axis=1)
