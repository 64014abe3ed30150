"""The pictures of docs/figures: time, memory and errors against each other, on logarithmic axes."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import matplotlib as mpl

mpl.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter
from numpy.typing import NDArray

import meshes

#: Colours that stay apart for colour-blind readers (Okabe, Ito), one per package; the marker tells methods apart.
COLOURS = {
    "vorogeo": "#D55E00",
    "pygeodesic": "#000000",
    "libigl": "#0072B2",
    "gdist": "#999999",
    "CGAL": "#009E73",
    "potpourri3d": "#CC79A7",
    "pymeshlab": "#E69F00",
}
MARKERS = {"exact": "s", "heat": "o", "marching": "^", "point": "v", "flips": "P", "index": "*"}
PATCHES = {90: "#0072B2", 180: "#009E73", 350: "#D55E00", 700: "#CC79A7"}
EXACT_AT = 1e-4  # where exact methods are drawn, as 0 has no place on the axis


def error_against_time(result: dict[str, Any], file: Path) -> None:
    """One panel for fields, one for two far vertices; exact methods on a line of their own at the bottom."""
    figure, panels = plt.subplots(1, 2, figsize=(11, 4.6), sharey=True, layout="constrained")
    seen: dict[str, Any] = {}
    for axes, times, errors, title in (
        (panels[0], "field", "field_error", "distances of all vertices from one"),
        (panels[1], "far", "far_error", "distance of two far vertices"),
    ):
        for name, method in result["methods"].items():
            if not method[times] or "mean" not in (method.get(errors) or {}):
                continue
            mean = EXACT_AT if method["exact"] else max(method[errors]["mean"], 2 * EXACT_AT)
            seen[method["title"]] = draw_point(axes, name, method, method[times]["cpu"] or method[times], mean)
        axes.axhline(EXACT_AT, color="#bbbbbb", linewidth=0.8, zorder=0)
        axes.set(xscale="log", yscale="log", title=title, xlabel="processor time (s)")
        axes.grid(alpha=0.3, which="major")
    panels[0].set_ylabel("mean relative error (%)")
    bottom, top = panels[0].get_ylim()
    ticks = [10.0**power for power in range(-3, 3) if 10.0**power < top]
    panels[0].set_yticks([EXACT_AT, *ticks], ["exact", *(f"{tick:g}" for tick in ticks)])
    panels[0].set_yticks([], minor=True)
    panels[0].set_ylim(min(bottom, 0.6 * EXACT_AT), top)
    figure.legend(seen.values(), seen.keys(), loc="outside right upper", fontsize=8, frameon=False)
    figure.suptitle(
        f"{result['mesh']}, {result['vertices']:,} vertices: median processor time (bars: quartiles)", fontsize=11
    )
    save(figure, file)


def draw_point(axes: Axes, name: str, method: dict[str, Any], times: dict[str, float], error: float) -> Any:
    """A method as one marker with its quartiles."""
    kind = next((kind for kind in MARKERS if kind in name), "exact")
    spread = [[times["median"] - times["q1"]], [times["q3"] - times["median"]]]
    own = method["package"] == "vorogeo"
    style = {"color": COLOURS[method["package"]], "marker": MARKERS[kind], "linestyle": "none", "elinewidth": 1}
    return axes.errorbar(
        [times["median"]], [error], xerr=spread, markersize=15 if kind == "index" else 8 + own, **style
    )


def growth(results: Sequence[dict[str, Any]], file: Path) -> None:
    """Time and peak memory against the number of vertices, both axes logarithmic."""
    figure, (time_axes, memory_axes) = plt.subplots(1, 2, figsize=(11, 5), layout="constrained")
    own = {"color": COLOURS["vorogeo"], "linewidth": 2}
    core = [(r["vertices"], r["core"]) for r in results]
    threads = max(core[0][1]["build"])
    for label, values, marker in (
        ("VoroGeo, build", [(n, c["build"][threads]["cpu"]["median"]) for n, c in core], "D"),
        ("VoroGeo, exact field", [(n, c["exact"]["cpu"]["median"]) for n, c in core], "s"),
        ("VoroGeo, field", [(n, c["field"]["1"]["cpu"]["median"]) for n, c in core], "*"),
        ("VoroGeo, two far vertices", [(n, c["far_pair"]["cpu"]["median"]) for n, c in core if c["far_pair"]], "."),
    ):
        time_axes.plot(*zip(*values, strict=True), marker=marker, label=label, **own)
    for label, key, marker in (
        ("build", "build_peak", "D"),
        ("queries", "query_peak", "*"),
        ("exact", "exact_peak", "s"),
    ):
        points = [(n, c[key] / 2**20) for n, c in core if c[key] > 0]  # 0: too short to be seen
        memory_axes.plot(*zip(*points, strict=True), marker=marker, label=f"VoroGeo, {label}", **own)
    for name in dict.fromkeys(name for r in results for name in r["methods"] if not name.startswith("vorogeo")):
        measured = [(r["vertices"], r["methods"][name]) for r in results if r["methods"].get(name, {}).get("field")]
        if not measured:
            continue
        method = measured[0][1]
        kind = next((kind for kind in MARKERS if kind in name), "exact")
        style = {"color": COLOURS[method["package"]], "marker": MARKERS[kind], "linestyle": "--", "linewidth": 1}
        times = [(n, m["field"]["cpu"]["median"]) for n, m in measured]
        time_axes.plot(*zip(*times, strict=True), label=f"{method['title']}, field", **style)
        peaks = [(n, m["peak_bytes"] / 2**20) for n, m in measured]
        memory_axes.plot(*zip(*peaks, strict=True), label=method["title"], **style)
    for axes, title, unit in (
        (time_axes, "time", "processor time (s)"),
        (memory_axes, "peak memory", "memory of the process (MiB)"),
    ):
        axes.set(xscale="log", yscale="log", xlabel="vertices", ylabel=unit, title=title)
        axes.grid(alpha=0.3, which="major")
    handles, labels = time_axes.get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=3, fontsize=8, frameon=False)
    save(figure, file)


def choosing(meshes_totals: dict[str, dict[str, Any]]) -> None:
    """Seconds of 1 to k fields by each choice, a panel for each mesh."""
    count = len(meshes_totals)
    figure, panels = plt.subplots(1, count, figsize=(4.5 * count, 3.6), squeeze=False, layout="constrained")
    styles = {"exact": "C0--", "index": "C1--", "quick": "C2:", "automatic": "k-"}
    for axes, (title, totals) in zip(panels[0], meshes_totals.items(), strict=True):
        for name, seconds in totals.items():
            axes.loglog(np.arange(1, len(seconds) + 1), seconds, styles[name], label=name)
        axes.set_title(title, fontsize=10)
        axes.set_xlabel("fields")
        axes.grid(alpha=0.3)
    panels[0][0].set_ylabel("seconds in all")
    panels[0][0].legend(fontsize=8)
    save(figure, meshes.PICTURES / "choosing.png")


def convergence(points: Sequence[int], lines: dict[str, Sequence[float]], file: Path) -> None:
    """Mean errors against points on an edge, a line for each mesh, and slopes to compare them with."""
    figure, axes = plt.subplots(figsize=(6.4, 4.4), layout="constrained")
    for (name, errors), colour, marker in zip(lines.items(), COLOURS.values(), "os^vDPX", strict=False):
        axes.loglog(points, errors, color=colour, marker=marker, label=name)
    first, last = points[0], points[-1]
    low = min(errors[0] for errors in lines.values())
    for power in (2, 3):
        axes.loglog([first, last], [low, low * (first / last) ** power], color="#bbbbbb", linestyle=":", zorder=0)
        end = last, low * (first / last) ** power
        axes.annotate(f"power {power}", end, (-8, 8), textcoords="offset points", ha="right", fontsize=8, color="#777")
    axes.set_xticks(points, map(str, points))
    axes.set_xticks([], minor=True)
    axes.set(xlabel="points on an edge", ylabel="mean relative error (%)")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8, frameon=False)
    save(figure, file)


def trade_off(title: str, rows: Sequence[dict[str, Any]], file: Path) -> None:
    """Mean error of two-point distances against memory, build and query: a line per patch size along delta."""
    figure, panels = plt.subplots(1, 3, figsize=(13, 4.4), sharey=True, layout="constrained")
    for axes, (key, scale, label) in zip(
        panels,
        (
            ("bytes", 1.0, "memory (bytes per vertex)"),
            ("build", 1e6, "build (microseconds per vertex, one core)"),
            ("pair", 1e6, "two points, mean (microseconds)"),
        ),
        strict=True,
    ):
        for size, colour in PATCHES.items():
            for form, mark, marker_size in (("graph", "o-", 6), ("tables", "*", 14)):
                own = [row for row in rows if row["patch_size"] == size and row["form"] == form]
                points = [(scale * row[key], row["pair_error"]) for row in own]
                style = {"color": colour, "markersize": marker_size, "label": f"{form}, {size} vertices a patch"}
                axes.plot(*zip(*points, strict=True), mark, **style)
                for row, at in zip(own, points, strict=True):
                    if key == "bytes" and form == "graph":
                        place = {"textcoords": "offset points", "xytext": (5, 3), "fontsize": 7, "color": colour}
                        axes.annotate(f"{row['delta']:g}", at, **place)
        axes.set(xscale="log", yscale="log", xlabel=label)
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
            axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
            axis.set_minor_formatter(NullFormatter())
        axes.grid(alpha=0.3, which="both")
    panels[0].set_ylabel("mean relative error of two points (%)")
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside right center", fontsize=8, frameon=False)
    figure.suptitle(f"{title}: forms, patch sizes and delta (the numbers at the marks)", fontsize=11)
    save(figure, file)


def log_maps(vertices: NDArray[np.float64], faces: NDArray[np.int32], maps: dict[str, NDArray[np.float64]]) -> None:
    """Log maps of one vertex side by side, seen from there: the angle as a hue, with rings of distance."""
    source = vertices[int(np.argmin(np.linalg.norm(maps["VoroGeo"], axis=1)))]
    normals = np.cross(*(vertices[faces[:, i]] - vertices[faces[:, 0]] for i in (1, 2)))
    near = np.linalg.norm(vertices[faces].mean(axis=1) - source, axis=1)
    sight = normals[near < np.percentile(near, 5)].sum(axis=0)
    sight /= np.linalg.norm(sight)
    across = np.cross(np.eye(3)[np.argmin(np.abs(sight))], sight)
    across /= np.linalg.norm(across)
    seen = (vertices - source) @ np.column_stack([across, np.cross(sight, across), sight])
    front = np.flatnonzero(normals @ sight > 0)
    front = front[np.argsort(seen[faces[front], 2].mean(axis=1))]
    corners = seen[faces[front], :2]
    ring = 0.06 * np.ptp(vertices, axis=0).max()
    figure, panels = plt.subplots(1, len(maps), figsize=(4 * len(maps), 4.4), layout="constrained")
    for axes, (title, vectors) in zip(panels, maps.items(), strict=True):
        mean = vectors[faces[front]].mean(axis=1)
        hue = np.nan_to_num(np.arctan2(mean[:, 1], mean[:, 0]) / (2 * np.pi) % 1)
        dark = np.nan_to_num(np.linalg.norm(vectors, axis=1)[faces[front]].mean(axis=1) / ring).astype(int) % 2
        colours = mpl.colors.hsv_to_rgb(np.column_stack([hue, np.full(len(hue), 0.75), 1.0 - 0.18 * dark]))
        axes.add_collection(
            mpl.collections.PolyCollection(corners, facecolors=colours, edgecolors="face", linewidths=0.1)
        )
        axes.set(title=title, aspect="equal")
        axes.autoscale_view()
        axes.axis("off")
    save(figure, meshes.PICTURES / "log_maps.png")


def save(figure: Any, file: Path) -> None:
    """Write a picture without the date, so that the same figures give the same file."""
    file.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(file, dpi=120, metadata={"Software": None})
    plt.close(figure)
    print(f"written: {file}")
