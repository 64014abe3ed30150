"""Refined and exact paths of random pairs against exact fields, as two tables.

Usage: tests/bench/paths.sh [--pairs N] [--points] [--landmarks K] [--write] [MESH...]; MESH is a file or the name of a
test mesh, by default all clean ones of the test meshes. Pairs are grouped by source, 100 targets each, so that one
exact field serves them all. Indexes are kept in build/bench-work. --write puts the table into docs/figures.md.

A mean error above its goal, a refined path shorter than the shortest or an exact one that is not shortest is named at
the end, and the status is 1.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import meshes
import pages

CLEAN = ("spot", "casting", "homer", "fandisk", "gears", "rocker_arm", "mountain", "bunny", "nefertiti", "igea")
GOAL = 1e-5
GOALS = {"gears": 1e-4, "casting": 1e-4}
ROUNDING = 1e-9
TARGETS = 100
HEADING = (
    "| refined: | mean error | 99 % below | largest | shortest | time | exact: error | certified | time | prepared "
    "| uncertified |\n"
    "|---|" + 10 * "--:|"
)


@dataclass(frozen=True)
class Result:
    """What was measured on one mesh: errors are relative, times in milliseconds of one thread."""

    name: str
    errors: NDArray[np.float64]
    exact_errors: NDArray[np.float64]
    certified: float
    refined_ms: NDArray[np.float64]
    exact_ms: NDArray[np.float64]
    prepared_ms: NDArray[np.float64]
    quick_errors: NDArray[np.float64]
    quick_ms: NDArray[np.float64]

    @classmethod
    def of(cls, name: str, rows: NDArray[np.float64]) -> Result:
        """From the lines that paths_bench prints."""
        rows = rows[rows[:, 0] > 0]
        exact, refined, found = rows[:, :3].T
        return cls(
            name,
            refined / exact - 1,
            np.concatenate([found, rows[:, 8]]) / np.tile(exact, 2) - 1,
            rows[:, 3].mean(),
            1e3 * rows[:, 4],
            1e3 * rows[:, 5],
            1e3 * rows[:, 9],
            rows[:, 6] / exact - 1,
            1e3 * rows[:, 7],
        )

    @property
    def faults(self) -> list[str]:
        """What misses its goal."""
        goal, found = GOALS.get(self.name, GOAL), []
        mean, least, exact = np.abs(self.errors).mean(), self.errors.min(), np.abs(self.exact_errors).max()
        if not mean <= goal:
            found.append(f"{self.name}: mean error of refined paths {mean:.1e}, goal {goal:.0e}")
        if not least >= -ROUNDING:
            found.append(f"{self.name}: a refined path is {-least:.1e} shorter than the shortest")
        if not exact <= ROUNDING:
            found.append(f"{self.name}: an exact path is off by {exact:.1e}")
        return found

    @property
    def row(self) -> str:
        """The line of the table."""
        share = np.mean(self.errors <= ROUNDING)
        return (
            f"| {self.name} | {np.abs(self.errors).mean():.1e} | {np.quantile(self.errors, 0.99):.1e} "
            f"| {self.errors.max():.1e} | {100 * share:.1f} % | {in_ms(self.refined_ms)} "
            f"| {np.abs(self.exact_errors).max():.0e} | {100 * self.certified:.0f} % | {in_ms(self.exact_ms)} "
            f"| {in_ms(self.prepared_ms)} | {in_ms(self.quick_ms)} |"
        )


def in_ms(times: NDArray[np.float64]) -> str:
    """Median and mean of times in milliseconds."""
    return f"{np.median(times):.2g} ms ({times.mean():.2g})"


def measured(name: str, pairs: int, threads: int, in_faces: bool, landmarks: int) -> Result | None:
    """Runs the program on one mesh; None if there is no such mesh."""
    file = meshes.find(name)
    if file is None:
        return None
    vertices, faces = meshes.load(file)
    meshes.WORK.mkdir(parents=True, exist_ok=True)
    raw, index = (meshes.WORK / f"{file.stem}.paths.{kind}" for kind in ("raw", "vgi"))
    with raw.open("wb") as out:
        np.array([len(vertices), len(faces)], np.int64).tofile(out)
        vertices.tofile(out)
        faces.tofile(out)
    program = meshes.ROOT / "build" / "bench" / "tests" / "bench" / "paths_bench"
    command = [program, raw, index, -(-pairs // TARGETS), min(pairs, TARGETS), threads, int(in_faces), landmarks]
    lines = subprocess.run(list(map(str, command)), check=True, stdout=subprocess.PIPE, text=True).stdout
    return Result.of(file.stem, np.array([json.loads(line.replace("inf", "Infinity")) for line in lines.splitlines()]))


def main() -> int:
    """Prints the table and what misses its goal."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("meshes", nargs="*", default=CLEAN, metavar="MESH")
    parser.add_argument("--pairs", type=int, default=10_000, help="pairs of each mesh (10000)")
    parser.add_argument("--threads", type=int, default=2, help="sources at a time (2)")
    parser.add_argument("--points", action="store_true", help="between points in faces instead of vertices")
    parser.add_argument("--landmarks", type=int, default=32, help="of prepared exact paths (32)")
    parser.add_argument("--write", action="store_true", help="put the table into docs/figures.md")
    options = parser.parse_args()
    results = []
    for name in options.meshes:
        result = measured(name, options.pairs, options.threads, options.points, options.landmarks)
        if result is not None:
            results.append(result)
            print(result.row, flush=True)
            print(f"{name}: without a certificate off by {np.abs(result.quick_errors).max():.0e} at most", flush=True)
    table = "\n".join([HEADING, *(result.row for result in results)])
    print(table, flush=True)
    if options.write:
        mark = "paths between points in faces" if options.points else "paths between vertices"
        pages.replace(pages.FIGURES, mark, f"{table}\n")
    faults = [fault for result in results for fault in result.faults]
    print(*faults, sep="\n")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
