"""Counts the results of a test run: JUnit files and the list of checks in a folder, as tests/run.sh leaves them.

Prints what failed and what was skipped, and at last the line "N passed, N failed". Exit status 1 if anything failed.
"""

from __future__ import annotations

import sys
import xml.etree.ElementTree as ElementTree
from collections import Counter
from pathlib import Path
from typing import NamedTuple

PROJECT = Path(__file__).resolve().parents[1]


class Result(NamedTuple):
    """One test: where it ran, its name, whether it passed, failed or was skipped, and why."""

    suite: str
    name: str
    outcome: str
    reason: str


def in_one_line(text: str | None) -> str:
    """Return a message of several lines as one; files are named from the project on."""
    return " ".join((text or "").replace(f"{PROJECT}/", "").split())


def junit_results(file: Path) -> list[Result]:
    """Read the results of one JUnit file of pytest or GoogleTest."""
    results = []
    for case in ElementTree.parse(file).iter("testcase"):
        name, group = case.get("name", ""), case.get("classname", "")
        if group and group != name:
            name = f"{group}::{name}"
        broken = case.find("failure")
        if broken is None:
            broken = case.find("error")
        skipped = case.find("skipped")
        if broken is not None or case.get("status") == "fail":
            reason = in_one_line(broken.get("message") if broken is not None else "")
            results.append(Result(file.stem, name, "failed", reason))
        elif skipped is not None or case.get("status") in ("disabled", "notrun"):
            reason = in_one_line(skipped.get("message") or skipped.text) if skipped is not None else "disabled"
            results.append(Result(file.stem, name, "skipped", reason))
        else:
            results.append(Result(file.stem, name, "passed", ""))
    return results


def check_results(file: Path) -> list[Result]:
    """Read the list of checks."""
    outcomes = {"pass": "passed", "fail": "failed", "skip": "skipped"}
    lines = (line.partition(" ") for line in file.read_text().splitlines())
    return [Result("checks", name, outcomes[word], "") for word, _, name in lines]


def all_results(folder: Path) -> list[Result]:
    """Read everything in a folder; a file that cannot be read is a failure of its own."""
    results = check_results(folder / "checks.txt")
    for file in sorted(folder.glob("*.xml")):
        try:
            found = junit_results(file)
        except ElementTree.ParseError as error:
            found = [Result(file.stem, "results", "failed", str(error))]
        results += found or [Result(file.stem, "results", "failed", "no test ran")]
    return results


def print_times(file: Path) -> None:
    """Print the time of each step: a line has seconds by the clock, of the user, of the system, and the name."""
    lines = file.read_text().splitlines() if file.exists() else []
    steps = []
    for line in lines:
        clock, user, system, name = line.split(" ", 3)
        steps.append((name, float(clock), float(user) + float(system)))
    print("\nSeconds of the processor, by the clock (steps overlap):")
    for name, clock, processor in sorted(steps, key=lambda step: -step[2]):
        if processor >= 1:
            print(f"  {processor:6.0f} {clock:6.0f}  {name}")
    print(f"  {sum(step[2] for step in steps):6.0f}         in all")


def main() -> int:
    """Print the summary of the folder named on the command line."""
    folder = Path(sys.argv[1])
    results = all_results(folder)
    print_times(folder / "times.txt")
    for outcome in ("skipped", "failed"):
        chosen = [result for result in results if result.outcome == outcome]
        if chosen:
            print(f"\n{outcome.capitalize()}:")
        for result in chosen:
            print(f"  {result.suite}: {result.name}" + (f" - {result.reason[:300]}" if result.reason else ""))
    print("\nPassed, failed, skipped:")
    for suite in dict.fromkeys(result.suite for result in results):
        count = Counter(result.outcome for result in results if result.suite == suite)
        print(f"  {suite}: {count['passed']}, {count['failed']}, {count['skipped']}")
    total = Counter(result.outcome for result in results)
    print(f"\n{total['passed']} passed, {total['failed']} failed")
    return 1 if total["failed"] else 0


if __name__ == "__main__":
    sys.exit(main())
