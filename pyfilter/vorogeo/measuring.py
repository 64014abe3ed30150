"""Measures along a surface: curves, areas, polygons, hulls and cuts."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _arguments as check
from .errors import InvalidInput
from .points import Points, SurfacePoints, surface_points
from .progress import ProgressFunction
from .results import Band, CutMesh, GeodesicPath, GeodesicPolygon, Girth, Polylines, Profile, RegionArea, SetDistances
from .tasks import Sources, Tasks, paths_of

#: Points on a path within the width of a band: its border then has dents of 1 / 3200 of the width.
_POINTS_IN_WIDTH = 20


class Measuring(Tasks):
    """The part of `Surface` that people measure with."""

    def path_through(
        self,
        points: Points,
        closed: bool = False,
        progress: ProgressFunction | bool | None = None,
        method: str | None = None,
        guides: bool = False,
    ) -> GeodesicPath:
        """The shortest path through points in the order given; each leg from a point to the next is exact.

        Parameters
        ----------
        points : k points, k >= 2
        closed : bool, default False
            Whether it leads from the last point back to the first, where it begins and ends.
        guides : bool, default False
            Whether the points between the ends are guides only: the path through them is then pulled tight, to a
            locally shortest one. If closed, as by `tighten`.

        Returns
        -------
        GeodesicPath
            Certified if all legs are, never with guides. Two points that no path joins are refused.
        """
        rows = self._rows("points", points)
        question = self._shared.core.tighten if guides else self._shared.core.path_through
        return paths_of(self._ask(question, rows, bool(closed), method=method, progress=progress))[0]

    def points_along(self, path: Points | GeodesicPath, fractions: ArrayLike) -> SurfacePoints:
        """The points at fractions of the length of a path, from 0 to 1.

        Parameters
        ----------
        path : GeodesicPath, or k points
            Consecutive points share a face.
        fractions : float, or array_like of shape (j,)
        """
        rows = self._curve_rows(path)
        (found,) = self._ask(
            self._shared.core.points_along, rows, check.real_values("fractions", fractions), method="exact"
        )
        return surface_points(found)

    def bezier(
        self,
        points: Points,
        samples: int = 32,
        progress: ProgressFunction | bool | None = None,
        method: str | None = None,
    ) -> GeodesicPath:
        """The Bezier curve of control points: de Casteljau's construction with shortest paths as its straight lines.

        Parameters
        ----------
        points : k points, k >= 2
            Of one component; four make a cubic curve.
        samples : int, default 32
            The curve is taken at samples + 1 parameters, which shortest paths join.

        Returns
        -------
        GeodesicPath
            From the first point to the last. Where a shortest path between points of the construction changes sides, as
            behind a hill, the curve jumps along a shortest path.

        Notes
        -----
        Takes (k - 1) (k - 2) / 2 exact paths for each sample, and one from each sample to the next.
        """
        chosen, steps = self._rows("points", points), check.integer("samples", samples, 1, 10**6)
        found = self._ask(self._shared.core.bezier, chosen, steps, method=method, progress=progress)
        return paths_of(found)[0]

    def b_spline(
        self,
        points: Points,
        closed: bool = False,
        levels: int = 4,
        progress: ProgressFunction | bool | None = None,
        method: str | None = None,
    ) -> GeodesicPath:
        """The cubic B-spline curve of control points, by subdivision with middles of shortest paths.

        It is smoother than `spline`, and passes near the points but not through them. On each level each point is
        doubled, then three times the points are replaced by the middles of neighbours (Lane, Riesenfeld 1980).

        Parameters
        ----------
        points : k points, k >= 2, or 3 of a closed curve
            Of one component.
        closed : bool, default False
            Whether it leads all the way round; else it begins at the first point and ends at the last.
        levels : int, default 4
            Levels of subdivision: some 2**levels points for each given one, which shortest paths join.
        """
        chosen, steps = self._rows("points", points), check.integer("levels", levels, 1, 20)
        found = self._ask(self._shared.core.b_spline, chosen, bool(closed), steps, method=method, progress=progress)
        return paths_of(found)[0]

    def spline(
        self,
        points: Points,
        closed: bool = False,
        samples: int = 16,
        progress: ProgressFunction | bool | None = None,
        method: str | None = None,
    ) -> GeodesicPath:
        """A smooth curve through points in the order given: cubic Bezier curves with one direction where they meet.

        That direction is half of the difference of the vectors to the next point and to the one before (Catmull, Rom
        1974), at an end the vector to its neighbour.

        Parameters
        ----------
        points : k points, k >= 2, or 3 of a closed curve
            Of one component, and such as `log_map` takes.
        closed : bool, default False
            Whether it leads from the last point back to the first.
        samples : int, default 16
            Samples of each curve between two points, as for `bezier`.
        """
        chosen, steps = self._rows("points", points), check.integer("samples", samples, 1, 10**6)
        found = self._ask(self._shared.core.spline, chosen, bool(closed), steps, method=method, progress=progress)
        return paths_of(found)[0]

    def tighten(
        self,
        curve: Points | GeodesicPath,
        progress: ProgressFunction | bool | None = None,
        method: str | None = None,
    ) -> GeodesicPath:
        """The closed geodesic that a closed curve is pulled to: it moves over faces and vertices, but over no border.

        It is the shortest curve near the given one, which need not be the shortest of all that go round the same way.
        With values of faces, where paths refract, it is refused.

        Parameters
        ----------
        curve : k points, k >= 2, or GeodesicPath
            In order; points that share no face are joined by shortest paths, the last with the first.

        Returns
        -------
        GeodesicPath
            It begins and ends at one point. A curve that nothing holds is refused, naming where it slips off. If it was
            still becoming shorter after some thousand rounds, `last.remark` says so.
        """
        rows = self._curve_rows(curve)
        return paths_of(self._ask(self._shared.core.tighten, rows, True, method=method, progress=progress))[0]

    def shortest_loop(
        self,
        point: Points,
        curve: Points | GeodesicPath | None = None,
        progress: ProgressFunction | bool | None = None,
        method: str | None = None,
    ) -> GeodesicPath:
        """The shortest loop through a point that cannot be contracted: round a handle, or between two borders.

        Parameters
        ----------
        point : one point
        curve : k points or GeodesicPath, optional
            As for `tighten`: the loop goes round in the same way, and is a shortest one of such loops near the curve.

        Returns
        -------
        GeodesicPath
            From the point back to it. Where every loop contracts, as on a sphere, it is refused.

        Notes
        -----
        From the exact field of the point: a loop for each class of edges at which the shortest paths of their two ends
        part (Erickson, Har-Peled 2004), pulled tight with the point held.
        """
        rows = self._one_row("point", point), self._curve_rows(() if curve is None else curve)
        return paths_of(self._ask(self._shared.core.shortest_loop, *rows, method=method, progress=progress))[0]

    def girth(
        self,
        point: Points,
        normal: ArrayLike | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> Girth:
        """How far it is round a limb at a point: by a plane section, by a tape measure, and along the surface.

        Parameters
        ----------
        point : one point
        normal : array_like, shape (3,), optional
            Normal of the plane, of any length: the direction of the limb. None: of the planes that contain the normal
            of the surface at the point, the one with the shortest closed section, sought among 36 at equal angles and
            then between the neighbours of the best.

        Returns
        -------
        Girth
            Its loop is a single point, of length 0, where the section slips off, as on a sphere; `last.remark` says so.
        """
        row = self._one_row("point", point)
        plane = (0.0, 0.0, 0.0) if normal is None else check.direction("normal", normal)
        *paths, direction, corners, _ = self._ask(
            self._shared.core.girth, row, *plane, normal is not None, method=None, progress=progress
        )
        section, loop = paths_of(paths)
        order = np.arange(len(corners), dtype=np.int32)
        return Girth(section, Polylines(corners, np.column_stack([order, np.roll(order, -1)])), loop, direction)

    def profile(self, path: Points | GeodesicPath, up: ArrayLike = (0.0, 0.0, 1.0)) -> Profile:
        """Height, slope, curvature and thickness along a path, in space; lengths are in the unit of the metric.

        `np.savetxt(file, np.column_stack(profile), delimiter=",", header=",".join(profile._fields))` writes a table.

        Parameters
        ----------
        path : GeodesicPath, or k points
            Consecutive points share a face.
        up : array_like, shape (3,)
            The direction in which heights count, of any length.

        Notes
        -----
        Normals point to the side of most faces, also where some are turned over. Curvature is how much the normals tilt
        forwards over the steps beside the point: as rough as the normals of vertices, between which it interpolates.
        """
        rows = self._curve_rows(path)
        return Profile(*self._ask(self._shared.core.profile, rows, *check.direction("up", up), method=None))

    def band(
        self,
        sources: Sources,
        width: float,
        method: str | None = None,
        progress: ProgressFunction | bool | None = None,
        to: bool = False,
    ) -> Band:
        """Area within a distance of the nearest source, and the length of its border.

        Faces at the border are bisected until their sides are at most width / 16. In each part the border is an arc of
        a circle through its crossings of the sides; the distance at the middle of its chord says how far the arc is
        from the chord. Exact for points in a plane, except for the few arcs that leave a part and come back.

        Parameters
        ----------
        sources : k points, k >= 1
            Or an `EdgeCurve` or a `GeodesicPath`, or a list that contains some. A band around a curve lies on both
            sides of it. A path counts as points at most width / 20 apart.
        width : float
            0 or more.
        to
            As for `distance_field`.
        """
        reach = check.length("width", width)
        rows, _ = self._source_rows(sources, spacing=reach / _POINTS_IN_WIDTH)
        return Band(*self._ask(self._core(to).band, rows, reach, method=method, progress=progress))

    def disk_area(
        self,
        sources: Sources,
        radius: float,
        method: str | None = None,
        progress: ProgressFunction | bool | None = None,
        to: bool = False,
    ) -> float:
        """The area within a radius of the nearest source, as `band` finds it."""
        return self.band(sources, check.length("radius", radius), method, progress, to).area

    def area(
        self,
        faces: ArrayLike | None = None,
        vertices: ArrayLike | None = None,
        inside: Points | GeodesicPath | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> RegionArea | list[RegionArea]:
        """Area of a region, of each of several, or inside a closed curve; the length of its border, and its volume.

        Parameters
        ----------
        faces : array_like, shape (m,), optional
            Which faces: a mask, or for each face its region, numbered from 0, such as `voronoi(...).face_region`.
        vertices : array_like, shape (n,), optional
            The same by vertices; only faces whose three corners agree count.
        inside : GeodesicPath or points, optional
            A closed curve: its inside is the side without border of the surface, else the smaller one. Consecutive
            points share a face. A curve that crosses itself or does not separate two sides is refused.

        Returns
        -------
        RegionArea or list of RegionArea
            A list, in the order of the regions, where `faces` or `vertices` are numbers.
        """
        if [faces is None, vertices is None, inside is None].count(False) != 1:
            raise InvalidInput("Give one of faces, vertices and inside: what the area is of.")
        core = self._shared.core
        if inside is not None:
            found = self._ask(core.enclosed_area, self._curve_rows(inside), method=None, progress=progress)
            return RegionArea(*(float(column[0]) for column in found))
        name, given = ("faces", faces) if vertices is None else ("vertices", vertices)
        count, wanted = len(getattr(self, name)), f"for each of the {name} whether it is inside, or its region's number"
        label = check.column(check.numbers(name, given, wanted))
        if label.shape != (count,):
            raise InvalidInput(f"{name}: has shape {label.shape}, but there are {count} {name}; give {wanted}.")
        is_mask = label.dtype == bool
        label = np.where(label, 0, -1) if is_mask else check.integers(name, label, wanted)
        if vertices is not None:
            corners = label[self.faces]
            label = np.where((corners == corners[:, :1]).all(axis=1), corners[:, 0], -1)
        last = int(label.max(initial=-1))
        if last >= 2**31 - 1:
            raise InvalidInput(f"{name}: {last} is out of range; number regions from 0 on.")
        regions = 1 if is_mask else max(last + 1, 0)
        rows = np.maximum(label, -1).astype(np.int32)
        columns = self._ask(core.region_areas, rows, regions, method=None, progress=progress)
        areas = [RegionArea(*row) for row in zip(*(column.tolist() for column in columns), strict=True)]
        return areas[0] if is_mask else areas

    def cut(
        self,
        lines: GeodesicPath | Points | list[GeodesicPath | Points],
        progress: ProgressFunction | bool | None = None,
    ) -> CutMesh:
        """The mesh with its faces cut along lines over it, such as paths.

        The region of a face is its connected part after the cut, numbered from 0 in the order of the faces; `side` says
        which faces are beside a line.

        Parameters
        ----------
        lines : GeodesicPath or points, or a list of these
            Consecutive points of a line lie on a common face: the points of a path do. Lines may cross.
        """
        chosen = self._line_rows("lines", lines)
        return self._cut_mesh(self._shared.core.cut_along, *chosen, progress=progress)

    def cut_at_levels(
        self,
        field: ArrayLike,
        levels: ArrayLike,
        interpolation: str = "distance",
        progress: ProgressFunction | bool | None = None,
    ) -> CutMesh:
        """The mesh with its faces cut along isolines of a field.

        The region of a face is the number of different levels at or below its values: 0 below all of them; -1 where
        values are not finite.

        Parameters
        ----------
        field, levels, interpolation
            As for `isolines`.
        """
        chosen = self._levels(field, levels, interpolation)
        return self._cut_mesh(self._shared.core.cut_at_levels, *chosen, progress=progress)

    def polygon(
        self, points: Points, method: str | None = None, progress: ProgressFunction | bool | None = None
    ) -> GeodesicPolygon:
        """The polygon of exact shortest paths from each point to the next, and from the last one to the first.

        Neighbouring legs may begin together, as at a saddle; legs that cross or touch elsewhere are refused, as are
        legs that do not separate an inside from an outside, such as those around a handle.

        Parameters
        ----------
        points : k points, k >= 3
        """
        return self._polygon(self._shared.core.polygon, points, method=method, progress=progress)

    def convex_hull(
        self, points: Points, method: str | None = None, progress: ProgressFunction | bool | None = None
    ) -> GeodesicPolygon:
        """The shortest closed curve around points: the polygon of some with the others inside and no angle above pi.

        Parameters
        ----------
        points : k points, k >= 3
            In a part like a disk in which any two have a single shortest path: less than half-way round a limb, say. It
            is checked that the polygon does not cross itself, has no angle above pi, and has all points and neither
            hole nor handle inside; otherwise, or if the points lie on one line, they are refused.

        Returns
        -------
        GeodesicPolygon
            Its `corners` are positions in the list of points.

        Notes
        -----
        Gift wrapping: the next corner is the point whose path from the last one has the others on one side. Takes an
        exact field as far as the points for each corner, then as `polygon`. With values of faces, where paths refract,
        it is refused.
        """
        return self._polygon(self._shared.core.convex_hull, points, method=method, progress=progress)

    def _polygon(self, question: Any, points: Points, **how: Any) -> GeodesicPolygon:
        rows = self._rows("points", points)
        area, perimeter, corners, angles, curvature, rest, vertices, faces, *legs = self._ask(question, rows, **how)
        return GeodesicPolygon(area, perimeter, corners, angles, curvature, rest, vertices, faces, paths_of(legs))

    def _cut_mesh(self, question: Any, *arguments: Any, progress: ProgressFunction | bool | None) -> CutMesh:
        vertices, faces, added, input_faces, region, edges, side = self._ask(
            question, *arguments, method=None, progress=progress
        )
        return CutMesh(vertices, faces, surface_points(added), input_faces, region, edges, side)

    def set_distances(
        self,
        first: Sources,
        second: Sources,
        method: str | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> SetDistances:
        """How far two sets of points are from each other: nearest, mean and Hausdorff distance, by two fields.

        Parameters
        ----------
        first, second : points
            At least one each. Or an `EdgeCurve` or a `GeodesicPath`, or a list that contains some, which stand for
            points along them.
        """
        sets = self._source_rows(first, "first")[0], self._source_rows(second, "second")[0]
        return SetDistances(*self._ask(self._shared.core.set_distances, *sets, method=method, progress=progress))
