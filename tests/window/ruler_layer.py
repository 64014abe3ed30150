"""Measures with the geodesic ruler on a layer before and after its matrix scales it (see script.py)."""

from __future__ import annotations

from ruler import PLATE_LEFT, PLATE_RIGHT, SCALE, RulerWindow
from script import Script

FACTOR = "1.1"


class RulerLayer(Script):
    """Drags between the same places of the view; only the layer's matrix changes, by which the first gets stale."""

    meshes = ("sphere", "plate")
    window_type = RulerWindow

    def steps(self) -> None:
        """Everything."""
        self.measure(1)
        self.use(SCALE, {"X Axis": FACTOR, "Freeze Matrix": "no"})
        self.measure(2)
        self.seen["rows"] = self.window.rows()

    def measure(self, count: int) -> None:
        """One more measurement, with the ruler on."""
        self.window.toggle()
        self.window.drag(PLATE_LEFT, PLATE_RIGHT)
        self.window.wait_for_rows(count)
        if count == 1:
            self.window.toggle()


if __name__ == "__main__":
    RulerLayer.main()
