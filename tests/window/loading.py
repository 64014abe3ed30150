"""Loads the plugin by MeshLab's own dialog, where it is not installed, and applies a filter (see script.py).

FOLDER/../plugin is the built plugin.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from filter_names import EXACT_FROM_POINT
from meshlab_window import MeshLabWindow
from screen import Atspi, wait_for
from script import Script

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


class Loading(Script):
    """The steps, in order, in one window."""

    home = "home"  # where MeshLab keeps plugins that were loaded so

    def open(self) -> MeshLabWindow:
        """A window without our filters."""
        with not_installed():
            return super().open()

    def steps(self) -> None:
        """Everything."""
        self.seen["source"] = SOURCE
        self.seen["before"] = filters(self.window)
        self.load()
        self.seen["after"] = filters(self.window)
        self.seen["applied"] = self.use(EXACT_FROM_POINT, {"Start vertex": str(SOURCE)})

    def load(self) -> None:
        """Help, Plugin Info, Load Plugins."""
        plugin = self.folder.parent / "plugin" / "plugin" / INSTALLED.name
        self.window.choose_in_menu("Help", "Plugin Info")
        box = wait_for("the list of plugins", self.window.message_box)
        self.window.press(box, "Load Plugins")
        self.window.give_file("Load Plugins", plugin)

        def names() -> list[str]:
            return [node.get_name() for node in self.window.nodes(box) if node.get_role() == Atspi.Role.TABLE_CELL]

        wait_for("the plugin in the list", lambda: "FilterVorogeo" in names())
        self.window.click(self.window.find(Atspi.Role.TABLE_CELL, names()[0], box)[0])
        self.window.keys("End")
        wait_for("the end of the list", lambda: self.window.find(Atspi.Role.TABLE_CELL, "FilterVorogeo", box))
        self.picture("plugin_info")
        self.window.keys("Escape")
        wait_for("the list of plugins to close", lambda: self.window.message_box() is None)


if __name__ == "__main__":
    Loading.main()
