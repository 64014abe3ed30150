"""Uses the plugin in MeshLab's window as a person does: dialogs, fields, the index (see script.py)."""

from __future__ import annotations

from filter_names import DESCRIBE, EXACT_FROM_POINT, FROM_POINT, LOAD, SAVE
from screen import Atspi
from script import Script

FROM_BORDER = "Geodesic distance from the border (VoroGeo)"
COMPARISON = "Compare geodesic methods (VoroGeo)"
PATCHES = "Geodesic Voronoi patches: colour faces (VoroGeo)"
SOURCE = 1234
START = {"Start vertex": str(SOURCE)}


class Scenario(Script):
    """The steps, in order, in one window."""

    def steps(self) -> None:
        """Everything."""
        self.seen |= {"source": SOURCE, "dialogs": {}, "help": {}, "fields": {}, "boxes": {}}
        self.seen["start"] = self.window.log_text()
        self.seen["menu"] = [item for item in self.window.menu_items("Filters") if "(VoroGeo)" in item]
        self.picture("start")
        self.look_at_dialogs()
        self.apply_filters()
        self.keep_the_index()
        self.seen["messages"] = self.window.log_text()

    def look_at_dialogs(self) -> None:
        """Open the dialog of every filter and write down its parameters."""
        for name in sorted({item.rpartition("/")[2] for item in self.seen["menu"]}):
            dialog = self.window.open_filter(name)
            self.seen["dialogs"][name] = []
            if dialog is None:
                continue
            self.seen["dialogs"][name] = [
                {"label": entry.label, "tooltip": entry.tooltip, "values": entry.values()}
                for entry in self.window.parameters(dialog)
            ]
            file = "".join(letter if letter.isalnum() else "_" for letter in name.removesuffix(" (VoroGeo)").lower())
            texts = [node.get_name() for node in self.window.find(Atspi.Role.LABEL, top=dialog)]
            self.seen["help"][name] = max(texts, key=len)
            self.picture(f"dialog_{file}")
            self.window.close(dialog)

    def apply_filters(self) -> None:
        """Fields with and without the index, patches; each field is saved."""
        self.apply(FROM_POINT, {**START, "Method": "index"}, "field_index", "index")
        self.apply(EXACT_FROM_POINT, START, "field_exact", "exact")
        self.apply(FROM_BORDER, key="border")
        self.apply(PATCHES, {"Layer": "2"})
        self.picture("patches")
        self.apply(COMPARISON, {**START, "Method": "Fast marching (MeshLab)"}, "comparison", "comparison")

    def keep_the_index(self) -> None:
        """Write the index to a file, read it again, look at it."""
        for name in (SAVE, LOAD):
            self.apply(name, {"Index file": str(self.folder / "terrain.vgi")})
        self.apply(DESCRIBE)
        self.picture("index_in_the_log")

    def apply(self, name: str, fields: dict | None = None, picture: str = "", key: str = "") -> None:
        """Apply a filter and write down what a box says; with a key the layer is saved."""
        self.seen["boxes"][name] = self.use(name, fields, picture)
        if key:
            self.seen["fields"][key] = self.export(key)


if __name__ == "__main__":
    Scenario.main()
