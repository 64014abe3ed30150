"""Forms of points: vertex ids, points on faces, or lists of both; and curves along edges as sources."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as check
from .errors import InvalidInput


@dataclass(frozen=True, eq=False)
class SurfacePoints:
    """Points on the faces of a mesh.

    Attributes
    ----------
    faces : ndarray of int32, shape (k,)
        The face of each point: a row of the faces of the surface.
    barycentric : ndarray of float64, shape (k, 3)
        Weights of the three corners: not negative, with sum 1; deviations of at most 1e-6, as in single precision, are
        treated as rounding. A point with one zero weight is on an edge, with two at a vertex.
    snap_distance : ndarray of float64, shape (k,), or None
        How far the original points were from the surface, for points from `Surface.snap`.
    """

    faces: NDArray[np.int32]
    barycentric: NDArray[np.float64]
    snap_distance: NDArray[np.float64] | None = None

    def __len__(self) -> int:
        return len(np.atleast_1d(self.faces))

    def __getitem__(self, which: Any) -> SurfacePoints:
        rows = np.atleast_1d(np.arange(len(self))[which])
        snapped = None if self.snap_distance is None else self.snap_distance[rows]
        return SurfacePoints(np.atleast_1d(self.faces)[rows], np.atleast_2d(self.barycentric)[rows], snapped)

    def __repr__(self) -> str:
        moved = ""
        if self.snap_distance is not None and len(self):
            moved = f", moved to the surface by at most {self.snap_distance.max():.3g}"
        return f"SurfacePoints({len(self)} points{moved})"

    def positions(self, vertices: ArrayLike, faces: ArrayLike) -> NDArray[np.float64]:
        """The positions of the points in space, float64 of shape (k, 3), from the arrays of the mesh of the surface."""
        places = check.numbers("vertices", vertices, "a row of numbers for each vertex")
        corners = places[self._corners(faces, len(places))].astype(np.float64)
        found: NDArray[np.float64] = np.einsum("kc,kcd->kd", np.atleast_2d(self.barycentric), corners)
        return found

    def _corners(self, faces: ArrayLike, vertex_count: int) -> NDArray[np.int32]:
        """The corners of each point's face."""
        triangles, own = check.faces(faces, vertex_count), _face_ids("faces", self.faces)
        if (own >= len(triangles)).any():
            raise InvalidInput(
                f"faces: has {len(triangles)} rows, but a point lies in face {own.max()}; give those of the surface."
            )
        return triangles[own]

    def to_text(self) -> str:
        """The points as text for the parameter `surface_points` of the filters, on a layer with the same faces.

        For example "203 0.2 0.3 0.5; 17 1.0 0.0 0.0": faces and weights, without loss of precision.
        """
        rows = zip(_face_ids("faces", self.faces).tolist(), np.atleast_2d(self.barycentric).tolist(), strict=True)
        return "; ".join(" ".join(map(repr, (face, *weights))) for face, weights in rows)

    def to_sparse(self, faces: ArrayLike, vertex_count: int) -> Any:
        """The weights as a ``scipy.sparse`` matrix of shape (k, n) that maps values of vertices to values of points.

        `faces` are those of the surface.
        """
        from scipy.sparse import csr_matrix

        corners = self._corners(faces, vertex_count)
        rows = np.repeat(np.arange(len(corners)), 3)
        weights = np.atleast_2d(self.barycentric).ravel()
        return csr_matrix((weights, (rows, corners.ravel())), shape=(len(corners), vertex_count))

    @classmethod
    def from_sparse(cls, weights: Any, faces: ArrayLike) -> SurfacePoints:
        """The points of a ``scipy.sparse`` matrix of shape (k, n), whose rows weigh up to three vertices of a face."""
        from scipy.sparse import csr_matrix

        matrix = csr_matrix(weights, copy=True)
        triangles = check.faces(faces, matrix.shape[1])
        matrix.eliminate_zeros()
        rows = np.repeat(np.arange(len(triangles)), 3)
        corner_of = csr_matrix((np.ones(rows.size), (rows, triangles.ravel())), shape=(len(triangles), matrix.shape[1]))
        corner_of.data[:] = 1  # also for a face that names a vertex twice
        common = csr_matrix(
            csr_matrix((np.ones(matrix.nnz), matrix.indices, matrix.indptr), matrix.shape) @ corner_of.T
        )
        point = np.repeat(np.arange(matrix.shape[0]), np.diff(common.indptr))
        whole = common.data == np.diff(matrix.indptr)[point]
        found, first = np.unique(point[whole], return_index=True)
        if len(found) < matrix.shape[0]:
            row = int(np.setdiff1d(np.arange(matrix.shape[0]), found)[0])
            raise InvalidInput(
                f"weights[{row}]: weighs vertices {matrix[row].indices.tolist()}, which are not corners of one face; "
                "give up to three that are, with sum 1."
            )
        chosen = common.indices[whole][first].astype(np.int32)
        return cls(chosen, matrix[np.arange(len(chosen))[:, None], triangles[chosen]].toarray())


