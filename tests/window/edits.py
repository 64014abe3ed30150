"""Picks on, edits and empties a mesh in MeshLab's window, and lacks memory there (see script.py)."""

from __future__ import annotations

import resource
from pathlib import Path

from filter_names import DESCRIBE, FROM_POINT, SAVE
from meshlab_window import text_of
from screen import Atspi, run, wait_for
from script import Script

MATRIX = "Geodesic distance matrix of the selection (VoroGeo)"
BEFORE, AFTER, LAST = 1000, 2500, 3000
SCALE = 2.0
ON_THE_MESH = (256, 500)  # on the screen, beside the dialog
SPARE = 48 << 20  # bytes for the message box; the matrix of all vertices takes more


class Edits(Script):
    """The steps, in order, in one window."""

    def steps(self) -> None:
        """Everything."""
        self.seen |= {"before": BEFORE, "after": AFTER, "scale": SCALE}
        self.use(FROM_POINT, {"Start vertex": str(BEFORE), "Method": "index"})
        self.pick_a_point()
        self.edit()
        self.lack_memory()
        self.empty()

    def pick_a_point(self) -> None:
        """Surf. Pos., Get, and a double-click on the mesh."""
        dialog = self.window.open_filter(FROM_POINT)
        point = next(entry for entry in self.window.parameters(dialog) if entry.label == "Start point")
        numbers = [widget for widget in point.widgets if widget.get_role() == Atspi.Role.TEXT]
        chooser = next(widget for widget in point.widgets if widget.get_role() == Atspi.Role.COMBO_BOX)
        before = [text_of(number) for number in numbers]
        self.window.choose(chooser, "Surf. Pos.")
        self.window.press(dialog, "Get")
        run("xdotool", "mousemove", *map(str, ON_THE_MESH), "click", "--repeat", "2", "--delay", "60", "1")
        wait_for("the picked point", lambda: [text_of(number) for number in numbers] != before)
        self.seen["picked"] = [float(text_of(number)) for number in numbers]
        self.picture("picked_point")
        self.seen["apply picked"] = self.window.apply(dialog)
        self.window.close(dialog)

    def edit(self) -> None:
        """The mesh is scaled: there is no index until the next distance by the index builds one."""
        self.use(DESCRIBE)
        self.use("Transform: Scale, Normalize", {"X Axis": str(SCALE)})
        self.seen["lines before the edit"] = len(self.window.log_lines())
        self.use(DESCRIBE)
        self.seen["save after the edit"] = self.use(SAVE, {"Index file": str(self.folder / "stale.vgi")})
        self.seen["apply after the edit"] = self.use(FROM_POINT, {"Start vertex": str(AFTER), "Method": "index"})
        self.export("edited")

    def lack_memory(self) -> None:
        """MeshLab may take hardly more memory than it has; then again as much as it likes."""
        self.use("Select All")
        dialog = self.window.open_filter(MATRIX)
        status = Path(f"/proc/{self.window.process.pid}/status").read_text()
        taken = next(int(line.split()[1]) << 10 for line in status.splitlines() if line.startswith("VmSize"))
        unlimited = resource.prlimit(
            self.window.process.pid, resource.RLIMIT_AS, (taken + SPARE, resource.RLIM_INFINITY)
        )
        self.seen["without memory"] = self.window.apply(dialog)
        self.picture("without_memory")
        self.window.dismiss()
        self.window.close(dialog)
        resource.prlimit(self.window.process.pid, resource.RLIMIT_AS, unlimited)
        self.seen["with memory"] = self.use(FROM_POINT, {"Start vertex": str(LAST)})

    def empty(self) -> None:
        """All vertices and faces are deleted."""
        self.use("Delete Selected Faces and Vertices")
        self.seen["empty layer"] = self.use(FROM_POINT)


if __name__ == "__main__":
    Edits.main()
