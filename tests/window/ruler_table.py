"""Measures by all kinds of the geodesic ruler, changes the table, and opens the project again (see script.py)."""

from __future__ import annotations

from meshlab_window import MeshLabWindow
from ruler import PLATE_LEFT, PLATE_RIGHT, SCALE, RulerWindow
from screen import run, wait_for
from script import Script

PROJECT = """<!DOCTYPE MeshLabDocument>
<MeshLabProject>
 <MeshGroup>
  <MLMesh label="sphere" visible="1" filename="sphere.ply">
   <MLMatrix44>
1 0 0 0
0 1 0 0
0 0 1 0
0 0 0 1
</MLMatrix44>
  </MLMesh>
 </MeshGroup>
 <RasterGroup/>
</MeshLabProject>
"""
# What the ruler wrote beside a project when its file was not yet a table.
OF_BEFORE = "VoroGeo measurements 1\nunit mm\nlast 1\nmeasurement 1 distance exact 7 9 0\nname distance 1\n"
# Places of the view, as in ruler.py: corners of a triangle beside the hole of the plate, and places on the sphere.
CORNERS = ((0.078, 0.166), (0.318, 0.166), (0.318, 0.106))
FIRST, SECOND, THIRD = (-0.28, 0.06), (-0.2, 0.12), (-0.13, 0.05)
BELOW, MOVED, ASIDE = (-0.24, -0.04), (-0.16, -0.02), (-0.2, 0.0)


class RulerTable(Script):
    """The steps, in order, in one window, and in another one with the same project."""

    window_type = RulerWindow

    def open(self) -> MeshLabWindow:
        """A project with the sphere, to which the plate is added."""
        project = self.folder / "meshes" / "table.mlp"
        project.write_text(PROJECT)
        return self.window_type([project, self.mesh("plate")], self.folder / f"{self.name}.log")

    def steps(self) -> None:
        """Everything."""
        self.window.toggle()
        self.measure_on_the_plate()
        self.window.make_current("sphere")
        self.measure_on_the_sphere()
        self.back_out()
        self.change_the_table()
        self.edit()
        self.reopen()
        self.open_beside_a_file_of_before()

    def note(self, key: str) -> None:
        """Keep the table and a picture."""
        self.seen[key] = self.window.rows()
        self.picture(f"ruler_table_{key}")

    def measure_on_the_plate(self) -> None:
        """A polygon, ended by a double click; a loop round the hole; an angle."""
        self.window.choose_kind("polygon")
        self.window.click_at(*CORNERS, times=2)
        self.window.wait_for_rows(1)
        self.window.choose_kind("loop")
        self.window.drag(PLATE_LEFT, PLATE_RIGHT)
        self.window.wait_for_rows(2)
        self.window.choose_kind("angle")
        self.window.click_at(CORNERS[1], CORNERS[0], CORNERS[2])
        self.window.wait_for_rows(3)
        self.note("plate")

    def measure_on_the_sphere(self) -> None:
        """A path, with a click for the camera and a point that is taken back; tape, disk, distance; a refused loop."""
        self.window.choose_kind("path")
        self.window.click_at(FIRST)
        self.window.keys("c")
        self.window.click_at(ASIDE)
        self.window.keys("c")
        self.window.click_at(SECOND, BELOW)
        self.picture("ruler_table_clicked")
        self.window.keys("BackSpace")
        self.window.click_at(THIRD)
        self.window.keys("Return")
        self.window.wait_for_rows(4)
        self.window.choose_kind("tape")
        self.window.drag(FIRST, ASIDE)
        self.window.wait_for_rows(5)
        self.window.choose_kind("disk")
        self.window.drag(THIRD, SECOND)
        self.window.wait_for_rows(6)
        self.window.choose_kind("distance")
        self.window.drag(FIRST, BELOW)
        self.window.wait_for_rows(7)
        self.note("sphere")
        self.window.choose_kind("loop")
        self.window.drag(FIRST, SECOND)
        self.seen["refused"] = wait_for(
            "the sentence", lambda: None if self.window.status().startswith("Paths") else self.window.status()
        )

    def back_out(self) -> None:
        """Escape takes points back; nothing is left that Return could end. A point is moved, with Ctrl."""
        self.window.choose_kind("path")
        self.window.click_at(FIRST, SECOND)
        self.window.keys("Escape", "Escape", "Return")
        self.window.choose_kind("distance")
        run("xdotool", "keydown", "ctrl")
        self.window.drag(BELOW, MOVED)
        run("xdotool", "keyup", "ctrl")
        before = self.seen["sphere"][6]
        wait_for("the moved point", lambda: self.window.rows()[6] != before)
        self.note("moved")

    def change_the_table(self) -> None:
        """Unit, name, tick, delete and undo; the CSV file."""
        self.window.choose_unit("mm")
        self.window.click(self.window.cell("disk 6"), times=2)
        self.window.write("neck, left")
        self.window.keys("Return")
        wait_for("the name", lambda: self.window.rows()[5][1] == "neck, left")
        self.window.click(self.window.cell("tape 5"))
        self.window.keys("space")
        self.note("changed")
        self.window.press(self.window.dock(), "Delete")
        self.window.wait_for_rows(6)
        self.window.press(self.window.dock(), "Undo")
        self.window.wait_for_rows(7)
        already = len(self.window.ruler_lines())
        self.window.press(self.window.dock(), "Save...")
        self.window.give_file("Save measurements", self.folder / "ruler_table.csv")
        self.window.wait_for_line("measurements written", already)

    def edit(self) -> None:
        """The sphere is scaled: its measurements say so, and are measured again."""
        self.use(SCALE, {"X Axis": "2"})
        self.window.toggle()
        self.note("edited")
        self.window.press(self.window.dock(), "Measure again")
        wait_for("new values", lambda: not any("before an edit" in row[5] for row in self.window.rows()))
        self.note("again")

    def reopen(self) -> None:
        """The project has the measurements in another window, and keeps them when it is saved under another name."""
        self.window.quit()
        self.seen["stored"] = (self.folder / "meshes" / "table.mlp.measurements").read_text()
        self.window = self.open()
        self.window.toggle()
        self.window.make_current("sphere")
        self.note("reopened")
        self.window.choose_in_menu("File", "Save Project As...")
        self.window.give_file("Save Project File", self.folder / "meshes" / "other.mlp")
        other = self.folder / "meshes" / "other.mlp.measurements"
        self.seen["stored again"] = wait_for(
            "the file beside the project", lambda: other.is_file() and other.read_text()
        )

    def open_beside_a_file_of_before(self) -> None:
        """The project has a file that the ruler cannot read, as it had one earlier."""
        self.window.quit()
        file = self.folder / "meshes" / "table.mlp.measurements"
        file.write_text(OF_BEFORE)
        file.with_name(f"{file.name}.unreadable").write_text("an earlier one")
        self.window = self.open()
        self.window.toggle()
        self.seen["unreadable line"] = wait_for(
            "the sentence", lambda: next((line for line in self.window.ruler_lines() if str(file) in line), None)
        )
        self.seen["unreadable rows"] = self.window.rows()
        self.seen["unreadable files"] = {path.name: path.read_text() for path in file.parent.glob(f"{file.name}*")}


if __name__ == "__main__":
    RulerTable.main()
