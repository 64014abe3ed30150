"""Tasks built on distance fields: Voronoi regions, samplings, isolines, disks, extents, relaxation."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as check
from . import _core
from . import points as point_lists
from .errors import InvalidInput
from .paths import Paths
from .points import Points, Sources, surface_points
from .progress import ProgressFunction, reporter
from .results import Disk, Extent, FarthestSamples, Isolines, Polylines, RelaxedPoints, VoronoiRegions

_INTERPOLATIONS = ("linear", "distance")


class SurfaceTasks(Paths):
    """The methods of `GeodesicIndex` that are built on distance fields.

    Points are vertex ids, `SurfacePoints` or lists of both, `progress` is as for the constructor, and errors are
    `InvalidInput` for arguments and `Cancelled` if `progress` returned False. With ``exact=True`` distances come from
    exact propagation instead of the index: slower, but without errors.
    """

    __slots__ = ()

    _handle: _core.Index

    def voronoi(
        self, points: Points, exact: bool = False, progress: ProgressFunction | bool | None = None
    ) -> VoronoiRegions:
        """Geodesic Voronoi regions of points: the nearest point of every vertex and face, and the borders.

        Parameters
        ----------
        points : k points, k >= 1
            One that repeats an earlier one owns nothing.
        exact, progress
            As for the class.

        Returns
        -------
        VoronoiRegions

        Notes
        -----
        Borders are exact on flat parts of the surface, given the distances of the vertices: in each face the difference
        of two squared distances is interpolated linearly. Complexity: a field for each point, bounded by the greatest
        distance of a vertex from its point.
        """
        chosen = point_lists.some("points", points, self._vertex_count)
        with reporter(progress) as report:
            found = _core.voronoi(self._handle, chosen, exact, report)
        borders = Polylines(found[4].reshape(-1, 3), found[5].reshape(-1, 2))
        return VoronoiRegions(*found[:4], borders, found[6].reshape(-1, 2))

    def isolines(self, field: ArrayLike, levels: ArrayLike, interpolation: str = "distance") -> Isolines:
        """Lines on which a field has given values.

        Parameters
        ----------
        field : array_like of float, shape (n,)
            Values of the vertices; faces with a value that is not finite hold no lines.
        levels : int or array_like of float, shape (l,)
            The values; an integer stands for that many, evenly spaced between the least and the greatest of the field.
        interpolation : {"distance", "linear"}
            "distance": along an edge, values vary like distances from a point in the plane, which is exact where the
            surface is flat; linear where they differ by more than the edge's length. "linear": for any field.

        Returns
        -------
        Isolines
            Edges join points of one level.
        """
        values = check.real_values("field", field)
        if values.size != self._vertex_count:
            raise InvalidInput(
                f"field: has {values.size} values; give one for each of the {self._vertex_count} vertices."
            )
        how = check.choice("interpolation", interpolation, _INTERPOLATIONS)
        if isinstance(levels, (int, np.integer)):
            count = check.integer("levels", levels, 0, 2**31 - 1)
            finite = values[np.isfinite(values)]
            low, high = (float(finite.min()), float(finite.max())) if finite.size else (0.0, 0.0)
            chosen = np.linspace(low, high, count + 2)[1:-1]
        else:
            chosen = check.real_values("levels", levels)
        points, edges, level = _core.isolines(self._handle, values, chosen, how)
        return Isolines(points.reshape(-1, 3), edges.reshape(-1, 2), chosen[level])

    def sample_farthest(
        self,
        count: int | None = None,
        radius: float = 0.0,
        start: Points = (),
        seed: int = 0,
        exact: bool = False,
        progress: ProgressFunction | bool | None = None,
    ) -> FarthestSamples:
        """Farthest point sampling: each sample is the vertex farthest from the previous ones.

        Parameters
        ----------
        count : int, optional
            Number of samples; fewer if there are not that many vertices.
        radius : float, default 0
            Stop as soon as every vertex is at most this far from a sample. Give this, `count`, or both.
        start : points, optional
            The first samples, anywhere on the surface; without them the first one is random.
        seed : int, default 0
            Of the random first sample.
        exact, progress
            As for the class.

        Returns
        -------
        FarthestSamples
            Samples are at least the covering radius apart; every component gets one before any gets two.

        Notes
        -----
        Complexity: a field for each sample, bounded by the covering radius so far.
        """
        limit = 0 if count is None else check.integer("count", count, 1, 2**31 - 1)
        reach = check.length("radius", radius)
        if count is None and reach == 0:
            raise InvalidInput("Give a count of samples, or a covering radius above 0 at which to stop.")
        first = point_lists.given("start", start, self._vertex_count)
        seed = check.integer("seed", seed, 0, 2**64 - 1)
        with reporter(progress) as report:
            found = _core.sample_farthest(self._handle, limit, reach, first, seed, exact, report)
        rows, gaps, distance, covered = found
        return FarthestSamples(rows[0], gaps, distance, covered, surface_points(*rows))

    def sample_poisson_disk(
        self, radius: float, seed: int = 0, exact: bool = False, progress: ProgressFunction | bool | None = None
    ) -> NDArray[np.int32]:
        """Poisson-disk sampling: random vertices at least a radius apart, none of which could be added.

        Parameters
        ----------
        radius : float
            Least distance of two samples, above 0.
        seed : int, default 0
            Seed of the random numbers.
        exact, progress
            As for the class.

        Returns
        -------
        ndarray of int32, shape (k,)
            Vertex ids. The result does not depend on the number of threads.

        Notes
        -----
        Complexity: a field for each sample, bounded by the radius.
        """
        reach = check.length("radius", radius)
        if not 0 < reach < np.inf:
            raise InvalidInput(f"radius: {reach} is out of range; give a finite length above 0.")
        seed = check.integer("seed", seed, 0, 2**64 - 1)
        with reporter(progress) as report:
            return _core.sample_poisson_disk(self._handle, reach, seed, exact, report)

    def disk(self, sources: Sources, radius: float, exact: bool = False) -> Disk:
        """Vertices and faces within a radius of the nearest source.

        Parameters
        ----------
        sources : k points, k >= 1
            Or an `EdgeCurve`, or a list that contains curves.
        radius : float
            0 or more.
        exact : bool
            As for the class.

        Returns
        -------
        Disk
        """
        rows, _ = self._source_rows(sources)
        return Disk(*_core.disk(self._handle, _core.Points(*rows), check.length("radius", radius), exact))

    def eccentricity(
        self, points: Points, exact: bool = False, progress: ProgressFunction | bool | None = None
    ) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """The greatest distance from each point within its component, and the vertex at that distance.

        Parameters
        ----------
        points : k points
        exact, progress
            As for the class.

        Returns
        -------
        distances : ndarray of float64, shape (k,)
        farthest : ndarray of int32, shape (k,)
        """
        chosen = point_lists.given("points", points, self._vertex_count)
        with reporter(progress) as report:
            return _core.eccentricity(self._handle, chosen, exact, report)

    def extent(
        self,
        start: int | None = None,
        fields: int = 20,
        exact: bool = False,
        progress: ProgressFunction | bool | None = None,
    ) -> Extent:
        """Bounds of the geodesic diameter and radius of a component, its ends and its centre.

        Parameters
        ----------
        start : int, optional
            A vertex of the component; None is the component with the most vertices.
        fields : int, default 20
            Distance fields that may be computed, at least 2; more bring the bounds closer together.
        exact, progress
            As for the class.

        Returns
        -------
        Extent

        Notes
        -----
        A double sweep, then vertices chosen by the bounds that the triangle inequality gives (Takes, Kosters 2011).
        """
        last = max(self._vertex_count - 1, 0)
        first = -1 if start is None else check.integer("start", start, 0, last)
        limit = check.integer("fields", fields, 2, 2**31 - 1)
        with reporter(progress) as report:
            return Extent(*_core.extent(self._handle, first, limit, exact, report))

    def relax(
        self,
        points: Points,
        rounds: int = 10,
        exact: bool = False,
        progress: ProgressFunction | bool | None = None,
    ) -> RelaxedPoints:
        """Lloyd relaxation: move points to the middle of their geodesic Voronoi regions, at vertices.

        Parameters
        ----------
        points : k points, k >= 1
            Anywhere on the surface; they move to vertices. A repeated point waits until the other one has moved.
        rounds : int, default 10
            At most this many; fewer if no point finds a better vertex.
        exact, progress
            As for the class.

        Returns
        -------
        RelaxedPoints

        Notes
        -----
        A point moves only if that lowers the integral of squared geodesic distances over its region. Complexity: two
        fields for each point and round, bounded by the size of the regions.
        """
        chosen = point_lists.some("points", points, self._vertex_count)
        limit = check.integer("rounds", rounds, 0, 2**31 - 1)
        with reporter(progress) as report:
            rows, energy = _core.relax(self._handle, chosen, limit, exact, report)
        return RelaxedPoints(rows[0], energy, surface_points(*rows))
