"""Time and memory against the size of the mesh: one mesh decimated and subdivided after Loop.

The index of loop3 is built in its file. Sizes measured before are kept in build/bench-work/growth, so the sizes can be
measured one at a time.
"""

from __future__ import annotations

import argparse
import json
from typing import Any

import measure
import meshes
import peers
import plots
import tables

RESULTS = meshes.WORK / "growth"
SIZES = ("1/16", "1/4", "1", "loop1", "loop2")
PEERS = ("pygeodesic", "pp3d_heat", "pp3d_marching", "igl_heat", "cgal_heat", "meshlab_point")
HEADING = (
    "vertices | build (s) | µs each | peak (MiB) | bytes | file | exact (s) | field (ms) | ns each | far (µs) | p99 "
    "| near | mean (%) | p99"
)
LEAST = 0.5  # µs a vertex, of a phase that the table shows


def options(parser: argparse.ArgumentParser) -> None:
    """Which sizes, of what, how long."""
    parser.add_argument("sizes", nargs="*", default=SIZES, metavar="SIZE", help=f"default: {' '.join(SIZES)}; or loop3")
    parser.add_argument("--mesh", default="igea", help="mesh file or name (default igea)")
    parser.add_argument("--sources", type=int, default=2, help="random source vertices (default 2)")
    parser.add_argument("--limit", type=float, default=120, help="seconds of the processor for a peer (default 120)")
    parser.add_argument("--no-peers", action="store_true", help="VoroGeo alone; peers measured before are kept")


def run(options: argparse.Namespace) -> dict[str, str]:
    """Measure the sizes of the command line; tables and picture have all that are there."""
    file = meshes.find(options.mesh)
    if not file:
        return {}
    RESULTS.mkdir(parents=True, exist_ok=True)
    for size in options.sizes:
        chosen = ["vorogeo_index", "vorogeo_exact", *(() if options.no_peers else PEERS)]
        limits = measure.Limits(0.1 * options.limit, options.limit)
        mesh = meshes.resized(file, size)
        result = peers.measure_mesh(mesh, options.sources, chosen, limits, 2, builds=False, in_file=size == "loop3")
        kept = RESULTS / f"{file.stem}_{size.replace('/', '_')}.json"
        if options.no_peers and kept.is_file():
            result["methods"] = json.loads(kept.read_text())["methods"] | result["methods"]
        kept.write_text(json.dumps(result, indent=1))
    results = [json.loads(kept.read_text()) for kept in RESULTS.glob(f"{file.stem}_*.json")]
    results.sort(key=lambda result: result["vertices"])
    if options.write:
        plots.growth(results, meshes.PICTURES / "growth.png")
    about = f"Measured on {measure.machine()}.\n\n![Time and memory against size](figures/growth.png)\n\n"
    print(phase_table(results), flush=True)
    return {"growth": f"{tables.table(HEADING, map(row, results))}\n{about}"}


def row(result: dict[str, Any]) -> list[str]:
    """What the index of one size costs, an exact field, queries, and the errors of fields."""
    core, n, number = result["core"], result["vertices"], tables.number
    build = core["build"][max(core["build"])]["cpu"]["median"]
    field = core["field"]["1"]["cpu"]["median"]
    far, near = ((core[name] or {}).get("cpu") or {} for name in ("far_pair", "near_pair"))
    error = result["methods"]["vorogeo_index"].get("field_error")
    costs = (build, 1e6 * build / n, core["build_peak"] / 2**20, core["index_bytes"] / n, core["file_bytes"] / n)
    queries = (core["exact"]["cpu"]["median"], 1e3 * field, 1e9 * field / n)
    pairs = (
        number(1e6 * times[key] if times else None) for times, key in ((far, "median"), (far, "p99"), (near, "median"))
    )
    return [f"{n:,}", *map(number, costs + queries), *pairs, *(tables.percent(error, key) for key in ("mean", "p99"))]


def phase_table(results: list[dict[str, Any]]) -> str:
    """Processor time of each phase per vertex, and the most bytes per vertex that the process held in it."""
    known = [result for result in results if "phases" in result["core"]]
    phases = dict.fromkeys(
        phase
        for result in known
        for phase, spent in result["core"]["phases"].items()
        if 1e6 * spent["cpu"] / result["vertices"] > LEAST
    )
    rows = []
    for phase in phases:
        row = [phase]
        for result in known:
            found, n = result["core"]["phases"].get(phase), result["vertices"]
            row.append(f"{1e6 * found['cpu'] / n:.1f}, {found['own'] / n:,.0f}" if found else tables.DASH)
        rows.append(row)
    sizes = " | ".join(f"{result['vertices']:,}" for result in known)
    return tables.table(f"µs a vertex, bytes a vertex | {sizes}", rows)
