"""Measures the time of 1 to 1,000 fields by the automatic choice beside each fixed one, and draws it.

Usage: tests/bench/choosing.sh [--write] [MESH[:SIZE]...]; SIZE as for growth.sh (mountain:loop3 is a terrain of 1.6
million vertices). Measured meshes are kept in build/bench-work/choosing.
"""

from __future__ import annotations

import argparse
import json
import time
from typing import Any

import matplotlib
import numpy as np
import vorogeo

import meshes
import pages

matplotlib.use("Agg")
from matplotlib import pyplot

RESULTS = meshes.WORK / "choosing"
FIELDS = 1000
AFTERWARDS = 20
COLUMNS = "mesh | vertices | exact | index: build + field | quick | automatic builds after | at most, of the better one"


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


def row(result: dict[str, Any]) -> str:
    """A line of the table."""
    return (
        f"{result['name']} | {result['vertices']:,} | {result['exact']:.3g} s | {result['build']:.3g} + "
        f"{result['index']:.2g} s | {result['quick']:.2g} s | {result['rented']} fields | {worst_ratio(result):.2f}"
    )


def draw(results: list[dict[str, Any]]) -> None:
    """One plot for each mesh."""
    figure, plots = pyplot.subplots(1, len(results), figsize=(4.5 * len(results), 3.6), squeeze=False)
    styles = {"exact": "C0--", "index": "C1--", "quick": "C2:", "automatic": "k-"}
    for plot, result in zip(plots[0], results, strict=True):
        for name, seconds in totals(result).items():
            plot.loglog(np.arange(1, FIELDS + 1), seconds, styles[name], label=name)
        plot.set_title(f"{result['name']}, {result['vertices']:,} vertices", fontsize=10)
        plot.set_xlabel("fields")
        plot.grid(alpha=0.3)
    plots[0][0].set_ylabel("seconds in all")
    plots[0][0].legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(pages.PICTURES / "choosing.png", dpi=110)


def main() -> None:
    """Measure the meshes of the command line, then print all that are kept."""
    parser = argparse.ArgumentParser(prog="tests/bench/choosing.sh", description="Time of many fields by each choice.")
    parser.add_argument(
        "meshes", nargs="*", default=["bunny", "igea"], metavar="MESH[:SIZE]", help="default: bunny igea"
    )
    parser.add_argument("--write", action="store_true", help="also draw the picture of docs/figures.md")
    arguments = parser.parse_args()
    RESULTS.mkdir(parents=True, exist_ok=True)
    for name in arguments.meshes:
        mesh, _, size = name.partition(":")
        file = meshes.find(mesh)
        if file:
            file = meshes.resized(file, size or "1")
            result = measured(file.stem, meshes.load(file))
            (RESULTS / f"{file.stem}.json").write_text(json.dumps(result))
    results = [json.loads(kept.read_text()) for kept in RESULTS.glob("*.json")]
    results.sort(key=lambda result: result["vertices"])
    print(COLUMNS)
    print("\n".join(map(row, results)))
    if arguments.write and results:
        draw(results)


if __name__ == "__main__":
    main()
