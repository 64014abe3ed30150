"""Tables of the source files and functions that take the time, from the samples that profile.sh recorded.

Usage: python profile_table.py FOLDER [--write]; --write puts that of the functions into docs/figures.md
"""

from __future__ import annotations

import re
import subprocess
import sys
from collections import Counter, defaultdict
from pathlib import Path

import pages
import tables

TITLES = {"exact": "exact field", "build": "build", "field": "index field", "far": "far pair", "near": "near pair"}
SHOWN = 8
LEAST = 1.0  # percent
CORE = "/core/"
TESTS = "/tests/bench/"


def main() -> None:
    """A table of files and one of functions, with a column for each recording in the folder."""
    recordings = {title: Path(sys.argv[1]) / f"{name}.data" for name, title in TITLES.items()}
    recordings = {title: data for title, data in recordings.items() if data.is_file()}
    texts = []
    for shares in (files_of, functions_of):
        columns = [
            [f"{place} {share:.0f} %" if place else "" for place, share in longest(shares(data))]
            for data in recordings.values()
        ]
        texts.append(tables.table(" | ".join(recordings), list(map(list, zip(*columns, strict=True)))))
    print(*texts, sep="\n")
    if "--write" in sys.argv[2:]:
        pages.replace(pages.FIGURES, "profile", f"\n{texts[1]}\n")


def longest(shares: dict[str, float]) -> list[tuple[str, float]]:
    """The largest shares and the rest; all tables have as many rows."""
    ordered = sorted(((share, place) for place, share in shares.items() if share >= LEAST), reverse=True)[:SHOWN]
    shown = [(place if " " in place and "(" not in place else f"`{place}`", share) for share, place in ordered]
    shown.append(("all others", 100 - sum(share for share, _ in ordered)))
    return shown + [("", 0.0)] * (SHOWN + 1 - len(shown))


def files_of(data: Path) -> dict[str, float]:
    """Source files of the core, with headers put into their callers, and their shares of the samples in percent."""
    samples = Counter[tuple[str, str]]()
    for line in perf("script", data, "-F", "ip,dso"):
        found = re.match(r"\s*([0-9a-f]+)\s+\((.*)\)", line)
        if found:
            samples[found[1], found[2]] += 1
    program = next((dso for _, dso in samples if dso.endswith("core_bench")), None)
    addresses = [address for address, dso in samples if dso == program]
    places = {}
    if program:
        command = ["addr2line", "-e", program]
        answer = subprocess.run(command, input="\n".join(addresses), check=True, capture_output=True, text=True).stdout
        places = dict(zip(addresses, answer.splitlines(), strict=True))
    shares: dict[str, float] = defaultdict(float)
    for (address, dso), count in samples.items():
        shares[file_name(places.get(address, ""), dso, program)] += 100 * count / samples.total()
    return shares


def file_name(place: str, dso: str, program: str | None) -> str:
    """`exact/envelope.cpp` for a line of the core, otherwise the library or the system."""
    if dso != program:
        return re.sub(r"\.so.*", "", Path(dso).name) if ".so" in dso else "the system"
    file = place.rsplit(":", 1)[0]
    if TESTS in file:
        return "the benchmark"
    return file.rsplit(CORE, 1)[1] if CORE in file else "C++ standard library"


def functions_of(data: Path) -> dict[str, float]:
    """Functions and their own shares of the samples in percent."""
    shares: dict[str, float] = defaultdict(float)
    for line in perf("report", data, "--stdio", "--no-children", "-g", "none", "-F", "overhead,sym", "-q"):
        found = re.match(r"\s*([\d.]+)%\s+\[(.)\]\s+(.*\S)", line)
        if found:
            shares["the system" if found[2] == "k" else short(found[3])] += float(found[1])
    return shares


def perf(task: str, data: Path, *options: str) -> list[str]:
    """The lines that perf prints about a recording."""
    command = ["perf", task, "-i", str(data), *options]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()


def short(symbol: str) -> str:
    """The name of a C++ function alone, without namespaces, classes, parameters and template arguments."""
    symbol = symbol.replace("(anonymous namespace)::", "")
    lambdas = "::{lambda" in symbol
    while re.search(r"<[^<>]*>", symbol):
        symbol = re.sub(r"<[^<>]*>", "", symbol)
    symbol = re.sub(r"\(.*", "", symbol).strip().split(" ")[-1].rpartition("::")[2]
    return f"{symbol} (lambda)" if lambdas else symbol


if __name__ == "__main__":
    main()
