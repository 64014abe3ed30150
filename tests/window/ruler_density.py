"""The same on a display with two pixels for each of the window, on each axis (see script.py)."""

from __future__ import annotations

from ruler_snapshot import RulerSnapshot


class RulerDensity(RulerSnapshot):
    """The steps, in order, in one window."""

    density = 2


if __name__ == "__main__":
    RulerDensity.main()
