"""Takes MeshLab's own snapshot of what the ruler measured (see script.py)."""

from __future__ import annotations

import os
import shutil

from meshlab_window import MeshLabWindow
from ruler import RulerWindow
from screen import Atspi, wait_for
from script import Script

LEFT, RIGHT = (-0.2, 0.0), (0.2, 0.1)


class RulerSnapshot(Script):
    """The steps, in order, in one window."""

    meshes = ("sphere",)
    window_type = RulerWindow

    def open(self) -> MeshLabWindow:
        """Snapshots go to the folder in which the program was started."""
        self.snapshots = self.folder / self.name
        shutil.rmtree(self.snapshots, ignore_errors=True)
        self.snapshots.mkdir()
        os.chdir(self.snapshots)
        return super().open()

    def steps(self) -> None:
        """Everything."""
        self.window.toggle()
        self.window.drag(LEFT, RIGHT)
        self.window.wait_for_rows(1)
        self.seen["ends"] = (LEFT, RIGHT)
        self.seen["rows"] = self.window.rows()
        for multiplier in ("1", "2"):
            self.snapshot(multiplier)

    def snapshot(self, multiplier: str) -> None:
        """A file of the view, so many times as large."""
        already = set(self.snapshots.iterdir())
        self.window.choose_in_menu("File", "Save snapshot")
        box = wait_for("the dialog", self.window.message_box)
        self.window.enter(self.window.find(Atspi.Role.SPIN_BUTTON, top=box)[1], multiplier)
        self.window.press(box, "Save")
        wait_for("the file", lambda: set(self.snapshots.iterdir()) - already)


if __name__ == "__main__":
    RulerSnapshot.main()
