"""Measures with the geodesic ruler in MeshLab's window, by the mouse, and writes down what was seen.

Usage (inside a root, within dbus-run-session): python3 ruler.py FOLDER [NAME]
  FOLDER holds meshes/; all that was seen goes to ruler.json, which test_ruler.py judges, with what the ruler saved:
  ruler.csv and ruler_paths.ply. NAME: only frames a second on meshes/NAME.ply, and what else a large mesh is for.
"""

from __future__ import annotations

import json
import sys
import time
from itertools import pairwise
from pathlib import Path

from meshlab_window import MeshLabWindow, text_of
from screen import Atspi, run, start_display, wait_for

TOOL = "Geodesic ruler (VoroGeo)"
SCALE = "Transform: Scale, Normalize"
DELETE = "Delete Current Mesh"
DOCK = "Geodesic ruler"
COLUMNS = 6
HINTS = ("Drag on", "Click on")
STEPS = 30  # of a drag
# Places of the view: from its middle, in heights of the view, y upwards.
SPHERE_LEFT, SPHERE_RIGHT = (-0.3, 0.0), (-0.12, 0.1)
PLATE_LEFT, PLATE_RIGHT = (0.08, 0.04), (0.31, 0.06)
SMALL_SQUARE, EMPTY = (0.197, -0.167), (0.0, 0.3)
LARGE_LEFT, LARGE_RIGHT = (-0.1, 0.15), (0.1, -0.05)
Place = tuple[float, float]


class RulerWindow(MeshLabWindow):
    """A window with the ruler."""

    def __init__(self, meshes: list[Path], log: Path) -> None:
        """Start MeshLab and find the view."""
        super().__init__(meshes, log)
        panes = [self.box(pane) for pane in self.find(Atspi.Role.LAYERED_PANE)]
        left, top, width, self.height = max(panes, key=lambda pane: pane[2] * pane[3])
        self.middle = (left + width / 2, top + self.height / 2)

    def toggle(self) -> None:
        """Start or end the ruler."""
        was_on = self.dialog(DOCK) is not None
        self.choose_in_menu("Edit", TOOL)
        wait_for("the ruler to start or end", lambda: (self.dialog(DOCK) is not None) != was_on)
        time.sleep(0.5)

    def pixel(self, place: Place) -> list[str]:
        """Where on the screen a place of the view is: from the middle, in heights of the view, y upwards."""
        x, y = place
        return [str(round(self.middle[0] + x * self.height)), str(round(self.middle[1] - y * self.height))]

    def drag(self, *places: Place, pause: float = 0.03) -> None:
        """Press at the first place, move over the others, release at the last."""
        command = ["mousemove", *self.pixel(places[0]), "sleep", "0.2", "mousedown", "1", "sleep", "0.3"]
        for a, b in pairwise(places):
            for step in range(1, STEPS + 1):
                t = step / STEPS
                between = (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))
                command += ["mousemove", *self.pixel(between), "sleep", str(pause)]
        run("xdotool", *command, "sleep", "0.3", "mouseup", "1")

    def click_at(self, *places: Place, times: int = 1) -> None:
        """Click on the places one after the other, the last one so many times."""
        for place in places:
            count = times if place == places[-1] else 1
            run("xdotool", "mousemove", *self.pixel(place), "sleep", "0.3")
            run("xdotool", "click", "--repeat", str(count), "--delay", "80", "1")
            time.sleep(0.7)  # no double click with the next one

    def hold(self, *places: Place) -> None:
        """Press at the first place, move over the others, and hold the button."""
        run("xdotool", "mousemove", *self.pixel(places[0]), "sleep", "0.2", "mousedown", "1", "sleep", "0.3")
        for place in places[1:]:
            run("xdotool", "mousemove", *self.pixel(place), "sleep", "0.7")

    def let_go(self) -> None:
        """Release the button."""
        run("xdotool", "mouseup", "1", "sleep", "0.7")

    def choices(self) -> list[Atspi.Accessible]:
        """The lists of the dock: kind, unit, where points snap, metric."""
        return self.find(Atspi.Role.COMBO_BOX, top=self.dock())

    def number(self, name: str) -> Atspi.Accessible:
        """The field of the dock for a number."""
        return self.find(Atspi.Role.TEXT, name, self.dock())[0]

    def choose_kind(self, kind: str) -> None:
        """Choose what is measured next."""
        self.choose(self.choices()[0], kind)

    def choose_unit(self, unit: str) -> None:
        """Choose what coordinates count in."""
        self.choose(self.choices()[1], unit)

    def choose_metric(self, metric: str) -> None:
        """Choose what paths cost."""
        self.choose(self.choices()[3], metric)

    def cell(self, text: str) -> Atspi.Accessible:
        """The cell of the table with this text."""
        return wait_for(f"the cell {text}", lambda: self.find(Atspi.Role.TABLE_CELL, text, self.dock()))[0]

    def rows(self) -> list[list[str]]:
        """The table of the dock, empty without a dock."""
        if self.dialog(DOCK) is None:
            return []
        for table in self.find(Atspi.Role.TABLE):
            names = [node.get_name() for node in self.nodes(table) if node.get_role() == Atspi.Role.TABLE_CELL]
            if names and len(names) % COLUMNS == 0 and names[0].isdigit():
                return [names[i : i + COLUMNS] for i in range(0, len(names), COLUMNS)]
        return []

    def ruler_lines(self) -> list[str]:
        """What the ruler wrote into the log."""
        return [line for line in self.log_lines() if line.startswith("Ruler: ")]

    def dock(self) -> Atspi.Accessible:
        """The ruler's dock."""
        return wait_for("the dock", lambda: self.dialog(DOCK))

    def buttons(self, begin: str) -> list[str]:
        """Names of buttons of the dock that begin so."""
        names = [node.get_name() for node in self.find(Atspi.Role.PUSH_BUTTON, top=self.dock())]
        return [name for name in names if name.startswith(begin)]

    def status(self) -> str:
        """What the dock says answers."""
        labels = [node.get_name() for node in self.find(Atspi.Role.LABEL, top=self.dock())]
        return next(label for label in labels if not label.startswith(HINTS))

    def make_current(self, name: str) -> None:
        """Choose a layer; 2022.02 shows the names of files with their endings."""
        names = [node.get_name() for node in self.find(Atspi.Role.TABLE_CELL)]
        self.choose_layer(next(n for n in names if n.removesuffix(".ply").removesuffix(" *") == name))

    def layers(self) -> list[str]:
        """Names in the list of layers."""
        in_dock = self.find(Atspi.Role.TABLE_CELL, top=self.dock())
        cells = [cell for cell in self.find(Atspi.Role.TABLE_CELL) if cell not in in_dock]
        return [cell.get_name() for cell in cells if cell.get_name()]

    def wait_for_rows(self, count: int) -> None:
        """Wait until the table has so many rows."""
        wait_for(f"{count} measurements", lambda: len(self.rows()) == count, 60, self.is_alive)

    def pasted(self, title: str) -> str:
        """What the clipboard holds, seen in a dialog that asks for a file; its field shows line ends as other signs."""
        wait_for(f"the dialog {title}", lambda: self.dialog(title))
        self.keys("ctrl+a", "ctrl+v")
        time.sleep(0.5)
        text = max((text_of(node) for node in self.find(Atspi.Role.TEXT, top=self.dialog(title))), key=len)
        self.keys("ctrl+a")
        return text

    def export_as(self, name: str, file: Path) -> None:
        """Save the current layer, a measurement's, to a file, with everything it has."""
        already = len(self.log_lines())
        self.keys("ctrl+shift+e")
        self.give_file(f'Save "{name}" Layer', file)
        box = wait_for("the dialog of saving options", self.message_box)
        self.click(self.find(Atspi.Role.RADIO_BUTTON, "All", box)[0])
        self.press(box, "OK")
        wait_for("the layer to be saved", lambda: any("Saved" in line for line in self.log_lines()[already:]))

    def wait_for_line(self, begin: str, already: int, seconds: float = 60) -> None:
        """Wait for one more line of the ruler."""
        wait_for(
            f"a line '{begin}'",
            lambda: any(line.startswith(f"Ruler: {begin}") for line in self.ruler_lines()[already:]),
            seconds,
            self.is_alive,
        )


