"""Makes the animated pictures of the documents: a drag with the geodesic ruler, one with Shift, a polygon and a tape.

Usage (inside a root, within dbus-run-session): python3 ruler_picture.py FOLDER MESH PICTURES
  Frames go to FOLDER; PICTURES gets ruler.gif and measuring_table.gif, of less than 1 MB each. For example:
  tests/roots/in_root.sh build/window/root-2025.07 dbus-run-session -- python3 /project/tests/window/ruler_picture.py \
    /project/build/window/picture /project/build/window/picture/bunny.obj /project/docs/pictures
"""

from __future__ import annotations

import sys
import time
from itertools import pairwise
from pathlib import Path

from ruler import Place, RulerWindow
from screen import run, start_display

START: Place = (-0.12, 0.16)
OVER: tuple[Place, ...] = ((0.0, 0.05), (0.14, -0.12), (0.02, -0.17), (-0.1, -0.1))
FIELD: tuple[Place, ...] = ((-0.1, -0.1), (0.05, -0.05), (0.13, -0.1))
CORNERS: tuple[Place, ...] = ((-0.02, 0.0), (0.17, -0.01), (0.19, -0.2), (0.0, -0.22))
EAR: tuple[Place, ...] = ((-0.1, 0.17), (0.0, 0.22))
STEPS = 7  # between two places
COLORS = 64


class Film:
    """Pictures of the view, one after the other, of which GIFs are made."""

    def __init__(self, window: RulerWindow, folder: Path) -> None:
        self.window = window
        self.folder = folder
        self.frames: list[str] = []

    def drag(self, *places: Place) -> None:
        """Drag over the places, a picture at each step."""
        run("xdotool", "mousemove", *self.window.pixel(places[0]), "sleep", "0.3", "mousedown", "1", "sleep", "0.5")
        for a, b in pairwise(places):
            for step in range(1, STEPS + 1):
                t = step / STEPS
                between = (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))
                run("xdotool", "mousemove", *self.window.pixel(between))
                time.sleep(0.5)
                self.add()
        run("xdotool", "mouseup", "1")
        time.sleep(1.0)

    def add(self, count: int = 1) -> None:
        """The view as it is, so many times."""
        side = round(0.74 * self.window.height)
        corner = (round(self.window.middle[0] - side / 2), round(self.window.middle[1] - side / 2))
        area = f"{side}x{side}+{corner[0]}+{corner[1]}"
        for _ in range(count):
            self.frames.append(str(self.folder / f"frame_{len(self.frames):03d}.png"))
            run("import", "-window", "root", "-crop", area, "+repage", self.frames[-1])

    def save(self, picture: Path) -> None:
        """A GIF of the pictures so far; then begin again."""
        scale = ("-resize", "400x400", "-colors", str(COLORS), "-layers", "Optimize")
        run("convert", "-delay", "14", "-loop", "0", *self.frames, *scale, str(picture))
        self.frames = []


if __name__ == "__main__":
    folder, mesh, pictures = (Path(argument) for argument in sys.argv[1:4])
    folder.mkdir(parents=True, exist_ok=True)
    start_display(folder)
    window = RulerWindow([mesh], folder / "picture.log")
    window.toggle()
    left, top, *_ = window.box(window.dock())
    title = (str(left + 100), str(top + 9))
    aside = (str(round(2 * window.middle[0]) + 120), title[1])
    run("xdotool", "mousemove", *title, "mousedown", "1", "mousemove", *aside, "sleep", "0.3", "mouseup", "1")
    film = Film(window, folder)
    window.choose_kind("polygon")
    for place in pairwise((CORNERS[0], *CORNERS)):
        film.drag(*place)
    window.keys("Return")
    time.sleep(1.0)
    film.add(4)
    window.choose_kind("tape")
    film.drag(*EAR)
    film.add(5)
    film.save(pictures / "measuring_table.gif")
    for _ in range(2):
        window.press(window.dock(), "Delete")
    window.choose_kind("distance")
    film.drag(START, *OVER)
    film.add(4)
    run("xdotool", "keydown", "shift")
    film.drag(*FIELD)
    run("xdotool", "keyup", "shift")
    film.add(4)
    film.save(pictures / "ruler.gif")
    window.process.kill()