@dataclass(frozen=True, eq=False)
class EdgeCurve:
    """A curve along edges of the mesh, as one source of a field: distances are from its nearest point.

    Parameters
    ----------
    vertices : array_like of int, shape (k,) or (k, 2)
        The vertices of the curve in order, each joined to the next by an edge; or the two ends of each edge, in any
        order.
    spacing : float, optional
        The curve is replaced by points on it at most this far apart, including its vertices; None: a quarter of the
        typical edge. Distances are never too short, and too long by at most half the spacing, far away by much less.
    """

    vertices: ArrayLike
    spacing: float | None = None

    def edges(self, vertex_count: int, name: str) -> NDArray[np.int32]:
        """The ends of the edges, as int32 of shape (q, 2)."""
        wanted = "vertex ids of shape (k,) along edges, or the ends of edges of shape (k, 2)"
        given = check.column(check.numbers(f"{name}.vertices", self.vertices, wanted))
        ids = check.vertex_ids(f"{name}.vertices", given.ravel() if given.ndim == 2 else given, vertex_count)
        if given.ndim == 1 and ids.size >= 2:
            return np.ascontiguousarray(np.column_stack([ids[:-1], ids[1:]]))
        if given.ndim == 2 and given.shape[1] == 2 and ids.size:
            return ids.reshape(-1, 2)
        raise InvalidInput(f"{name}: is a curve of shape {given.shape}; give {wanted}, one edge at least.")


Points: TypeAlias = ArrayLike | SurfacePoints | Sequence["ArrayLike | SurfacePoints"]

Rows: TypeAlias = tuple[NDArray[np.int32], NDArray[np.int32], NDArray[np.float64]]
"""Points as the core takes them: vertex (-1: none), face and weights; the last two are empty if all are vertices."""


def holds(value: Any, kind: type | tuple[type, ...]) -> bool:
    """Whether a value is of a kind, or a list with an element of that kind."""
    return isinstance(value, kind) or (isinstance(value, (list, tuple)) and any(isinstance(v, kind) for v in value))


def _face_ids(name: str, value: ArrayLike) -> NDArray[np.int32]:
    """Rows of faces as contiguous int32 of shape (k,), none negative; the core checks the upper limit."""
    wanted = "rows of the faces (integers)"
    array = check.column(np.atleast_1d(check.numbers(name, value, wanted)))
    if array.size == 0:
        return np.empty(0, dtype=np.int32)
    array = check.integers(name, array, wanted)
    bad = (array < 0) | (array > np.iinfo(np.int32).max)
    if array.ndim != 1 or bad.any():
        found = f"shape {array.shape}" if array.ndim != 1 else f"face {int(array[bad][0])}"
        if found == "face -1":
            found += " (a point on the bridge over a gap is in no face)"
        raise InvalidInput(f"{name}: has {found}; give {wanted}.")
    return np.ascontiguousarray(array, dtype=np.int32)


def rows(name: str, value: Any, vertex_count: int, least: int = 0) -> Rows:
    """Checked points, at least `least` of them; a single point is one row."""
    if isinstance(value, SurfacePoints):
        faces = _face_ids(f"{name}.faces", np.atleast_1d(value.faces))
        weights = check.positions(f"{name}.barycentric", value.barycentric)
        if len(faces) != len(weights):
            raise InvalidInput(
                f"{name}: has {len(faces)} faces but {len(weights)} rows of weights; give one row for each."
            )
        found = np.full(len(faces), -1, np.int32), faces, weights
    elif holds(value, SurfacePoints):
        found = joined([rows(f"{name}[{i}]", part, vertex_count) for i, part in enumerate(value)])
    else:
        found = check.vertex_ids(name, value, vertex_count), np.empty(0, np.int32), np.empty((0, 3))
    if len(found[0]) < least:
        raise InvalidInput(f"{name}: is empty; give at least one vertex id or surface point.")
    return found


def joined(parts: list[Rows]) -> Rows:
    """The lists, concatenated."""
    filled = [
        part
        if len(part[1]) == len(part[0])
        else (part[0], np.full(len(part[0]), -1, np.int32), np.zeros((len(part[0]), 3)))
        for part in parts
    ]
    vertex, face, weights = (np.concatenate([part[k] for part in filled]) for k in range(3))
    return vertex, face, np.ascontiguousarray(weights)


def taken(found: Rows, which: NDArray[Any]) -> Rows:
    """The rows with these numbers, each as often as its number occurs."""
    vertex, face, weights = found
    return (vertex[which], face[which], weights[which]) if len(face) else (vertex[which], face, weights)


def is_single(value: Any) -> bool:
    """Whether a value is one point rather than a list: a number, or SurfacePoints with one row."""
    if isinstance(value, SurfacePoints):
        return len(value) == 1
    return not holds(value, SurfacePoints) and np.ndim(value) == 0


def pairs(names: tuple[str, str], source: Any, target: Any, vertex_count: int) -> tuple[Rows, Rows]:
    """Both ends of k pairs; a single point goes with each of the others."""
    sources, targets = rows(names[0], source, vertex_count), rows(names[1], target, vertex_count)
    if is_single(source) and not is_single(target):
        sources = taken(sources, np.zeros(len(targets[0]), int))
    elif is_single(target) and not is_single(source):
        targets = taken(targets, np.zeros(len(sources[0]), int))
    if len(sources[0]) != len(targets[0]):
        raise InvalidInput(
            f"{names[0]} has {len(sources[0])} points, {names[1]} {len(targets[0])}; give as many of one as of the "
            "other, or a single one."
        )
    return sources, targets


def surface_points(rows: Rows) -> SurfacePoints:
    """Points that the core returns: vertices as corners of faces."""
    return SurfacePoints(rows[1], rows[2])
