"""The rules that can be checked in the sources themselves: arrows, circles, lengths, first lines, first pages.

Needs nothing but Python and pytest, and no build.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import tree
import weight

MAX_LINES = 900
MAX_LINES_OF_A_README = 20
MAX_LINE_OF_A_PAGE = 140


def none(found: dict[str, str]) -> None:
    """Fail with everything found."""
    assert not found, "\n" + "\n".join(f"{file}: {why}" for file, why in found.items())


@pytest.mark.parametrize("part", tree.ORDER)
def test_arrows_between_modules_point_down(part: str) -> None:
    order = tree.ORDER[part]
    found = {}
    for file in (file for files in tree.modules().values() for file in files if file.parts[0] == part):
        assert tree.module_of(file) in order, f"{file.parent} has no place in tree.ORDER"
        for other in tree.imported(file) if file.suffix == ".py" else tree.included(file):
            same_part = other.parts[0] == part and tree.module_of(other) in order
            if same_part and order.index(tree.module_of(other)) > order.index(tree.module_of(file)):
                found[str(file)] = f"uses {other}, which stands above it"
    none(found)


def test_imports_are_found_in_every_form() -> None:
    package = tree.PACKAGE
    assert package / "errors.py" in tree.imported(package / "cli" / "job.py")  # from ..errors
    assert package / "_arguments.py" in tree.imported(package / "compat" / "gdist.py")  # from .. import _arguments
    assert package / "cli" / "worker.py" in tree.imported(package / "cli" / "main.py")  # from .worker
    assert package / "__init__.py" in tree.imported(Path("tests/python/test_brain.py"))  # import vorogeo
    assert Path("tests/bench/meshes.py") in tree.imported(Path("tests/bench/peers.py"))  # beside a script


def test_the_core_includes_nothing_of_the_hosts() -> None:
    hosts = re.compile(r"#\s*include\s*<(Q[A-Z]|vcg|wrap/|Python|nanobind|common/)")
    found = {}
    for file in tree.sources(".cpp", ".h"):
        if file.parts[0] != "core":
            continue
        strangers = [str(other) for other in tree.included(file) if other.parts[0] not in ("core", "include")]
        if strangers or hosts.search(tree.text(file)):
            found[str(file)] = f"knows a host: {strangers or hosts.search(tree.text(file)).group()}"
    none(found)


def test_the_wheels_library_has_what_is_used() -> None:
    newer = re.compile(r"std::(bit_cast|format|expected|source_location|barrier)\b")  # than Debian 11
    found = {}
    for file in tree.sources(".cpp", ".h"):
        if file.parts[0] in ("core", "plugin", "pyfilter") and (used := newer.search(tree.text(file))):
            found[str(file)] = f"uses {used.group()}, which the C++ library of the wheels lacks (docs/releasing.md)"
    none(found)


def test_plugin_and_python_package_do_not_know_each_other() -> None:
    for file in tree.sources(".cpp", ".h"):
        for other in tree.included(file):
            assert {file.parts[0], other.parts[0]} != {"plugin", "pyfilter"}, f"{file} includes {other}"


def test_no_circles_between_files() -> None:
    arrows = {str(file): {str(other) for other in tree.included(file)} for file in tree.sources(".cpp", ".h")}
    arrows |= {str(file): {str(other) for other in tree.imported(file)} for file in tree.sources(".py")}
    assert tree.circles(arrows) == []


def test_the_search_for_circles_finds_them() -> None:
    arrows = {"a": {"b"}, "b": {"c"}, "c": {"a", "d"}, "d": set(), "e": {"a", "f"}, "f": {"e"}}
    assert sorted(tree.circles(arrows)) == [["a", "b", "c"], ["e", "f"]]
    assert tree.circles({"a": {"b", "c"}, "b": {"c"}, "c": set()}) == []


def test_includes_in_quotes_name_a_file_of_the_project_from_its_part_on() -> None:
    found = {}
    for file in tree.sources(".cpp", ".h"):
        names = tree.quoted_includes(file)
        if any(".." in Path(name).parts for name in names):
            found[str(file)] = "includes through '..'"
        elif len(tree.included(file)) != len(names):
            found[str(file)] = f"includes a file that is not there, among {names}"
    none(found)


def test_no_file_is_longer_than_a_reader_takes_in() -> None:
    lengths = {str(file): len(tree.text(file).splitlines()) for file in tree.sources()}
    none({file: f"{n} lines" for file, n in lengths.items() if n > MAX_LINES})


def test_every_source_says_first_what_it_is() -> None:
    found = {}
    for file in tree.sources():
        lines = tree.text(file).splitlines()
        if file.suffix == ".sh" or (lines and lines[0].startswith("#!")):
            lines = lines[1:]
        begin = {".cpp": "// ", ".h": "// ", ".py": '"""'}.get(file.suffix, "# ")
        if not lines or not lines[0].startswith(begin) or len(lines[0]) < 12:
            found[str(file)] = f"begins with {lines[:1]}"
    none(found)


