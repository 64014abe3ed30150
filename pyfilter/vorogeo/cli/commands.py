"""What each command computes on one mesh."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import InvalidInput
from ..mesh_check import check_mesh
from ..results import GeodesicPath
from .comparison import compare
from .job import Command, MeshTask, surface_area
from .outputs import Result, format_of


def field(task: MeshTask) -> Result:
    """Distance of every vertex from the nearest source."""
    values = task.surface.distance_field(
        task.points("from"), task.options.get("max_distance"), method=task.method, dtype=task.dtype
    )
    reached = values[np.isfinite(values)]
    text = f"{reached.size} of {values.size} vertices reached, the farthest at {reached.max(initial=0):.6g}"
    return Result("distance", {"distance": values}, task.shown_mesh, per_vertex="distance", text=text)


def distance(task: MeshTask) -> Result:
    """Distances of pairs; one source may have many targets, or one target many sources."""
    values = task.surface.distances(*_ends(task), progress=task.progress, method=task.method, dtype=task.dtype)
    text = "\n".join(f"{value:.12g}" for value in values.tolist())
    return Result("distance", {"distance": values}, task.shown_mesh, text=text)


def _ends(task: MeshTask) -> tuple[Any, Any]:
    """Both ends of pairs; one that is alone goes with each of the others."""
    ends: list[Any] = [task.points("from"), task.points("to")]
    return tuple(points[0] if len(points) == 1 else points for points in ends)


def path(task: MeshTask) -> Result:
    """Shortest paths of pairs: their points, one path after the other."""
    find = task.surface.exact_path if task.exact else task.surface.path
    found = find(*_ends(task), progress=task.progress)
    paths: list[GeodesicPath] = found if isinstance(found, list) else [found]
    begin = np.concatenate([[0], np.cumsum([len(one.points) for one in paths])])
    points = np.concatenate([one.points for one in paths]) / task.scale
    arrays: dict[str, NDArray[Any]] = {
        "points": points,
        "path": np.repeat(np.arange(len(paths)), np.diff(begin)),
        "length": np.array([one.length for one in paths]),
        "certified": np.array([one.certified for one in paths]),
        "face": np.concatenate([one.surface_points.faces for one in paths]),
        "barycentric": np.concatenate([one.surface_points.barycentric for one in paths]),
        "vertex": np.concatenate([one.vertices for one in paths]),
    }
    joined = np.flatnonzero(arrays["path"][1:] == arrays["path"][:-1])
    text = "\n".join(f"{one.length:.12g}" for one in paths)
    result = Result("points", arrays, task.shown_mesh, lines=(points, np.column_stack([joined, joined + 1])), text=text)
    if format_of(task.target) == ".csv":
        columns = [arrays["path"], points, arrays["face"], arrays["barycentric"]]
        result.arrays = {"points": np.column_stack(columns)}
        result.columns = ["path", "x", "y", "z", "face", "weight1", "weight2", "weight3"]
    return result


def matrix(task: MeshTask) -> Result:
    """Distances between all points, by default all vertices."""
    count = len(task.vertices)
    points = task.points("points") if task.options.get("points") else np.arange(count)
    others = task.points("to") if task.options.get("to") else None
    direct = format_of(task.target) == ".npy"
    values = task.surface.distance_matrix(
        points,
        others,
        entries=task.options.get("method") or "automatic",
        out=task.job.out if direct else None,
        progress=task.progress,
        method=task.method,
        dtype=task.dtype,
    )
    text = f"{values.shape[0]} x {values.shape[1]} distances, {values.dtype}, {values.nbytes / 1e6:.4g} MB"
    return Result("" if direct else "matrix", {"matrix": values}, task.shown_mesh, text=text)


def neighbours(task: MeshTask) -> Result:
    """All pairs within a radius, as a sparse matrix."""
    points = task.points("points") if task.options.get("points") else np.arange(len(task.vertices))
    found = task.surface.pairs_within(
        points, task.options["radius"], progress=task.progress, method=task.method, dtype=task.dtype
    )
    if not hasattr(found, "tocoo"):
        raise InvalidInput("Sparse matrices are written by scipy; run 'pip install scipy'.")
    text = f"{found.nnz} entries, {found.nnz / max(1, found.shape[0]):.4g} for each point"
    return Result("distance", {}, task.shown_mesh, sparse=found, text=text)


def voronoi(task: MeshTask) -> Result:
    """The nearest point of every vertex and face, and areas of the regions."""
    found = task.surface.voronoi(task.points("from"), method=task.method, progress=task.progress)
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
    return Result("vertex_region", arrays, task.shown_mesh, per_vertex="vertex_region", text=text)


def sample(task: MeshTask) -> Result:
    """Vertices spread over the surface."""
    seed, radius = task.options.get("seed") or 0, task.options.get("radius")
    if task.options.get("method") == "poisson":
        if radius is None:
            raise InvalidInput("--radius: is missing; Poisson-disk sampling needs the least distance of two samples.")
        ids = task.surface.sample_poisson_disk(radius, seed, method=task.method, progress=task.progress)
        covered = ""
    else:
        found = task.surface.sample_farthest(
            task.options.get("count"), radius or 0.0, seed=seed, method=task.method, progress=task.progress
        )
        ids, covered = found.vertices, f", every vertex within {found.covering_radius:.6g} of one"
    points = task.file_vertices[ids]
    arrays: dict[str, NDArray[Any]] = {"vertex": ids, "points": points}
    none = np.empty((0, 2), np.int32)
    return Result("vertex", arrays, task.shown_mesh, lines=(points, none), text=f"{len(ids)} samples{covered}")


def index(task: MeshTask) -> Result:
    """The index in a file, for --index of other commands."""
    s = task.index.statistics
    made = f"built in {s.seconds:.1f} s" if s.seconds else "was there"
    text = f"{s.form}, {s.bytes / 2**20:.1f} MiB, {made}"
    return Result("", {}, task.shown_mesh, text=text)


def info(task: MeshTask) -> Result:
    """What the mesh contains, and what its index would be tied to."""
    report = check_mesh(task.vertices, task.faces)
    size = np.ptp(task.vertices, axis=0) if len(task.vertices) else np.zeros(3)
    lines = [
        str(report),
        f"area {surface_area(task.vertices, task.faces):.6g}, size " + " x ".join(f"{s:.4g}" for s in size),
    ]
    if task.options.get("index"):
        lines.append(repr(task.index))
    return Result("", {}, task.shown_mesh, text="\n".join(lines))


COMMANDS: dict[str, Command] = {
    "field": field,
    "distance": distance,
    "path": path,
    "matrix": matrix,
    "neighbours": neighbours,
    "voronoi": voronoi,
    "sample": sample,
    "index": index,
    "compare": compare,
    "info": info,
}
