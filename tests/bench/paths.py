"""Refined and exact paths of random pairs against exact fields.

Pairs are grouped by source, 100 targets each, so that one exact field serves them all. A mean error above its goal, a
refined path shorter than the shortest or an exact one that is not shortest is named at the end, and the status is 1.
"""

from __future__ import annotations

import argparse

import numpy as np
from numpy.typing import NDArray

import measure
import meshes
import tables

CLEAN = ("spot", "casting", "homer", "fandisk", "gears", "rocker_arm", "mountain", "bunny", "nefertiti", "igea")
GOAL = 1e-5
GOALS = {"gears": 1e-4, "casting": 1e-4}
ROUNDING = 1e-9
TARGETS = 100
HEADING = (
    "refined: | mean error | 99 % below | largest | shortest | time | exact: error | certified | time | prepared "
    "| uncertified"
)


def options(parser: argparse.ArgumentParser) -> None:
    """Which and how many."""
    parser.add_argument("meshes", nargs="*", default=CLEAN, metavar="MESH", help="default: the clean test meshes")
    parser.add_argument("--pairs", type=int, default=10_000, help="pairs of each mesh (10000)")
    parser.add_argument("--threads", type=int, default=2, help="sources at a time (2)")
    parser.add_argument("--points", action="store_true", help="between points in faces instead of vertices")
    parser.add_argument("--landmarks", type=int, default=32, help="of prepared exact paths (32)")


def run(options: argparse.Namespace) -> dict[str, str]:
    """Measure the meshes, and name what misses its goal."""
    rows, faults = [], []
    for file in filter(None, map(meshes.find, options.meshes)):
        raw, index = (meshes.WORK / f"{file.stem}.paths.{kind}" for kind in ("raw", "vgi"))
        meshes.write_raw(meshes.load(file), raw)
        sources, targets = -(-options.pairs // TARGETS), min(options.pairs, TARGETS)
        many = (sources, targets, options.threads, int(options.points), options.landmarks)
        found = np.array(measure.program("paths", raw, index, *many))
        rows.append(row(file.stem, found[found[:, 0] > 0]))
        faults += faults_of(file.stem, found[found[:, 0] > 0])
        print(" | ".join(rows[-1]), flush=True)
    if faults:
        print(*faults, sep="\n")
        raise SystemExit(1)
    return {
        "paths between points in faces" if options.points else "paths between vertices": tables.table(HEADING, rows)
    }


def errors_of(found: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Relative errors of refined paths, and of exact ones by both ways, from the lines that core_bench prints."""
    exact = found[:, :1]
    return found[:, 1] / exact[:, 0] - 1, found[:, [2, 8]] / exact - 1


def faults_of(name: str, found: NDArray[np.float64]) -> list[str]:
    """What misses its goal."""
    refined, exact = errors_of(found)
    goal = GOALS.get(name, GOAL)
    claims = {
        f"mean error of refined paths {np.abs(refined).mean():.1e}, goal {goal:.0e}": np.abs(refined).mean() <= goal,
        f"a refined path is {-refined.min():.1e} shorter than the shortest": refined.min() >= -ROUNDING,
        f"an exact path is off by {np.abs(exact).max():.1e}": np.abs(exact).max() <= ROUNDING,
    }
    return [f"{name}: {fault}" for fault, holds in claims.items() if not holds]


def row(name: str, found: NDArray[np.float64]) -> list[str]:
    """The line of the table; times are median and mean."""
    refined, exact = errors_of(found)
    refined_ms, exact_ms, quick_ms, prepared_ms = (
        f"{np.median(times):.2g} ms ({times.mean():.2g})" for times in 1e3 * found[:, [4, 5, 7, 9]].T
    )
    print(f"{name}: without a certificate off by {np.abs(found[:, 6] / found[:, 0] - 1).max():.0e} at most", flush=True)
    return [
        name, f"{np.abs(refined).mean():.1e}", f"{np.quantile(refined, 0.99):.1e}", f"{refined.max():.1e}",
        f"{100 * np.mean(refined <= ROUNDING):.1f} %", refined_ms, f"{np.abs(exact).max():.0e}",
        f"{100 * found[:, 3].mean():.0f} %", exact_ms, prepared_ms, quick_ms,
    ]  # fmt: skip
