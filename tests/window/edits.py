"""Picks on, edits and empties a mesh in MeshLab's window, and lacks memory there; writes down what was seen.

Usage (inside a root, within dbus-run-session): python3 edits.py FOLDER
  FOLDER holds meshes/; all that was seen goes to edits.json, which test_edits.py judges, the field after the edit to
  field_edited.ply.
"""

from __future__ import annotations

import json
import resource
import sys
from pathlib import Path

from bad_input import FROM_POINT, SAVE
from meshlab_window import MeshLabWindow, text_of
from screen import Atspi, run, start_display, wait_for

DESCRIBE = "Geodesic index: describe (VoroGeo)"
MATRIX = "Geodesic distance matrix of the selection (VoroGeo)"
BEFORE, AFTER, LAST = 1000, 2500, 3000
SCALE = 2.0
ON_THE_MESH = (256, 500)  # on the screen, beside the dialog
SPARE = 48 << 20  # bytes for the message box; the matrix of all vertices takes more


class Edits:
    """The steps, in order, in one window."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.seen: dict[str, object] = {"before": BEFORE, "after": AFTER, "scale": SCALE}

    def run(self) -> None:
        """Everything; what was seen before a step failed is kept."""
        window = MeshLabWindow([self.folder / "meshes" / "terrain.ply"], self.folder / "edits.log")
        try:
            self.apply(window, FROM_POINT, {"Start vertex": str(BEFORE), "Method": "index"})
            self.pick_a_point(window)
            self.edit(window)
            self.lack_memory(window)
            self.empty(window)
            self.seen["alive"] = window.is_alive()
        finally:
            window.picture(self.folder / "shots" / "edits_last.png")
            self.seen["log"] = window.log_lines()
            (self.folder / "edits.json").write_text(json.dumps(self.seen, indent=1))

    def apply(self, window: MeshLabWindow, name: str, fields: dict[str, str] | None = None) -> str:
        """Fill in a dialog and apply it; without one the filter is applied at once. Returns the message box's text."""
        dialog = window.open_filter(name)
        if dialog is None:
            return ""
        for label, value in (fields or {}).items():
            window.fill(dialog, label, value)
        box = window.apply(dialog)
        if box:
            window.dismiss()
        window.close(dialog)
        return box

    def pick_a_point(self, window: MeshLabWindow) -> None:
        """Surf. Pos., Get, and a double-click on the mesh."""
        dialog = window.open_filter(FROM_POINT)
        point = next(entry for entry in window.parameters(dialog) if entry.label == "Start point")
        numbers = [widget for widget in point.widgets if widget.get_role() == Atspi.Role.TEXT]
        chooser = next(widget for widget in point.widgets if widget.get_role() == Atspi.Role.COMBO_BOX)
        before = [text_of(number) for number in numbers]
        window.choose(chooser, "Surf. Pos.")
        window.press(dialog, "Get")
        run("xdotool", "mousemove", *map(str, ON_THE_MESH), "click", "--repeat", "2", "--delay", "60", "1")
        wait_for("the picked point", lambda: [text_of(number) for number in numbers] != before)
        self.seen["picked"] = [float(text_of(number)) for number in numbers]
        window.picture(self.folder / "shots" / "picked_point.png")
        self.seen["apply picked"] = window.apply(dialog)
        window.close(dialog)

    def edit(self, window: MeshLabWindow) -> None:
        """The mesh is scaled: there is no index until the next distance by the index builds one."""
        self.apply(window, DESCRIBE)
        self.apply(window, "Transform: Scale, Normalize", {"X Axis": str(SCALE)})
        self.seen["lines before the edit"] = len(window.log_lines())
        self.apply(window, DESCRIBE)
        self.seen["save after the edit"] = self.apply(window, SAVE, {"Index file": str(self.folder / "stale.vgi")})
        self.seen["apply after the edit"] = self.apply(
            window, FROM_POINT, {"Start vertex": str(AFTER), "Method": "index"}
        )
        window.export()
        mesh = self.folder / "meshes" / "terrain.ply"
        (self.folder / "field_edited.ply").write_bytes(mesh.read_bytes())

    def lack_memory(self, window: MeshLabWindow) -> None:
        """MeshLab may take hardly more memory than it has; then again as much as it likes."""
        self.apply(window, "Select All")
        dialog = window.open_filter(MATRIX)
        status = Path(f"/proc/{window.process.pid}/status").read_text()
        taken = next(int(line.split()[1]) << 10 for line in status.splitlines() if line.startswith("VmSize"))
        unlimited = resource.prlimit(window.process.pid, resource.RLIMIT_AS, (taken + SPARE, resource.RLIM_INFINITY))
        self.seen["without memory"] = window.apply(dialog)
        window.picture(self.folder / "shots" / "without_memory.png")
        window.dismiss()
        window.close(dialog)
        resource.prlimit(window.process.pid, resource.RLIMIT_AS, unlimited)
        self.seen["with memory"] = self.apply(window, FROM_POINT, {"Start vertex": str(LAST)})

    def empty(self, window: MeshLabWindow) -> None:
        """All vertices and faces are deleted."""
        self.apply(window, "Delete Selected Faces and Vertices")
        self.seen["empty layer"] = self.apply(window, FROM_POINT)


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    start_display(folder)
    Edits(folder).run()
