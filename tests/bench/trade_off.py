"""What an index costs against what it gives, for both forms, four patch sizes and four deltas."""

from __future__ import annotations

import argparse

import measure
import meshes
import plots
import tables

SOURCES = 10
HEADING = "form | patch | delta | build (µs/vertex) | bytes/vertex | field (ms) | pair (µs) | field (%) | pair (%)"


def options(parser: argparse.ArgumentParser) -> None:
    """Which mesh."""
    parser.add_argument("mesh", nargs="?", default="rocker_arm", metavar="MESH", help="default: rocker_arm")


def run(options: argparse.Namespace) -> dict[str, str]:
    """Measure, draw."""
    file = meshes.find(options.mesh)
    if file is None:
        return {}
    mesh = meshes.load(file)
    found = measure.program("trade_off", meshes.write_raw(mesh, meshes.WORK / f"{file.stem}.raw"), SOURCES)
    if options.write:
        plots.trade_off(f"{file.stem}, {len(mesh[0]):,} vertices", found, meshes.PICTURES / "trade_off.png")
    rows = [
        [
            f["form"], f"{f['patch_size']:g}", f"{f['delta']:g}", f"{1e6 * f['build']:.0f}", f"{f['bytes']:.0f}",
            f"{1e3 * f['field']:.2f}", f"{1e6 * f['pair']:.0f}", f"{f['field_error']:.4f}", f"{f['pair_error']:.4f}",
        ]
        for f in found
    ]  # fmt: skip
    return {"trade-off": tables.table(HEADING, rows)}
