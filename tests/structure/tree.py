"""The files of the project and what they include or import, read from the sources alone."""

from __future__ import annotations

import ast
import re
from functools import cache
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
TOP = ("core", "plugin", "pyfilter", "samples", "tests")
SUFFIXES = (".cpp", ".h", ".py", ".pyi", ".sh", ".cmake")

# The rooms of each part from the bottom to the top: a file includes its own room and those before it.
ORDER = {
    "core": ("support", "mesh", "exact", "partition", "index", "route", "field", "path", "tasks", "methods"),
    "plugin": ("host", "layers", "filters"),
}


@cache
def sources(*suffixes: str) -> list[Path]:
    """Sources of the project with one of these suffixes (none: all kinds), relative to it."""
    found = [file.relative_to(PROJECT) for top in TOP for file in sorted((PROJECT / top).rglob("*"))]
    return [
        file
        for file in found
        if file.suffix in (suffixes or SUFFIXES) and not any(part.startswith((".", "__")) for part in file.parts[:-1])
    ]


@cache
def known() -> frozenset[Path]:
    """All sources, to look one up."""
    return frozenset(sources())


@cache
def text(file: Path) -> str:
    """The contents of a file of the project."""
    return (PROJECT / file).read_text()


def rooms() -> list[Path]:
    """Folders of the core and of the plugin."""
    return sorted({file.parent for file in sources(".cpp", ".h") if file.parts[0] in ORDER and len(file.parts) == 3})


def quoted_includes(file: Path) -> list[str]:
    """What a C++ file includes in quotes, as written."""
    return re.findall(r'^\s*#\s*include\s+"([^"]+)"', text(file), flags=re.MULTILINE)


@cache
def included(file: Path) -> list[Path]:
    """Files of the project that a C++ file includes."""
    part = Path(file.parts[0])
    bases = [file.parent, part, Path("core"), Path("tests")]
    if file.parts[:2] == ("tests", "plugin"):
        bases.insert(1, Path("plugin"))
    places = [[base / name for base in bases if base / name in known()] for name in quoted_includes(file)]
    return [found[0] for found in places if found]


@cache
def imported(file: Path) -> list[Path]:
    """Files of the project that a Python file imports: of its own folder or of its package, at any place in it."""
    names = []
    for node in ast.walk(ast.parse(text(file))):
        if isinstance(node, ast.Import):
            names += [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            base = node.module or ""
            names += [base, *(f"{base}.{alias.name}".lstrip(".") for alias in node.names)]
    modules = [Path(*name.removeprefix(f"{file.parent.name}.").split(".")) for name in names if name]
    candidates = [file.parent / module.with_suffix(".py") for module in modules]
    return [place for place in dict.fromkeys(candidates) if place != file and place in known()]


def circles(arrows: dict[str, set[str]]) -> list[list[str]]:
    """Groups of nodes that reach one another (Tarjan's strongly connected components of two or more)."""
    number: dict[str, int] = {}
    lowest: dict[str, int] = {}
    stack: list[str] = []
    groups = []

    def visit(node: str) -> None:
        number[node] = lowest[node] = len(number)
        stack.append(node)
        for target in sorted(arrows.get(node, ())):
            if target not in number:
                visit(target)
                lowest[node] = min(lowest[node], lowest[target])
            elif target in stack:
                lowest[node] = min(lowest[node], number[target])
        if lowest[node] == number[node]:
            group = stack[stack.index(node) :]
            del stack[stack.index(node) :]
            if len(group) > 1:
                groups.append(sorted(group))

    for node in sorted(arrows):
        if node not in number:
            visit(node)
    return groups