def test_every_module_has_a_first_page() -> None:
    found = {}
    for module in (*tree.modules(), Path("plugin")):
        page = tree.PROJECT / module / "README.md"
        if not page.is_file():
            found[str(module)] = "has no README.md"
        elif len(page.read_text().splitlines()) > MAX_LINES_OF_A_README:
            found[str(module)] = f"its README.md has more than {MAX_LINES_OF_A_README} lines"
    none(found)


def test_lines_of_pages_are_not_wider_than_a_page() -> None:
    found = {}
    for page in tree.pages():
        code = False
        for number, line in enumerate((tree.PROJECT / page).read_text().splitlines(), 1):
            code ^= line.lstrip().startswith("```")
            if len(line) > MAX_LINE_OF_A_PAGE and not code and not line.lstrip().startswith("!["):
                found[f"{page}:{number}"] = f"{len(line)} characters; at most {MAX_LINE_OF_A_PAGE}"
    none(found)


def test_links_of_pages_lead_somewhere() -> None:
    found = {}
    link = re.compile(r"(?:\]\(|^\[\w+\]: )([^)#:\s]*)(#([^)\s]*))?(?:\)|$)", flags=re.MULTILINE)  # here, or at the end
    for page in tree.pages():
        for target, _, heading in link.findall((tree.PROJECT / page).read_text()):
            file = tree.PROJECT / page.parent / target if target else tree.PROJECT / page
            if not file.exists():
                found[f"{page} -> {target}"] = "is not there"
            elif heading and heading not in headings(file.read_text()):
                found[f"{page} -> {target}#{heading}"] = "has no such heading"
    none(found)


