"""Random steps in MeshLab's window: distances, indexes, edits by its own filters, wrong numbers, saving, reloading.

Usage: random_steps.py FOLDER [COUNT [FIRST_SEED]]
Each sequence goes on with the mesh that the one before left, and ends with a distance that is saved;
test_random_steps.py judges it (see script.py). Now and then MeshLab is left, and started with the mesh as it was made.
"""

from __future__ import annotations

import random
import sys
from collections.abc import Callable

from filter_names import BUILD, DESCRIBE, EXACT_FROM_POINT, FROM_POINT, SAVE
from screen import wait_for
from script import Fields, Script

SEQUENCES = 3
SEQUENCES_A_WINDOW = 25  #: MeshLab keeps what it draws with for each filter applied: some 28 MB without a graphics card
STEPS = (2, 6)
FEWEST = 1500  #: vertices that are left whatever the steps delete
MOST_DELETED = 4
BORDER = "Select Border"
EDITS: dict[str, Callable[[random.Random], Fields]] = {
    "Transform: Scale, Normalize": lambda draw: {"X Axis": f"{draw.uniform(0.5, 2):.3f}"},
    "Laplacian Smooth": lambda _: {},
    "Invert Faces Orientation": lambda _: {},
    "Select All": lambda _: {},
    BORDER: lambda _: {},
}


class RandomSteps(Script):
    """Sequence after sequence."""

    def steps(self) -> None:
        """Everything."""
        count = int(sys.argv[2]) if len(sys.argv) > 2 else SEQUENCES
        first = int(sys.argv[3]) if len(sys.argv) > 3 else random.SystemRandom().randrange(10**6)
        mesh = self.mesh("terrain").read_bytes()
        self.seen["sequences"] = []
        for seed in range(first, first + count):
            if (seed - first) % SEQUENCES_A_WINDOW == 0:
                self.deleted = 0
                if seed > first:
                    self.window.quit()
                    self.mesh("terrain").write_bytes(mesh)
                    self.window = self.open()
            self.sequence(seed)

    def sequence(self, seed: int) -> None:
        """Some steps, then a distance that is saved."""
        draw = random.Random(seed)
        boxes: list[tuple[str, str]] = []
        self.seen["sequences"].append({"seed": seed, "boxes": boxes})
        for _ in range(draw.randint(*STEPS)):
            self.step(draw, boxes)
        source = draw.randrange(FEWEST)
        exact = draw.random() < 0.5
        name, fields = (EXACT_FROM_POINT, {}) if exact else (FROM_POINT, {"Method": "index"})
        boxes.append((name, self.use(name, {"Start vertex": str(source), **fields})))
        self.seen["sequences"][-1] |= {"source": source, "exact": exact, "field": self.export(f"random_{seed}")}

    def step(self, draw: random.Random, boxes: list[tuple[str, str]]) -> None:
        """One step; what it was, and what a message box said, are noted."""
        kind = draw.choice(("edit", "edit", "distance", "wrong", "index", "describe", "delete", "save", "reload"))
        if kind == "edit":
            name = draw.choice(sorted(EDITS))
            boxes.append((name, self.use(name, EDITS[name](draw))))
        elif kind == "distance":
            boxes.append((FROM_POINT, self.use(FROM_POINT, {"Start vertex": str(draw.randrange(FEWEST))})))
        elif kind == "wrong":
            boxes.append((kind, self.use(FROM_POINT, {"Start vertex": str(draw.choice((-7, 10**7)))})))
        elif kind == "index":
            boxes.append((BUILD, self.use(BUILD)))
            boxes.append((SAVE, self.use(SAVE, {"Index file": str(self.folder / "random.vgi")})))
        elif kind == "describe":
            boxes.append((DESCRIBE, self.use(DESCRIBE)))
        elif kind == "delete" and self.deleted < MOST_DELETED:
            self.deleted += 1
            for name in (BORDER, "Delete Selected Faces and Vertices"):
                boxes.append((name, self.use(name)))
        elif kind == "save":
            self.window.export()
        elif kind == "reload":
            self.reload()

    def reload(self) -> None:
        """What was changed since the mesh was saved is lost."""
        already = len(self.window.log_lines())
        self.window.choose_in_menu("File", "Reload")
        wait_for("the mesh", lambda: any("reloaded" in line for line in self.window.log_lines()[already:]))


if __name__ == "__main__":
    RandomSteps.main()
