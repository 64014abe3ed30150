"""Asks MeshLab's window for what cannot be done, then for points and layers (see script.py).

Needs terrain.vgi, which scenario.py saves.
"""

from __future__ import annotations

from bad_input import BAD_INPUT, FINITE_AGAIN, GEOMETRIC_FUNCTION, LAYER, NO_PATH, NOT_FINITE, PATH
from filter_names import FROM_POINT
from script import Script

PICKED = (1.1, 0.7, 0.3)
PICTURED = ("point cloud", "index of another mesh", "vertex out of range")


class Refusals(Script):
    """The steps, in order, in one window."""

    meshes = ("terrain", "points", "torus", "parts")

    def steps(self) -> None:
        """Everything."""
        self.seen |= {"boxes": {}, "no path": {}, "picked": PICKED}
        index = (self.folder / "terrain.vgi").read_bytes()
        (self.folder / "truncated.vgi").write_bytes(index[: len(index) // 2])
        (self.folder / "wrong.vgi").write_bytes(b"no index " * 100)
        for case in BAD_INPUT:
            self.window.choose_layer(case.layer)
            fields = {label: value.replace("FOLDER", str(self.folder)) for label, value in case.fields.items()}
            picture = f"refused_{case.name.replace(' ', '_')}" if case.name in PICTURED else ""
            self.seen["boxes"][case.name] = self.use(case.filter, fields, picture)
        self.no_path()
        self.not_finite()
        self.window.choose_layer("terrain")
        self.point_and_layer()

    def no_path(self) -> None:
        """Ask for what no path leads to, and keep what the log says."""
        self.window.choose_layer("parts")
        for case in NO_PATH:
            already = len(self.window.log_lines())
            box = self.use(case.filter, case.fields)
            self.seen["no path"][case.name] = {"box": box, "log": self.window.log_lines()[already:]}

    def not_finite(self) -> None:
        """Ask for distances on a mesh with a coordinate that is not a finite number, then on the corrected mesh."""
        for name, formula in {**NOT_FINITE, "finite again": FINITE_AGAIN}.items():
            self.use(GEOMETRIC_FUNCTION, {"func x = ": formula, "func z = ": "z"})  # by default a function of x
            self.seen["boxes"][name] = self.use(FROM_POINT, {"Start vertex": "5"})

    def point_and_layer(self) -> None:
        """After all the refusals: a start point, a layer of points, a path."""
        for key, name, fields in (
            ("start_point", FROM_POINT, {"Start point": tuple(map(str, PICKED))}),
            ("source_layer", LAYER, {"Source layer": "points.ply"}),
            ("path", PATH, {"Source vertex": "35", "Target vertex": "3460"}),
        ):
            self.seen[key] = self.use(name, fields, picture=key)


if __name__ == "__main__":
    Refusals.main()
