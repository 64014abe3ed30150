"""Installs the plugin into the user's folder of extra plugins, by the documented command, and starts MeshLab.

FOLDER/../plugin is the built plugin (see script.py).
"""

from __future__ import annotations

from filter_names import EXACT_FROM_POINT
from loading import SOURCE, filters, not_installed
from meshlab_window import MeshLabWindow
from screen import run
from script import Script


class ExtraFolder(Script):
    """The steps, in order, in one window."""

    home = "home_with_plugin"

    def open(self) -> MeshLabWindow:
        """A window that finds our filters among the user's."""
        with not_installed():
            run("cmake", "--install", str(self.folder.parent / "plugin"), "--component", "user")
            return super().open()

    def steps(self) -> None:
        """Everything."""
        self.seen["source"] = SOURCE
        self.seen["filters"] = filters(self.window)
        self.seen["applied"] = self.use(EXACT_FROM_POINT, {"Start vertex": str(SOURCE)})


if __name__ == "__main__":
    ExtraFolder.main()
