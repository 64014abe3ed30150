"""Commands for directions and what is built on them: log maps, means, clusters, splines, sides of curves, cut loci."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import InvalidInput
from ..points import SurfacePoints
from ..surface import GeodesicIndex
from .job import Command, MeshTask
from .outputs import Result
from .paths import lines_of
from .sources import values_in


def directions(task: MeshTask) -> Result:
    """Where all vertices lie as seen from a point: vectors in its frame; as quality their angle."""
    limit = task.options.get("max_distance")
    how: dict[str, Any] = {"max_distance": limit, "return_distance": True, "progress": task.progress}
    if isinstance(task.surface, GeodesicIndex) and not task.exact:
        how["method"] = "index"
    vector, distance = task.surface.log_map(task.points("at"), **how)
    reached = np.isfinite(distance)
    angle = np.where(reached, np.arctan2(vector[:, 1], vector[:, 0]) % (2 * np.pi), np.inf)
    arrays: dict[str, NDArray[Any]] = {"vector": vector, "distance": distance, "angle": angle}
    text = f"{reached.sum()} of {reached.size} vertices reached, the farthest at {distance[reached].max(initial=0):.6g}"
    summary = {"vertices": reached.size, "reached": reached.sum(), "farthest": distance[reached].max(initial=0)}
    result = Result("vector", arrays, task.shown_mesh, per_vertex="angle", text=text, summary=summary)
    result.columns = ["x", "y"]
    if limit:
        uv = np.where(reached[:, None], 0.5 + vector / (2 * limit), 0)
        result.vertex_values = {"texture_u": uv[:, 0].astype("f4"), "texture_v": uv[:, 1].astype("f4")}
    return result


def signed(task: MeshTask) -> Result:
    """Distance of every vertex from a closed curve or the border of a region, negative inside."""
    if task.options.get("region"):
        faces = values_in("--region", task.options["region"])
        curve: Any = np.asarray(faces != 0)
    else:
        if not task.options.get("curve"):
            raise InvalidInput("--curve: is missing; name points of a closed curve, or a --region.")
        curve = task.surface.path_through(task.points("curve"), closed=True, progress=task.progress)
    values = task.surface.signed_distance(curve, task.options.get("max_distance"), progress=task.progress)
    reached = values[np.isfinite(values)]
    inside, outside = -reached.min(initial=0), reached.max(initial=0)
    text = f"{reached.size} of {values.size} vertices, up to {inside:.6g} inside and {outside:.6g} outside"
    summary = {"vertices": values.size, "reached": reached.size, "inside": inside, "outside": outside}
    result = Result("distance", {"distance": values}, task.shown_mesh, per_vertex="distance", text=text)
    result.summary, result.no_value = summary, 0
    return result


def spline(task: MeshTask) -> Result:
    """The smooth curve through points, or near them."""
    find = task.surface.b_spline if task.options.get("near") else task.surface.spline
    closed = bool(task.options.get("closed"))
    return lines_of(task, [find(task.points("points"), closed=closed, progress=task.progress)])


def mean(task: MeshTask) -> Result:
    """The point in the middle of points."""
    find = task.surface.geometric_median if task.options.get("median") else task.surface.frechet_mean
    found = find(task.points("points"), progress=task.progress)
    arrays = _points(task, found)
    (at,) = arrays["points"].tolist()
    text = ",".join(f"{number:.12g}" for number in at)
    none = np.empty((0, 2), np.int32)
    lines = (arrays["points"], none)
    columns = ["x", "y", "z"]
    return Result("points", arrays, task.shown_mesh, lines=lines, text=text, summary={"point": at}, columns=columns)


def clusters(task: MeshTask) -> Result:
    """The number of the cluster of each vertex, or of each point."""
    points = task.points("points") if task.options.get("points") else None
    find = task.surface.k_medoids if task.options.get("medoids") else task.surface.k_means
    found = find(task.options["count"], points, seed=task.options.get("seed") or 0, **task.how)
    centres = _points(task, found.centres)
    arrays: dict[str, NDArray[Any]] = {
        "label": found.labels,
        "energy": found.energy,
        **{f"centre_{name}": centres[name] for name in centres},
    }
    size = np.bincount(found.labels[found.labels >= 0], minlength=len(found.centres))
    text = f"{len(size)} clusters of {size.min()} to {size.max()}, in {len(found.energy) - 1} rounds"
    summary = {"size": size, "energy": found.energy[-1], "centre": centres["points"]}
    per_vertex = "label" if points is None else ""
    return Result("label", arrays, task.shown_mesh, per_vertex=per_vertex, text=text, summary=summary)


def cut_locus(task: MeshTask) -> Result:
    """Where several shortest paths from points end, as lines."""
    least = np.radians(task.options.get("min_angle") or 0)
    how: dict[str, Any] = {"max_distance": task.options.get("max_distance"), "progress": task.progress}
    found = task.surface.cut_locus(task.points("from"), float(least), **how)
    arrays: dict[str, NDArray[Any]] = {
        "points": found.points / task.scale,
        "edges": found.edges,
        "distance": found.distance,
        "angle": found.angle,
        **{name: one for name, one in _points(task, found.surface_points).items() if name != "points"},
    }
    text = f"{len(found.edges)} segments, length {found.length:.6g}"
    summary = {"segments": len(found.edges), "length": found.length}
    lines = (arrays["points"], found.edges)
    result = Result("points", arrays, task.shown_mesh, lines=lines, text=text, summary=summary)
    result.vertex_values = {"quality": found.distance.astype("f4")}
    return result


def _points(task: MeshTask, found: SurfacePoints) -> dict[str, NDArray[Any]]:
    """Points of the surface, as the file has it."""
    at = found.positions(task.file_vertices, task.faces)
    return {"points": at, "face": found.faces, "barycentric": found.barycentric}


COMMANDS: dict[str, Command] = {
    "directions": directions,
    "signed": signed,
    "spline": spline,
    "mean": mean,
    "clusters": clusters,
    "cut-locus": cut_locus,
}
