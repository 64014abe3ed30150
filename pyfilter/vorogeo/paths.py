"""Shortest paths between points anywhere on a surface, and fields from sources of every kind."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as check
from . import _core
from . import points as point_lists
from .on_mesh import OnMesh
from .points import Points, Sources, SurfacePoints
from .progress import ProgressFunction, reporter


@dataclass(frozen=True, repr=False)
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
    over_gap : ndarray of bool, shape (p,)
        Whether the step from a point to the next one runs over a gap (`gap` of `GeodesicIndex`), so over no face. A
        point between the borders of a gap has face -1 in `surface_points`.
    """

    points: NDArray[np.float64]
    length: float
    vertices: NDArray[np.int32]
    surface_points: SurfacePoints
    certified: bool
    over_gap: NDArray[np.bool_]

    def __repr__(self) -> str:
        return f"GeodesicPath(length {self.length:g}, {len(self.points)} points, certified: {self.certified})"

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


def from_core(found: Any) -> list[GeodesicPath]:
    """The paths that the core returns as arrays."""
    lengths, certified, begin, positions, vertices, faces, weights, over_gap = found
    positions, weights = positions.reshape(-1, 3), weights.reshape(-1, 3)
    return [
        GeodesicPath(
            positions[a:b],
            float(length),
            vertices[a:b],
            SurfacePoints(faces[a:b], weights[a:b]),
            bool(proven),
            over_gap[a:b] > 0,
        )
        for length, proven, a, b in zip(lengths, certified, begin[:-1], begin[1:], strict=True)
    ]


class Paths(OnMesh):
    """The methods of `GeodesicIndex` for paths and for points that need not be vertices."""

    __slots__ = ()

    _paths: _core.Paths

    @property
    def _points_on_mesh(self) -> _core.Paths:
        return self._paths

    def path(
        self,
        source: Points,
        target: Points,
        progress: ProgressFunction | bool | None = None,
    ) -> GeodesicPath | list[GeodesicPath]:
        """Refined shortest path between two points, or of each of k pairs.

        The route of the index is shortened to a geodesic, which is never shorter than the shortest path, and in most
        cases is that path (``docs/paths.md`` has the errors).

        Parameters
        ----------
        source, target : a point, or k points
            Vertex ids, `SurfacePoints` or lists of both; both of the same length.
        progress : callable or bool, optional
            As for the class.

        Returns
        -------
        GeodesicPath, or list of k GeodesicPath
            One path if both are single ids or hold one surface point each. Where no path joins them, the result
            has no points and infinite length.

        Raises
        ------
        InvalidInput
            (a ValueError) If an id or a face is out of range, weights are not barycentric, or lengths differ.
        """
        return self._find_paths(source, target, False, False, progress)

    def exact_path(
        self,
        source: Points,
        target: Points,
        certify: bool = True,
        progress: ProgressFunction | bool | None = None,
    ) -> GeodesicPath | list[GeodesicPath]:
        """Exact shortest path between two points, or of each of k pairs, without a field over the whole mesh.

        A call that certifies 1,000 pairs or more first calls `prepare_exact_paths`, unless that was called before.

        Parameters
        ----------
        source, target, progress
            As for `path`.
        certify : bool, default True
            Whether to prove that no path is shorter, by lower bounds from straight lines in space and from what
            `prepare_exact_paths` computed. False: the distances of the index less an error margin serve as bounds,
            which is about twice as fast on large curved surfaces and hardly faster on others; on meshes of needles a
            few answers are then too long.

        Returns
        -------
        GeodesicPath, or list of k GeodesicPath
            `certified` says whether it is proven to be a shortest path.

        Raises
        ------
        InvalidInput
            As `path`.
        """
        return self._find_paths(source, target, True, bool(certify), progress)

    def prepare_exact_paths(self, landmarks: int = 32, progress: ProgressFunction | bool | None = None) -> int:
        """Make all later certified paths faster, by exact distance fields from a few vertices.

        The differences of these distances are lower bounds of those of all pairs, on a curved surface much closer ones
        than straight lines in space. It pays off for many pairs: preparing takes as long as `landmarks` exact fields.

        Parameters
        ----------
        landmarks : int, default 32
            Number of vertices, 1 to 32, spread over the component with the most vertices.
        progress : callable or bool, optional
            As for `path`.

        Returns
        -------
        int
            The memory taken, in bytes: four for each vertex and landmark.

        Raises
        ------
        InvalidInput
            (a ValueError) If the number is out of range.
        Cancelled
            If `progress` returned False; nothing is prepared then.
        """
        count = check.integer("landmarks", landmarks, 1, 32)
        with reporter(progress) as report:
            return self._paths.use_landmarks(count, report)

    def _find_paths(
        self, source: Any, target: Any, exact: bool, certify: bool, progress: ProgressFunction | bool | None
    ) -> GeodesicPath | list[GeodesicPath]:
        ends = point_lists.pairs(source, target, self._vertex_count)
        with reporter(progress) as report:
            found = self._paths.paths(*ends, exact, certify, report)
        paths = from_core(found)
        return paths[0] if point_lists.is_pair(source, target) else paths

    def _labelled_field(
        self, sources: Sources, offsets: ArrayLike | None, limit: float, exact: bool
    ) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        rows, number = self._source_rows(sources)
        start = check.offsets(offsets, int(number[-1]) + 1)[number]
        distance, label = self._paths.field(_core.Points(*rows), start, limit, exact)
        return distance, np.where(label < 0, np.int32(-1), number[label])
