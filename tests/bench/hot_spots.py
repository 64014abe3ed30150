"""Which functions of the core take the time of the exact solver, the build, a field and two points.

Needs perf (Debian: linux-perf) and, in containers, the right to sample a clock; and a mesh that `peers` has measured.
"""

from __future__ import annotations

import argparse
import re
import subprocess
import sys
from collections import defaultdict

import measure
import meshes
import tables

SHOWN = 8
LEAST = 1.0  # percent


def options(parser: argparse.ArgumentParser) -> None:
    """Which mesh."""
    parser.add_argument("mesh", nargs="?", default="igea", metavar="MESH", help="measured by peers; default: igea")


def run(options: argparse.Namespace) -> dict[str, str]:
    """A table of functions with a column for each task."""
    raw, index, far, near = (meshes.WORK / f"{options.mesh}.{kind}" for kind in ("raw", "vgi", "far", "near"))
    for file in (raw, index, far, near):
        if not file.is_file():
            sys.exit(f"there is no {file}; run tests/bench/run.sh peers --no-peers {options.mesh} first")
    built = meshes.WORK / "profile.vgi"
    tasks = {
        "exact field": ("exact", raw, 0, 1000, 2000),
        "build": ("build", raw, 2, built),
        "index field": ("fields", raw, index, 1, 200, 0, 1000, 2000),
        "far pair": ("pairs", raw, index, far, 200),
        "near pair": ("pairs", raw, index, near, 30),
    }
    columns = [longest(shares_of(*task)) for task in tasks.values()]
    built.unlink()
    rows = map(list, zip(*columns, strict=True))
    return {"profile": f"\n{tables.table(' | '.join(tasks), rows).replace('--:', '---')}\n"}


def shares_of(*task: object) -> dict[str, float]:
    """Functions and their own shares of the samples of a run, in percent."""
    data = meshes.WORK / "profile.data"
    record = ["perf", "record", "-e", "cpu-clock", "-F", "499", "-q", "-o", data, "--", measure.CORE_BENCH, *task]
    report = ["perf", "report", "-i", data, "--stdio", "--no-children", "-g", "none", "-F", "overhead,sym", "-q"]
    subprocess.run(list(map(str, record)), check=True, stdout=subprocess.DEVNULL)
    lines = subprocess.run(list(map(str, report)), check=True, capture_output=True, text=True).stdout.splitlines()
    shares: dict[str, float] = defaultdict(float)
    for line in lines:
        found = re.match(r"\s*([\d.]+)%\s+\[(.)\]\s+(.*\S)", line)
        if found:
            shares["the system" if found[2] == "k" else short(found[3])] += float(found[1])
    return shares


def longest(shares: dict[str, float]) -> list[str]:
    """The largest shares and the rest; all columns have as many rows."""
    ordered = sorted(((share, name) for name, share in shares.items() if share >= LEAST), reverse=True)[:SHOWN]
    shown = [(name if " " in name and "(" not in name else f"`{name}`", share) for share, name in ordered]
    shown.append(("all others", 100 - sum(share for share, _ in ordered)))
    return [f"{name} {share:.0f} %" for name, share in shown] + [""] * (SHOWN + 1 - len(shown))


def short(symbol: str) -> str:
    """The name of a C++ function alone, without namespaces, classes, parameters and template arguments."""
    symbol = symbol.replace("(anonymous namespace)::", "")
    lambdas = "::{lambda" in symbol
    while re.search(r"<[^<>]*>", symbol):
        symbol = re.sub(r"<[^<>]*>", "", symbol)
    symbol = re.sub(r"\(.*", "", symbol).strip().split(" ")[-1].rpartition("::")[2]
    return f"{symbol} (lambda)" if lambdas else symbol
