"""What an index costs and how it errs on meshes of every kind: scans, CAD parts, needles, cities, high genus."""

from __future__ import annotations

import argparse

import measure
import meshes
import tables

MADE = ("drilled_plate", "thick_plate", "drilled_block", "gear", "small_plate", "small_gear", "coarse_sphere")
MADE += ("block_city",)
SOURCES = 6
#: Of the page: errors in percent, of fields and pairs of an index, then of quick fields.
HEADING = (
    "mesh | vertices | needles | mean | p99 | long | short | pairs: mean | p99 | build | ms | bytes "
    "| quick: time | mean | p99 | long | short"
)

KEPT = 12  #: columns of the page; the times behind them are printed only


def options(parser: argparse.ArgumentParser) -> None:
    """Which meshes."""
    parser.add_argument("meshes", nargs="*", metavar="MESH", help=f"also {', '.join(MADE)}; default: all there are")


def run(options: argparse.Namespace) -> dict[str, str]:
    """Measure the meshes one by one."""
    names = options.meshes or [*map(str, sorted(meshes.SHARED.glob("*.ply"))), *MADE]
    rows = []
    for name in names:
        file = name if name in MADE else meshes.find(name)
        if not file:
            continue
        for found in measure.program("any_mesh", SOURCES, file):
            of_index, of_quick = row(found), quick_row(found)
            rows.append(of_index[:KEPT] + of_quick)
            print(*of_index, *of_quick, sep=" | ", flush=True)
    return {"any mesh": tables.table(HEADING, rows)}


def row(found: dict[str, float | str]) -> list[str]:
    """The row of a mesh, and after what the page has: exact (s), build (s), field (ms), pair (µs)."""
    formats = {
        "mesh": "", "vertices": ",.0f", "needles": ".1f", "mean": ".4f", "p99": ".3f", "over": ".2f", "under": ".2f",
        "pair_mean": ".4f", "pair_p99": ".3f", "build/exact": ".0f", "each": ".2f", "bytes": ",.0f", "exact": ".3g",
        "build": ".3g",
    }  # fmt: skip
    found = found | {"each": 1e3 * float(found["build"]) / float(found["vertices"])}
    field, pair = float(found["field"]), float(found["pair"])
    return [*(format(found[key], how) for key, how in formats.items()), f"{1e3 * field:.3g}", f"{1e6 * pair:.3g}"]


def quick_row(found: dict[str, float | str]) -> list[str]:
    """What its row has of quick fields."""
    formats = {"quick/exact": ".2f", "quick_mean": ".3f", "quick_p99": ".2f"}
    formats |= {"quick_over": ".2f", "quick_under": ".2f"}
    return [format(found[key], how) for key, how in formats.items()]