def headings(page: str) -> set[str]:
    """The anchors that a reader's browser makes of the headings of a page."""
    titles = re.findall(r"^#+ (.+)$", page, flags=re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


def test_the_pages_name_every_filter() -> None:
    names = {}
    for file in tree.sources(".cpp"):
        if file.parts[:2] == ("plugin", "filters"):
            names |= dict(re.findall(r'[({]\s*"([^"]+\(VoroGeo\))",\s*"([a-z_]+)"', tree.text(file)))
    assert len(names) > 20
    page = " ".join((tree.PROJECT / "docs" / "filters.md").read_text().split())
    assert set(re.findall(r"\*\*([^*]+\(VoroGeo\))\*\*", page)) == set(names)
    none({name: "is not in docs/filters.md" for name in names.values() if f"`{name}`" not in page})


def test_the_table_of_constants_has_the_names_and_values_of_the_sources() -> None:
    table = (tree.PROJECT / "docs" / "constants.md").read_text()
    rows = [[cell.strip() for cell in line.split("|")[1:4]] for line in table.splitlines() if line.startswith("| `")]
    found, checked = {}, 0
    for names, places, values in rows:
        files: list[Path] = []
        for place in places.split(", "):  # a second file may lie in the module of the first
            candidates = [Path(place), Path("core", place), *(file.parent / place for file in files[:1])]
            files += [file for file in candidates if (tree.PROJECT / file).is_file()][:1]
        numbers = {value_of(text.replace(",", "")) for text in values.split(", ")}
        for name in re.findall(r"`([^`]+)`", names):
            uses = [use for file in files for use in re.findall(rf"\b{name}\b(?: = |\{{)?([^;,}}]*)", tree.text(file))]
            defined = next((value for use in uses if (value := value_of(use)) is not None), None)
            checked += defined is not None
            if not uses:
                found[name] = f"is not in {places}"
            elif defined is not None and defined not in numbers:
                found[name] = f"is {defined:g} in {places}, not {values}"
    none(found)
    assert checked > 150  # the others are functions


def value_of(text: str) -> float | None:
    """The number that a text begins with: a literal, or one of two literals, as in 1/32."""
    number = r"(-?\d[\d.]*(?:e-?\d+)?)f?"
    found = re.match(rf"{number}(?: ?(/|-|<<) ?{number})?", text)
    if found is None:
        return None
    first, operator, second = float(found[1]), found[2], float(found[3] or 1)
    return {None: first, "/": first / second, "-": first - second, "<<": first * 2**second}[operator]


def test_the_list_of_calls_names_functions_of_the_sources() -> None:
    calls = weight.calls(tree.text(Path("docs/architecture.md")))
    assert len(calls) >= 4
    product = "".join(tree.text(file) for file in tree.sources() if file.parts[0] in weight.PRODUCT)
    names = {name for functions in calls.values() for name in functions}
    none({name: "is no function" for name in names if not re.search(rf"\b{re.split(r'[.:]+', name)[-1]}\(", product)})


def test_every_module_of_the_core_has_tests() -> None:
    for module in tree.ORDER["core"]:
        tests = [file for file in tree.sources(".cpp") if file.parts[:3] == ("tests", "core", module)]
        assert any(re.search(r"^TEST", tree.text(file), flags=re.MULTILINE) for file in tests), module


def test_the_version_stands_in_one_place() -> None:
    version = (tree.PROJECT / "VERSION").read_text().strip()
    assert re.fullmatch(r"\d+\.\d+\.\d+", version)
    assert f"\n## {version}\n" in (tree.PROJECT / "CHANGELOG.md").read_text()
    builds = ("CMakeLists.txt", "pyfilter/CMakeLists.txt", "pyfilter/pyproject.toml")
    for file in (*tree.sources(), *map(Path, builds)):
        assert f'"{version}"' not in tree.text(file), f"{file} repeats the version; it comes from the file VERSION"


def test_the_weight_of_the_tree_is_counted() -> None:
    figures = weight.weight(Path(__file__).parents[2])
    product = [file for file in tree.sources(".cpp", ".h", ".py", ".pyi") if file.parts[0] in weight.PRODUCT]
    assert figures["product files"] == len(product)
    assert all(count > 0 for count in figures.values())


def test_the_last_run_is_told_without_its_set_up(tmp_path: Path) -> None:
    assert weight.last_run(tmp_path) == {}
    results = tmp_path / "build" / "test-results"
    results.mkdir(parents=True)
    (results / "times.txt").write_text("90 100 5 set-up\n2 3 1 format of C++\n60 50 6.2 cpp-0\n170 0 0 whole run\n")
    (results / "checks.txt").write_text("pass format of C++\nfail structure\nskip wheels\n")
    (results / "cpp-0.xml").write_text('<testsuite><testcase name="a"/><testcase name="b"/></testsuite>')
    told = {"run.sh, seconds": 80, "run.sh, seconds of the processor": 60, "run.sh, passed tests": 3}
    assert weight.last_run(tmp_path) == told
