"""Keeps what was done in MeshLab's window as a filter script, and applies a script with another start (see script.py).

Beside filter_script.json there are the scripts, saved.mlx and applied.mlx, and the field, field_script.ply.
"""

from __future__ import annotations

from pathlib import Path

from filter_names import EXACT_FROM_POINT
from screen import Atspi, wait_for
from script import Script

FIRST, SECOND = 777, 2750


class FilterScript(Script):
    """The steps, in order, in one window."""

    def steps(self) -> None:
        """Everything."""
        self.seen |= {"first": FIRST, "second": SECOND}
        self.seen["applied"] = self.use(EXACT_FROM_POINT, {"Start vertex": str(FIRST)})
        self.save(self.folder / "saved.mlx")
        script = (self.folder / "saved.mlx").read_text()
        (self.folder / "applied.mlx").write_text(script.replace(f'"{FIRST}"', f'"{SECOND}"'))
        self.apply(self.folder / "applied.mlx")
        self.export("script")

    def show(self) -> Atspi.Accessible:
        """Filters, Show current filter script."""
        self.window.choose_in_menu("Filters", "Show current filter script")
        return wait_for("the filter script", self.window.message_box)

    def save(self, file: Path) -> None:
        """Save Script."""
        box = self.show()
        self.picture("filter_script")
        self.window.press(box, "Save Script")
        self.window.give_file("Save Filter Script File", file)
        wait_for("the script to be written", lambda: file.is_file() and "</FilterScript>" in file.read_text())
        self.window.press(box, "Close")
        wait_for("the filter script to close", lambda: self.window.message_box() is None)

    def apply(self, file: Path) -> None:
        """Clear Script, Open Script, Apply Script."""
        already = len(self.window.log_lines())
        box = self.show()
        self.window.press(box, "Clear Script")
        self.window.press(box, "Open Script")
        self.window.give_file("Open Filter Script File", file)
        self.window.press(box, "Apply Script")
        wait_for(
            "the script to be applied", lambda: any("Distances from" in x for x in self.window.log_lines()[already:])
        )
        wait_for("the filter script to close", lambda: self.window.message_box() is None)


if __name__ == "__main__":
    FilterScript.main()
