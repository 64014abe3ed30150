"""Uses the plugin in MeshLab's window as a person does, and writes down what was seen.

Usage (inside a root, within dbus-run-session): python3 scenario.py FOLDER
  FOLDER holds meshes/; pictures go to shots/, saved meshes stay in meshes/, all else that was seen goes to
  scenario.json, which test_window.py judges.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

from meshlab_window import MeshLabWindow
from screen import Atspi, start_display

FROM_POINT = "Geodesic distance from a given point (VoroGeo)"
EXACT_FROM_POINT = "Exact geodesic distance from a given point (VoroGeo)"
FROM_SELECTION = "Geodesic distance from the selection (VoroGeo)"
FROM_BORDER = "Geodesic distance from the border (VoroGeo)"
COMPARISON = "Compare geodesic methods (VoroGeo)"
SAVE_INDEX = "Geodesic index: save to file (VoroGeo)"
LOAD_INDEX = "Geodesic index: load from file (VoroGeo)"
DESCRIBE_INDEX = "Geodesic index: describe (VoroGeo)"
PATCHES = "Geodesic Voronoi patches: colour faces (VoroGeo)"
SOURCE = 1234


class Scenario:
    """The steps, in order, on one window after the other."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.seen: dict[str, object] = {"source": SOURCE, "dialogs": {}, "help": {}, "fields": {}, "errors": {}}
        (folder / "shots").mkdir(parents=True, exist_ok=True)

    def picture(self, window: MeshLabWindow, name: str) -> None:
        """Keep a picture of the screen."""
        window.picture(self.folder / "shots" / f"{name}.png")

    def run(self) -> None:
        """Everything; what was seen before a step failed is kept."""
        log = self.folder / "meshlab.log"
        window = MeshLabWindow([self.folder / "meshes" / "terrain.ply"], log)
        try:
            self.seen["start"] = window.log_text()
            self.seen["menu"] = [item for item in window.menu_items("Filters") if "(VoroGeo)" in item]
            self.picture(window, "start")
            self.look_at_dialogs(window)
            self.apply_filters(window)
            self.keep_the_index(window)
            self.meet_errors(window)
            self.seen["alive"] = window.is_alive()
        finally:
            self.picture(window, "last")
            self.seen["log"] = window.log_lines()
            self.seen["messages"] = window.log_text()
            (self.folder / "scenario.json").write_text(json.dumps(self.seen, indent=1))

    def look_at_dialogs(self, window: MeshLabWindow) -> None:
        """Open the dialog of every filter and write down its parameters."""
        names = sorted({item.rpartition("/")[2] for item in self.seen["menu"]})
        for name in names:
            dialog = window.open_filter(name)
            self.seen["dialogs"][name] = (
                []
                if dialog is None
                else [
                    {"label": entry.label, "tooltip": entry.tooltip, "values": entry.values()}
                    for entry in window.parameters(dialog)
                ]
            )
            file = "".join(letter if letter.isalnum() else "_" for letter in name.removesuffix(" (VoroGeo)").lower())
            if dialog is not None:
                texts = [node.get_name() for node in window.find(Atspi.Role.LABEL, top=dialog)]
                self.seen["help"][name] = max(texts, key=len)
                self.picture(window, f"dialog_{file}")
                window.close(dialog)

    def apply_filters(self, window: MeshLabWindow) -> None:
        """Fields with and without the index, patches; each field is saved."""
        for key, name in (("index", FROM_POINT), ("exact", EXACT_FROM_POINT)):
            dialog = window.open_filter(name)
            window.fill(dialog, "Start vertex", str(SOURCE))
            if key == "index":
                window.fill(dialog, "Method", "index")
            self.seen["errors"][f"apply {name}"] = window.apply(dialog)
            self.picture(window, f"field_{key}")
            window.close(dialog)
            self.save(window, key)
        dialog = window.open_filter(FROM_BORDER)
        self.seen["errors"][f"apply {FROM_BORDER}"] = window.apply(dialog)
        window.close(dialog)
        self.save(window, "border")
        dialog = window.open_filter(PATCHES)
        window.fill(dialog, "Layer", "2")
        self.seen["errors"][f"apply {PATCHES}"] = window.apply(dialog)
        window.close(dialog)
        self.picture(window, "patches")
        dialog = window.open_filter(COMPARISON)
        window.fill(dialog, "Start vertex", str(SOURCE))
        window.fill(dialog, "Method", "Fast marching (MeshLab)")
        self.seen["errors"][f"apply {COMPARISON}"] = window.apply(dialog)
        self.picture(window, "comparison")
        window.close(dialog)
        self.save(window, "comparison")

    def keep_the_index(self, window: MeshLabWindow) -> None:
        """Write the index to a file, read it again, look at it."""
        file = str(self.folder / "terrain.vgi")
        for name in (SAVE_INDEX, LOAD_INDEX):
            dialog = window.open_filter(name)
            window.fill(dialog, "Index file", file)
            self.seen["errors"][f"apply {name}"] = window.apply(dialog)
            window.close(dialog)
        dialog = window.open_filter(DESCRIBE_INDEX)
        self.seen["errors"][f"apply {DESCRIBE_INDEX}"] = window.apply(dialog)
        window.close(dialog)
        self.picture(window, "index_in_the_log")

    def save(self, window: MeshLabWindow, key: str) -> None:
        """Save the layer and keep the file under a name of its own."""
        window.export()
        file = self.folder / "meshes" / "terrain.ply"
        (self.folder / f"field_{key}.ply").write_bytes(file.read_bytes())
        self.seen["fields"][key] = f"field_{key}.ply"

    def meet_errors(self, window: MeshLabWindow) -> None:
        """What is refused is said in a message box; MeshLab goes on working."""
        dialog = window.open_filter(FROM_POINT)
        window.fill(dialog, "Start vertex", "999999")
        self.error(window, dialog, "vertex out of range")
        window.fill(dialog, "Start vertex", str(SOURCE))
        window.fill(dialog, "Max distance", "-1")
        self.error(window, dialog, "negative limit")
        window.close(dialog)
        dialog = window.open_filter(FROM_SELECTION)
        self.error(window, dialog, "empty selection")
        window.close(dialog)
        dialog = window.open_filter(FROM_POINT)
        window.fill(dialog, "Start vertex", str(SOURCE))
        self.seen["after errors"] = window.apply(dialog)
        window.close(dialog)

    def error(self, window: MeshLabWindow, dialog: object, name: str) -> None:
        """Apply, write down the message box, close it."""
        self.seen["errors"][name] = window.apply(dialog)
        self.picture(window, f"error_{name.replace(' ', '_')}")
        window.dismiss()


if __name__ == "__main__":
    start_display(Path(sys.argv[1]))
    Scenario(Path(sys.argv[1])).run()
