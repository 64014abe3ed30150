"""Measures time and memory against the size of the mesh: one mesh decimated and subdivided after Loop.

Usage: tests/bench/growth.sh [OPTIONS] [SIZE...]; SIZE is 1, 1/4, 1/16, loop1, loop2 or loop3.
The index of loop3 is built in its file. Sizes measured before are kept
in build/bench-work/growth, so the sizes can be measured one at a time.
"""

from __future__ import annotations

import argparse
import json
from typing import Any

import bench
import measure
import meshes
import pages
import tables

RESULTS = meshes.WORK / "growth"
SIZES = ("1/16", "1/4", "1", "loop1", "loop2")
PEERS = ("pygeodesic", "pp3d_heat", "pp3d_marching", "igl_heat", "cgal_heat", "meshlab_point")
HEADING = (
    "vertices | build (s) | µs each | peak (MiB) | bytes | file | exact (s) | field (ms) | ns each | far (µs) | p99 "
    "| near | mean (%) | p99"
)
LEAST = 0.5  # µs a vertex, of a phase that the table shows


def main() -> None:
    """Measure the sizes of the command line, then print and draw all that are there."""
    parser = argparse.ArgumentParser(prog="tests/bench/growth.sh", description="Time and memory against mesh size.")
    parser.add_argument("sizes", nargs="*", default=SIZES, metavar="SIZE", help=f"default: {' '.join(SIZES)}")
    parser.add_argument("--mesh", default="igea", help="mesh file or name (default igea)")
    parser.add_argument("--sources", type=int, default=2, help="random source vertices (default 2)")
    parser.add_argument(
        "--limit", type=float, default=120, help="seconds of processor time after which a peer is ended (default 120)"
    )
    parser.add_argument("--no-peers", action="store_true", help="VoroGeo alone; peers measured before are kept")
    parser.add_argument("--write", action="store_true", help="also refresh docs/figures.md and its picture")
    arguments = parser.parse_args()
    file = meshes.find(arguments.mesh)
    if not file:
        return
    RESULTS.mkdir(parents=True, exist_ok=True)
    for size in arguments.sizes:
        chosen = ["vorogeo_index", "vorogeo_exact", *(() if arguments.no_peers else PEERS)]
        limits = measure.Limits(0.1 * arguments.limit, arguments.limit)
        mesh = meshes.resized(file, size)
        result = bench.measure_mesh(mesh, arguments.sources, chosen, limits, 2, builds=False, in_file=size == "loop3")
        kept = RESULTS / f"{file.stem}_{size.replace('/', '_')}.json"
        if arguments.no_peers and kept.is_file():
            result["methods"] = json.loads(kept.read_text())["methods"] | result["methods"]
        kept.write_text(json.dumps(result, indent=1))
    results = [json.loads(kept.read_text()) for kept in RESULTS.glob(f"{file.stem}_*.json")]
    results.sort(key=lambda result: result["vertices"])
    whole = tables.table(HEADING, [build_row(result) + query_row(result) for result in results])
    text = f"{whole}\n{phase_table(results)}"
    print(text)
    if arguments.write:
        import plots

        picture = pages.PICTURES / "growth.png"
        plots.growth(results, picture)
        about = f"\nMeasured on {pages.machine()}.\n\n![Time and memory against size](figures/growth.png)\n\n"
        pages.replace(pages.FIGURES, "growth", text + about)


def build_row(result: dict[str, Any]) -> list[str]:
    """What the index of one size costs, and an exact field."""
    core, n = result["core"], result["vertices"]
    build = core["build"][max(core["build"])]["cpu"]["median"]
    return [
        f"{n:,}",
        tables.number(build),
        tables.number(1e6 * build / n),
        tables.number(core["build_peak"] / 2**20),
        tables.number(core["index_bytes"] / n),
        tables.number(core["file_bytes"] / n),
        tables.number(core["exact"]["cpu"]["median"]),
    ]


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


def query_row(result: dict[str, Any]) -> list[str]:
    """What queries of one size take, and the errors of fields."""
    core, n = result["core"], result["vertices"]
    field = core["field"]["1"]["cpu"]["median"]
    far, near = ((core[name] or {}).get("cpu") for name in ("far_pair", "near_pair"))
    error = result["methods"]["vorogeo_index"].get("field_error")
    return [
        tables.number(1e3 * field),
        tables.number(1e9 * field / n),
        *(tables.number(1e6 * far[key]) if far else tables.DASH for key in ("median", "p99")),
        tables.number(1e6 * near["median"]) if near else tables.DASH,
        tables.percent(error, "mean"),
        tables.percent(error, "p99"),
    ]


if __name__ == "__main__":
    main()
