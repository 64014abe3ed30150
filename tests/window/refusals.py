"""Asks MeshLab's window for what cannot be done, then for points and layers; writes down what was seen.

Usage (inside a root, within dbus-run-session): python3 refusals.py FOLDER
  FOLDER holds meshes/ and terrain.vgi (by scenario.py); all that was seen goes to refusals.json, which test_refusals.py
  judges, and to shots/.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

from bad_input import (
    BAD_INPUT,
    FINITE_AGAIN,
    FROM_POINT,
    GEOMETRIC_FUNCTION,
    LAYER,
    NO_PATH,
    NOT_FINITE,
    PATH,
)
from meshlab_window import MeshLabWindow
from screen import start_display

PICKED = (1.1, 0.7, 0.3)
PICTURED = ("point cloud", "index of another mesh", "vertex out of range")


class Refusals:
    """The steps, in order, in one window."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.seen: dict[str, object] = {"boxes": {}, "no path": {}, "picked": PICKED}
        index = (folder / "terrain.vgi").read_bytes()
        (folder / "truncated.vgi").write_bytes(index[: len(index) // 2])
        (folder / "wrong.vgi").write_bytes(b"no index " * 100)

    def picture(self, window: MeshLabWindow, name: str) -> None:
        """Keep a picture of the screen."""
        window.picture(self.folder / "shots" / f"{name}.png")

    def run(self) -> None:
        """Everything; what was seen before a step failed is kept."""
        meshes = [self.folder / "meshes" / f"{name}.ply" for name in ("terrain", "points", "torus", "parts")]
        window = MeshLabWindow(meshes, self.folder / "refusals.log")
        try:
            for case in BAD_INPUT:
                window.choose_layer(case.layer)
                dialog = window.open_filter(case.filter)
                for label, value in case.fields.items():
                    window.fill(dialog, label, value.replace("FOLDER", str(self.folder)))
                self.seen["boxes"][case.name] = window.apply(dialog)
                if case.name in PICTURED:
                    self.picture(window, f"refused_{case.name.replace(' ', '_')}")
                window.dismiss()
                window.close(dialog)
            self.no_path(window)
            self.not_finite(window)
            window.choose_layer("terrain")
            self.point_and_layer(window)
            self.seen["alive"] = window.is_alive()
        finally:
            self.picture(window, "refusals_last")
            self.seen["log"] = window.log_lines()
            (self.folder / "refusals.json").write_text(json.dumps(self.seen, indent=1))

    def no_path(self, window: MeshLabWindow) -> None:
        """Ask for what no path leads to, and keep what the log says."""
        window.choose_layer("parts")
        for case in NO_PATH:
            already = len(window.log_lines())
            dialog = window.open_filter(case.filter)
            for label, value in case.fields.items():
                window.fill(dialog, label, value)
            box = window.apply(dialog)
            self.seen["no path"][case.name] = {"box": box, "log": window.log_lines()[already:]}
            if box:
                window.dismiss()
            window.close(dialog)

    def not_finite(self, window: MeshLabWindow) -> None:
        """Ask for distances on a mesh with a coordinate that is not a finite number, then on the corrected mesh."""
        for name, formula in {**NOT_FINITE, "finite again": FINITE_AGAIN}.items():
            dialog = window.open_filter(GEOMETRIC_FUNCTION)
            window.fill(dialog, "func x = ", formula)
            window.fill(dialog, "func z = ", "z")  # by default a function of x
            window.apply(dialog)
            window.close(dialog)
            dialog = window.open_filter(FROM_POINT)
            window.fill(dialog, "Start vertex", "5")
            self.seen["boxes"][name] = window.apply(dialog)
            if self.seen["boxes"][name]:
                window.dismiss()
            window.close(dialog)

    def point_and_layer(self, window: MeshLabWindow) -> None:
        """After all the refusals: a start point, a layer of points, a path."""
        self.apply(window, FROM_POINT, "start_point", {"Start point": tuple(map(str, PICKED))})
        self.apply(window, LAYER, "source_layer", {"Source layer": ("points.ply",)})
        self.apply(window, PATH, "path", {"Source vertex": ("35",), "Target vertex": ("3460",)})

    def apply(self, window: MeshLabWindow, name: str, picture: str, fields: dict[str, tuple[str, ...]]) -> None:
        """Fill in a dialog and apply it."""
        dialog = window.open_filter(name)
        for label, values in fields.items():
            window.fill(dialog, label, *values)
        self.seen[picture] = window.apply(dialog)
        self.picture(window, picture)
        window.close(dialog)


if __name__ == "__main__":
    start_display(Path(sys.argv[1]))
    Refusals(Path(sys.argv[1])).run()
