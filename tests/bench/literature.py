"""Methods of docs/methods.md on one mesh: time and errors, and where public code of the same method is installed, its.

Usage: tests/bench/literature.sh [--sources K] [--methods NAMES] [--gaps] MESH...

Times are processor time of one run, so that set-ups on two threads and on one can be compared; errors are relative to
exact distances. `--gaps` measures instead how long it takes to bridge the mesh with cracks, and as loose triangles.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import vorogeo

import meshes
import methods
import summary
import tables

#: Public code of the same method, by the names of methods.py.
PEERS = {"heat": ("pp3d_heat", "igl_heat"), "fast_marching": ("pp3d_marching",), "mmp": ("pygeodesic",)}
CHOSEN = "mmp ammp fast_marching heat gsp svg dgg(epsilon=0.01) dgg gtu stvd dijkstra"
COLUMNS = "method | set-up | field | exact fields | mean error | largest | public code: set-up | field | ours to it"


class Row(NamedTuple):
    """What one method cost, in seconds of the processor, and its errors in percent."""

    name: str
    setup: float
    field: float
    errors: dict[str, float] | None


def timed(work: Callable[[], Any]) -> tuple[Any, float]:
    """What it returns, and its processor time."""
    start = time.process_time()
    result = work()
    return result, time.process_time() - start


def measured(name: str, prepare: Callable[[], Any], field: str, sources: list[int], exact: np.ndarray) -> Row:
    """Set-up once and a field from each source; the first field also pays for what is made on demand."""
    method, setup = timed(prepare)
    run = getattr(method, field)
    seconds = [timed(lambda s=source: run(s))[1] for source in sources]
    found = np.stack([run(source) for source in sources[:2]])
    return Row(name, setup, float(np.median(seconds)), summary.errors(found.ravel(), exact[:2].ravel()))


def prepared(mesh: meshes.Mesh, text: str) -> Callable[[], Any]:
    """The method of a text such as "svg(K=50)"."""
    name, _, rest = text.partition("(")
    options = {key: float(value) for key, value in (part.split("=") for part in rest.strip(")").split(",") if part)}
    return lambda: vorogeo.GeodesicMethod(*mesh, name, **options)


def compared(mesh: meshes.Mesh, chosen: list[str], count: int) -> list[str]:
    """The lines of the table: a method of ours, and behind it each public code that can be imported."""
    sources = np.random.default_rng(2).integers(0, len(mesh[0]), count).tolist()
    reference = measured("mmp", prepared(mesh, "mmp"), "distance_field", sources, np.ones((2, len(mesh[0]))))
    exact = np.stack([vorogeo.exact_distance_field(*mesh, source) for source in sources[:2]])
    lines = [COLUMNS, "--|" * COLUMNS.count("|") + "--"]
    for text in chosen:
        own = measured(text, prepared(mesh, text), "distance_field", sources, exact)
        cells = [text, tables.duration(own.setup), tables.duration(own.field), f"{own.field / reference.field:.3g}"]
        worst = own.errors or {"mean": np.nan, "over": np.nan, "under": np.nan}
        cells += [f"{worst['mean']:.2g} %", f"{max(worst['over'], worst['under']):.2g} %"]
        peers = [row for peer in PEERS.get(text.partition("(")[0], ()) for row in peer_row(mesh, peer, sources, exact)]
        for peer in peers or [None]:
            beside = ["-", "-", "-"]
            if peer:
                title = methods.METHODS[peer.name].title
                beside = [f"{title}: {tables.duration(peer.setup)}", tables.duration(peer.field)]
                beside += [f"{own.setup / peer.setup:.2f}, {own.field / peer.field:.2f}"]
            lines.append(" | ".join(cells + beside))
    return lines


def peer_row(mesh: meshes.Mesh, name: str, sources: list[int], exact: np.ndarray) -> list[Row]:
    """Public code of a method; nothing if it is not installed here."""
    try:
        methods.import_package(name)
    except ImportError:
        return []
    return [measured(name, lambda: methods.make(name, *mesh, 1, None), "field", sources, exact)]


def with_cracks(mesh: meshes.Mesh, width: float) -> meshes.Mesh:
    """The mesh cut open along two planes through its middle, both sides pulled back by half of `width`."""
    vertices, faces = mesh
    for axis in (0, 1):
        middle = np.median(vertices[:, axis])
        beyond = vertices[faces][:, :, axis].mean(axis=1) > middle
        both = np.intersect1d(faces[beyond], faces[~beyond])
        copies = np.arange(len(vertices), len(vertices) + len(both), dtype=faces.dtype)
        new = np.arange(len(vertices), dtype=faces.dtype)
        new[both] = copies
        aside = np.zeros(3)
        aside[axis] = width / 2
        vertices = np.vstack([vertices, vertices[both] + aside])
        vertices[both] -= aside
        faces = np.where(beyond[:, None], new[faces], faces)
    return np.ascontiguousarray(vertices), np.ascontiguousarray(faces)


def bridging(mesh: meshes.Mesh) -> list[str]:
    """Lines with the time that a mesh takes longer to be read with a gap than without."""
    edge = float(np.linalg.norm(np.diff(mesh[0][mesh[1][:, :2]], axis=1), axis=2).mean())
    loose = mesh[0][mesh[1]].reshape(-1, 3), np.arange(3 * len(mesh[1]), dtype=mesh[1].dtype).reshape(-1, 3)
    lines = ["mesh | vertices | read | with the gap bridged | bridging | components, before and after"]
    for name, given in (("whole", mesh), ("two cracks", with_cracks(mesh, 0.3 * edge)), ("loose triangles", loose)):
        _, plain = timed(lambda m=given: vorogeo.Surface(*m))
        _, bridged = timed(lambda m=given: vorogeo.Surface(*m, gap=edge))
        report = vorogeo.check_mesh(*given, gap=edge)
        counts = f"{report.components:,}, {report.components_after_bridging:,}"
        times = " | ".join(map(tables.duration, (plain, bridged, bridged - plain)))
        lines.append(f"{name} | {len(given[0]):,} | {times} | {counts}")
    return lines


def main() -> None:
    """Measure the meshes of the command line."""
    parser = argparse.ArgumentParser(prog="tests/bench/literature.sh", description="Methods beside public code.")
    parser.add_argument("meshes", nargs="+", metavar="MESH")
    parser.add_argument("--sources", type=int, default=3, help="fields that are timed (default 3)")
    parser.add_argument("--methods", default=CHOSEN, help="names with spaces between, options in parentheses")
    parser.add_argument("--gaps", action="store_true", help="measure bridging instead")
    arguments = parser.parse_args()
    for name in arguments.meshes:
        file = meshes.find(name)
        if file:
            mesh = meshes.load(file)
            print(f"{file.stem}, {len(mesh[0]):,} vertices")
            work = bridging(mesh) if arguments.gaps else compared(mesh, arguments.methods.split(), arguments.sources)
            print("\n".join(work))


if __name__ == "__main__":
    main()
