"""What a person does in MeshLab's window: looks for a filter, fills in its dialog, applies it, saves the mesh."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from pathlib import Path

from screen import Atspi, Screen, wait_for

FIELDS = (Atspi.Role.TEXT, Atspi.Role.COMBO_BOX, Atspi.Role.CHECK_BOX, Atspi.Role.SPIN_BUTTON)
WINDOWS = (Atspi.Role.FRAME, Atspi.Role.DIALOG, Atspi.Role.ALERT)
MOST_TABS = 80  # more than a dialog has widgets
MAX_DOWN = 12  # a filter is among the first entries when its whole name was typed
TRIES = 3  # of what a click or a key may miss on a busy machine


def text_of(node: Atspi.Accessible) -> str:
    """Text in a field."""
    return Atspi.Text.get_text(node, 0, -1) if node.get_text_iface() else node.get_name()


def same(shown: str, entered: str) -> bool:
    """Whether a field shows what was entered; some fields write numbers their own way."""
    try:
        return float(shown) == float(entered)
    except ValueError:
        return shown == entered


@dataclass
class Parameter:
    """A parameter as the dialog shows it."""

    label: str
    tooltip: str
    widgets: list[Atspi.Accessible] = field(default_factory=list)

    def values(self) -> list[str]:
        """What stands in its fields."""
        return [text_of(widget) for widget in self.widgets if widget.get_role() in FIELDS]


def name_of(label: str) -> str:
    """The label of a parameter without what it says about 0, and what MeshLab adds to lengths."""
    return label.removesuffix(" (abs and %)").partition(" (0:")[0]


def is_switch(node: Atspi.Accessible) -> bool:
    """Whether it shows advanced parameters: in 2022.02 a box of that name, in 2025.07 an arrow with that tooltip."""
    return any(text.endswith(" advanced parameters") for text in (node.get_name(), node.get_description()))


class MeshLabWindow(Screen):
    """The main window of a MeshLab that was started with mesh files."""

    def __init__(self, meshes: list[Path], log: Path) -> None:
        """Start MeshLab and wait until it has read the meshes."""
        super().__init__([str(mesh) for mesh in meshes], log, "All files opened")

    def dialog(self, title: str) -> Atspi.Accessible | None:
        """The visible window with this title."""
        tops = (self.application.get_child_at_index(i) for i in range(self.application.get_child_count()))
        for top in tops:
            if top and top.get_role() in WINDOWS and top.get_name() == title and self.is_showing(top):
                return top
        docks = self.find(Atspi.Role.FRAME, title)
        return docks[0] if docks else None

    def search(self, text: str, down: int) -> None:
        """Type into the search box and choose the entry so many steps down; on a busy machine a key may be missed."""
        for _ in range(TRIES):
            before = self.windows()
            self.keys("ctrl+f")
            try:
                box = wait_for("the search box", lambda before=before: self.windows() - before, 15)
                self.write(text)
                self.keys(*["Down"] * down, "Return")
                wait_for("the search box to close", lambda box=box: not self.windows() & box, 15)
                return
            except TimeoutError:
                self.keys("Escape")
        raise TimeoutError(f"the search box does not take '{text}'")

    def open_filter(self, name: str) -> Atspi.Accessible | None:
        """Find a filter by its name in the search box and open its dialog; without parameters it is applied at once."""
        already = len(self.log_lines())
        for down in [1, *range(1, MAX_DOWN)]:
            self.search(name, down)
            try:
                wait_for(
                    f"a dialog after searching {name}", lambda: self.filter_dialogs() or self.applied("", already), 15
                )
            except TimeoutError:
                continue
            if self.dialog(name) or self.applied(name, already):
                return self.dialog(name)
            for other in self.filter_dialogs():
                self.close(other)
        raise TimeoutError(f"the search box does not offer '{name}'")

    def filter_dialogs(self) -> list[Atspi.Accessible]:
        """Dialogs of filters: what has a button Apply and a title."""
        found = []
        for node in self.find(Atspi.Role.PUSH_BUTTON, "Apply"):
            while node.get_role() not in WINDOWS:
                node = node.get_parent()
            found.append(node)
        return found

    def applied(self, name: str, already: int) -> bool:
        """Whether the log says, after its first lines, that a filter was applied."""
        starts = (f"Applied filter {name}", f"Applied filter: {name}")  # as 2022.02 and 2025.07 write it
        return any(line.startswith(starts) for line in self.log_lines()[already:])

    def parameters(self, dialog: Atspi.Accessible) -> list[Parameter]:
        """Labels, tooltips and fields of a filter's dialog, from top to bottom."""
        frames = [node for node in self.nodes(dialog) if self._is_parameter_frame(node)]
        found: list[Parameter] = []
        widgets: list[Atspi.Accessible] = []
        for frame in frames[:1]:
            for i in range(frame.get_child_count()):
                child = frame.get_child_at_index(i)
                if child.get_role() == Atspi.Role.LABEL and child.get_description():
                    found.append(Parameter(child.get_name(), child.get_description(), widgets))
                    widgets = []
                elif is_switch(child):
                    continue  # of the dialog, not of a parameter
                elif child.get_role() in (*FIELDS, Atspi.Role.PUSH_BUTTON):
                    widgets.append(child)
        return found

    @staticmethod
    def _is_parameter_frame(node: Atspi.Accessible) -> bool:
        children = [node.get_child_at_index(i) for i in range(node.get_child_count())]
        labels = [child for child in children if child and child.get_role() == Atspi.Role.LABEL]
        return any(label.get_description() for label in labels) and len(labels) > 1

    def fill(self, dialog: Atspi.Accessible, label: str, *values: str) -> None:
        """Replace what stands in the fields of a parameter, by mouse and keyboard."""
        parameter = next(entry for entry in self.parameters(dialog) if name_of(entry.label) == label)
        widgets = [widget for widget in parameter.widgets if widget.get_role() in FIELDS]
        if not all(map(self.is_showing, widgets)):
            self.click(next(filter(is_switch, self.nodes(dialog))))
            wait_for(f"the field of {label}", lambda: all(map(self.is_showing, widgets)))
        for widget, value in zip(widgets, values, strict=False):
            if widget.get_role() == Atspi.Role.COMBO_BOX:
                self.choose(widget, value)
            elif widget.get_role() == Atspi.Role.CHECK_BOX:
                self.click(widget)
            else:
                self.enter(widget, value)

    def enter(self, widget: Atspi.Accessible, value: str) -> None:
        """Replace the text of a field."""
        for _ in range(TRIES):
            self.focus(widget)
            self.keys("ctrl+a")
            self.write(value)
            self.keys("Tab")
            try:
                wait_for(f"'{value}' in its field", lambda: same(text_of(widget), value), 10)
                return
            except TimeoutError:
                pass
        raise TimeoutError(f"the field holds '{text_of(widget)}' instead of '{value}'")

    def is_in_sight(self, widget: Atspi.Accessible) -> bool:
        """Whether its middle lies in all that it is part of: what is scrolled away does not."""
        left, top, width, height = self.box(widget)
        x, y = left + width // 2, top + height // 2
        around = widget.get_parent()
        while around.get_role() != Atspi.Role.APPLICATION:
            left, top, width, height = self.box(around)
            if not (left <= x < left + width and top <= y < top + height):
                return False
            around = around.get_parent()
        return True

    def focus(self, widget: Atspi.Accessible) -> None:
        """Click a field, or go to it by Tab where the dialog has to be scrolled for it."""
        if self.is_in_sight(widget):
            self.click(widget, times=3)
            return
        for _ in range(MOST_TABS):
            self.keys("Tab")
            if widget.get_state_set().contains(Atspi.StateType.FOCUSED):
                return
        raise TimeoutError("no number of tabs leads to the field")

    def choose(self, box: Atspi.Accessible, entry: str) -> None:
        """Choose an entry of a combo box by keyboard."""
        before = self.windows()
        self.click(box)
        entries = wait_for("the list of the combo box", lambda: self.windows() - before)
        self.keys("Escape")  # the list closes, the box keeps the focus
        wait_for("the list to close", lambda: not self.windows() & entries)
        self.keys("Home")
        while box.get_name() != entry:
            last = box.get_name()
            self.keys("Down")
            wait_for(f"the entry '{entry}' after '{last}'", lambda last=last: box.get_name() != last, 10)

    def press(self, window: Atspi.Accessible, *names: str) -> None:
        """Click the button of one of these names."""

        def buttons() -> list[Atspi.Accessible]:
            return [node for name in names for node in self.find(Atspi.Role.PUSH_BUTTON, name, window)]

        self.click(wait_for(f"a button {names}", buttons)[0])

    def message_box(self) -> Atspi.Accessible | None:
        """A box with a message and a button OK."""
        for i in range(self.application.get_child_count()):
            top = self.application.get_child_at_index(i)
            if top and self.is_showing(top) and top.get_role() in (Atspi.Role.ALERT, Atspi.Role.DIALOG):
                return top
        return None

    def apply(self, dialog: Atspi.Accessible, seconds: float = 300) -> str:
        """Click Apply and wait for the end. Returns the text of the message box, empty if the filter succeeded."""
        already = len(self.log_lines())
        self.press(dialog, "Apply")

        def ended() -> bool:
            return self.message_box() is not None or any("Applied filter" in x for x in self.log_lines()[already:])

        wait_for(f"the end of {dialog.get_name()}", ended, seconds, self.is_alive)
        box = self.message_box()
        if box is None:
            return ""
        text = "\n".join(node.get_name() for node in self.find(Atspi.Role.LABEL, top=box) if node.get_name())
        return text

    def apply_at_once(self, name: str) -> None:
        """Apply a filter without parameters, or with those that it begins with."""
        dialog = self.open_filter(name)
        if dialog is not None:
            self.apply(dialog)
            self.close(dialog)

    def dismiss(self) -> None:
        """Close a message box with Return."""
        self.keys("Return")
        wait_for("the message box to close", lambda: self.message_box() is None)

    def close(self, dialog: Atspi.Accessible) -> None:
        """Close a filter's dialog."""
        self.press(dialog, "Close")
        wait_for("the dialog to close", lambda: not self.filter_dialogs())

    def choose_layer(self, name: str) -> None:
        """Make the layer of this name the current one."""

        def cell() -> Atspi.Accessible | None:
            return next(iter(self.find(Atspi.Role.TABLE_CELL, name)), None)

        self.click(wait_for(f"the layer {name}", cell))
        wait_for(f"the layer {name} to be current", lambda: cell().get_state_set().contains(Atspi.StateType.SELECTED))

    def choose_in_menu(self, menu: str, *entries: str) -> None:
        """Click an entry of a menu of the menu bar, or of the menus below it."""
        before = self.windows()
        bar = next(node for node in self.nodes() if node.get_role() == Atspi.Role.MENU_BAR)
        top = next(node for node in self.nodes(bar) if node.get_name() == menu)
        self.click(top)
        wait_for(f"the menu {menu}", lambda: self.windows() - before)
        for entry in entries:
            named = [node for node in self.nodes(top) if node.get_name() == entry]
            self.click(wait_for(f"the entry {entry}", lambda named=named: next(filter(self.is_showing, named), None)))

    def give_file(self, title: str, file: Path) -> None:
        """Type the name of a file into the dialog of this title that asks for one."""
        wait_for(f"the dialog {title}", lambda: self.dialog(title))
        self.write(str(file))
        self.keys("Return")
        wait_for(f"the dialog {title} to close", lambda: self.dialog(title) is None)

    def export(self) -> None:
        """Save the current layer to the file it came from, with everything it has."""
        already = len(self.log_lines())
        self.keys("ctrl+e")
        box = wait_for("the dialog of saving options", self.message_box)
        self.click(self.find(Atspi.Role.RADIO_BUTTON, "All", box)[0])
        self.press(box, "OK")
        wait_for("the mesh to be saved", lambda: any("Saved" in line for line in self.log_lines()[already:]))

    def close_without_saving(self) -> None:
        """Answer the question whether changes are to be saved, if it comes."""
        time.sleep(2.0)
        box = self.message_box()
        if box is not None:
            self.press(box, "Close without saving", "Discard", "Yes")

    def quit(self) -> float:
        """Leave the program by its menu. Returns the seconds until the process has ended."""
        begin = time.monotonic()
        self.keys("ctrl+q")
        self.close_without_saving()
        wait_for("the program to end", lambda: not self.is_alive(), 60)
        return time.monotonic() - begin
