"""Measures times, size and errors of the index on meshes and writes them as the table in docs/figures.md.

Usage: tests/bench/accuracy_table.sh [--sources N] [--dry-run] [MESH...]
  MESH: a mesh file, or the name of one in the folder of test meshes (VOROGEO_MESHES, by default ../shared/meshes beside
  the project). Without any, all meshes of the table. Rows of other meshes stay as they are. There is no pass or fail.
"""

from __future__ import annotations

import argparse
import os
import platform
import re
import statistics
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pymeshlab
import vorogeo

ROOT = Path(__file__).resolve().parents[2]
MESHES = Path(os.environ.get("VOROGEO_MESHES", ROOT.parent / "shared" / "meshes"))
DEFAULT = ("bunny", "rocker_arm", "fandisk", "mountain", "nefertiti", "igea", "casting", "gears")
FIGURES = ROOT / "docs" / "figures.md"
BEGIN, END = "<!-- table: tests/bench/accuracy_table.sh -->\n", "<!-- end of table -->\n"
HEADING = (
    "| mesh | vertices | build (s) | bytes per vertex | field (ms) | two points (µs) | two points p99 (µs) "
    "| mean error (%) | p99 error (%) | largest error (%) "
    "| two points, mean error (%) | exact field (s) |\n"
    "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n"
)
PAIRS = 2000


def main() -> None:
    """Measure the meshes named and refresh their rows."""
    parser = argparse.ArgumentParser(description="Measures the index and refreshes docs/figures.md.")
    parser.add_argument("meshes", nargs="*", default=DEFAULT, metavar="MESH")
    parser.add_argument("--sources", type=int, default=10, help="random source vertices of the errors (default 10)")
    parser.add_argument("--dry-run", action="store_true", help="print only")
    arguments = parser.parse_args()
    print(HEADING, end="", flush=True)
    rows = {}
    for name in arguments.meshes:
        file = Path(name) if Path(name).is_file() else MESHES / f"{name}.ply"
        if not file.is_file():
            print(f"{name}: left out, there is neither a file {name} nor {file}", file=sys.stderr)
            continue
        rows[file.stem] = measure(file, arguments.sources)
        print(rows[file.stem], end="", flush=True)
    if rows and not arguments.dry_run:
        refresh(rows)


def measure(file: Path, source_count: int) -> str:
    """One row of the table."""
    mesh_set = pymeshlab.MeshSet()
    mesh_set.load_new_mesh(str(file))
    vertices, faces = mesh_set.current_mesh().vertex_matrix(), mesh_set.current_mesh().face_matrix()
    index = vorogeo.GeodesicIndex(vertices, faces)
    random = np.random.default_rng(0)
    with_face = np.unique(faces)
    sources = random.choice(with_face, source_count).tolist()

    field_times, exact_times, errors, pair_errors = [], [], [], []
    for source in sources:
        index.distance_field(source)
        field_times.append(seconds(lambda s=source: index.distance_field(s)))
        start = time.perf_counter()
        exact = vorogeo.exact_distance_field(vertices, faces, source)
        exact_times.append(time.perf_counter() - start)
        found = index.distance_field(source)
        if not np.array_equal(np.isinf(found), np.isinf(exact)):
            sys.exit(f"{file}: index and exact solver disagree about which vertices {source} reaches")
        compared = np.flatnonzero((exact > 0) & np.isfinite(exact))
        errors.append(percent_off(found[compared], exact[compared]))
        targets = random.choice(compared, PAIRS // source_count)
        pair_errors.append(percent_off(index.distance(np.full(len(targets), source), targets), exact[targets]))
    error, pair_error = np.concatenate(errors), np.concatenate(pair_errors)

    pairs = random.choice(with_face, (4 * PAIRS, 2))
    pairs = pairs[np.isfinite(index.distance(pairs[:, 0], pairs[:, 1]))][:PAIRS].tolist()
    pair_times = [1e6 * seconds(lambda s=s, t=t: index.distance(s, t)) for s, t in pairs]
    s = index.statistics
    return (
        f"| {file.stem} | {s.vertices} | {s.seconds:.2f} | {s.bytes / s.vertices:.0f} "
        f"| {1e3 * statistics.median(field_times):.1f} | {statistics.median(pair_times):.0f} "
        f"| {np.quantile(pair_times, 0.99):.0f} | {error.mean():.4f} | {np.quantile(error, 0.99):.3f} "
        f"| {error.max():.2f} | {pair_error.mean():.4f} | {statistics.median(exact_times):.2f} |\n"
    )


def percent_off(found: np.ndarray, exact: np.ndarray) -> np.ndarray:
    """Relative errors in percent."""
    return 100 * np.abs(found - exact) / exact


def seconds(run: Callable[[], object]) -> float:
    """Wall-clock time of a call."""
    start = time.perf_counter()
    run()
    return time.perf_counter() - start


def refresh(rows: dict[str, str]) -> None:
    """Put the rows into the table of docs/figures.md; the machine is that of the last run."""
    text = FIGURES.read_text()
    before, rest = text.split(BEGIN)
    table, after = rest.split(END)
    kept = {line.split("|")[1].strip(): line for line in table.splitlines(keepends=True) if line.startswith("| ")}
    kept.pop("mesh", None)
    everything = {**kept, **rows}
    order = [*(name for name in DEFAULT if name in everything), *(name for name in everything if name not in DEFAULT)]
    lines = "".join(everything[name] for name in order)
    about = f"\nLast refreshed on {processor()}, {os.cpu_count()} cores, {platform.system()}.\n"
    FIGURES.write_text(before + BEGIN + HEADING + lines + about + END + after)


def processor() -> str:
    """Name of the processor, as far as the system tells."""
    try:
        found = re.search(r"^model name\s*:\s*(.+)$", Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    except OSError:
        found = None
    return found[1] if found else platform.machine()


if __name__ == "__main__":
    main()
