"""Works on a mesh of two million vertices in MeshLab's window: times, and how long the window does not respond.

Usage (inside a root, within dbus-run-session): python3 large_mesh.py FOLDER
  FOLDER holds meshes/large.ply; the figures are printed and go to large.json, pictures to shots/.

A question to a widget is answered when MeshLab handles its events, which a filter lets it do at each step of its
progress: the longest time without an answer is the longest time without a step.
"""

from __future__ import annotations

import json
import sys
import time
from contextlib import suppress
from pathlib import Path

from bad_input import BUILD, FROM_POINT
from loading import EXACT_FROM_POINT
from meshlab_window import MeshLabWindow
from screen import Atspi, GLib, start_display, wait_for

PATIENCE = 7200
# The first answer comes without an index.
STEPS = (
    ("first field", FROM_POINT, {"Start vertex": "0"}, "Distances from"),
    ("exact field", EXACT_FROM_POINT, {"Start vertex": "0"}, "Distances from"),
    ("index", BUILD, {}, "Geodesic index in the form"),
    ("field from the index", FROM_POINT, {"Start vertex": "0"}, "Distances from"),
)


class LargeMesh:
    """The filters of STEPS, one after the other, in one window."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.seen: dict[str, object] = {"filters": {}}

    def run(self) -> None:
        """Everything; what was seen before a step failed is kept."""
        window = MeshLabWindow([self.folder / "meshes" / "large.ply"], self.folder / "large.log")
        try:
            for step, name, fields, line in STEPS:
                dialog = window.open_filter(name)
                for label, value in fields.items():
                    window.fill(dialog, label, value)
                self.seen["filters"][step] = self.watch(window, dialog, line)
                print(step, json.dumps(self.seen["filters"][step]), flush=True)
                window.close(dialog)
            self.seen["alive"] = window.is_alive()
        finally:
            window.picture(self.folder / "shots" / "large.png")
            self.seen["log"] = window.log_lines()
            (self.folder / "large.json").write_text(json.dumps(self.seen, indent=1))

    def watch(self, window: MeshLabWindow, dialog: Atspi.Accessible, line: str) -> dict[str, object]:
        """Apply and ask the progress bar how far it is, over and over. `line`: begins the filter's line of the log."""
        bar = next(node for node in window.nodes() if node.get_role() == Atspi.Role.PROGRESS_BAR)
        already = len(window.log_lines())
        start = time.monotonic()
        window.press(dialog, "Apply")
        steps, longest, answers, pictured = set(), 0.0, 0, False

        def has(begin: str) -> bool:
            return any(entry.startswith(begin) for entry in window.log_lines()[already:])

        while not has(line) and window.is_alive() and time.monotonic() - start < PATIENCE:
            asked = time.monotonic()
            with suppress(GLib.Error):
                steps.add(round(bar.get_current_value()))
                answers += 1
            if not has(line):  # what lasts beyond the filter's end is MeshLab's own drawing
                longest = max(longest, time.monotonic() - asked)
            if not pictured and time.monotonic() - start > 5:
                pictured = True
                window.picture(self.folder / "shots" / "large_in_work.png")
        seconds = time.monotonic() - start
        wait_for("the end of the filter", lambda: has("Applied filter"), PATIENCE, window.is_alive)
        return {
            "seconds": seconds,
            "longest without an answer": longest,
            "answers": answers,
            "percentages": len(steps),
            "seconds of drawing": time.monotonic() - start - seconds,
        }


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    start_display(folder)
    LargeMesh(folder).run()
