"""Exact fields on one thread: of a fresh solver, as a script pays that asks once, and of a kept one; beside VTP."""

from __future__ import annotations

import argparse
import json
import statistics
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import measure
import meshes
import questions
import tables

SOURCES = 4
#: Posts of a side of a grid that is made here: one round without VTP, which takes a minute there for each source.
MADE = {"elevation_grid": 1200}
HEADING = (
    "mesh | vertices | VTP (s) | fresh (s) | warm (s) | VTP / fresh | VTP / warm | windows an edge | bytes a vertex "
    "| differ"
)


def options(parser: argparse.ArgumentParser) -> None:
    """Which meshes, and where VTP is."""
    parser.add_argument("meshes", nargs="*", metavar="MESH", help=f"also {', '.join(MADE)}; default: all there are")
    parser.add_argument("--vtp", type=Path, metavar="FOLDER", help="sources of VTP as its authors publish them")
    parser.add_argument(
        "--rounds", type=int, default=3, help="runs of each program, in turn; the least time counts (3)"
    )


def run(options: argparse.Namespace) -> dict[str, str]:
    """Measure the meshes one by one."""
    if options.vtp:
        build = meshes.ROOT / "build" / "bench"
        for command in (f"-DVOROGEO_VTP_SOURCE={options.vtp.resolve()} {build}", f"--build {build} --target vtp_peer"):
            subprocess.run(["cmake", *command.split()], check=True, stdout=subprocess.DEVNULL)
    rows = []
    for name in options.meshes or [*sorted(map(str, meshes.SHARED.glob("*.ply"))), *MADE]:
        is_made = name in MADE
        file = Path(name) if is_made else meshes.find(name)
        if not file:
            continue
        mesh = meshes.elevation_grid(MADE[name]) if is_made else meshes.load(file)
        raw = meshes.write_raw(mesh, meshes.WORK / f"{file.stem}.raw")
        rounds, with_vtp = (1, False) if is_made else (options.rounds, bool(options.vtp))
        rows.append(row(file.stem, raw, len(mesh[0]), questions.sources_of(mesh, SOURCES), rounds, with_vtp))
        print(" | ".join(rows[-1]), flush=True)
    return {"exact fields": tables.table(HEADING, rows)}


def row(name: str, raw: Path, vertices: int, sources: list[int], rounds: int, with_vtp: bool) -> list[str]:
    """The row of a mesh: medians over the sources of the least times, and the largest difference."""
    ours, theirs = [], []
    for _ in range(rounds):
        ours.append(measure.program("fresh", raw, *sources))
        theirs.append(vtp(raw, sources, vertices) if with_vtp else None)
    fresh, warm, windows, size = (
        statistics.median(min(run[i][key] for run in ours) for i in range(len(sources)))
        for key in ("fresh", "warm", "windows", "bytes")
    )
    peer = difference = None
    if theirs[-1]:
        peer = statistics.median(map(min, zip(*(found[0] for found in theirs if found), strict=True)))
        task = measure.Task(raw, vertices, sources, np.empty((0, 2), np.int64))
        exact = measure.run("vorogeo_exact", task, measure.Limits(float("inf"), 3600.0, 1)).fields
        assert exact is not None
        compared = np.isfinite(exact) & (exact > 0)
        difference = np.max(np.abs(theirs[-1][1][compared] / exact[compared] - 1), initial=0.0)
    figures = [peer, fresh, warm, peer and peer / fresh, peer and peer / warm, windows]
    return [
        name,
        f"{vertices:,}",
        *map(tables.number, figures),
        f"{size / vertices:,.0f}",
        tables.number(difference, 1),
    ]


def vtp(raw: Path, sources: list[int], vertices: int) -> tuple[list[float], NDArray[np.float64]] | None:
    """Seconds and fields of VTP; none if it crashes or has no end."""
    with tempfile.TemporaryDirectory() as folder:
        fields = Path(folder) / "fields"
        seconds: list[float] = []
        command = [str(measure.PROGRAMS / "vtp_peer"), str(raw), str(fields), *map(str, sources)]
        status, _, _ = measure.stream(command, 600.0, lambda line: seconds.append(json.loads(line)["cpu"]))
        if status != 0:
            return None
        return seconds, np.fromfile(fields).reshape(len(sources), vertices)