class Ruler:
    """The steps, in order, in one window after the other."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.seen: dict[str, object] = {"tables": {}}
        (folder / "shots").mkdir(parents=True, exist_ok=True)

    def run(self, name: str | None) -> None:
        """Everything, or one mesh; what was seen before a step failed is kept."""
        try:
            if name is None:
                self.measure_shapes()
            self.measure_a_large_mesh(name or "terrain_20k")
        finally:
            (self.folder / "ruler.json").write_text(json.dumps(self.seen, indent=1))

    def window(self, *names: str) -> RulerWindow:
        """A window with these meshes."""
        meshes = [self.folder / "meshes" / f"{name}.ply" for name in names]
        return RulerWindow(meshes, self.folder / f"ruler_{names[-1]}.log")

    def note(self, window: RulerWindow, key: str) -> None:
        """Keep the table and a picture."""
        self.seen["tables"][key] = window.rows()
        window.picture(self.folder / "shots" / f"ruler_{key}.png")

    def measure_shapes(self) -> None:
        """A sphere and a plate with a hole, as two layers of one project."""
        window = self.window("sphere", "plate")
        try:
            self.seen["start"] = window.log_text()
            window.toggle()
            self.plate_and_sphere(window)
            self.keep_and_leave(window)
            self.hostile_steps(window)
        finally:
            window.picture(self.folder / "shots" / "ruler_shapes_last.png")
            self.seen["lines"] = window.ruler_lines()
            self.seen["log"] = window.log_lines()
            window.process.kill()

    def plate_and_sphere(self, window: RulerWindow) -> None:
        """Paths on the current layer; nothing beside it, on another layer, to another component."""
        window.drag(PLATE_LEFT, PLATE_RIGHT)
        window.wait_for_rows(1)
        self.note(window, "plate")
        window.drag(EMPTY, PLATE_RIGHT)
        window.drag(SPHERE_LEFT, SPHERE_RIGHT)
        time.sleep(1.0)
        self.note(window, "beside the layer")
        window.drag(PLATE_LEFT, SMALL_SQUARE)
        window.wait_for_rows(2)
        self.note(window, "other component")
        window.make_current("sphere")
        window.drag(SPHERE_LEFT, SPHERE_RIGHT)
        window.wait_for_rows(3)
        self.note(window, "sphere")

    def keep_and_leave(self, window: RulerWindow) -> None:
        """A field, the saved files, leaving and entering again, removing a row."""
        already = len(window.ruler_lines())
        run("xdotool", "keydown", "shift")
        window.drag(SPHERE_LEFT, SPHERE_RIGHT)
        run("xdotool", "keyup", "shift")
        window.wait_for_line("distances", already)
        self.note(window, "field")
        window.drag(EMPTY, EMPTY)  # the view has the keys
        window.keys("ctrl+c")
        window.press(window.dock(), "Save...")
        self.seen["copied"] = window.pasted("Save measurements")
        window.give_file("Save measurements", self.folder / "ruler.csv")
        window.wait_for_line("measurements written", already)
        window.toggle()
        self.note(window, "left")
        window.toggle()
        self.note(window, "entered again")
        window.drag(EMPTY, EMPTY)
        window.keys("Delete")
        wait_for("a row less", lambda: len(window.rows()) == 2)
        self.note(window, "deleted")
        self.seen["layers"] = window.layers()
        window.make_current("distance 3")
        window.export_as("distance 3", self.folder / "ruler_paths.ply")

    def hostile_steps(self, window: RulerWindow) -> None:
        """Another tool, a layer deleted while its paths are shown, the project closed while the tool is on."""
        self.seen["on a layer without faces"] = window.status()
        window.drag(SPHERE_LEFT, SPHERE_RIGHT)
        window.toggle()
        window.choose_in_menu("Edit", "Measuring Tool")
        window.drag(SPHERE_LEFT, SPHERE_RIGHT)
        window.choose_in_menu("Edit", "Measuring Tool")
        window.make_current("plate")
        window.toggle()
        window.apply_at_once(DELETE)
        window.make_current("sphere")
        window.toggle()
        self.note(window, "layer deleted")
        window.drag(SPHERE_LEFT, SPHERE_RIGHT)
        window.wait_for_rows(3)
        window.toggle()
        window.choose_in_menu("Windows", "Split current view", "Vertically")
        window.drag(PLATE_RIGHT, PLATE_RIGHT)  # makes the second view the current one
        window.toggle()
        self.note(window, "second view")
        window.choose_in_menu("File", "Close Project")
        window.close_without_saving()
        time.sleep(2.0)
        window.picture(self.folder / "shots" / "ruler_closed.png")
        self.seen["alive"] = window.is_alive()

    def measure_a_large_mesh(self, name: str) -> None:
        """Frames a second without and with an index; an edit; quitting while an index is built."""
        window = self.window(name)
        try:
            window.toggle()
            there_and_back = (LARGE_LEFT, LARGE_RIGHT, LARGE_LEFT, LARGE_RIGHT)
            for key in ("exact", "with index"):
                for _ in range(2):
                    already, before = len(window.ruler_lines()), window.processor_seconds()
                    window.drag(*there_and_back, pause=0.015)
                    window.wait_for_line("distance ", already)
                after = window.processor_seconds()
                self.seen[f"processor seconds {key}"] = {kind: after[kind] - before[kind] for kind in after}
                self.note(window, f"large {key}")
                self.seen[f"status {key}"] = window.status()
                if key == "exact":
                    window.press(window.dock(), *window.buttons("Prepare"))
                    window.drag(LARGE_LEFT, LARGE_RIGHT)
                    window.wait_for_line("the index was built", already, 600)
            already = len(window.ruler_lines())
            run("xdotool", "keydown", "shift")
            window.drag(*there_and_back, pause=0.015)
            run("xdotool", "keyup", "shift")
            window.wait_for_line("distances", already)
            dialog = window.open_filter(SCALE)
            window.fill(dialog, "X Axis", "2")
            window.apply(dialog)
            window.close(dialog)
            window.toggle()
            self.note(window, "large edited")
            self.seen["status edited"] = window.status()
            window.press(window.dock(), *window.buttons("Prepare"))
            self.seen["building"] = wait_for("the build to begin", lambda: window.buttons("Cancel"), 10)
            self.seen["seconds to quit"] = window.quit()
        finally:
            self.seen["large lines"] = window.ruler_lines()
            window.process.kill()


if __name__ == "__main__":
    start_display(Path(sys.argv[1]))
    Ruler(Path(sys.argv[1])).run(sys.argv[2] if len(sys.argv) > 2 else None)
