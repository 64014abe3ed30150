"""Means, medians and medoids of points on a surface, and clusters around them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as check
from .points import Points, SurfacePoints, surface_points
from .progress import ProgressFunction
from .results import Clusters
from .tasks import METHODS, Tasks

#: The power to which distances are raised before they are summed.
_MEDIAN, _MEAN = 1, 2


class Means(Tasks):
    """The part of `Surface` that finds points in the middle of others; without weights, each point counts 1."""

    def frechet_mean(
        self,
        points: Points,
        weights: ArrayLike | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> SurfacePoints:
        """The point with the least sum of weighted squared distances from some points: their mean on the surface.

        It is found exactly, to 1e-8 of their distances, by descent from the best of the points. Where the sum has
        several minima, it is the one near that point. `last.remark` says whether several points were equally good and
        their descents ended at different places with equal sums, and whether the descent did not converge.

        Parameters
        ----------
        points : k points, k >= 1
            Of one component.
        weights : array_like, shape (k,), optional
            Finite, 0 or more, not all 0.

        Returns
        -------
        SurfacePoints
            One point; on the bridge over a gap, its face is -1.

        Notes
        -----
        Newton's method on exact log maps: some ten exact fields, bounded by the distances of the points, besides those
        of `medoid`. Refused where a metric jumps at edges, as by `log_map`.
        """
        return self._centre(points, weights, _MEAN, progress=progress)

    def geometric_median(
        self,
        points: Points,
        weights: ArrayLike | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> SurfacePoints:
        """The point with the least sum of weighted distances from some points; otherwise as `frechet_mean`."""
        return self._centre(points, weights, _MEDIAN, progress=progress)

    def _centre(self, points: Points, weights: ArrayLike | None, power: int, **how: Any) -> SurfacePoints:
        rows = self._rows("points", points, 1)
        (found,) = self._ask(
            self._shared.core.centre, rows, _weights(weights, len(rows[0])), power, method="exact", **how
        )
        return surface_points(found)

    def medoid(
        self,
        points: Points,
        weights: ArrayLike | None = None,
        method: str | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> int:
        """The position, in the list, of the point with the least sum of weighted distances from all of them.

        Parameters
        ----------
        points, weights
            As for `frechet_mean`.

        Notes
        -----
        As exact as the distances: the triangle inequality rules out most of the points (Newling, Fleuret 2017), so that
        some multiple of sqrt(k) fields is enough where the points are spread out.
        """
        rows = self._rows("points", points, 1)
        given = _weights(weights, len(rows[0]))
        (found,) = self._ask(self._shared.core.medoid, rows, given, method=method, progress=progress)
        return int(found)

    def k_means(
        self,
        count: int,
        points: Points | None = None,
        weights: ArrayLike | None = None,
        seed: int = 0,
        rounds: int = 100,
        method: str | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> Clusters:
        """Clusters around their means: a low sum of weighted squared distances from the nearest centre.

        Begins with k-means++ and goes on with Lloyd's rounds: each point goes to the nearest centre, each centre to the
        mean of its points (`frechet_mean`, nearby). For all vertices, the first centres are chosen by distances along
        edges; centres are then vertices, and move as in `relax`: to the vertex nearest in space to the middle of their
        region, if that is better.

        Parameters
        ----------
        count : int
            Number of clusters, at least that of the components with points; points without a path between them never
            share a cluster.
        points : k points, optional
            None for all vertices with a face.
        weights : array_like, shape (k,) or (n,), optional
            None: 1 for each point; for each vertex a third of the area of its faces.
        seed : int, default 0
            Seed of the random points to begin with.
        rounds : int, default 100
            At most this many; fewer if no centre moves.

        Notes
        -----
        Each round takes a field from each centre, from the index if there is one, and no farther than clusters may
        reach; for all vertices, it takes one or two fields from all centres at once, for which `method` may also be
        "quick". Means of points also take exact fields, bounded by their cluster.
        """
        return self._clusters(count, points, weights, _MEAN, seed, rounds, method=method, progress=progress)

    def k_medoids(
        self,
        count: int,
        points: Points | None = None,
        weights: ArrayLike | None = None,
        seed: int = 0,
        rounds: int = 100,
        method: str | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> Clusters:
        """Clusters around points of the list, with a low sum of weighted distances; otherwise as `k_means`."""
        return self._clusters(count, points, weights, _MEDIAN, seed, rounds, method=method, progress=progress)

    def _clusters(
        self,
        count: int,
        points: Points | None,
        weights: ArrayLike | None,
        power: int,
        seed: int,
        rounds: int,
        **how: Any,
    ) -> Clusters:
        rows = None if points is None else self._rows("points", points, 1)
        given = _weights(weights, len(self.vertices) if rows is None else len(rows[0]))
        number = check.integer("count", count, 1, 2**31 - 1)
        limit, begin = check.integer("rounds", rounds, 0, 2**31 - 1), check.integer("seed", seed, 0, 2**64 - 1)
        arguments = number, rows, given, power, limit, begin
        choices = METHODS if rows is None else METHODS[:3]
        centres, labels, energy = self._ask(self._shared.core.clusters, *arguments, choices=choices, **how)
        return Clusters(labels, surface_points(centres), energy)


def _weights(weights: ArrayLike | None, count: int) -> NDArray[np.float64]:
    """Weights as the core takes them: empty for equal ones. The core checks that one is above 0."""
    if weights is None:
        return np.empty(0)
    return check.not_negative("weights", weights, count, "numbers of 0 or more, one for each point")
