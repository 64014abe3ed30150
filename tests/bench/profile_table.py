"""Tables of the functions that take the time, from the samples that profile.sh recorded.

Usage: python profile_table.py FOLDER [--write]; --write puts them into docs/benchmarks.md
"""

from __future__ import annotations

import re
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

import pages
import tables

TITLES = {
    "exact": "exact solver, whole mesh",
    "build": "build, two threads",
    "field": "field, one thread",
    "pairs": "two points, one thread",
}
SHOWN = 8
LEAST = 1.0  # percent


def main() -> None:
    """One table for each recording in the folder."""
    text = ""
    for name, title in TITLES.items():
        data = Path(sys.argv[1]) / f"{name}.data"
        if not data.is_file():
            continue
        shares = shares_of(data)
        rows = [[f"`{function}`", f"{share:.0f}"] for function, share in shares if share >= LEAST][:SHOWN]
        rows.append(["all others", f"{100 - sum(share for _, share in shares[: len(rows)]):.0f}"])
        text += "\n" + tables.table(f"{title}: function | share of samples (%)", rows)
    print(text)
    if "--write" in sys.argv[2:]:
        pages.replace(pages.BENCHMARKS, "profile", text + "\n")


def shares_of(data: Path) -> list[tuple[str, float]]:
    """Functions and their own shares of the samples in percent, greatest first."""
    command = ["perf", "report", "-i", str(data), "--stdio", "--no-children", "-g", "none", "--sort", "symbol", "-q"]
    report = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    shares: dict[str, float] = defaultdict(float)
    for line in report.splitlines():
        found = re.match(r"\s*([\d.]+)%\s+\[(.)\]\s+(.*)$", line)
        if found:
            shares["the system" if found[2] == "k" else short(found[3])] += float(found[1])
    return sorted(shares.items(), key=lambda item: -item[1])


def short(symbol: str) -> str:
    """A C++ function without parameters, template arguments and the parts of its name that all share."""
    symbol = symbol.replace("(anonymous namespace)::", "")
    lambdas = "::{lambda" in symbol
    while re.search(r"<[^<>]*>", symbol):
        symbol = re.sub(r"<[^<>]*>", "", symbol)
    symbol = re.sub(r"\(.*", "", symbol).replace("vorogeo::", "").strip().split(" ")[-1]
    return f"{symbol} (lambda)" if lambdas else symbol


if __name__ == "__main__":
    main()
