"""What the scripts share that drive MeshLab's window: steps in one window, and a file of what was seen."""

from __future__ import annotations

import json
import os
import sys
from abc import ABC, abstractmethod
from pathlib import Path

from meshlab_window import MeshLabWindow
from screen import start_display

Fields = dict[str, str | tuple[str, ...]]


class Script(ABC):
    """Steps in a window with some meshes of FOLDER/meshes.

    All that was seen goes to FOLDER/NAME.json, also if a step fails, where NAME is that of the script: there test_*.py
    judges it. Pictures go to FOLDER/shots.
    """

    meshes: tuple[str, ...] = ("terrain",)
    window_type = MeshLabWindow
    density = 1  #: pixels of the display for each of the window, on each axis
    home = ""  #: a folder in FOLDER where MeshLab finds what the user has; by default the user's own

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.name = Path(sys.modules[type(self).__module__].__file__ or "").stem
        self.seen: dict = {}
        (folder / "shots").mkdir(parents=True, exist_ok=True)

    @classmethod
    def main(cls) -> None:
        """Run the script as a program."""
        folder = Path(sys.argv[1])
        if cls.home:
            (folder / cls.home).mkdir(exist_ok=True)
            os.environ["HOME"] = str(folder / cls.home)
        start_display(folder, cls.density)
        cls(folder).run()

    def open(self) -> MeshLabWindow:
        """The window with the meshes."""
        return self.window_type([self.mesh(name) for name in self.meshes], self.folder / f"{self.name}.log")

    def mesh(self, name: str) -> Path:
        """The file of a mesh."""
        return self.folder / "meshes" / f"{name}.ply"

    def run(self) -> None:
        """Everything; what was seen before a step failed is kept."""
        self.window = self.open()
        try:
            self.steps()
            self.seen["alive"] = self.window.is_alive()
        finally:
            self.picture(f"{self.name}_last")
            self.seen["log"] = self.window.log_lines()
            (self.folder / f"{self.name}.json").write_text(json.dumps(self.seen, indent=1))

    @abstractmethod
    def steps(self) -> None:
        """What the script does."""

    def picture(self, name: str) -> None:
        """Keep a picture of the screen."""
        self.window.picture(self.folder / "shots" / f"{name}.png")

    def use(self, name: str, fields: Fields | None = None, picture: str = "") -> str:
        """Fill in the dialog of a filter, if it has one, and apply it. Returns what a message box says."""
        dialog = self.window.open_filter(name)
        if dialog is None:
            return ""
        for label, values in (fields or {}).items():
            self.window.fill(dialog, label, *([values] if isinstance(values, str) else values))
        box = self.window.apply(dialog)
        if picture:
            self.picture(picture)
        if box:
            self.window.dismiss()
        self.window.close(dialog)
        return box

    def export(self, key: str) -> str:
        """Save the layer over its mesh, and keep that as field_KEY.ply."""
        self.window.export()
        (self.folder / f"field_{key}.ply").write_bytes(self.mesh("terrain").read_bytes())
        return f"field_{key}.ply"
