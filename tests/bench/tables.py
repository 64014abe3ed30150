"""The tables in Markdown, from the summaries of one mesh."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable
from typing import Any

Summary = dict[str, Any]
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


def figures(result: Summary) -> str:
    """The figures of VoroGeo on one mesh: C++ core, and what numpy sees."""
    core, own = result["core"], result["methods"].get("vorogeo_index", {})
    n = result["vertices"]
    rows = [["exact solver, whole mesh, a source, one thread", spread(core["exact"]), cpu(core["exact"])]]
    for size, times in core["exact_patch"].items():
        text = f"exact solver on a piece of {float(size):.0f} vertices, per vertex and source"
        rows.append([text, spread(times), cpu(times)])
    for threads, times in core["build"].items():
        rows.append(
            [
                f"build, {threads} thread{'s' * (threads != '1')}",
                duration(times["median"]),
                duration(times["cpu"]["median"] if times["cpu"] else None),
            ]
        )
    rows += [
        ["peak memory of the process while it builds", f"{number(core['build_peak'] / 2**20)} MiB"],
        ["index in memory, bytes per vertex", number(core["index_bytes"] / n)],
        ["index in the file, bytes per vertex", number(core["file_bytes"] / n)],
    ]
    for threads, times in core["field"].items():
        rows.append([f"field, {threads} thread{'s' * (threads != '1')}", spread(times), cpu(times)])
    rows.append(["field, numpy", spread(own.get("field")), cpu(own.get("field"))])
    for name, key in (("far", "far_pair"), ("near", "near_pair")):
        for where, times in (("", core[key]), (", numpy", own.get(name))):
            if times:
                both = [f"{duration(t['median'])}, p99 {duration(t['p99'])}" for t in (times, times["cpu"]) if t]
                rows.append([f"two points, {name}{where}", *both])
    if own.get("many"):
        both = [f"{number(rate['median'])} a second" for rate in (own["many"], own["many"]["cpu"]) if rate]
        rows.append(["many far pairs in one call, numpy", *both])
    for name in ("field", "far", "near"):
        error = own.get(f"{name}_error")
        if error and "mean" in error:
            text = " / ".join(f"{percent(error, key)} %" for key in ("mean", "p99", "over", "under"))
            rows.append([f"error, {name}: mean / p99 / largest too long / too short", text])
    return table("figure | wall clock | processor time", [[*row, *[""] * (3 - len(row))] for row in rows])


def details(result: Summary) -> str:
    """In a paragraph what the table of all meshes does not have: by the clock, by numpy, on pieces, memory."""
    core, own = result["core"], result["methods"].get("vorogeo_index", {})

    def clock(times: dict[str, Any]) -> str:
        each = (f"{duration(t['median'])} on {n} thread{'s' * (n != '1')}" for n, t in times.items())
        return ", ".join(each)

    sentences = [
        f"By the clock, a build takes {clock(core['build'])}, with at most {number(core['build_peak'] / 2**20)} MiB in "
        f"the process, and a field {clock(core['field'])}"
    ]
    pieces = core["exact_patch"]
    if pieces:
        sizes = ", ".join(f"{float(size):.0f}" for size in pieces)
        times = ", ".join(duration(times["median"]) for times in pieces.values())
        sentences.append(f"Exact runs on pieces of {sizes} vertices take {times} per vertex and source")
    by_numpy = [(name, own[key]) for name, key in (("a field", "field"), ("a far pair", "far")) if own.get(key)]
    if by_numpy:
        each = ", ".join(f"{name} {duration(times['median'])}" for name, times in by_numpy)
        many = f", {number(own['many']['median'])} far pairs in one call a second" if own.get("many") else ""
        sentences.append(f"From numpy: {each}{many}")
    near = core["near_pair"]
    if near:
        sentences.append(f"Of near pairs 99 % take less than {duration(near['p99'])}")
    return "\n".join(textwrap.wrap(". ".join(sentences) + ".", 138)) + "\n"


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
        if name == "pp3d_flips":
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
                *(percent(error, key) for key in ("mean", "p99", "over", "under")),
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
        figures_of_error = [percent(error, key) for key in ("mean", "p99", "over", "under")]
        row = [method["title"], cpu(method["far"]), str(method["far"]["count"]), ratio(method["far"], index)]
        rows.append(row + figures_of_error)
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
