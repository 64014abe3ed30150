"""Keeps what was done in MeshLab's window as a filter script, and applies a script with another start.

Usage (inside a root, within dbus-run-session): python3 filter_script.py FOLDER
  FOLDER holds meshes/; all that was seen goes to filter_script.json, which test_filter_script.py judges, the scripts to
  saved.mlx and applied.mlx, the field to field_script.ply.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

from loading import EXACT_FROM_POINT
from meshlab_window import MeshLabWindow
from screen import Atspi, start_display, wait_for

FIRST, SECOND = 777, 2750


class FilterScript:
    """The steps, in order, in one window."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.seen: dict[str, object] = {"first": FIRST, "second": SECOND}

    def run(self) -> None:
        """Everything; what was seen before a step failed is kept."""
        mesh = self.folder / "meshes" / "terrain.ply"
        window = MeshLabWindow([mesh], self.folder / "filter_script.log")
        try:
            dialog = window.open_filter(EXACT_FROM_POINT)
            window.fill(dialog, "Start vertex", str(FIRST))
            self.seen["applied"] = window.apply(dialog)
            window.close(dialog)
            self.save(window, self.folder / "saved.mlx")
            script = (self.folder / "saved.mlx").read_text()
            (self.folder / "applied.mlx").write_text(script.replace(f'"{FIRST}"', f'"{SECOND}"'))
            self.apply(window, self.folder / "applied.mlx")
            window.export()
            (self.folder / "field_script.ply").write_bytes(mesh.read_bytes())
            self.seen["alive"] = window.is_alive()
        finally:
            window.picture(self.folder / "shots" / "filter_script_last.png")
            self.seen["log"] = window.log_lines()
            (self.folder / "filter_script.json").write_text(json.dumps(self.seen, indent=1))

    @staticmethod
    def show(window: MeshLabWindow) -> Atspi.Accessible:
        """Filters, Show current filter script."""
        window.choose_in_menu("Filters", "Show current filter script")
        return wait_for("the filter script", window.message_box)

    def save(self, window: MeshLabWindow, file: Path) -> None:
        """Save Script."""
        box = self.show(window)
        window.picture(self.folder / "shots" / "filter_script.png")
        window.press(box, "Save Script")
        window.give_file("Save Filter Script File", file)
        wait_for("the script to be written", lambda: file.is_file() and "</FilterScript>" in file.read_text())
        window.press(box, "Close")
        wait_for("the filter script to close", lambda: window.message_box() is None)

    def apply(self, window: MeshLabWindow, file: Path) -> None:
        """Clear Script, Open Script, Apply Script."""
        already = len(window.log_lines())
        box = self.show(window)
        window.press(box, "Clear Script")
        window.press(box, "Open Script")
        window.give_file("Open Filter Script File", file)
        window.press(box, "Apply Script")
        wait_for("the script to be applied", lambda: any("Distances from" in x for x in window.log_lines()[already:]))
        wait_for("the filter script to close", lambda: window.message_box() is None)


if __name__ == "__main__":
    start_display(Path(sys.argv[1]))
    FilterScript(Path(sys.argv[1])).run()
