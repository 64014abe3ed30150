"""Loads the plugin by MeshLab's own dialog, where it is not installed, and applies a filter.

Usage (inside a root, within dbus-run-session): python3 loading.py FOLDER
  FOLDER holds meshes/, and ../plugin the built plugin; all that was seen goes to loading.json, which test_loading.py
  judges.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from meshlab_window import MeshLabWindow
from screen import Atspi, start_display, wait_for

EXACT_FROM_POINT = "Exact geodesic distance from a given point (VoroGeo)"
SOURCE = 777
INSTALLED = Path("/usr/lib/x86_64-linux-gnu/meshlab/plugins/libfilter_vorogeo.so")


@contextmanager
def not_installed() -> Iterator[None]:
    """MeshLab finds no plugin of ours in its own folder."""
    aside = INSTALLED.with_suffix(".aside")
    INSTALLED.rename(aside)
    try:
        yield
    finally:
        aside.rename(INSTALLED)


def filters(window: MeshLabWindow) -> list[str]:
    """Our filters in the menu."""
    return [item.rpartition("/")[2] for item in window.menu_items("Filters") if "(VoroGeo)" in item]


class Loading:
    """The steps, in order, in one window."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.seen: dict[str, object] = {"source": SOURCE}

    def run(self) -> None:
        """Everything; what was seen before a step failed is kept."""
        with not_installed():
            window = MeshLabWindow([self.folder / "meshes" / "terrain.ply"], self.folder / "loading.log")
        try:
            self.seen["before"] = filters(window)
            self.load(window)
            self.seen["after"] = filters(window)
            dialog = window.open_filter(EXACT_FROM_POINT)
            window.fill(dialog, "Start vertex", str(SOURCE))
            self.seen["applied"] = window.apply(dialog)
            window.close(dialog)
            self.seen["alive"] = window.is_alive()
        finally:
            window.picture(self.folder / "shots" / "loading_last.png")
            self.seen["log"] = window.log_lines()
            (self.folder / "loading.json").write_text(json.dumps(self.seen, indent=1))

    def load(self, window: MeshLabWindow) -> None:
        """Help, Plugin Info, Load Plugins."""
        plugin = self.folder.parent / "plugin" / "plugin" / INSTALLED.name
        window.choose_in_menu("Help", "Plugin Info")
        box = wait_for("the list of plugins", window.message_box)
        window.press(box, "Load Plugins")
        window.give_file("Load Plugins", plugin)

        def names() -> list[str]:
            return [node.get_name() for node in window.nodes(box) if node.get_role() == Atspi.Role.TABLE_CELL]

        wait_for("the plugin in the list", lambda: "FilterVorogeo" in names())
        window.click(window.find(Atspi.Role.TABLE_CELL, names()[0], box)[0])
        window.keys("End")
        wait_for("the end of the list", lambda: window.find(Atspi.Role.TABLE_CELL, "FilterVorogeo", box))
        window.picture(self.folder / "shots" / "plugin_info.png")
        window.keys("Escape")
        wait_for("the list of plugins to close", lambda: window.message_box() is None)


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    home = folder / "home"  # where MeshLab keeps plugins that were loaded so
    home.mkdir(exist_ok=True)
    os.environ["HOME"] = str(home)
    start_display(folder)
    Loading(folder).run()
