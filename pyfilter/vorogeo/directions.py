"""Questions about directions: which way things lie and distances change, on which side, and where paths meet."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as check
from . import points as point_lists
from .errors import InvalidInput
from .points import Points, SurfacePoints, surface_points
from .progress import ProgressFunction
from .results import CutLocus, DistanceGradient, GeodesicPath, TextureCoordinates
from .tasks import Tasks


class Directions(Tasks):
    """The part of `Surface` that answers questions about directions; what they share stands in `Surface`'s notes."""

    def tangent_frames(self, points: Points) -> NDArray[np.float64]:
        """The frames in which directions at points are given: x axis, y axis and normal, as unit vectors in space.

        At a vertex, the x axis runs along the edge that leaves it in the last face that has the vertex (on a border,
        along the border edge after which the faces follow), and angles are scaled so that those of the faces sum to
        2 pi, on a border to pi. In a face, it runs from the first corner to the second. A point on an edge takes the
        first of the faces there. These are the frames of geometry-central and potpourri3d. With a metric, whose angles
        are not those in space, they are refused.

        Returns
        -------
        ndarray, shape (k, 3, 3)
            Three rows for each point. The normal of a vertex is the mean of the normals of its faces, weighted by their
            angles; its x axis is the sum of all edges, projected along the normal and each turned back by its angle.
        """
        rows = self._rows("points", points)
        return self._array(self._shared.core.tangent_frames, rows, method="exact").reshape(-1, 3, 3)

    def log_map(
        self,
        point: Points,
        targets: Points | None = None,
        max_distance: float | None = None,
        return_distance: bool = False,
        method: str = "exact",
        progress: ProgressFunction | bool | None = None,
    ) -> NDArray[np.float64] | tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Where vertices or points lie as seen from a point: vectors in its frame (`tangent_frames`).

        Each has the direction in which the shortest path begins, and its length; of several shortest paths, any. Behind
        a saddle vertex or a border that the path turns at, all points have the direction of that vertex.

        Parameters
        ----------
        point : a vertex id, or SurfacePoints with one point
            Refused are a vertex whose faces form no fan, and points on an edge of three faces or more or in a face
            without area.
        targets : k points, optional
            None for all vertices. If all targets are vertices, propagation ends at the farthest of them.
        max_distance : float, optional
            Vectors longer than this become NaN; None for no limit.
        return_distance : bool, default False
            Whether to return also the lengths of the vectors.
        method : {"exact", "index"}, default "exact"
            "index" (built if there is none) takes as long as 2 to 3 of its fields: exact around the point; elsewhere
            off by .01 to .45 degrees in the mean, in faces by up to .5, more where two paths are almost equally long.

        Returns
        -------
        vector : ndarray, shape (n, 2) or (k, 2)
            NaN where no path leads.
        distance : ndarray, shape (n,) or (k,)
            Only if `return_distance`; infinity where no path leads.
        """
        source, limit = self._one_row("point", point), check.max_distance(max_distance)
        ends = None if targets is None else self._rows("targets", targets)
        vector, distance = self._ask(self._shared.core.log_map, source, ends, limit, method=method, progress=progress)
        return (vector, distance) if return_distance else vector

    def gradient(
        self,
        sources: Points,
        points: Points | None = None,
        max_distance: float | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> NDArray[np.float64]:
        """The gradient of the distance from the nearest source: which way leads straight away from it.

        At each vertex or point a vector of length 1 in its frame (`tangent_frames`), against the direction in which the
        shortest path to the source begins: exact, not the slope of a field that is linear in the faces. Where there are
        several shortest paths, any of them counts. Always exact, even if there is an index.

        Parameters
        ----------
        sources : vertex ids, or SurfacePoints
        points : k points, optional
            None for all vertices; centres of faces are SurfacePoints.
        max_distance : float, optional
            Beyond it there is no gradient; None for no limit.

        Returns
        -------
        ndarray, shape (n, 2) or (k, 2)
            NaN at sources, where no path leads, and at vertices without a frame; `points` without a frame are refused.

        Notes
        -----
        Takes an exact field that keeps all windows, as for an exact path.
        """
        ends = None if points is None else self._rows("points", points)
        limit, rows = check.max_distance(max_distance), self._rows("sources", sources, 1)
        return self._array(self._shared.core.gradient, rows, ends, limit, method="exact", progress=progress)

    def transport(self, path: Points | GeodesicPath, vectors: ArrayLike) -> NDArray[np.float64]:
        """Vectors at the first point of a path, carried along it in parallel to its last point.

        In the faces and over their edges they keep their angle with the path; through a vertex they keep their
        direction in its frame. Round a closed path they come back turned by the curvature inside.

        Parameters
        ----------
        path : GeodesicPath, or k points
            Consecutive points share a face.
        vectors : array_like, shape (2,) or (k, 2)
            In the frame of the first point (`tangent_frames`).

        Returns
        -------
        ndarray, shape (k, 2)
            In the frame of the last point.

        Notes
        -----
        O(points). For all vertices, use `transport_from`; for other points, the paths of `path(p, points)`.
        """
        rows, along = self._curve_rows(path), check.positions("vectors", vectors, 2)
        return self._array(self._shared.core.transport, rows, along, method="exact")

    def transport_from(
        self,
        point: Points,
        vector: ArrayLike,
        max_distance: float | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> NDArray[np.float64]:
        """A vector at a point, carried in parallel along the shortest paths to all vertices (`transport`).

        Parameters
        ----------
        point : a vertex id, or SurfacePoints with one point
        vector : array_like, shape (2,)
            In the frame of the point (`tangent_frames`).
        max_distance : float, optional
            Beyond it there are no vectors; None for no limit.

        Returns
        -------
        ndarray, shape (n, 2)
            In the frames of the vertices. NaN where no path leads, and where there is no frame. Where there are several
            shortest paths, along one of them. Always exact, even if there is an index.

        Notes
        -----
        Takes an exact field that keeps all windows, and for each vertex a trace from where its path turns last.
        """
        source, limit = self._one_row("point", point), check.max_distance(max_distance)
        along = check.positions("vector", vector, 2)
        if len(along) != 1:
            raise InvalidInput(f"vector: has {len(along)} vectors; give one.")
        return self._array(self._shared.core.transport_from, source, along, limit, method="exact", progress=progress)

    def signed_distance(
        self,
        curves: GeodesicPath | Points | list[GeodesicPath | Points] | NDArray[np.bool_],
        max_distance: float | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> NDArray[np.float64]:
        """The distance of every vertex from closed curves or the border of a region: negative inside.

        The inside of closed curves is the side without border of the surface, else the smaller one, whichever way the
        curves run; each component has its own. `isolines(field, [-w, w], "linear")` are the inner and the outer offset.

        Parameters
        ----------
        curves : GeodesicPath or points, or a list of these; or array of bool, shape (m,)
            Lines whose consecutive points share a face and which end where they begin, such as those of
            `path_through(points, closed=True)` and `tighten`; they neither cross nor touch. An array of bool says which
            faces belong to a region, inside which distances from its border are negative.
        max_distance : float, optional
            Distances beyond it become infinite, with their sign; None for no limit.

        Returns
        -------
        ndarray, shape (n,)
            From the lines themselves, straight in each face: at most 1.3e-6 of a typical edge too long. Infinity on
            components without a curve. Always exact, even if there is an index.
        """
        limit, core = check.max_distance(max_distance), self._shared.core
        if isinstance(curves, np.ndarray) and curves.dtype == np.bool_:
            if curves.shape != (len(self.faces),):
                raise InvalidInput(
                    f"curves: has bools of shape {curves.shape}; give one for each of the {len(self.faces)} faces."
                )
            flags = np.ascontiguousarray(curves, dtype=np.uint8)
            return self._array(core.region_distance, flags, limit, method="exact", progress=progress)
        lines = self._line_rows("curves", cast(Any, curves))
        return self._array(core.signed_distance, *lines, limit, method="exact", progress=progress)

    def distance_gradient(
        self,
        source: Points,
        target: Points,
        progress: ProgressFunction | bool | None = None,
        method: str | None = None,
    ) -> DistanceGradient:
        """How exact distances of pairs change with the positions of the vertices.

        A pair has entries only for the vertices of the faces that its path crosses. Points stay at their vertices, or
        keep their weights in their faces. Where there are several shortest paths, the derivative is that of one of
        them; where both points coincide, or no path joins them, there are no entries. Refused with a metric.

        Parameters
        ----------
        source, target : points of k pairs
            As for `distance`.

        Returns
        -------
        DistanceGradient
            `np.add.at(gradient, found.vertices, found.values * weights[found.pairs, None])` sums it up to the gradient
            of ``(weights * found.distances).sum()``, of shape (n, 3).
        """
        ends = point_lists.pairs(("source", "target"), source, target, len(self.vertices))
        return DistanceGradient(
            *self._ask(self._shared.core.distance_gradient, *ends, method=method, progress=progress)
        )

    def cut_locus(
        self,
        sources: Points,
        min_angle: float = 0.0,
        max_distance: float | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> CutLocus:
        """The points that several shortest paths reach from a source, as lines over the surface.

        Cut along it, the surface can be laid out from the source: a closed one becomes one disk for each source. With
        several sources, it includes the borders of their Voronoi regions: the ridge of the field. It is exact where it
        crosses edges, and drawn straight in a face, as it is unless a path has turned. On a polyhedron a line leads to
        each convex vertex; where the mesh approximates a smooth surface, the directions of the shortest paths hardly
        differ along such a line: `min_angle` leaves these out.

        Parameters
        ----------
        sources : k points, k >= 1
        min_angle : float, default 0
            In radians, at most pi. Lines are pruned from their ends up to where the directions of two shortest paths
            differ by this angle. What was connected stays connected.
        max_distance : float, optional
            Only what is within this distance; None for no limit.
        """
        rows, limit = self._rows("sources", sources, 1), check.max_distance(max_distance)
        least = check.angle("min_angle", min_angle)
        points, edges, distance, angle, on_faces = self._ask(
            self._shared.core.cut_locus, rows, least, limit, method="exact", progress=progress
        )
        return CutLocus(points, edges, distance, angle, surface_points(on_faces))

    def texture_coordinates(
        self,
        point: Points,
        radius: float,
        rotation: float = 0.0,
        scale: float = 1.0,
        progress: ProgressFunction | bool | None = None,
    ) -> TextureCoordinates:
        """Texture coordinates that lay a picture around a point: a decal.

        Lines through the middle of the picture become shortest paths from the point, of their true length (`log_map`).
        The x axis of the picture is that of the frame at the point, turned by `rotation`.

        Parameters
        ----------
        point : a vertex id, or SurfacePoints with one point
        radius : float
            How far from the point vertices get coordinates, above 0.
        rotation : float, default 0
            Angle by which the picture is turned about the point, in radians, counter-clockwise in the frame there.
        scale : float, default 1
            Scale of the picture, above 0; at 1 its side is twice the radius.
        """
        source = self._one_row("point", point)
        sizes = (
            check.length("radius", radius),
            check.real("rotation", rotation, "an angle in radians"),
            check.length("scale", scale),
        )
        return TextureCoordinates(
            *self._ask(self._shared.core.texture_coordinates, source, *sizes, method="exact", progress=progress)
        )

    def exp_map(
        self,
        points: Points,
        vectors: ArrayLike,
        at_border: str = "end",
        return_length: bool = False,
        progress: ProgressFunction | bool | None = None,
    ) -> SurfacePoints | tuple[SurfacePoints, NDArray[np.float64]]:
        """Where straightest lines end that begin at points along vectors in the frames there (`tangent_frames`).

        A line is straight in the faces and over their edges; through a vertex it leaves half of the vertex's angle on
        either side. Vertices whose faces form no fan and edges of three faces or more count as borders. With vectors of
        `log_map`, lines lead back to its targets, except those behind a vertex at which the shortest path turns.

        Parameters
        ----------
        points : one point, or k points
            As for `log_map`.
        vectors : array_like, shape (2,) or (k, 2)
            Finite; those of length 0 give the point itself.
        at_border : {"end", "slide"}
            Whether lines end at a border, or go on along it, to the side that they lean to.
        return_length : bool, default False
            Whether to return also how long the lines are: shorter than their vectors where they ended at a border.

        Returns
        -------
        points : SurfacePoints
            Where the k lines end. Between the borders of a bridged gap, the face is -1.
        length : ndarray, shape (k,)
            Only if `return_length`.
        """
        rows, along = self._rows("points", points), check.positions("vectors", vectors, 2)
        slides = check.choice("at_border", at_border, ("end", "slide")) == 1
        if len(rows[0]) not in (1, len(along)):
            raise InvalidInput(
                f"points has {len(rows[0])} points, vectors {len(along)}; give one vector for each, or a single point."
            )
        ends, length = self._ask(self._shared.core.exp_map, rows, along, slides, method="exact", progress=progress)
        return (surface_points(ends), length) if return_length else surface_points(ends)
