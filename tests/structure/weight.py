"""Prints how heavy checkouts are, side by side: lines, files, constants, pages, how deep a question goes, the last run.

Usage: python tests/structure/weight.py [CHECKOUT ...]

Without a checkout, this one. Counts what git tracks in the work tree; comments and blank lines count like others. Ways
and hops are counted in the list of calls of docs/architecture.md, whose names the tests of this folder check. Time and
passed tests of the last tests/run.sh are those in build/test-results, where there is one.
To compare with an earlier tree: `git worktree add /tmp/before COMMIT`, then give both folders.
"""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import count_results

SOURCES = (".h", ".cpp", ".py", ".pyi")
PRODUCT = ("core", "plugin", "pyfilter", "include")
CONSTANT = re.compile(r"\bconstexpr\s+(?:double|float|int|Index|std::\w+)\s+\w+\s*=\s*[-0-9.(1]")

#: An item of the list of calls: what is counted, and the functions, of which `>` says that one calls the next.
CALLS = re.compile(r"^- ((?:ways|hops) [^:]+): (.+?)\.$", re.MULTILINE | re.DOTALL)


def tracked(checkout: Path) -> list[Path]:
    """Tracked files that the work tree has."""
    names = subprocess.run(["git", "-C", checkout, "ls-files", "-z"], check=True, capture_output=True, text=True).stdout
    return [Path(name) for name in names.split("\0") if name and (checkout / name).is_file()]


def weight(checkout: Path) -> dict[str, int]:
    """The figures of a checkout by name."""
    files = tracked(checkout)
    text = {file: (checkout / file).read_text(errors="replace") for file in files if file.suffix in (*SOURCES, ".md")}
    lines = {file: len(content.splitlines()) for file, content in text.items()}
    product = [file for file in lines if file.parts[0] in PRODUCT and file.suffix in SOURCES]
    tests = [file for file in lines if file.parts[0] == "tests" and file.suffix in SOURCES]
    pages = [file for file in lines if file.suffix == ".md"]
    table = calls(text.get(Path("docs/architecture.md"), ""))
    return {
        "product lines (core, plugin, pyfilter, include)": sum(lines[file] for file in product),
        "product files": len(product),
        "test lines": sum(lines[file] for file in tests),
        "tracked files": len(files),
        "lines of .md": sum(lines[file] for file in pages),
        "numeric constants of the product": sum(len(CONSTANT.findall(text[file])) for file in product),
        **{name: len(functions) - name.startswith("hops") for name, functions in table.items()},
    }


def last_run(checkout: Path) -> dict[str, int]:
    """Seconds of the last tests/run.sh, set-up apart, and how many tests passed; empty where there was none."""
    results = checkout / "build" / "test-results"
    if not (results / "times.txt").is_file():
        return {}
    steps = {}
    for line in (results / "times.txt").read_text().splitlines():
        clock, user, system, name = line.split(" ", 3)
        steps[name] = float(clock), float(user) + float(system)
    set_up, _ = steps.pop("set-up", (0.0, 0.0))
    whole = {"run.sh, seconds": round(steps["whole run"][0] - set_up)} if "whole run" in steps else {}
    return {
        **whole,
        "run.sh, seconds of the processor": round(sum(processor for _, processor in steps.values())),
        "run.sh, passed tests": sum(result.outcome == "passed" for result in count_results.all_results(results)),
    }


def calls(page: str) -> dict[str, list[str]]:
    """The functions of each item of the list of calls."""
    return {name: re.findall(r"`([^`]+)`", functions) for name, functions in CALLS.findall(page)}


def main() -> None:
    """Print the table."""
    checkouts = [Path(name).resolve() for name in sys.argv[1:]] or [Path(__file__).resolve().parents[2]]
    columns = [weight(checkout) | last_run(checkout) for checkout in checkouts]
    print(f"{'':50}" + "".join(f"{checkout.name:>14}" for checkout in checkouts))
    for name in dict.fromkeys(name for column in columns for name in column):
        print(f"{name:50}" + "".join(f"{column[name]:>14,}" if name in column else f"{'-':>14}" for column in columns))


if __name__ == "__main__":
    main()
