"""Tables in Markdown, and what the page of figures says of one mesh, from its summaries."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable
from typing import Any

from summary import ERRORS, Summary

DASH = "-"


def table(heading: str, rows: Iterable[list[str]]) -> str:
    """A table whose first column is text and whose others are numbers; `heading` has its columns between bars."""
    columns = [column.strip() for column in heading.split("|")]
    rule = "|---|" + "--:|" * (len(columns) - 1) + "\n"
    first, *others = ("| " + " | ".join(row) + " |\n" for row in [columns, *rows])
    return first + rule + "".join(others)


def number(value: float | None, digits: int = 3) -> str:
    """Three significant digits, without an exponent."""
    if value is None:
        return DASH
    if value == 0:
        return "0"
    if abs(value) < 1e-4:
        return f"{value:.0e}"
    if abs(value) >= 100:
        return f"{value:,.0f}"
    return f"{value:#.{digits}g}".rstrip(".")


def duration(seconds: float | None) -> str:
    """Seconds in the unit that suits them."""
    if seconds is None:
        return DASH
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            return f"{number(seconds / size)} {unit}"
    return f"{number(seconds / 1e-9)} ns"


def spread(times: Summary | None) -> str:
    """Median and quartiles of times."""
    if not times:
        return DASH
    return f"{duration(times['median'])} ({duration(times['q1'])} to {duration(times['q3'])})"


def cpu(times: Summary | None) -> str:
    """Median and quartiles of the processor time."""
    return spread(times["cpu"]) if times and times["cpu"] else DASH


def percent(errors: Summary | None, key: str) -> str:
    """One figure of the errors, in percent; below rounding it is 0."""
    if not errors or key not in errors:
        return DASH
    return "0" if errors[key] < 1e-7 else number(errors[key])


def ratio(times: Summary | None, to: Summary | None) -> str:
    """How many times as long a median is as another, in processor time."""
    if not times or not to:
        return DASH
    return f"{number((times['cpu'] or times)['median'] / (to['cpu'] or to)['median'], 2)}"


def details(result: Summary) -> str:
    """In a paragraph what the table of all meshes does not have: by the clock, by numpy, memory."""
    core, own = result["core"], result["methods"].get("vorogeo_index", {})

    def clock(times: dict[str, Any]) -> str:
        each = (f"{duration(t['median'])} on {n} thread{'s' * (n != '1')}" for n, t in times.items())
        return ", ".join(each)

    text = (
        f"By the clock, a build takes {clock(core['build'])}, with at most {number(core['build_peak'] / 2**20)} MiB in "
    )
    text += f"the process, and a field {clock(core['field'])}."
    if own.get("field"):
        text += f" From numpy: a field {duration(own['field']['median'])}"
        text += f", a far pair {duration(own['far']['median'])}" if own.get("far") else ""
        text += f", {number(own['many']['median'])} far pairs in one call a second" if own.get("many") else ""
        text += "."
    if core["near_pair"]:
        text += f" Of near pairs 99 % take less than {duration(core['near_pair']['p99'])}."
    return "\n".join(textwrap.wrap(text, 138)) + "\n"


def fields(result: Summary) -> str:
    """All methods for fields: times and errors."""
    all_methods = result["methods"]
    index = all_methods.get("vorogeo_index", {}).get("field")
    exact = all_methods.get("vorogeo_exact", {}).get("field")
    heading = (
        "one source to all vertices | set-up | processor time | clock | sources | of index | of exact | MiB | mean (%) "
        "| p99 | too long | short"
    )
    rows = []
    for name, method in all_methods.items():
        if name == "pp3d_flips":  # it has no fields
            continue
        error = method.get("field_error")
        rows.append(
            [
                method["title"],
                duration(method["prepared"]),
                cpu(method["field"]),
                duration(method["field"]["median"]) if method["field"] else DASH,
                str(method["field_sources"]),
                ratio(method["field"], index),
                ratio(method["field"], exact),
                number(method["peak_bytes"] / 2**20) if method["peak_bytes"] else DASH,
                *(percent(error, key) for key in ERRORS),
            ]
        )
    return f"{table(heading, rows)}{remarks(all_methods)}"


def pairs(result: Summary) -> str:
    """All methods for two points."""
    rows = []
    index = result["methods"].get("vorogeo_index", {}).get("far")
    for method in result["methods"].values():
        if not method["far"]:
            continue
        error = method.get("far_error")
        row = [method["title"], cpu(method["far"]), str(method["far"]["count"]), ratio(method["far"], index)]
        rows.append(row + [percent(error, key) for key in ERRORS])
    if not rows:
        return "No two of the vertices drawn are far from each other and joined by a path.\n"
    heading = (
        "two far vertices | processor time | pairs | times our index | mean error (%) | p99 (%) | too long (%) "
        "| too short (%)"
    )
    return table(heading, rows)


def remarks(all_methods: dict[str, Summary]) -> str:
    """What the tables cannot say: failures, missing distances."""
    lines = []
    for method in all_methods.values():
        missing = (method.get("field_error") or {}).get("missing", 0)
        if missing:
            lines.append(f"{method['title']}: no distance for {number(missing)} % of the vertices that a path reaches.")
        if method["failure"]:
            lines.append(f"{method['title']}: {method['failure']}.")
    return "".join(f"\n{line}\n" for line in lines)


def versions(all_methods: dict[str, Summary]) -> str:
    """The packages and their versions, in one line."""
    found = {method["package"]: method["version"] for method in all_methods.values() if method["version"]}
    return ", ".join(f"{package} {version}" for package, version in found.items())


def mesh_section(result: Summary) -> str:
    """What docs/figures.md says about one mesh beside other packages."""
    name = result["mesh"]
    return (
        f"\n{result['vertices']:,} vertices, {result['faces']:,} faces; {result['machine']}.\n"
        f"Packages: {versions(result['methods'])}.\n\n"
        f"{details(result)}\n{fields(result)}\n{pairs(result)}\n"
        f"![Error against time on {name}](figures/error_time_{name}.png)\n\n"
    )


COSTS = (
    "mesh | vertices | build (s) | bytes per vertex | file | field (ms) | far pair (µs) | p99 (µs) | near pair (µs) "
    "| exact field (s)"
)


def costs_row(result: Summary) -> list[str]:
    """The row of a mesh in the table of all meshes."""
    core, n = result["core"], result["vertices"]
    build, far, near = core["build"], core["far_pair"], core["near_pair"]
    return [
        result["mesh"],
        str(n),
        number(build[min(build)]["cpu"]["median"]),
        f"{core['index_bytes'] / n:.0f}",
        f"{core['file_bytes'] / n:.0f}",
        number(1e3 * core["field"]["1"]["cpu"]["median"]),
        *(number(1e6 * far["cpu"][key]) if far else DASH for key in ("median", "p99")),
        number(1e6 * near["cpu"]["median"]) if near else DASH,
        number(core["exact"]["cpu"]["median"]),
    ]
