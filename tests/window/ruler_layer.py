"""Measures with the geodesic ruler on a layer before and after its matrix scales it, and writes down what was seen.

Usage (inside a root, within dbus-run-session): python3 ruler_layer.py FOLDER
  FOLDER holds meshes/; the table of measurements goes to ruler_layer.json, which test_ruler.py judges.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

from ruler import PLATE_LEFT, PLATE_RIGHT, SCALE, RulerWindow
from screen import start_display

FACTOR = "1.1"


def measure(window: RulerWindow) -> list[list[str]]:
    """Drag between the same places of the view before and after; the vertices stay, only the layer's matrix changes."""
    window.toggle()
    window.drag(PLATE_LEFT, PLATE_RIGHT)
    window.wait_for_rows(1)
    window.toggle()
    dialog = window.open_filter(SCALE)
    window.fill(dialog, "X Axis", FACTOR)
    window.fill(dialog, "Freeze Matrix", "no")
    window.apply(dialog)
    window.close(dialog)
    window.toggle()
    window.drag(PLATE_LEFT, PLATE_RIGHT)
    window.wait_for_rows(2)
    return window.rows()


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    start_display(folder)
    meshes = [folder / "meshes" / f"{name}.ply" for name in ("sphere", "plate")]
    started = RulerWindow(meshes, folder / "ruler_layer.log")
    try:
        (folder / "ruler_layer.json").write_text(json.dumps(measure(started)))
        (folder / "shots").mkdir(exist_ok=True)
        started.picture(folder / "shots" / "ruler_layer.png")
    finally:
        started.process.kill()
