"""What an index costs and how it errs on meshes of every kind: scans, CAD parts, needles, cities, high genus."""

from __future__ import annotations

import argparse

import measure
import meshes
import tables

MADE = ("drilled_plate", "thick_plate", "drilled_block", "gear", "small_plate", "small_gear", "coarse_sphere")
MADE += ("block_city",)
SOURCES = 6
HEADING = (
    "mesh | vertices | needles (%) | mean (%) | p99 (%) | too long (%) | too short (%) | pairs, mean (%) "
    "| pairs, p99 (%) | build | bytes | exact (s) | build (s) | field (ms) | pair (µs)"
)
QUICK = "mesh | of an exact field | mean (%) | p99 (%) | too long (%) | too short (%)"

KEPT = 11  #: columns of the page: what does not depend on the machine


def options(parser: argparse.ArgumentParser) -> None:
    """Which meshes."""
    parser.add_argument("meshes", nargs="*", metavar="MESH", help=f"also {', '.join(MADE)}; default: all there are")


def run(options: argparse.Namespace) -> dict[str, str]:
    """Measure the meshes one by one."""
    names = options.meshes or [*map(str, sorted(meshes.SHARED.glob("*.ply"))), *MADE]
    rows, quick = [], []
    for name in names:
        file = name if name in MADE else meshes.find(name)
        if not file:
            continue
        for found in measure.program("any_mesh", SOURCES, file):
            rows.append(row(found))
            quick.append(quick_row(found))
            print(" | ".join(rows[-1]), *quick[-1][1:], sep=" | ", flush=True)
    kept = [row[:KEPT] for row in rows]
    return {
        "any mesh": tables.table(" | ".join(HEADING.split(" | ")[:KEPT]), kept),
        "quick": tables.table(QUICK, quick),
    }


def row(found: dict[str, float | str]) -> list[str]:
    """The row of a mesh."""
    formats = {
        "mesh": "", "vertices": ",.0f", "needles": ".1f", "mean": ".4f", "p99": ".3f", "over": ".2f", "under": ".2f",
        "pair_mean": ".4f", "pair_p99": ".3f", "build/exact": ".0f", "bytes": ",.0f", "exact": ".3g", "build": ".3g",
    }  # fmt: skip
    field, pair = float(found["field"]), float(found["pair"])
    return [*(format(found[key], how) for key, how in formats.items()), f"{1e3 * field:.3g}", f"{1e6 * pair:.3g}"]


def quick_row(found: dict[str, float | str]) -> list[str]:
    """The row of its quick fields."""
    formats = {"mesh": "", "quick/exact": ".2f", "quick_mean": ".3f", "quick_p99": ".2f"}
    formats |= {"quick_over": ".2f", "quick_under": ".2f"}
    return [format(found[key], how) for key, how in formats.items()]
