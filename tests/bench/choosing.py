"""The time of 1 to 1,000 fields by the automatic choice beside each fixed one, by the clock.

Measured meshes are kept in build/bench-work/choosing.
"""

from __future__ import annotations

import argparse
import json
import time
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
    return {"choosing": tables.table(HEADING, map(row, results))}


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
    }


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
