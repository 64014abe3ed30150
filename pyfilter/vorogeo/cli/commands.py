"""What each command computes on one mesh."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import InvalidInput
from ..mesh_check import check_mesh
from ..points import SurfacePoints
from ..results import GeodesicPath
from . import directions
from .comparison import compare
from .job import Command, MeshTask, surface_area
from .outputs import Result, format_of
from .paths import lines_of
from .sources import values_in


def field(task: MeshTask) -> Result:
    """Distance of every vertex from the nearest source."""
    sources, to = task.sources()
    values = task.surface.distance_field(
        sources, task.options.get("max_distance"), to=to, method=task.method, dtype=task.dtype
    )
    reached = values[np.isfinite(values)]
    text = f"{reached.size} of {values.size} vertices reached, the farthest at {reached.max(initial=0):.6g}"
    summary = {"vertices": values.size, "reached": reached.size, "farthest": reached.max(initial=0)}
    return Result("distance", {"distance": values}, task.shown_mesh, per_vertex="distance", text=text, summary=summary)


def distance(task: MeshTask) -> Result:
    """Distances of pairs; one source may have many targets, or one target many sources."""
    values = task.surface.distances(*_ends(task), dtype=task.dtype, **task.how)
    text = "\n".join(f"{value:.12g}" for value in values.tolist())
    return Result("distance", {"distance": values}, task.shown_mesh, text=text, summary={"distance": values})


def _ends(task: MeshTask) -> tuple[Any, Any]:
    """Both ends of pairs; one that is alone goes with each of the others."""
    ends: list[Any] = [task.points("from"), task.points("to")]
    return tuple(points[0] if len(points) == 1 else points for points in ends)


def path(task: MeshTask) -> Result:
    """Shortest paths of pairs."""
    find = task.surface.exact_path if task.exact else task.surface.path
    found = find(*_ends(task), progress=task.progress)
    return lines_of(task, found if isinstance(found, list) else [found])


def matrix(task: MeshTask) -> Result:
    """Distances between all points, by default all vertices."""
    count = len(task.vertices)
    points = task.points("points") if task.options.get("points") else np.arange(count)
    others = task.points("to") if task.options.get("to") else None
    direct = format_of(task.target) == ".npy"
    values = task.surface.distance_matrix(
        points,
        others,
        entries=task.options.get("entries") or "automatic",
        out=task.job.out if direct else None,
        dtype=task.dtype,
        **task.how,
    )
    text = f"{values.shape[0]} x {values.shape[1]} distances, {values.dtype}, {values.nbytes / 1e6:.4g} MB"
    summary = {"shape": values.shape, "bytes": values.nbytes}
    return Result("" if direct else "matrix", {"matrix": values}, task.shown_mesh, text=text, summary=summary)


def neighbours(task: MeshTask) -> Result:
    """All pairs within a radius, as a sparse matrix."""
    points = task.points("points") if task.options.get("points") else np.arange(len(task.vertices))
    found = task.surface.pairs_within(points, task.options["radius"], dtype=task.dtype, **task.how)
    if not hasattr(found, "tocoo"):
        raise InvalidInput("Sparse matrices are written by scipy; run 'pip install scipy'.")
    text = f"{found.nnz} entries, {found.nnz / max(1, found.shape[0]):.4g} for each point"
    return Result("distance", {}, task.shown_mesh, sparse=found, text=text, summary={"entries": found.nnz})


def voronoi(task: MeshTask) -> Result:
    """The nearest point of every vertex and face, and areas of the regions."""
    sources, to = task.sources()
    found = task.surface.voronoi(sources, to=to, **task.how)
    arrays: dict[str, NDArray[Any]] = {
        "vertex_region": found.vertex_region,
        "face_region": found.face_region,
        "distance": found.distance.astype(task.dtype, copy=False),
        "area": found.area,
        "border_points": found.borders.points / task.scale,
        "border_edges": found.borders.edges,
        "border_regions": found.border_regions,
    }
    text = f"{len(found.area)} regions, areas {found.area.min():.4g} to {found.area.max():.4g}"
    summary = {"area": found.area}
    return Result("vertex_region", arrays, task.shown_mesh, per_vertex="vertex_region", text=text, summary=summary)


def sample(task: MeshTask) -> Result:
    """Vertices spread over the surface."""
    seed, radius = task.options.get("seed") or 0, task.options.get("radius")
    if task.options.get("method") == "poisson":
        if radius is None:
            raise InvalidInput("--radius: is missing; Poisson-disk sampling needs the least distance of two samples.")
        ids = task.surface.sample_poisson_disk(radius, seed, **task.how)
        radius, covered = None, ""
    else:
        found = task.surface.sample_farthest(task.options.get("count"), radius or 0.0, seed=seed, **task.how)
        ids, radius = found.vertices, found.covering_radius
        covered = f", every vertex within {radius:.6g} of one"
    points = task.file_vertices[ids]
    arrays: dict[str, NDArray[Any]] = {"vertex": ids, "points": points}
    none = np.empty((0, 2), np.int32)
    summary = {"vertex": ids, "covering_radius": radius}
    text = f"{len(ids)} samples{covered}"
    return Result("vertex", arrays, task.shown_mesh, lines=(points, none), text=text, summary=summary)


def through(task: MeshTask) -> Result:
    """The path through points."""
    return lines_of(task, [_path_through(task)])


def _path_through(task: MeshTask) -> GeodesicPath:
    return task.surface.path_through(
        task.points("points"),
        closed=bool(task.options.get("closed")),
        guides=bool(task.options.get("guides")),
        **task.how,
    )


def loop(task: MeshTask) -> Result:
    """The shortest loop through a point, or a closed curve pulled tight."""
    curve = task.points("curve") if task.options.get("curve") else None
    if task.options.get("at"):
        return lines_of(task, [task.surface.shortest_loop(task.points("at"), curve, **task.how)])
    if curve is None:
        raise InvalidInput("--at: is missing; name the point that the loop goes through, or a --curve to pull tight.")
    return lines_of(task, [task.surface.tighten(curve, **task.how)])


def girth(task: MeshTask) -> Result:
    """The lengths of section, tape and loop at a point; section and loop as paths."""
    found = task.surface.girth(task.points("at"), task.options.get("normal"), progress=task.progress)
    result = lines_of(task, [found.section, found.loop])
    result.arrays["tape"] = found.tape.points / task.scale
    return _of_measures(result, {"section": found.section.length, "tape": found.tape.length, "loop": found.loop.length})


def _of_measures(result: Result, values: dict[str, float]) -> Result:
    """The result, which tells these."""
    result.text, result.summary = "\n".join(f"{name} {value:.12g}" for name, value in values.items()), dict(values)
    return result


def area(task: MeshTask) -> Result:
    """The area near points or a curve, inside a curve or of each region, and the length of its border."""
    if task.options.get("regions"):
        return _areas_of_regions(task, task.options["regions"])
    if task.options.get("inside"):
        curve = task.surface.path_through(task.points("inside"), closed=True, **task.how)
        inside: Any = task.surface.area(inside=curve, progress=task.progress)
        return _table(task, {"area": inside.area, "border_length": inside.border_length})
    radius = task.options.get("radius")
    if radius is None:
        raise InvalidInput("--radius: is missing; give how far from --from or --curve, or name --inside or --regions.")
    if task.options.get("curve"):
        curve = task.surface.path_through(task.points("curve"), closed=bool(task.options.get("closed")), **task.how)
        found = task.surface.band(curve, radius, **task.how)
    else:
        sources, to = task.sources()
        found = task.surface.band(sources, radius, to=to, **task.how)
    return _table(task, {"area": found.area, "border_length": found.border_length})


def _areas_of_regions(task: MeshTask, file: str) -> Result:
    values = values_in("--regions", file)
    label = values.astype(np.int64) if np.array_equal(values, np.round(values)) else values
    name = "vertices" if len(label) == len(task.vertices) else "faces"
    found: Any = task.surface.area(**{name: label}, progress=task.progress)
    columns = ["area", "border_length", "volume"]
    rows = np.array([[one.area, one.border_length, one.volume] for one in found]).reshape(-1, 3)
    text = "\n".join(" ".join(f"{value:.12g}" for value in row) for row in rows.tolist())
    summary = {column: rows[:, k] for k, column in enumerate(columns)}
    return Result("measures", {"measures": rows}, task.shown_mesh, text=text, summary=summary, columns=columns)


def _table(task: MeshTask, measures: dict[str, float]) -> Result:
    """A row of measures."""
    row = np.array([list(measures.values())])
    return _of_measures(Result("measures", {"measures": row}, task.shown_mesh, columns=list(measures)), measures)


def sets(task: MeshTask) -> Result:
    """How far two sets of points are apart."""
    first, second = task.points("from"), task.points("to")
    found = task.surface.set_distances(first, second, **task.how)
    result = _table(task, {"nearest": found.nearest, "mean": found.mean, "hausdorff": found.hausdorff})
    result.arrays |= {"to_second": found.to_second, "to_first": found.to_first}
    return result


def polygon(task: MeshTask) -> Result:
    """The polygon of points, or their convex hull: its legs as paths, and its measures."""
    find = task.surface.convex_hull if task.options.get("hull") else task.surface.polygon
    found = find(task.points("points"), **task.how)
    result = lines_of(task, found.legs)
    result.arrays |= {
        "area": np.array([found.area]),
        "perimeter": np.array([found.perimeter]),
        "corners": found.corners,
        "angles": found.angles,
        "inside_vertices": found.vertices,
        "inside_faces": found.faces,
    }
    return _of_measures(result, {"area": found.area, "perimeter": found.perimeter})


def profile(task: MeshTask) -> Result:
    """What lies along the path through points, a row for each of its points."""
    found = task.surface.profile(_path_through(task), task.options.get("up") or (0.0, 0.0, 1.0))
    text = f"{len(found.length)} points, length {found.length[-1]:.6g}"
    table = {"profile": np.column_stack(found)}
    summary = {"points": len(found.length), "length": found.length[-1]}
    return Result("profile", table, task.shown_mesh, text=text, summary=summary, columns=list(found._fields))


def cut(task: MeshTask) -> Result:
    """The mesh cut along the path through points, or at distances from sources; all of it or a region."""
    line = "levels" if task.options.get("levels") else "points"
    if not task.options.get(line):
        raise InvalidInput("--points: is missing; name points to cut along the path through them, or give --levels.")
    for name in ("from", "to") if line == "points" else ("points", "closed", "guides"):
        if task.options.get(name):
            raise InvalidInput(f"--{name}: says nothing beside --{line}; leave out one of them.")
    if line == "levels":
        sources, to = task.sources()
        distances = task.surface.distance_field(sources, to=to, method=task.method)
        found = task.surface.cut_at_levels(distances, task.options["levels"], progress=task.progress)
    else:
        found = task.surface.cut(_path_through(task), progress=task.progress)
    count = int(found.region.max(initial=-1)) + 1
    vertices, faces, region = found.vertices, found.faces, found.region
    given = task.vertex_values if format_of(task.target) == ".ply" else {}
    values = _carried_over(given, found.points, task.faces)
    chosen = task.options.get("region")
    if chosen is not None:
        if chosen >= count:
            raise InvalidInput(f"--region {chosen}: is not there; the cut has regions 0 to {count - 1}.")
        vertices, faces, kept = found.part(chosen)
        values = {name: value[kept] for name, value in values.items()}
        region = region[region == chosen]
    areas = [surface_area(found.vertices, found.faces[found.region == k]) for k in range(count)]
    arrays: dict[str, NDArray[Any]] = {
        "region": region,
        "vertices": vertices / task.scale,
        "faces": faces,
        "edges": found.edges,
        "input_faces": found.input_faces,
        "side": found.side,
    }
    if chosen is not None:
        arrays = {name: arrays[name] for name in ("region", "vertices", "faces")}
    text = f"{count} regions, areas {' '.join(f'{one:.6g}' for one in areas)}"
    shown = arrays["vertices"], faces
    summary = {"area": areas}
    return Result("region", arrays, shown, per_face="region", vertex_values=values, text=text, summary=summary)


def _carried_over(
    values: dict[str, NDArray[Any]], points: SurfacePoints, faces: NDArray[Any]
) -> dict[str, NDArray[Any]]:
    """Values of vertices, then those at new points between them, in the types that they had; normals have length 1."""
    if not values:
        return {}
    table = np.column_stack(list(values.values())).astype(float)
    found = dict(zip(values, np.vstack([table, points.positions(table, faces)]).T, strict=True))
    normal = [found[name] for name in ("nx", "ny", "nz") if name in found]
    if len(normal) == 3:
        length = np.linalg.norm(normal, axis=0)
        for one in normal:
            np.divide(one, length, out=one, where=length > 0)
    whole = {name for name, value in values.items() if value.dtype.kind in "iu"}
    return {name: (np.rint(one) if name in whole else one).astype(values[name].dtype) for name, one in found.items()}


def index(task: MeshTask) -> Result:
    """The index in a file, for --index of other commands."""
    s = task.index.statistics
    made = f"built in {s.seconds:.1f} s" if s.seconds else "was there"
    text = f"{s.form}, {s.bytes / 2**20:.1f} MiB, {made}"
    return Result("", {}, task.shown_mesh, text=text, summary={"index": asdict(s)})


def info(task: MeshTask) -> Result:
    """What the mesh contains, and what its index would be tied to."""
    report = check_mesh(task.vertices, task.faces)
    size = np.ptp(task.vertices, axis=0) if len(task.vertices) else np.zeros(3)
    area = surface_area(task.vertices, task.faces)
    lines = [str(report), f"area {area:.6g}, size " + " x ".join(f"{s:.4g}" for s in size)]
    summary = {**asdict(report), "area": area, "size": size}
    if task.options.get("index"):
        lines.append(repr(task.index))
        summary["index"] = asdict(task.index.statistics)
    return Result("", {}, task.shown_mesh, text="\n".join(lines), summary=summary)


COMMANDS: dict[str, Command] = {
    "field": field,
    "distance": distance,
    "path": path,
    "matrix": matrix,
    "neighbours": neighbours,
    "voronoi": voronoi,
    "sample": sample,
    "through": through,
    "loop": loop,
    "girth": girth,
    "area": area,
    "sets": sets,
    "polygon": polygon,
    "profile": profile,
    "cut": cut,
    **directions.COMMANDS,
    "index": index,
    "compare": compare,
    "info": info,
}
