"""Chooses where points of the ruler snap and what paths cost, backs out of drags, saves and opens (see script.py)."""

from __future__ import annotations

from ruler import EMPTY, Place, RulerWindow
from ruler_table import BELOW, FIRST, SECOND
from screen import run, wait_for
from script import Script


def plate(x: float, y: float) -> Place:
    """The place of the view where a point of the plate is seen; from its middle."""
    return (0.1967 + 0.1511 * x, 0.0463 + 0.1515 * y)


LEFT, RIGHT = plate(-0.63, 0.57), plate(0.66, 0.52)
ABOVE_GAP, BELOW_GAP = plate(0.05, -0.7), plate(0.05, -1.4)
START, NEAR, FAR = plate(-0.8, 0.85), plate(-0.4, 0.85), plate(0.8, 0.85)
GAP = "0.25"
PENALTY = "2"


class RulerChoices(Script):
    """The steps, in order, in one window."""

    meshes = ("sphere", "plate")
    window_type = RulerWindow

    def steps(self) -> None:
        """Everything."""
        self.window.toggle()
        self.snap()
        self.cross_a_gap()
        self.weigh_by_quality()
        self.window.make_current("sphere")
        self.weigh_by_slope()
        self.back_out()
        self.preview()
        self.save_and_open()

    def distance(self, *places: Place) -> None:
        """One more measurement by a drag."""
        count = len(self.window.rows()) + 1
        self.window.drag(*places)
        self.window.wait_for_rows(count)

    def snap(self) -> None:
        """Paths between the same places of the view, with each key."""
        self.window.choose_kind("path")
        self.window.drag(EMPTY, EMPTY)  # the view has the keys
        self.seen["snaps"] = []
        for count, key in enumerate("vebf", start=1):
            self.window.keys(key)
            self.window.click_at(LEFT, RIGHT)
            self.window.keys("Return")
            self.window.wait_for_rows(count)
            self.seen["snaps"].append(self.window.choices()[2].get_name())
        self.picture("ruler_choices_snapped")
        self.window.choose_kind("distance")

    def cross_a_gap(self) -> None:
        """Between two components, without and with a bridge."""
        self.distance(ABOVE_GAP, BELOW_GAP)
        self.window.enter(self.window.number("gap"), GAP)
        self.distance(ABOVE_GAP, BELOW_GAP)
        self.picture("ruler_choices_gap")

    def color(self, place: Place) -> None:
        """Distances from a place, as quality."""
        already = len(self.window.ruler_lines())
        run("xdotool", "keydown", "shift")
        self.window.drag(NEAR, place)
        run("xdotool", "keyup", "shift")
        self.window.wait_for_line("distances", already)

    def weigh_by_quality(self) -> None:
        """The distance from a point as the cost, over the gap, too, which is kept when that is overwritten."""
        self.distance(START, NEAR)
        self.color(START)
        self.window.choose_metric("Vertex quality as cost")
        self.distance(NEAR, FAR)
        self.color(FAR)
        self.distance(NEAR, FAR)
        self.picture("ruler_choices_quality")
        self.window.choose_metric("Face quality as cost")
        self.seen["without quality"] = self.window.status()
        self.window.choose_metric("Length")
        self.window.enter(self.window.number("gap"), "0")

    def weigh_by_slope(self) -> None:
        """A path on the sphere that costs more on slopes; a number that is none."""
        self.window.choose_metric("Slope penalty")
        self.window.enter(self.window.number("weight"), "steep")
        self.seen["no number"] = self.window.status()
        self.window.enter(self.window.number("weight"), PENALTY)
        self.distance(FIRST, BELOW)
        self.picture("ruler_choices_slope")
        self.window.choose_metric("Length")

    def back_out(self) -> None:
        """Escape in the middle of a drag: nothing is measured."""
        self.seen["before"] = self.window.rows()
        for kind in ("tape", "disk", "distance"):
            self.window.choose_kind(kind)
            self.window.hold(FIRST, SECOND)
            self.window.keys("Escape")
            self.window.let_go()
        self.seen["backed out"] = self.window.rows()

    def preview(self) -> None:
        """What the dock says during a drag, without and with an index."""
        self.seen["during a drag"] = []
        for method in ("exact", "index"):
            self.window.hold(FIRST, SECOND)
            self.seen["during a drag"].append(self.window.status())
            self.window.let_go()
            if method == "exact":
                already = len(self.window.ruler_lines())
                self.window.press(self.window.dock(), *self.window.buttons("Prepare"))
                self.window.wait_for_line("the index was built", already)
        wait_for("the end of the drag", lambda: self.window.status().startswith("Paths"))

    def save_and_open(self) -> None:
        """The table from its CSV file; the rows of the other layer once that is current."""
        already = len(self.window.ruler_lines())
        file = self.folder / "ruler_choices.csv"
        self.window.press(self.window.dock(), "Save...")
        self.window.give_file("Save measurements", file)
        self.window.wait_for_line("measurements written", already)
        self.seen["saved"] = self.window.rows()
        for left in reversed(range(len(self.seen["saved"]))):
            self.window.press(self.window.dock(), "Delete")
            self.window.wait_for_rows(left)
        self.seen["lines before"] = len(self.window.ruler_lines())
        self.window.press(self.window.dock(), "Open...")
        self.window.give_file("Open measurements", file)
        self.window.wait_for_rows(len(self.seen["saved"]))
        self.seen["opened"] = self.window.rows()
        self.window.make_current("plate")
        self.window.wait_for_line("distance 9", self.seen["lines before"])
        self.picture("ruler_choices_opened")
        self.window.press(self.window.dock(), "Open...")
        self.window.give_file("Open measurements", self.mesh("plate"))
        self.seen["no table"] = wait_for(
            "the sentence", lambda: None if self.window.status().startswith("Paths") else self.window.status()
        )
        self.seen["lines"] = self.window.ruler_lines()


if __name__ == "__main__":
    RulerChoices.main()
