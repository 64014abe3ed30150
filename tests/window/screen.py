"""MeshLab on a virtual display, read through the accessibility bus and driven by mouse and keyboard.

Runs inside a root made by make_root.sh, within dbus-run-session; needs only the packages of that root.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TypeVar

import gi

gi.require_version("Atspi", "2.0")
from gi.repository import Atspi, GLib  # noqa: E402

Result = TypeVar("Result")
SIZE = (1280, 1080)
# Seconds to wait for what takes one or two on an idle machine.
PATIENCE = 60
START_PATIENCE = 180
# Asked in a process of its own: libatspi remembers an empty desktop for ever.
COUNT = (
    "import gi; gi.require_version('Atspi', '2.0'); from gi.repository import Atspi;"
    "print(Atspi.get_desktop(0).get_child_count())"
)


def wait_for(
    what: str, condition: Callable[[], Result], seconds: float = PATIENCE, going: Callable[[], bool] | None = None
) -> Result:
    """Return the first result of the condition that is not empty. An error names what was waited for.

    `going`: whether it still makes sense to wait.
    """
    end = time.monotonic() + seconds
    while True:
        begin = time.monotonic()
        goes_on = (going is None or going()) and begin < end
        while GLib.MainContext.default().iteration(False):
            pass
        try:
            result = condition()
        except GLib.Error:  # a widget that vanished while it was looked at
            result = None
        if result:
            return result
        if not goes_on:
            raise TimeoutError(f"not seen in {seconds:.0f} s, or the program has ended: {what}")
        # Looking through all widgets keeps MeshLab busy: it gets as much time for its own work.
        time.sleep(max(0.1, time.monotonic() - begin))


def run(*command: str) -> str:
    """Standard output of a command."""
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def succeeds(*command: str) -> bool:
    """Whether a command ends soon and without an error."""
    try:
        return subprocess.run(command, capture_output=True, check=False, timeout=PATIENCE).returncode == 0
    except subprocess.TimeoutExpired:
        return False


def programs_on_the_bus() -> int:
    """Number of programs on the accessibility bus; -1 if there is no bus."""
    asked = subprocess.run((sys.executable, "-c", COUNT), capture_output=True, text=True, check=False)
    return int(asked.stdout) if asked.returncode == 0 and asked.stdout.strip() else -1


def start_display(folder: Path, density: int = 1) -> None:
    """A display and a window manager; their messages go to files in the folder.

    They end with the namespace this runs in. `density`: pixels of the display for each of the window, on each axis.
    """
    runtime = Path("/tmp/runtime")
    runtime.mkdir(mode=0o700, exist_ok=True)
    os.environ.update(
        XDG_RUNTIME_DIR=str(runtime),
        LIBGL_ALWAYS_SOFTWARE="1",
        QT_LINUX_ACCESSIBILITY_ALWAYS_ON="1",
        QT_ASSUME_STDERR_HAS_CONSOLE="1",
        QT_SCALE_FACTOR=str(density),
    )
    start_server(folder / "display.log", density)
    start_window_manager(folder / "window_manager.log")
    Atspi.set_timeout(30_000, 60_000)  # a busy machine answers late


def start_server(log: Path, density: int) -> None:
    """The display. It looks for a free number, as names of displays are shared even by roots of their own."""
    read_end, write_end = os.pipe()
    screen = ("-screen", "0", f"{density * SIZE[0]}x{density * SIZE[1]}x24")
    # By default, the server restarts whenever its last client leaves, and drops clients that are just connecting.
    command = ("Xvfb", "-noreset", "-displayfd", str(write_end), *screen)
    with open(log, "w") as file:
        server = subprocess.Popen(command, pass_fds=(write_end,), stdout=file, stderr=file, stdin=subprocess.DEVNULL)
    os.close(write_end)
    with os.fdopen(read_end) as number:
        os.environ["DISPLAY"] = ":" + number.readline().strip()
    try:
        wait_for("the display", lambda: succeeds("xdotool", "getdisplaygeometry"), going=lambda: server.poll() is None)
    except TimeoutError as error:
        raise TimeoutError(f"Xvfb did not come up: {error}; it wrote:\n{log.read_text()}") from None


def start_window_manager(log: Path) -> None:
    """The window manager; once it answers, windows get a place and the keys."""
    for last in (False, False, True):
        manager = start("openbox", errors=log)
        try:
            wait_for(
                "the window manager",
                lambda: succeeds("xdotool", "get_num_desktops"),
                going=lambda manager=manager: manager.poll() is None,
            )
            return
        except TimeoutError as error:
            manager.kill()
            manager.wait()
            if last:
                raise TimeoutError(f"openbox did not come up: {error}; it wrote:\n{log.read_text()}") from None


def start(*command: str, errors: Path | None = None) -> subprocess.Popen:
    """A program in the background, its messages in a file."""
    with open(errors or os.devnull, "w") as file:
        return subprocess.Popen(command, stdout=file, stderr=file, stdin=subprocess.DEVNULL)


class Screen:
    """The running MeshLab."""

    def __init__(self, arguments: list[str], log: Path, first_line: str) -> None:
        """Start MeshLab, wait until its log holds the first line, and find it on the accessibility bus."""
        self.log = log
        for last in (False, False, True):
            self.process = start("meshlab", *arguments, errors=log)
            bus = None
            try:
                wait_for(first_line, lambda: first_line in self.log_text(), START_PATIENCE, self.is_alive)
                # The bus is started after MeshLab: Qt 5 registers when the bus appears. If it is there before,
                # Qt looks for it while starting, and mostly misses its own signal.
                bus = start("/usr/libexec/at-spi-bus-launcher", "--launch-immediately")
                wait_for("MeshLab on the bus", lambda: programs_on_the_bus() == 1, going=self.is_alive)
                break
            except TimeoutError as error:
                for process in filter(None, (self.process, bus)):
                    process.kill()
                    process.wait()
                if last:
                    raise TimeoutError(f"MeshLab did not come up: {error}; it wrote:\n{self.log_text()}") from None
        desktop = Atspi.get_desktop(0)
        self.application = wait_for("MeshLab in the list of programs", lambda: desktop.get_child_at_index(0))
        self.application.set_cache_mask(Atspi.Cache.NONE)

    def log_text(self) -> str:
        """All that MeshLab wrote: each line of its log pane is there after 'LOG: <level> '."""
        return self.log.read_text(errors="replace")

    def log_lines(self) -> list[str]:
        """Lines of the log pane so far."""
        return [line.split(" ", 2)[2] for line in self.log_text().splitlines() if line.startswith("LOG: ")]

    def is_alive(self) -> bool:
        """Whether the program still runs."""
        return self.process.poll() is None

    def processor_seconds(self) -> dict[str, float]:
        """Time that the program has taken of the processor: the window's thread, those that draw, all others."""

        def used(folder: Path) -> tuple[str, float]:
            name, _, fields = (folder / "stat").read_text().partition("(")[2].rpartition(")")
            return name, sum(int(fields.split()[i]) for i in (11, 12)) / os.sysconf("SC_CLK_TCK")

        program = Path(f"/proc/{self.process.pid}")
        tasks = [used(task) for task in (program / "task").iterdir()]
        window = used(program / "task" / program.name)[1]
        drawing = sum(seconds for name, seconds in tasks if name.startswith("llvmpipe"))
        return {"window": window, "drawing": drawing, "others": used(program)[1] - window - drawing}

    # What is on the screen

    def nodes(
        self, top: Atspi.Accessible | None = None, skip: tuple[Atspi.Role, ...] = (), hidden: bool = True
    ) -> Iterator[Atspi.Accessible]:
        """Widget by widget, parents first; without hidden ones if they are not wanted: theirs are hidden, too."""
        node = top or self.application
        if node.get_role() in skip or not (hidden or node == self.application or self.is_showing(node)):
            return
        yield node
        for i in range(node.get_child_count()):
            child = node.get_child_at_index(i)
            if child is not None:
                yield from self.nodes(child, skip, hidden)

    @staticmethod
    def is_showing(node: Atspi.Accessible) -> bool:
        """Whether it is to be seen on the screen."""
        return node.get_state_set().contains(Atspi.StateType.SHOWING)

    def find(
        self, roles: Atspi.Role | tuple[Atspi.Role, ...], name: str | None = None, top: Atspi.Accessible | None = None
    ) -> list[Atspi.Accessible]:
        """Visible widgets of these roles (and of this name), outside the menus."""
        roles = roles if isinstance(roles, tuple) else (roles,)
        return [
            node
            for node in self.nodes(top, skip=(Atspi.Role.MENU_BAR, Atspi.Role.TOOL_BAR), hidden=False)
            if node.get_role() in roles and (name is None or node.get_name() == name)
        ]

    def menu_items(self, menu: str) -> list[str]:
        """Names of all entries below a menu of the menu bar, as 'submenu/entry'."""
        bar = next(node for node in self.nodes() if node.get_role() == Atspi.Role.MENU_BAR)
        top = next(node for node in self.nodes(bar) if node.get_name() == menu)
        return list(self._entries(top, ""))

    def _entries(self, node: Atspi.Accessible, path: str) -> Iterator[str]:
        for i in range(node.get_child_count()):
            child = node.get_child_at_index(i)
            below = path
            if child.get_role() in (Atspi.Role.MENU_ITEM, Atspi.Role.MENU, Atspi.Role.CHECK_MENU_ITEM):
                below = f"{path}/{child.get_name()}" if path else child.get_name()
                yield below
            yield from self._entries(child, below)

    @staticmethod
    def box(node: Atspi.Accessible) -> tuple[int, int, int, int]:
        """Left, top, width and height of a widget in pixels of the display; Qt names those of the window."""
        density = int(os.environ["QT_SCALE_FACTOR"])
        extents = node.get_extents(Atspi.CoordType.SCREEN)
        return tuple(density * side for side in (extents.x, extents.y, extents.width, extents.height))

    # Mouse and keyboard

    def click(self, node: Atspi.Accessible, times: int = 1) -> None:
        """Click in the middle of a widget."""
        left, top, width, height = self.box(node)
        x, y = left + width // 2, top + height // 2
        run("xdotool", "mousemove", str(x), str(y), "click", "--repeat", str(times), "1")

    def windows(self) -> set[str]:
        """X windows of the program that are on the screen: lists that pop up are seen only so."""
        command = ("xdotool", "search", "--onlyvisible", "--pid", str(self.process.pid))
        return set(subprocess.run(command, capture_output=True, text=True, check=False).stdout.split())

    def keys(self, *names: str) -> None:
        """Press keys, one after the other."""
        run("xdotool", "key", "--delay", "60", *names)

    def write(self, text: str) -> None:
        """Type a text."""
        run("xdotool", "type", "--delay", "8", "--", text)

    def picture(self, file: Path) -> None:
        """A picture of the whole screen."""
        run("import", "-window", "root", str(file))
