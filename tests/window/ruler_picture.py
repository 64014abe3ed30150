"""Makes the animated picture of the documents: a drag with the geodesic ruler, then one with Shift.

Usage (inside a root, within dbus-run-session): python3 ruler_picture.py FOLDER MESH PICTURE
  Frames go to FOLDER; PICTURE is a GIF of less than 2 MB. In the project, for example:
  tests/roots/in_root.sh build/window/root-2025.07 dbus-run-session -- python3 /project/tests/window/ruler_picture.py \
    /project/build/window/picture /project/build/window/picture/bunny.obj /project/docs/pictures/ruler.gif
"""

from __future__ import annotations

import sys
import time
from itertools import pairwise
from pathlib import Path

from ruler import Place, RulerWindow
from screen import Atspi, run, start_display

START: Place = (-0.12, 0.16)
OVER: tuple[Place, ...] = ((0.0, 0.05), (0.14, -0.12), (0.02, -0.17), (-0.1, -0.1))
FIELD: tuple[Place, ...] = ((-0.1, -0.1), (0.05, -0.05), (0.13, -0.1))
STEPS = 9  # between two places
COLORS = 96


def film(window: RulerWindow, folder: Path, places: tuple[Place, ...]) -> None:
    """Drag over the places, a picture at each step."""
    run("xdotool", "mousemove", *window.pixel(places[0]), "sleep", "0.3", "mousedown", "1", "sleep", "0.5")
    for a, b in pairwise(places):
        for step in range(1, STEPS + 1):
            t = step / STEPS
            run("xdotool", "mousemove", *window.pixel((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))))
            time.sleep(0.5)
            frame(window, folder)
    run("xdotool", "mouseup", "1")
    time.sleep(1.0)
    for _ in range(4):
        frame(window, folder)


def frame(window: RulerWindow, folder: Path) -> None:
    """One more picture of the view."""
    side = round(0.74 * window.height)
    corner = (round(window.middle[0] - side / 2), round(window.middle[1] - side / 2))
    number = len(list(folder.glob("frame_*.png")))
    area = f"{side}x{side}+{corner[0]}+{corner[1]}"
    run("import", "-window", "root", "-crop", area, "+repage", str(folder / f"frame_{number:03d}.png"))


if __name__ == "__main__":
    folder, mesh, picture = (Path(argument) for argument in sys.argv[1:4])
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("frame_*.png"):
        old.unlink()
    start_display(folder)
    window = RulerWindow([mesh], folder / "picture.log")
    window.toggle()
    dock = window.dock().get_extents(Atspi.CoordType.SCREEN)
    title = (str(dock.x + 100), str(dock.y + 9))
    aside = (str(round(2 * window.middle[0]) + 120), title[1])
    run("xdotool", "mousemove", *title, "mousedown", "1", "mousemove", *aside, "sleep", "0.3", "mouseup", "1")
    film(window, folder, (START, *OVER))
    run("xdotool", "keydown", "shift")
    film(window, folder, FIELD)
    run("xdotool", "keyup", "shift")
    frames = [str(file) for file in sorted(folder.glob("frame_*.png"))]
    scale = ("-resize", "400x400", "-colors", str(COLORS), "-layers", "Optimize")
    run("convert", "-delay", "12", "-loop", "0", *frames, *scale, str(picture))
    window.process.kill()
