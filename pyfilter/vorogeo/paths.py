"""Points anywhere on a surface, the shortest paths between them, and fields from sources of every kind."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as check
from . import _core
from .errors import InvalidInput
from .progress import ProgressFunction, reporter

if TYPE_CHECKING:
    from .index import IndexStatistics


@dataclass(frozen=True)
class SurfacePoints:
    """Points on the faces of a mesh.

    Attributes
    ----------
    faces : ndarray of int32, shape (k,)
        The face of each point: a row of the faces the index was built for.
    barycentric : ndarray of float64, shape (k, 3)
        Weights of the three corners: not negative, sum 1. A zero weight puts a point on an edge, two at a vertex.
    snap_distance : ndarray of float64, shape (k,), or None
        How far the points were from the surface, for those that `GeodesicIndex.snap` found.
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


@dataclass(frozen=True)
class GeodesicPath:
    """A shortest path over the surface.

    Attributes
    ----------
    points : ndarray of float64, shape (p, 3)
        From source to target; consecutive points lie on a common face. Shape (0, 3) if there is no path.
    length : float
        Sum of the distances of consecutive points; infinity if there is no path.
    vertices : ndarray of int32, shape (p,)
        The vertex of each point; -1 for a point on an edge or in a face.
    surface_points : SurfacePoints
        The same points on faces.
    certified : bool
        For exact paths: whether it is proven that none is shorter. False for refined paths.
    """

    points: NDArray[np.float64]
    length: float
    vertices: NDArray[np.int32]
    surface_points: SurfacePoints
    certified: bool

    def to_pyvista(self) -> Any:
        """The path as a ``pyvista.PolyData`` with one line.

        Raises
        ------
        ImportError
            If PyVista is not installed.
        """
        import pyvista

        if not len(self.points):
            return pyvista.PolyData()
        return pyvista.PolyData(self.points, lines=np.r_[len(self.points), np.arange(len(self.points))])


_Arrays = tuple[NDArray[np.int32], NDArray[np.int32], NDArray[np.float64]]


class Paths:
    """The methods of `GeodesicIndex` for paths and for points that need not be vertices."""

    __slots__ = ()

    _paths: _core.Paths
    _statistics: IndexStatistics

    def snap(self, points: ArrayLike, max_distance: float | None = None) -> SurfacePoints:
        """Move points in space to the nearest points of the surface.

        Parameters
        ----------
        points : array_like, shape (3,) or (k, 3)
            Finite positions.
        max_distance : float, optional
            How far a point may be from the surface; None for any distance.

        Returns
        -------
        SurfacePoints
            With `snap_distance`.

        Raises
        ------
        InvalidInput
            (a ValueError) If a point is not finite or farther away than `max_distance`; names the point.
        """
        positions = check.positions("points", points)
        limit = check.max_distance(max_distance)
        faces, weights, distance = self._paths.snap(positions)
        if (distance > limit).any():
            row = int(np.flatnonzero(distance > limit)[0])
            raise InvalidInput(
                f"points[{row}]: is {distance[row]:g} away from the surface, more than max_distance {limit:g}; "
                "move the point or raise the limit."
            )
        return SurfacePoints(faces, weights.reshape(-1, 3), distance)

    def path(
        self,
        source: ArrayLike | SurfacePoints,
        target: ArrayLike | SurfacePoints,
        progress: ProgressFunction | bool | None = None,
    ) -> GeodesicPath | list[GeodesicPath]:
        """Refined shortest path between two points, or of each of k pairs.

        The way that the index gives is shortened to a geodesic: never shorter than the shortest path, and in most cases
        that very path (``docs/paths.md`` has the errors).

        Parameters
        ----------
        source, target : int, array_like of int of shape (k,), or SurfacePoints
            Vertex ids or points from `snap`; both of the same length.
        progress : callable or bool, optional
            As for the class.

        Returns
        -------
        GeodesicPath, or list of k GeodesicPath
            One path if both are single ids or hold one surface point each. Without a way from one to the other a path
            has no points and the length infinity.

        Raises
        ------
        InvalidInput
            (a ValueError) If an id or a face is out of range, weights are no barycentric weights, or lengths differ.
        """
        return self._find_paths(source, target, False, False, progress)

    def exact_path(
        self,
        source: ArrayLike | SurfacePoints,
        target: ArrayLike | SurfacePoints,
        certify: bool = False,
        progress: ProgressFunction | bool | None = None,
    ) -> GeodesicPath | list[GeodesicPath]:
        """Exact shortest path between two points, or of each of k pairs, without a field over the whole mesh.

        Parameters
        ----------
        source, target, progress
            As for `path`.
        certify : bool, default False
            Whether to prove that no path is shorter, by bounds that rest on nothing but straight lines in space; slower
            on curved surfaces. Otherwise the search is kept in a corridor by the index less an error margin.

        Returns
        -------
        GeodesicPath, or list of k GeodesicPath
            `certified` says whether it is proven to be a shortest one.

        Raises
        ------
        InvalidInput
            As `path`.
        """
        return self._find_paths(source, target, True, bool(certify), progress)

    def _find_paths(
        self, source: Any, target: Any, exact: bool, certify: bool, progress: ProgressFunction | bool | None
    ) -> GeodesicPath | list[GeodesicPath]:
        sources, one_source = self._points("source", source)
        targets, one_target = self._points("target", target)
        if len(sources[0]) != len(targets[0]):
            raise InvalidInput(
                f"source has {len(sources[0])} points, target {len(targets[0])}; give as many of one as of the other."
            )
        with reporter(progress) as report:
            found = self._paths.paths(*sources, *targets, exact, certify, report)
        lengths, certified, begin, positions, vertices, faces, weights = found
        positions, weights = positions.reshape(-1, 3), weights.reshape(-1, 3)
        paths = [
            GeodesicPath(
                positions[a:b], float(length), vertices[a:b], SurfacePoints(faces[a:b], weights[a:b]), bool(proven)
            )
            for length, proven, a, b in zip(lengths, certified, begin[:-1], begin[1:], strict=True)
        ]
        return paths[0] if one_source and one_target else paths

    def _points(self, name: str, value: Any) -> tuple[_Arrays, bool]:
        """Vertex (or -1), face and weights of points, and whether it is a single one."""
        if not isinstance(value, SurfacePoints):
            ids = check.vertex_ids(name, value, self._statistics.vertices)
            row = np.atleast_1d(ids)
            return (row, np.full(len(row), -1, np.int32), np.zeros((len(row), 3))), ids.ndim == 0
        faces = check.face_ids(f"{name}.faces", np.atleast_1d(value.faces))
        weights = check.positions(f"{name}.barycentric", value.barycentric)
        if len(faces) != len(weights):
            raise InvalidInput(
                f"{name}: has {len(faces)} faces but {len(weights)} rows of weights; give one row for each."
            )
        return (np.full(len(faces), -1, np.int32), faces, weights), len(faces) == 1

    def _labelled_field(
        self, sources: Any, offsets: ArrayLike | None, limit: float
    ) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        if isinstance(sources, Sequence) and any(isinstance(part, SurfacePoints) for part in sources):
            parts = [self._points(f"sources[{i}]", part)[0] for i, part in enumerate(sources)]
            arrays = tuple(np.concatenate([part[k] for part in parts]) for k in range(3))
        else:
            arrays, _ = self._points("sources", sources)
        count = len(arrays[0])
        if count == 0:
            raise InvalidInput("sources: is empty; give at least one vertex id or surface point.")
        start = check.offsets(offsets, count)
        return self._paths.field(arrays[0], arrays[1], arrays[2], start, limit)
