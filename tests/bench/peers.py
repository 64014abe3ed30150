"""VoroGeo and public packages on meshes, in one run: times, memory, errors."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

import numpy as np

import measure
import meshes
import methods
import plots
import questions
import summary
import tables

RESULTS = meshes.WORK / "results"
NAMES = ", ".join([*methods.METHODS, "our_NAME(OPTION=VALUE)"])


def options(parser: argparse.ArgumentParser) -> None:
    """Which meshes and methods, how long."""
    parser.add_argument("meshes", nargs="*", default=("igea", "casting"), metavar="MESH", help="default: igea casting")
    parser.add_argument("--sources", type=int, default=10, help="random source vertices (default 10)")
    parser.add_argument("--budget", type=float, default=20, help="processor seconds for a method's fields (default 20)")
    parser.add_argument("--limit", type=float, default=300, help="processor seconds that end a method (default 300)")
    parser.add_argument("--threads", type=int, default=2, help="threads of build and field (default 2)")
    parser.add_argument("--one-build", action="store_true", help="no build on one thread")
    parser.add_argument("--no-peers", action="store_true", help="VoroGeo alone")
    parser.add_argument("--methods", nargs="+", metavar="NAME", help=f"only these: {NAMES}")


def run(options: argparse.Namespace) -> dict[str, str]:
    """A section for each mesh, and the table of all that are kept."""
    limits = measure.Limits(options.budget, options.limit)
    chosen = names(options.methods, not options.no_peers)
    RESULTS.mkdir(parents=True, exist_ok=True)
    texts = {}
    for file in filter(None, map(meshes.find, options.meshes)):
        result = measure_mesh(file, options.sources, chosen, limits, options.threads, not options.one_build)
        (RESULTS / f"{file.stem}.json").write_text(json.dumps(result, indent=1))
        texts[file.stem] = tables.mesh_section(result)
        if options.write and not options.no_peers:
            plots.error_against_time(result, meshes.PICTURES / f"error_time_{file.stem}.png")
    kept = sorted((json.loads(file.read_text()) for file in RESULTS.glob("*.json")), key=lambda r: r["vertices"])
    costs = tables.table(tables.COSTS, map(tables.costs_row, kept))
    return texts | {"table": f"{costs}\nMeasured on {measure.machine()}.\n"}


def names(only: list[str] | None, peers: bool) -> list[str]:
    """The methods to run, in the order of the tables."""
    chosen = only or [
        name for name in methods.METHODS if (peers and not name.startswith("our_")) or name.startswith("vorogeo")
    ]
    for name in chosen:
        if name not in methods.METHODS:
            sys.exit(f"there is no method {name}; there are {NAMES}")
    return chosen


def measure_mesh(
    file: Path,
    source_count: int,
    chosen: list[str],
    limits: measure.Limits,
    threads: int,
    builds: bool = True,
    in_file: bool = False,
) -> dict[str, Any]:
    """All figures of one mesh. `builds`: also with one thread; `in_file`: the index is built in its file."""
    mesh = meshes.load(file)
    raw = meshes.write_raw(mesh, meshes.WORK / f"{file.stem}.raw")
    index_file = meshes.WORK / f"{file.stem}.vgi"
    sources = questions.sources_of(mesh, source_count)
    counts = {threads} | ({1} if builds else set())
    core = measure_core(raw, mesh, index_file, sources, sorted(counts), "build_in_file" if in_file else "build")

    near = questions.Neighbourhood(mesh, questions.patches_of(mesh, index_file))
    random = np.random.default_rng(1)
    starts = np.repeat(np.array(sources), 200)
    far_pairs = random.permutation(near.far_pairs(starts, questions.with_face(mesh, len(starts), random)))
    near_pairs = near.near_pairs(np.repeat(np.array(sources), 20), random)
    core |= query_core(raw, mesh, index_file, sources, near, threads)
    many = near.far_pairs(*(questions.with_face(mesh, 20_000, random) for _ in range(2)))

    task = measure.Task(raw, len(mesh[0]), sources, np.vstack([far_pairs, near_pairs]), many, index_file, threads)
    exact_limits = measure.Limits(float("inf"), 24 * 3600, 1)
    exact = measure.run("vorogeo_exact", task, exact_limits)
    if exact.fields is None or len(exact.fields) != len(sources):
        raise SystemExit(f"{file}: the exact solver failed: {exact.failure}")
    row_of = {source: row for row, source in enumerate(sources)}
    exact_pairs = np.array([exact.fields[row_of[s], t] for s, t in task.pairs.tolist()])

    found: dict[str, Any] = {}
    for name in chosen:
        print(f"  {methods.description(name).title} ...", flush=True)
        result = exact if name == "vorogeo_exact" else measure.run(name, task, limits)
        found[name] = summary.of_method(result, exact.fields, exact_pairs, len(far_pairs))
    if "vorogeo_index" in found:  # it was read from the file that the core wrote
        found["vorogeo_index"]["prepared"] = core["build"][str(threads)]["cpu"]["median"]
    return {
        "mesh": file.stem,
        "vertices": len(mesh[0]),
        "faces": len(mesh[1]),
        "machine": measure.machine(),
        "core": core,
        "methods": found,
    }


def measure_core(
    raw: Path, mesh: meshes.Mesh, index_file: Path, sources: list[int], thread_counts: list[int], build: str
) -> dict[str, Any]:
    """Times of the C++ core: exact solver, and build with each number of threads, by a task of core_bench."""
    n = len(mesh[0])
    print(f"{raw.stem}: {n:,} vertices, {len(mesh[1]):,} faces\n  core ...", flush=True)
    exact, exact_peak = measure.core("exact", raw, *sources)
    found: dict[str, Any] = {
        "exact": summary.of_line(exact["exact", n]),
        "exact_peak": exact_peak,
        "build": {},
    }
    for threads in thread_counts:
        lines, found["build_peak"] = measure.core(build, raw, threads, index_file)
        found["phases"] = phases_of(lines)
        found["build"][str(threads)] = summary.of_line(lines["build", threads])
        found["index_bytes"], found["file_bytes"] = lines["index_bytes", n].values[0], lines["file_bytes", n].values[0]
    return found


def phases_of(lines: measure.Lines) -> dict[str, dict[str, float]]:
    """Seconds of the phases of a build, and the most bytes in memory: resident, and without the pages of files."""
    found: dict[str, dict[str, float]] = {}
    for (name, detail), line in lines.items():
        if name.startswith("phase "):
            activity = name.removeprefix("phase ")
            resident, own = lines[f"memory {activity}", detail].values
            phase = found.setdefault(activity, dict.fromkeys(("cpu", "wall", "resident", "own"), 0.0))
            phase["cpu"] += line.cpu[0]
            phase["wall"] += line.values[0]
            phase["resident"], phase["own"] = max(phase["resident"], resident), max(phase["own"], own)
    return found


def query_core(
    raw: Path, mesh: meshes.Mesh, index_file: Path, sources: list[int], near: questions.Neighbourhood, threads: int
) -> dict[str, Any]:
    """Times of the C++ core: fields, and pairs with random sources."""
    random = np.random.default_rng(2)
    far = near.far_pairs(*(questions.with_face(mesh, 5000, random) for _ in range(2)))
    close = near.near_pairs(questions.with_face(mesh, 500, random), random)
    lines, peak = measure.core("fields", raw, index_file, threads, 3, *sources)
    times = {}
    for name, pairs in (("far", far), ("near", close)):
        file = raw.with_suffix(f".{name}")
        pairs.astype(np.int32).tofile(file)
        if len(pairs):
            times[name] = measure.core("pairs", raw, index_file, file, 1)[0]["pair", 1]
    return {
        "load": summary.of_line(lines["load", 1]),
        "field": {str(int(d)): summary.of_line(v) for (name, d), v in lines.items() if name == "field"},
        "far_pair": summary.of_line(times["far"]) if "far" in times else None,
        "near_pair": summary.of_line(times["near"]) if "near" in times else None,
        "query_peak": peak,
    }
