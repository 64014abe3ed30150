"""Puts measured tables into the page of figures, between their marks."""

from __future__ import annotations

import os
import platform
import re
from pathlib import Path
from typing import Any

import meshes
import tables

FIGURES = meshes.ROOT / "docs" / "figures.md"
PICTURES = meshes.ROOT / "docs" / "figures"
COSTS_HEADING = (
    "mesh | vertices | build (s) | bytes per vertex | file | field (ms) | far pair (µs) | p99 (µs) | near pair (µs) "
    "| exact field (s)"
)


def replace(file: Path, mark: str, text: str) -> None:
    """Replace what stands between `<!-- mark -->` and `<!-- end of mark -->`; ends the run if the marks are missing."""
    page = file.read_text()
    pattern = rf"(<!-- {re.escape(mark)} -->\n).*?(<!-- end of {re.escape(mark)} -->)"
    if not re.search(pattern, page, re.DOTALL):
        raise SystemExit(f"{file} has no marks for '{mark}'")
    file.write_text(re.sub(pattern, lambda found: found[1] + text + found[2], page, flags=re.DOTALL))


def has_marks(file: Path, mark: str) -> bool:
    """Whether a page has a place for this text."""
    return f"<!-- {mark} -->" in file.read_text()


def mesh_section(result: dict[str, Any]) -> str:
    """What docs/figures.md says about one mesh beside other packages."""
    name = result["mesh"]
    return (
        f"\n{result['vertices']:,} vertices, {result['faces']:,} faces; {result['machine']}.\n"
        f"Packages: {tables.versions(result['methods'])}.\n\n"
        f"{tables.details(result)}\n{tables.fields(result)}\n{tables.pairs(result)}\n"
        f"![Error against time on {name}](figures/error_time_{name}.png)\n\n"
    )


def costs_row(result: dict[str, Any]) -> list[str]:
    """The row of a mesh in the table of docs/figures.md."""
    core, n = result["core"], result["vertices"]
    build, far, near = core["build"], core["far_pair"], core["near_pair"]
    return [
        result["mesh"],
        str(n),
        tables.number(build[min(build)]["cpu"]["median"]),
        f"{core['index_bytes'] / n:.0f}",
        f"{core['file_bytes'] / n:.0f}",
        tables.number(1e3 * core["field"]["1"]["cpu"]["median"]),
        *(tables.number(1e6 * far["cpu"][key]) if far else tables.DASH for key in ("median", "p99")),
        tables.number(1e6 * near["cpu"]["median"]) if near else tables.DASH,
        tables.number(core["exact"]["cpu"]["median"]),
    ]


def refresh_figures(results: dict[str, dict[str, Any]]) -> None:
    """The table of docs/figures.md with one row for each result that is kept."""
    kept = sorted(results.values(), key=lambda r: r["vertices"])
    costs = tables.table(COSTS_HEADING, list(map(costs_row, kept)))
    replace(FIGURES, "table", f"{costs}\nMeasured on {machine()}.\n")


def machine() -> str:
    """Processor and cores, as far as the system tells."""
    try:
        found = re.search(r"^model name\s*:\s*(.+)$", Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    except OSError:
        found = None
    return f"{found[1] if found else platform.machine()}, {os.cpu_count()} cores, {platform.system()}"
