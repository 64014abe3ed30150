"""The files of the project and what they include or import, read from the sources alone."""

from __future__ import annotations

import ast
import re
from functools import cache
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
TOP = ("core", "include", "packaging", "plugin", "pyfilter", "samples", "tests")
SUFFIXES = (".cpp", ".h", ".py", ".pyi", ".sh", ".cmake")
PACKAGE = Path("pyfilter", "vorogeo")

# The modules of each part from the bottom to the top: a file includes or imports of its own module and those before it.
ORDER = {
    "core": ("support", "mesh", "exact", "patches", "index", "query", "tasks", "methods"),
    "plugin": ("host", "layers", "filters", "edit"),
    "pyfilter": ("src", "vorogeo", "vorogeo/compat", "vorogeo/cli"),
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


def pages() -> list[Path]:
    """The documents: those at the top, in docs/ and in the modules."""
    places = [PROJECT, *(PROJECT / top for top in (*TOP, "docs"))]
    found = {page for place in places for page in place.glob("*.md" if place == PROJECT else "**/*.md")}
    pages = sorted(page.relative_to(PROJECT) for page in found)
    return [page for page in pages if not any(part.startswith(".") for part in page.parts)]


@cache
def text(file: Path) -> str:
    """The contents of a file of the project."""
    return (PROJECT / file).read_text()


def module_of(file: Path) -> str:
    """The module of a file of one of the parts in ORDER, as named there; empty for what lies beside the modules."""
    if file.name == "__main__.py":  # the entry of the program, which has to lie in the package itself
        return "vorogeo/cli"
    return Path(*file.parts[1:-1]).as_posix() if file.parts[0] in ORDER and len(file.parts) > 2 else ""


def modules() -> dict[Path, list[Path]]:
    """The folders of the parts in ORDER that hold sources, and these sources."""
    found: dict[Path, list[Path]] = {}
    for file in sources(".cpp", ".h", ".py"):
        if module_of(file):
            found.setdefault(file.parent, []).append(file)
    return found


def quoted_includes(file: Path) -> list[str]:
    """What a C++ file includes in quotes, as written."""
    return re.findall(r'^\s*#\s*include\s+"([^"]+)"', text(file), flags=re.MULTILINE)


@cache
def included(file: Path) -> list[Path]:
    """Files of the project that a C++ file includes."""
    part = Path(file.parts[0])
    bases = [file.parent, part, Path("core"), Path("include"), Path("samples"), Path("tests")]
    if file.parts[:2] == ("tests", "plugin"):
        bases.insert(1, Path("plugin"))
    places = [[base / name for base in bases if base / name in known()] for name in quoted_includes(file)]
    return [found[0] for found in places if found]


@cache
def imported(file: Path) -> list[Path]:
    """Files of the project that a Python file imports, at any place in it.

    Relative names are looked up in its package, others in the package vorogeo and, for scripts, beside the file.
    """
    scripts = [] if file.parent / "__init__.py" in known() else [file.parent]
    modules: list[Path] = []
    for node in ast.walk(ast.parse(text(file))):
        if isinstance(node, ast.Import):
            names = [alias.name.replace(".", "/") for alias in node.names]
            modules += [base / name for base in (*scripts, PACKAGE.parent) for name in names]
        elif isinstance(node, ast.ImportFrom):
            bases = [file.parents[node.level - 1]] if node.level else [*scripts, PACKAGE.parent]
            for base in bases:
                module = base / (node.module or "").replace(".", "/")
                modules += [*([module] if node.module else []), *(module / alias.name for alias in node.names)]
    candidates = [place for module in modules for place in (module.with_suffix(".py"), module / "__init__.py")]
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
