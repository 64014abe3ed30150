"""Works on a mesh of two million vertices in MeshLab's window: times, and how long the window does not respond.

The figures are also printed (see script.py). A question to a widget is answered when MeshLab handles its events, which
a filter lets it do at each step of its progress: the longest time without an answer is that without a step.
"""

from __future__ import annotations

import json
import time
from contextlib import suppress

from filter_names import BUILD, EXACT_FROM_POINT, FROM_POINT
from screen import Atspi, GLib, wait_for
from script import Script

PATIENCE = 7200
# The first answer comes without an index.
STEPS = (
    ("first field", FROM_POINT, {"Start vertex": "0"}, "Distances from"),
    ("exact field", EXACT_FROM_POINT, {"Start vertex": "0"}, "Distances from"),
    ("index", BUILD, {}, "Geodesic index in the form"),
    ("field from the index", FROM_POINT, {"Start vertex": "0"}, "Distances from"),
)


class LargeMesh(Script):
    """The filters of STEPS, one after the other, in one window."""

    meshes = ("large",)

    def steps(self) -> None:
        """Everything."""
        self.seen["filters"] = {}
        for step, name, fields, line in STEPS:
            dialog = self.window.open_filter(name)
            for label, value in fields.items():
                self.window.fill(dialog, label, value)
            self.seen["filters"][step] = self.watch(dialog, line)
            print(step, json.dumps(self.seen["filters"][step]), flush=True)
            self.window.close(dialog)

    def watch(self, dialog: Atspi.Accessible, line: str) -> dict[str, object]:
        """Apply and ask the progress bar how far it is, over and over. `line`: begins the filter's line of the log."""
        bar = next(node for node in self.window.nodes() if node.get_role() == Atspi.Role.PROGRESS_BAR)
        already = len(self.window.log_lines())
        start = time.monotonic()
        self.window.press(dialog, "Apply")
        steps, longest, answers, pictured = set(), 0.0, 0, False

        def has(begin: str) -> bool:
            return any(entry.startswith(begin) for entry in self.window.log_lines()[already:])

        while not has(line) and self.window.is_alive() and time.monotonic() - start < PATIENCE:
            asked = time.monotonic()
            with suppress(GLib.Error):
                steps.add(round(bar.get_current_value()))
                answers += 1
            if not has(line):  # what lasts beyond the filter's end is MeshLab's own drawing
                longest = max(longest, time.monotonic() - asked)
            if not pictured and time.monotonic() - start > 5:
                pictured = True
                self.picture("large_in_work")
        seconds = time.monotonic() - start
        wait_for("the end of the filter", lambda: has("Applied filter"), PATIENCE, self.window.is_alive)
        return {
            "seconds": seconds,
            "longest without an answer": longest,
            "answers": answers,
            "percentages": len(steps),
            "seconds of drawing": time.monotonic() - start - seconds,
        }


if __name__ == "__main__":
    LargeMesh.main()
