"""Prints what the index costs, how fast it answers, and the errors of VoroGeo and of MeshLab's own geodesic filters.

Usage: python samples/table.py [MESH] [--sources N]
  Everything runs in PyMeshLab on the same mesh and sources. The reference is the exact filter, whose distances are
  those of pygeodesic (an independent exact solver) to rounding; the tests check that.
"""

from __future__ import annotations

import argparse
import multiprocessing
import statistics
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from pathlib import Path

import mesh_input
import numpy as np
import pymeshlab
import vorogeo

Run = Callable[[int], object]
Fields = tuple[np.ndarray, float]
HEADING = f"{'filter':<45}{'time':>10}{'mean error':>12}{'99 %':>10}{'largest':>10}"


def main() -> None:
    """The table of one mesh."""
    parser = argparse.ArgumentParser(description="Times, sizes and errors of geodesic filters on a mesh.")
    parser.add_argument("mesh", nargs="?", type=Path, default=mesh_input.BUNNY)
    parser.add_argument("--sources", type=int, default=3, help="random source vertices (default 3)")
    arguments = parser.parse_args()
    mesh_set = mesh_input.load(arguments.mesh)
    index_file = Path(__file__).parent / "out" / "table.vgi"
    index_file.parent.mkdir(exist_ok=True)
    built = mesh_set.compute_geodesic_index_by_vorogeo(index_file=str(index_file))
    print_table(arguments.mesh, mesh_set, built, index_file, arguments.sources)


def print_table(
    mesh_file: Path, mesh_set: pymeshlab.MeshSet, built: dict[str, float], index_file: Path, source_count: int = 3
) -> None:
    """Print all figures of the mesh in the MeshSet, whose index `built` describes and `index_file` holds."""
    mesh = mesh_set.current_mesh()
    vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
    size = f"{built['bytes'] / 2**20:.1f} MiB, {built['bytes'] / built['vertices']:.0f} bytes per vertex"
    print(f"\nindex: built in {built['seconds']:.2f} s; {size}")
    print_queries(vorogeo.GeodesicIndex.load(index_file, vertices, faces))

    sources = np.random.default_rng(0).choice(np.unique(faces), source_count).tolist()
    exact, exact_time = fields(mesh_set, sources, by_vertex(mesh_set, "exact_geodesic"))
    print(f"\nFrom {source_count} random vertices to all others: time of one call, relative errors")
    print(HEADING)
    print(f"{'VoroGeo, exact filter':<45}{exact_time:>8.3f} s{'reference':>12}")
    print_row("VoroGeo", exact, lambda: fields(mesh_set, sources, by_vertex(mesh_set, "vorogeo")))
    # The built-in filters stop at half the diagonal of the bounding box unless told otherwise.
    limit = pymeshlab.PureValue(1000 * mesh.bounding_box().diagonal())
    name = "compute_scalar_by_geodesic_distance_from_given_point_per_vertex"
    from_point = lambda s: mesh_set.apply_filter(name, startpoint=vertices[s], maxdistance=limit)  # noqa: E731
    print_row("MeshLab, fast marching from a point", exact, lambda: fields(mesh_set, sources, from_point))
    marching = by_selection(mesh_set, "geodesic", maxdistance=limit)
    print_row("MeshLab, fast marching from the selection", exact, lambda: fields(mesh_set, sources, marching))
    print_row("MeshLab, heat method from the selection", exact, lambda: heat_fields(mesh_file, sources))


def print_queries(index: vorogeo.GeodesicIndex) -> None:
    """Times of the queries themselves, without the filter around them, for pairs that a path joins."""
    pairs = np.random.default_rng(1).integers(0, index.statistics.vertices, size=(2000, 2))
    pairs = pairs[np.isfinite(index.distance(pairs[:, 0], pairs[:, 1]))][:500].tolist()
    field_times = [seconds(lambda s=s: index.distance_field(s)) for s, _ in pairs[:10]]
    pair_times = [seconds(lambda s=s, t=t: index.distance(s, t)) for s, t in pairs]
    if not pairs:
        print("no path joins any of 2000 random pairs of vertices")
        return
    print(f"field: {1e3 * statistics.median(field_times):.1f} ms (median of {len(field_times)} random sources)")
    print(f"two points: {1e6 * statistics.median(pair_times):.0f} microseconds (median of {len(pairs)} random pairs)")


def seconds(run: Callable[[], object]) -> float:
    """Wall-clock time of a call."""
    start = time.perf_counter()
    run()
    return time.perf_counter() - start


def by_vertex(mesh_set: pymeshlab.MeshSet, method: str) -> Run:
    """A filter of VoroGeo, from a vertex given by its number."""
    distance = "distance_from_given_point_per_vertex"
    return lambda source: mesh_set.apply_filter(f"compute_scalar_by_{method}_{distance}", vertex_index=source)


def by_selection(mesh_set: pymeshlab.MeshSet, method: str, **parameters: object) -> Run:
    """A built-in filter, from the selected vertex."""

    def run(source: int) -> None:
        mesh_set.compute_selection_by_condition_per_vertex(condselect=f"(vi == {source})")
        mesh_set.apply_filter(f"compute_scalar_by_{method}_distance_from_selection_per_vertex", **parameters)

    return run


def fields(mesh_set: pymeshlab.MeshSet, sources: list[int], run: Run) -> Fields:
    """Fields of all sources, shape (sources, vertices), and the median time of a call of the filter."""
    times, values = [], []
    for source in sources:
        times.append(seconds(lambda s=source: run(s)))
        values.append(mesh_set.current_mesh().vertex_scalar_array().copy())
    return np.array(values), statistics.median(times)


def heat_fields(mesh_file: Path, sources: list[int]) -> Fields:
    """The heat method in a process of its own, since it crashes on some meshes."""
    with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as pool:
        return pool.submit(heat_fields_here, mesh_file, sources).result()


def heat_fields_here(mesh_file: Path, sources: list[int]) -> Fields:
    """The heat method in this process."""
    mesh_set = mesh_input.load(mesh_file)
    return fields(mesh_set, sources, by_selection(mesh_set, "heat_geodesic"))


def print_row(name: str, exact: np.ndarray, run: Callable[[], Fields]) -> None:
    """One line of the table: errors over all vertices that can be reached, without the sources."""
    try:
        found, time_of_field = run()
    except pymeshlab.PyMeshLabException as error:
        print(f"{name:<45}  refused: {str(error).strip().splitlines()[-1]}", flush=True)
        return
    except BrokenProcessPool:
        print(f"{name:<45}  crashed on this mesh", flush=True)
        return
    compared = exact > 0
    nonsense = np.isnan(found[compared]).mean()
    if nonsense > 0:
        print(f"{name:<45}{time_of_field:>8.3f} s  NaN for {100 * nonsense:.0f} % of the vertices", flush=True)
        return
    error = 100 * np.abs(found[compared] - exact[compared]) / exact[compared]
    figures = zip((error.mean(), np.quantile(error, 0.99), error.max()), (10, 8, 8), strict=True)
    columns = "".join(f"{figure:>{width}.{4 if figure < 0.1 else 2}f} %" for figure, width in figures)
    print(f"{name:<45}{time_of_field:>8.3f} s{columns}", flush=True)


if __name__ == "__main__":
    main()
