"""Installs the plugin into the user's folder of extra plugins, by the documented command, and starts MeshLab.

Usage (inside a root, within dbus-run-session): python3 extra_folder.py FOLDER
  FOLDER holds meshes/, and ../plugin the built plugin; all that was seen goes to extra_folder.json, which
  test_loading.py judges.
"""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path

from loading import EXACT_FROM_POINT, SOURCE, filters, not_installed
from meshlab_window import MeshLabWindow
from screen import run, start_display


def use(folder: Path) -> None:
    """Everything; what was seen before a step failed is kept."""
    seen: dict[str, object] = {"source": SOURCE}
    with not_installed():
        run("cmake", "--install", str(folder.parent / "plugin"), "--component", "user")
        window = MeshLabWindow([folder / "meshes" / "terrain.ply"], folder / "extra_folder.log")
    try:
        seen["filters"] = filters(window)
        dialog = window.open_filter(EXACT_FROM_POINT)
        window.fill(dialog, "Start vertex", str(SOURCE))
        seen["applied"] = window.apply(dialog)
        seen["alive"] = window.is_alive()
    finally:
        seen["log"] = window.log_lines()
        (folder / "extra_folder.json").write_text(json.dumps(seen, indent=1))


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    home = folder / "home_with_plugin"
    home.mkdir(exist_ok=True)
    os.environ["HOME"] = str(home)
    start_display(folder)
    use(folder)
