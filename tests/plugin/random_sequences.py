"""Random sequences of filters, edits by MeshLab's own filters and wrong parameters on random layers of one project.

Usage: random_sequences.py [--first SEED] [--count N]

Whatever is clicked, nothing crashes or hangs, a refused filter ends in a sentence and changes nothing, an answered one
changes only what it says, new layers are finite, and an answer belongs to the layers as they are: fields equal those of
the numpy package, which knows nothing of the layers before. Each finding ends with the seed that repeats it.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Iterator
from multiprocessing.connection import Connection
from pathlib import Path

import conftest
import filters
import numpy as np
import pymeshlab
import support
from test_hostile_layers import LAYERS

# Processor seconds after which a step is assumed never to end, and vertices above which layers no longer grow.
MAX_STEP_SECONDS = 120
MANY_VERTICES = 3000
MAX_LAYERS = 7
STEPS = (6, 16)

# Parameters that are lengths: a number in the unit of the mesh, or a percentage of its diagonal.
LENGTHS = {"max_distance", "gap", "radius", "spacing", "max_snap_distance", "width"}
LAYER_NUMBERS = {"source_layer", "point_layer", "curve_layer"}
VERTEX_NUMBERS = {"vertex_index", "source", "target"}
# At most so large that a step takes a second.
MOST = {"sample_number": 200, "fields": 30, "rounds": 20, "n1": 12, "n2": 8, "samples": 30, "line_number": 30}

# How the host refuses a value before a filter sees it.
BY_THE_HOST = {"InvalidEnumException", "InvalidPercentageException"}

HOST_EDITS: dict[str, Callable[[np.random.Generator], dict[str, object]]] = {
    "compute_coord_laplacian_smoothing": lambda _: {},
    "apply_coord_laplacian_smoothing": lambda _: {},
    "compute_matrix_from_scaling_or_normalization": lambda r: {"axisx": float(r.uniform(0.3, 3)), "uniformflag": False},
    "compute_matrix_from_rotation": lambda r: {"angle": float(r.uniform(0, 360)), "freeze": bool(r.integers(2))},
    "compute_matrix_from_translation": lambda r: {"axisx": float(r.normal()), "freeze": bool(r.integers(2))},
    "apply_matrix_freeze": lambda _: {},
    "compute_coord_by_function": lambda _: {"x": "x + 0.01 * sin(9 * y)", "y": "y", "z": "z + 0.02 * cos(7 * x)"},
    "meshing_invert_face_orientation": lambda _: {},
    "meshing_re_orient_faces_coherently": lambda _: {},
    "meshing_surface_subdivision_midpoint": lambda _: {"iterations": 1},
    "meshing_surface_subdivision_loop": lambda _: {"iterations": 1},
    "meshing_decimation_quadric_edge_collapse": lambda r: {"targetperc": float(r.uniform(0.3, 0.9))},
    "meshing_decimation_clustering": lambda _: {},
    "meshing_isotropic_explicit_remeshing": lambda _: {"iterations": 1},
    "meshing_merge_close_vertices": lambda _: {},
    "meshing_remove_duplicate_vertices": lambda _: {},
    "meshing_remove_duplicate_faces": lambda _: {},
    "meshing_remove_unreferenced_vertices": lambda _: {},
    "meshing_remove_selected_faces": lambda _: {},
    "meshing_remove_selected_vertices": lambda _: {},
    "meshing_repair_non_manifold_edges": lambda _: {},
    "meshing_repair_non_manifold_vertices": lambda _: {},
    "meshing_close_holes": lambda _: {},
    "meshing_poly_to_tri": lambda _: {},
    "compute_selection_by_condition_per_vertex": lambda r: {"condselect": f"(vi % {r.integers(2, 60)}) == 0"},
    "compute_selection_by_condition_per_face": lambda r: {"condselect": f"(fi % {r.integers(2, 30)}) == 0"},
    "apply_selection_inverse": lambda _: {},
    "set_selection_none": lambda _: {},
    "compute_scalar_by_function_per_vertex": lambda r: {"q": str(r.choice(["1 + x * x", "x - y", "0", "1 / (x - x)"]))},
    "compute_scalar_by_function_per_face": lambda _: {"q": "1 + (fi % 5)"},
    "compute_normal_per_vertex": lambda _: {},
    "generate_copy_of_current_mesh": lambda _: {},
    "generate_by_merging_visible_meshes": lambda _: {},
    "generate_splitting_by_connected_components": lambda _: {},
    "generate_from_selected_faces": lambda _: {},
}


class FindingError(Exception):
    """What a sequence found wrong: kind and numbers."""


#: PyMeshLab 2022.2 has it by another name.
PERCENT = getattr(pymeshlab, "PercentageValue", None) or pymeshlab.Percentage


def layer_state(mesh: pymeshlab.Mesh) -> dict[str, np.ndarray]:
    """Everything of a layer that a filter could have changed, by what the host calls it."""
    found = {
        "vertices": mesh.vertex_matrix(),
        "faces": mesh.face_matrix(),
        "edges": mesh.edge_matrix(),
        "vertices in place": mesh.transformed_vertex_matrix(),
        "vertex selection": mesh.vertex_selection_array(),
        "face selection": mesh.face_selection_array(),
        "vertex colours": mesh.vertex_color_matrix(),
        "quality": mesh.vertex_scalar_array(),
    }
    if mesh.has_face_color():
        found["face colours"] = mesh.face_color_matrix()
    if mesh.has_face_scalar():
        found["face quality"] = mesh.face_scalar_array()
    return {key: np.array(value) for key, value in found.items()}


CHANGES = {
    filters.VERTEX_COLOR: "vertex colours",
    filters.VERTEX_QUALITY: "quality",
    filters.FACE_COLOR: "face colours",
    filters.VERTEX_SELECTION: "vertex selection",
    filters.FACE_SELECTION: "face selection",
}


def tube_of(random: np.random.Generator) -> support.Arrays:
    return support.tube(list(random.uniform(0.5, 1.5, int(random.integers(2, 9)))), int(random.integers(3, 20)))


def start_layer(random: np.random.Generator) -> support.Arrays:
    """A surface, more often one that is whole than one that barely is."""
    kind = random.integers(6)
    if kind == 0:
        at, rows = LAYERS[str(random.choice(list(LAYERS)))]()
    elif kind == 1:
        at, rows = tube_of(random)
    elif kind == 2:
        at, rows = support.side_by_side(support.grid(5, 4), support.sphere(1), tube_of(random))
    elif kind == 3:
        at, rows = support.sphere(int(random.integers(4)))
    else:
        at, rows = support.grid(int(random.integers(1, 20)), int(random.integers(1, 20)))
    if random.integers(2):
        at = at + random.normal(scale=0.1, size=at.shape)
    return at * 10 ** random.uniform(-2, 2), rows


class Sequence:
    """One project and what is done with it."""

    def __init__(self, seed: int, folder: Path, say: Callable[[str], None]) -> None:
        self.random = np.random.default_rng(seed)
        self.folder = folder
        self.say = say
        self.counts: Counter[str] = Counter()
        self.ms = pymeshlab.MeshSet()
        for _ in range(self.random.integers(1, 4)):
            at, rows = start_layer(self.random)
            self.ms.add_mesh(pymeshlab.Mesh(at, rows))
        if self.one_in(2):
            at, rows = self.arrays()
            self.ms.add_mesh(pymeshlab.Mesh(at[self.random.choice(np.unique(rows), 5)]))
        # See support.load: saving, too, writes into the log of the MeshSet that applied a filter last.
        self.ms.apply_filter("set_selection_none")
        self.choose_layer()

    def one_in(self, count: int) -> bool:
        """True once in so many times."""
        return self.random.integers(count) == 0

    def layers(self) -> Iterator[pymeshlab.Mesh]:
        """All layers."""
        return iter(self.ms)

    def arrays(self) -> support.Arrays:
        """The current layer, where it stands in the scene."""
        mesh = self.ms.current_mesh()
        return mesh.transformed_vertex_matrix(), mesh.face_matrix()

    def choose_layer(self) -> None:
        """Make some layer current; more often one with faces."""
        numbers = [mesh.id() for mesh in self.layers()]
        with_faces = [mesh.id() for mesh in self.layers() if mesh.face_number() > 0]
        self.ms.set_current_mesh(int(self.random.choice(with_faces if with_faces and not self.one_in(6) else numbers)))

    # ---- Parameters

    def vertex(self) -> int:
        """Number of a vertex, or now and then of none."""
        count = self.ms.current_mesh().vertex_number()
        return (
            int(self.random.choice([-1, count, 2**31 - 1, 0]))
            if self.one_in(8)
            else int(self.random.integers(max(count, 1)))
        )

    def number(self, usual: float) -> float:
        """A number of the order of the usual one, or now and then one that makes no sense."""
        if self.one_in(8):
            return float(self.random.choice([0.0, -1.0, np.nan, np.inf, 1e300]))
        return float((usual or 1.0) * 10 ** self.random.uniform(-1.5, 1.0))

    def place(self) -> np.ndarray:
        """A point near the layer, or none."""
        at, _ = self.arrays()
        if len(at) == 0 or self.one_in(12):
            return np.array([np.nan, np.inf, 1e30])
        return at[self.random.integers(len(at))] + self.random.normal(scale=0.05 * np.ptp(at), size=3)

    def points(self) -> str:
        """Surface points, as they are written."""
        if self.one_in(12):
            return str(
                self.random.choice(["; ;", "1; x", "-3", "2 0.5", "0 nan 1 0", "99999999999999", "1 0.2 0.3 0.6"])
            )
        faces = self.ms.current_mesh().face_number()
        entries = []
        for _ in range(self.random.integers(1, 6)):
            if faces and self.one_in(2):
                weights = self.random.dirichlet(np.ones(3))
                entries.append(f"{self.random.integers(faces)} " + " ".join(map(repr, weights.tolist())))
            else:
                entries.append(str(self.vertex()))
        return "; ".join(entries)

    def text(self, name: str) -> str:
        """Text for a parameter."""
        if name == "surface_points":
            return self.points()
        if name == "values":
            return str(self.random.choice(["0.5", "0.1; 0.7; 1e9", "-1; 0", "nan", "a", ""]))
        if name == "methods":
            return str(self.random.choice(["dijkstra", "all", "heat, fmm", "none such", ""]))
        return str(self.random.choice(["", str(self.folder / "file.csv"), str(self.folder / "none" / "x.npy")]))

    def value(self, name: str, usual: object) -> object:
        """Any value of the type that the parameter has."""
        if isinstance(usual, bool):
            return bool(self.random.integers(2))
        if isinstance(usual, np.ndarray):
            return self.place()
        if isinstance(usual, str):
            return self.text(name)
        if isinstance(usual, float):
            value = self.number(usual)
            if name not in LENGTHS:
                return value
            return support.length(value) if self.random.integers(2) else PERCENT(self.random.uniform(0, 100))
        if name in VERTEX_NUMBERS:
            return self.vertex()
        if name in LAYER_NUMBERS:
            numbers = [mesh.id() for mesh in self.layers()]
            return int(self.random.choice([*numbers, *numbers, -1, 77]))
        if self.one_in(10):
            return int(self.random.choice([-1, 99]))
        return int(self.random.integers(MOST.get(name, 6) + 1))

    def parameters(self, name: str) -> dict[str, object]:
        """Some of those of a filter; most calls of users leave most as they are."""
        usual = self.ms.filter_parameter_values(name)
        share = self.random.choice([0.15, 0.4, 0.8])
        chosen = {key: self.value(key, value) for key, value in usual.items() if self.random.random() < share}
        if "metric" in chosen and self.one_in(2):
            del chosen["metric"]
        for key, most in MOST.items():
            if key == "sample_number" and key in usual:
                chosen.setdefault(key, int(self.random.integers(1, most)))
        return chosen

    # ---- Steps

    def step(self) -> None:
        """One click."""
        kind = self.random.integers(20)
        if kind < 11:
            self.filter()
        elif kind < 15:
            self.edit()
        elif kind < 18:
            self.compare_fields()
        elif kind == 18:
            self.add_or_delete_layer()
        else:
            self.reopen()
        self.choose_layer()

    def filter(self) -> None:
        """A filter of the plugin, which may be refused."""
        name = str(self.random.choice(list(filters.FILTERS)))
        parameters = self.parameters(name)
        shown = {k: v.value() if hasattr(v, "value") else v for k, v in parameters.items()}
        self.say(f"{name} {shown} on layer {self.ms.current_mesh_id()}")
        current = self.ms.current_mesh_id()
        before = {mesh.id(): layer_state(mesh) for mesh in self.layers()}
        try:
            self.ms.apply_filter(name, **parameters)
        except Exception as error:
            if type(error).__name__ in BY_THE_HOST:
                self.counts["refused by the host"] += 1
                return
            said = str(error).strip().splitlines()[-1]
            if not said.endswith(".") or len(said) < 20:
                raise FindingError("refused without a sentence: " + said) from None
            self.counts["refused"] += 1
            self.require_same(before, current, 0)
            if len(list(self.layers())) != len(before):
                raise FindingError("a refused filter added a layer") from None
            return
        self.counts["answered"] += 1
        self.require_same(before, current, filters.FILTERS[name][1])
        for mesh in self.layers():
            if mesh.id() in before:
                continue
            if mesh.vertex_number() == 0:
                raise FindingError("a new layer is empty")
            if not np.isfinite(mesh.vertex_matrix()).all():
                raise FindingError("a new layer has a position that is not finite")

    def require_same(self, before: dict[int, dict[str, np.ndarray]], current: int, changes: int) -> None:
        """Complain about what changed in the layers that were there, but for what the filter says it changes."""
        allowed = {what for mask, what in CHANGES.items() if changes & mask}
        for mesh in self.layers():
            after = layer_state(mesh)
            for key, value in before.get(mesh.id(), {}).items():
                if mesh.id() == current and key in allowed:
                    continue
                if key not in after or not np.array_equal(after[key], value, equal_nan=value.dtype.kind == "f"):
                    raise FindingError(f"{key} of layer {mesh.id()} changed")

    def edit(self) -> None:
        """A filter of the host; what it refuses is its own affair."""
        name = str(self.random.choice(list(HOST_EDITS)))
        if name not in pymeshlab.filter_list():
            return
        grows = "subdivision" in name or name.startswith("generate_")
        if grows and (self.ms.current_mesh().vertex_number() > MANY_VERTICES or len(list(self.layers())) >= MAX_LAYERS):
            return
        self.say(f"host: {name}")
        try:
            self.ms.apply_filter(name, **HOST_EDITS[name](self.random))
        except pymeshlab.PyMeshLabException:
            self.counts["refused by the host"] += 1
        self.delete_layers()

    def compare_fields(self) -> None:
        """Fields of the current layer as it is now, against those of the numpy package."""
        import vorogeo  # once the plugin of the build is loaded: the package would load its own

        at, rows = self.arrays()
        if len(rows) == 0 or not np.isfinite(at).all():
            return
        source = int(self.random.choice(rows.ravel()))
        self.say(f"comparison of fields from vertex {source} of layer {self.ms.current_mesh_id()}")
        try:
            exact = vorogeo.exact_distance_field(at, rows, source)
        except ValueError:
            return
        near = np.isfinite(exact)
        for name, method, allowed in [
            (filters.EXACT_FROM_POINT, {}, 1e-6),
            (filters.FROM_POINT, {"method": "exact"}, 1e-6),
            (filters.FROM_POINT, {}, 0.5),
            (filters.FROM_POINT, {"method": "quick"}, 0.05),
        ]:
            self.ms.apply_filter(name, vertex_index=source, **method)
            found = support.field(self.ms)
            if not np.array_equal(found >= 0, near):
                raise FindingError(f"{name} {method} reaches other vertices than there are now")
            off = np.abs(found - exact)[near] - np.where(exact[near] > 0, allowed * exact[near], 0)
            if (off > 1e-9 * np.abs(at).max()).any():
                worst = int(np.argmax(off))
                raise FindingError(
                    f"stale: {name} {method}: {found[near][worst]!r}, not {exact[near][worst]!r}, at number {worst}"
                )
            if (np.abs(found - exact)[near]).mean() > 0.3 * exact[near].mean():
                raise FindingError(f"stale: {name} {method} errs by more than 0.3 in the mean")
            self.counts["fields compared"] += 1

    def add_or_delete_layer(self) -> None:
        """A layer more or less."""
        if self.one_in(2) or len(list(self.layers())) >= MAX_LAYERS:
            return self.delete_layers(1)
        self.say("a new layer")
        at, rows = start_layer(self.random)
        self.ms.add_mesh(pymeshlab.Mesh(at, rows))
        return None

    def delete_layers(self, more: int = 0) -> None:
        """So many as are too many, and more."""
        for _ in range(max(0, len(list(self.layers())) - MAX_LAYERS) + more):
            if len(list(self.layers())) < 2:
                return
            self.choose_layer()
            self.say(f"layer {self.ms.current_mesh_id()} is deleted")
            self.ms.delete_current_mesh()
            self.ms.set_current_mesh(next(self.layers()).id())

    def reopen(self) -> None:
        """Save the current layer and load it as another."""
        if self.ms.current_mesh().vertex_number() == 0:
            return
        self.say("saved and loaded")
        file = str(self.folder / "layer.ply")
        try:
            self.ms.save_current_mesh(file)
            support.load(self.ms, file)
        except pymeshlab.PyMeshLabException:
            self.counts["refused by the host"] += 1


def work(to_parent: Connection, first: int, end: int) -> None:
    """In a process of its own: tells each step before it is taken."""
    conftest.pytest_configure(None)
    quiet = os.open(os.devnull, os.O_WRONLY)
    os.dup2(quiet, 1)
    os.dup2(quiet, 2)
    for seed in range(first, end):
        to_parent.send(("seed", seed, ""))
        with tempfile.TemporaryDirectory() as folder:
            sequence = None
            try:
                sequence = Sequence(seed, Path(folder), lambda text: to_parent.send(("step", 0, text)))
                for _ in range(sequence.random.integers(*STEPS)):
                    sequence.step()
            except FindingError as finding:
                to_parent.send(("finding", seed, str(finding)))
            except Exception as error:
                to_parent.send(("finding", seed, f"{type(error).__name__}: {error}"))
            if sequence is not None:
                for what, count in sequence.counts.items():
                    to_parent.send(("count", count, what))
    to_parent.send(("end", 0, ""))


def processor_seconds(process: int) -> float:
    """Of a process that runs."""
    fields = Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def run(first: int, count: int) -> tuple[list[str], Counter[str]]:
    """Try so many seeds. Return what was found wrong, and how much was tried."""
    findings: list[str] = []
    counts: Counter[str] = Counter()
    forks = multiprocessing.get_context("spawn")
    seed = first
    while seed < first + count:
        mine, theirs = forks.Pipe(duplex=False)
        worker = forks.Process(target=work, args=(theirs, seed, first + count))
        worker.start()
        theirs.close()
        steps: list[str] = []
        began, how = 0.0, ""
        while True:
            if not mine.poll(1.0):
                if worker.is_alive() and processor_seconds(worker.pid) - began > MAX_STEP_SECONDS:
                    how = "a hang"
                    worker.kill()
                continue
            try:
                kind, number, text = mine.recv()
            except EOFError:
                worker.join()
                how = how or f"a crash ({worker.exitcode})"
                break
            if kind == "seed":
                seed, steps = number, []
            elif kind == "step":
                steps.append(text)
                counts["steps"] += 1
                began = processor_seconds(worker.pid)
            elif kind == "finding":
                findings.append(f"seed {number}: {text}, after " + "; ".join(steps[-3:]))
            elif kind == "count":
                counts[text] += number
            else:
                break
        worker.join()
        if not how:
            break
        if steps and steps[-1].startswith("host: "):
            counts[f"ended by {steps[-1]}"] += 1
        else:
            findings.append(f"seed {seed}: {how}, in " + "; ".join(steps[-3:]))
        seed += 1
    counts["sequences"] = count
    return findings, counts


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--first", type=int, default=int(np.random.SeedSequence().entropy % 2**31))
    parser.add_argument("--count", type=int, default=100)
    arguments = parser.parse_args()
    findings, counts = run(arguments.first, arguments.count)
    for finding in findings:
        print("FINDING", finding)
    print(f"from seed {arguments.first} on: " + ", ".join(f"{count} {what}" for what, count in counts.most_common()))
    print(f"{len(findings)} findings")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
