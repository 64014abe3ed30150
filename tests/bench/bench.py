"""Runs one of the benchmarks: the command line, and the page of figures that it renews. There is no pass or fail.

A page is a module with `options(parser)`, which adds what only it has, and `run(options)`, which measures, prints on
the way what it likes, and returns the texts to be put between the marks of docs/figures.md and docs/metrics.md, by
mark. MESH is a mesh file, or the name of one in the folder of test meshes (VOROGEO_MESHES, by default
../shared/meshes beside the project).
"""

from __future__ import annotations

import argparse
import importlib
import re
import sys
from pathlib import Path

import meshes

DOCUMENTS = [meshes.ROOT / "docs" / name for name in ("figures.md", "metrics.md")]
PAGES = {
    "peers": "times, memory and errors, beside public packages",
    "exact_fields": "exact fields of fresh and of kept surfaces, beside VTP from its authors' sources",
    "any_mesh": "costs and errors of an index on meshes of every kind",
    "matrices": "matrices of all distances as float32 in a file, beside other packages",
    "paths": "refined and exact paths of many random pairs against exact fields",
    "waits": "fields on one and two threads, and the slowest of many questions of two points",
    "choosing": "the time of 1 to 1,000 fields by the automatic choice and by each fixed one",
    "directions": "log maps, traced lines and transported vectors beside potpourri3d",
    "growth": "time and memory against the size of the mesh",
    "hot_spots": "the functions that take the time, by perf",
    "gaps": "bridging",
    "face_metrics": "metrics that jump at edges against formulas",
    "convergence": "metrics on meshes of every kind against themselves on finer ones",
    "trade_off": "both forms of the index, sizes of patches and delta against accuracy",
}


def main() -> None:
    """Run the page of the command line."""
    pages = "\n".join(f"  {name:13}{about}" for name, about in PAGES.items())
    parser = argparse.ArgumentParser(
        prog="tests/bench/run.sh", description=f"Pages:\n{pages}", formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("page", choices=PAGES, metavar="PAGE")
    parser.add_argument("options", nargs=argparse.REMAINDER, help="PAGE --help names them")
    chosen = parser.parse_args()
    page = importlib.import_module(chosen.page)
    own = argparse.ArgumentParser(prog=f"tests/bench/run.sh {chosen.page}", description=PAGES[chosen.page])
    own.add_argument("--write", action="store_true", help="also renew the figures and pictures in docs/")
    page.options(own)
    options = own.parse_args(chosen.options)
    for mark, text in page.run(options).items():
        print(f"\n{text}", flush=True)
        for file in DOCUMENTS:
            if options.write and has_marks(file, mark):
                replace(file, mark, text)


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


if __name__ == "__main__":
    sys.exit(main())
