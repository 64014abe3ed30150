"""The time of 1 to 1,000 fields, and of each task, by the automatic choice beside each fixed one.

Fields by the clock, tasks in seconds of a core. Measured meshes are kept in build/bench-work/choosing.
"""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Callable
from typing import Any

import numpy as np
import vorogeo

import meshes
import plots
import tables

RESULTS = meshes.WORK / "choosing"
FIELDS = 1000
AFTERWARDS = 20
HEADING = (
    "mesh | vertices | exact field | index: build + field | quick field | automatic builds after | costs at most, of "
    "the better one"
)
TASKS = "task | mesh | exact | index | automatic with an index | its ratio | automatic before an index | its ratio"
REPEATS = 3
LARGEST_FOR_TASKS = 50_000


def options(parser: argparse.ArgumentParser) -> None:
    """Which meshes."""
    parser.add_argument(
        "meshes",
        nargs="*",
        default=["bunny", "igea"],
        metavar="MESH[:SIZE]",
        help="sizes as for growth: mountain:loop3 is a terrain of 1.6 million vertices; default: bunny igea",
    )


def run(options: argparse.Namespace) -> dict[str, str]:
    """Measure the meshes of the command line; the table has all that are kept."""
    RESULTS.mkdir(parents=True, exist_ok=True)
    for name in options.meshes:
        mesh, _, size = name.partition(":")
        file = meshes.find(mesh)
        if file:
            file = meshes.resized(file, size or "1")
            (RESULTS / f"{file.stem}.json").write_text(json.dumps(measured(file.stem, meshes.load(file))))
    results = sorted((json.loads(kept.read_text()) for kept in RESULTS.glob("*.json")), key=lambda r: r["vertices"])
    if options.write and results:
        plots.choosing({f"{r['name']}, {r['vertices']:,} vertices": totals(r) for r in results})
    tasks = [line for result in results for line in result["tasks"]]
    return {"choosing": tables.table(HEADING, map(row, results)), "choosing_tasks": tables.table(TASKS, tasks)}


def measured(name: str, mesh: meshes.Mesh) -> dict[str, Any]:
    """Seconds of single fields by each choice; the automatic one until it has an index, and some fields more."""
    sources = np.random.default_rng(1).integers(0, len(mesh[0]), FIELDS).tolist()
    surface = vorogeo.Surface(*mesh)
    automatic, by_index = [], []
    for source in sources:
        start = time.perf_counter()
        surface.distance_field(source)
        automatic.append(time.perf_counter() - start)
        last = surface.last
        if last is not None and last.by == "index":
            by_index.append(last.seconds)
        if len(by_index) > AFTERWARDS:
            break
    quick = []
    for source in sources[:5]:
        surface.distance_field(source, method="quick")
        quick.append(surface.last.seconds if surface.last else 0.0)
    build = max(automatic) - by_index[0] if by_index else vorogeo.estimate(*mesh).build_seconds
    rented = automatic[: len(automatic) - len(by_index)]
    return {
        "name": name,
        "vertices": len(mesh[0]),
        "automatic": automatic,
        "rented": len(rented),
        "exact": float(np.mean(rented)),
        "build": build,
        "index": float(np.mean(by_index[1:])) if by_index else vorogeo.estimate(*mesh).field_seconds,
        "quick": float(np.mean(quick[1:])),
        "tasks": task_rows(name, mesh) if len(mesh[0]) <= LARGEST_FOR_TASKS else [],
    }


def questions(mesh: meshes.Mesh) -> dict[str, Callable[[Any, str | None], object]]:
    """Each task by its call in the documents, asked of a surface by a method."""
    vertices = mesh[0]
    some = np.random.default_rng(2).integers(0, len(vertices), 300)
    diagonal = float(np.linalg.norm(np.ptp(vertices, axis=0)))

    def within(surface: Any, method: str | None, share: float) -> object:
        return surface.pairs_within(np.arange(len(vertices)), share * diagonal, method=method)

    def near(surface: Any, method: str | None) -> None:
        for source in some:
            surface.distance_field(source, max_distance=0.02 * diagonal, method=method)

    return {
        "sample_farthest(1000)": lambda s, how: s.sample_farthest(1000, seed=1, method=how),
        "sample_farthest(30)": lambda s, how: s.sample_farthest(30, seed=1, method=how),
        "sample_poisson_disk(2 %)": lambda s, how: s.sample_poisson_disk(0.02 * diagonal, seed=1, method=how),
        "voronoi(100 sites)": lambda s, how: s.voronoi(some[:100], method=how),
        "voronoi(5 sites)": lambda s, how: s.voronoi(some[:5], method=how),
        "pairs_within(.5 %)": lambda s, how: within(s, how, 0.005),
        "pairs_within(2 %)": lambda s, how: within(s, how, 0.02),
        "300 fields within 2 %": near,
        "disk(10 %)": lambda s, how: s.disk(some[0], 0.1 * diagonal, method=how),
        "nearest(30 of 300)": lambda s, how: s.nearest(some[:30], some, method=how),
        "distance_matrix(100)": lambda s, how: s.distance_matrix(some[:100], method=how),
        "relax(100, 3 rounds)": lambda s, how: s.relax(some[:100], 3, method=how),
        "eccentricity(10)": lambda s, how: s.eccentricity(some[:10], method=how),
    }


def task_rows(name: str, mesh: meshes.Mesh) -> list[list[str]]:
    """Seconds of a core for each task; before an index, the better choice may be to build one."""
    indexed = vorogeo.Surface(*mesh)
    start = time.process_time()
    indexed.build_index()
    build = time.process_time() - start
    rows = []
    for task, ask in questions(mesh).items():

        def least(surface_of: Callable[[], Any], method: str | None, ask: Any = ask) -> float:
            def once() -> float:
                surface = surface_of()
                start = time.process_time()
                ask(surface, method)
                return time.process_time() - start

            return min(once() for _ in range(REPEATS))

        def warm() -> Any:
            surface = vorogeo.Surface(*mesh)
            surface.distance_field(0, method="exact", max_distance=0.0)
            return surface

        exact, index = least(lambda: indexed, "exact"), least(lambda: indexed, "index")
        after, before = least(lambda: indexed, None), least(warm, None)
        ratios = after / min(exact, index), before / min(exact, build + index)
        times = [tables.duration(value) for value in (exact, index, after, before)]
        rows.append([task, name, *times[:3], f"{ratios[0]:.2f}", times[3], f"{ratios[1]:.2f}"])
    return rows


def totals(result: dict[str, Any]) -> dict[str, np.ndarray]:
    """Seconds of 1 to FIELDS fields by each choice."""
    count = np.arange(1, FIELDS + 1)
    later = np.full(max(0, FIELDS - len(result["automatic"])), result["index"])
    return {
        "exact": count * result["exact"],
        "index": result["build"] + count * result["index"],
        "quick": count * result["quick"],
        "automatic": np.cumsum(np.concatenate([result["automatic"], later]))[:FIELDS],
    }


def worst_ratio(result: dict[str, Any]) -> float:
    """The most that the automatic choice costs, as a multiple of the better of exact and index."""
    lines = totals(result)
    return float((lines["automatic"] / np.minimum(lines["exact"], lines["index"])).max())


def row(result: dict[str, Any]) -> list[str]:
    """A line of the table."""
    exact, build, index, quick = (tables.duration(result[key]) for key in ("exact", "build", "index", "quick"))
    choice = [f"{result['rented']} fields", f"{worst_ratio(result):.2f} times"]
    return [result["name"], f"{result['vertices']:,}", exact, f"{build} + {index}", quick, *choice]
