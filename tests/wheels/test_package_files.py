"""What is installed or uploaded: metadata, licences, and what the binaries need of the system that loads them.

Without VOROGEO_WHEEL the installed package is looked at; with it, the wheel of that name.
"""

from __future__ import annotations

import email
import os
import re
import subprocess
import zipfile
from email.message import Message
from importlib.metadata import distribution
from pathlib import Path

import pytest

PROJECT = Path(__file__).parents[2]
WHEEL = os.environ.get("VOROGEO_WHEEL")
ON_LINUX = pytest.mark.skipif("win_amd64" in str(WHEEL), reason="Windows has neither plugins nor paths to libraries")
QT_AND_HOST = {f"libQt5{part}.so.5" for part in ("Core", "Gui", "Widgets", "OpenGL", "Xml")} | {"libmeshlab-common.so"}
WINDOWS = {"kernel32.dll", "msvcrt.dll", "python311.dll"}
RUNTIME = {"libstdc++.so.6", "libgcc_s.so.1", "libm.so.6", "libc.so.6", "libpthread.so.0", "ld-linux-x86-64.so.2"}
RUNTIME |= {"ld-linux-aarch64.so.1"}


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    """Where the package and its metadata lie side by side."""
    if WHEEL is None:
        return Path(str(distribution("vorogeo").locate_file("")))
    place = tmp_path_factory.mktemp("wheel")
    with zipfile.ZipFile(WHEEL) as archive:
        archive.extractall(place)
    return place


@pytest.fixture(scope="module")
def info(folder) -> Path:
    """The folder of the metadata."""
    (found,) = folder.glob("vorogeo-*.dist-info")
    return found


@pytest.fixture(scope="module")
def metadata(info) -> Message:
    """The metadata itself."""
    return email.message_from_string((info / "METADATA").read_text())


def binaries(folder: Path) -> list[Path]:
    """The extension and the plugins."""
    return [*(folder / "vorogeo").glob("_core*.so"), *(folder / "vorogeo" / "plugins").glob("*/*.so")]


def dynamic(file: Path) -> str:
    """The dynamic section of a binary."""
    return subprocess.run(["readelf", "-d", file], capture_output=True, text=True, check=True).stdout


def test_metadata_are_complete(metadata):
    assert metadata["Name"] == "vorogeo"
    assert metadata["Version"] == (PROJECT / "VERSION").read_text().strip()
    assert metadata["License-Expression"] == "GPL-3.0-or-later"
    assert metadata["Requires-Python"] == ">=3.10"
    assert set(metadata.get_all("Provides-Extra")) == {"brain", "dask", "files", "meshlab", "progress", "test"}
    assert "Typing :: Typed" in metadata.get_all("Classifier")
    assert not [line for line in metadata.get_all("Classifier") if line.startswith("License")]
    assert metadata.get_payload().startswith("# vorogeo")


def test_licences_are_in_the_package(metadata, info):
    assert metadata.get_all("License-File") == ["LICENSE", "NOTICES.txt"]
    assert (info / "licenses" / "LICENSE").read_bytes() == (PROJECT / "LICENSE").read_bytes()
    assert "Wenzel Jakob" in (info / "licenses" / "NOTICES.txt").read_text()


def test_program_is_declared(info):
    assert "vorogeo = vorogeo.cli.main:main" in (info / "entry_points.txt").read_text().splitlines()


@ON_LINUX
def test_binaries_need_the_runtime_and_plugins_also_what_comes_with_pymeshlab(folder):
    found = binaries(folder)
    assert len(found) >= 2
    for file in found:
        needed = set(re.findall(r"NEEDED.*\[(.+)\]", dynamic(file)))
        allowed = RUNTIME if file.name.startswith("_core") else RUNTIME | QT_AND_HOST
        assert needed <= allowed, file


@ON_LINUX
def test_plugins_look_for_libraries_in_pymeshlab_and_the_extension_nowhere(folder):
    for file in binaries(folder):
        paths = re.findall(r"(RPATH|RUNPATH).*\[(.+)\]", dynamic(file))
        expected = [] if file.name.startswith("_core") else [("RUNPATH", "$ORIGIN/../../../pymeshlab/lib")]
        assert paths == expected, file


@ON_LINUX
def test_neither_qt_nor_meshlab_is_inside(folder, info):
    names = (info / "RECORD").read_text().splitlines()
    libraries = {line.split(",")[0] for line in names if re.search(r"\.so(\.|,)", line)}
    assert {Path(name).name.split(".")[0] for name in libraries} == {"_core", "libfilter_vorogeo"}
    assert len([file for file in folder.rglob("*.so*") if "Qt5" in file.name]) == 0 or WHEEL is None


@ON_LINUX
@pytest.mark.skipif(WHEEL is None, reason="the installed package is made for this system alone")
def test_symbols_are_no_newer_than_the_tag(folder, info):
    tag = re.search(
        r"^Tag: (\S+)-manylinux_2_(\d+)_(x86_64|aarch64)$", (info / "WHEEL").read_text(), flags=re.MULTILINE
    )
    assert tag
    assert Path(str(WHEEL)).name.endswith(f"-{tag[1]}-manylinux_2_{tag[2]}_{tag[3]}.whl")
    for file in binaries(folder):
        symbols = subprocess.run(["readelf", "-V", file], capture_output=True, text=True, check=True).stdout
        assert max(int(minor) for minor in re.findall(r"\bGLIBC_2\.(\d+)", symbols)) <= int(tag[2]), file


@pytest.mark.skipif("win_amd64" not in str(WHEEL), reason="this is no wheel for Windows")
def test_the_extension_for_windows_needs_nothing_that_has_to_be_brought_and_exports_its_start(folder, info):
    assert re.search(r"^Tag: cp311-cp311-win_amd64$", (info / "WHEEL").read_text(), flags=re.MULTILINE)
    assert Path(str(WHEEL)).name.endswith("-cp311-cp311-win_amd64.whl")
    (file,) = folder.rglob("*.pyd")
    assert not list(folder.rglob("*.dll"))
    assert not list(folder.rglob("*.so"))
    tables = subprocess.run(["objdump", "-p", file], capture_output=True, text=True, check=True).stdout
    assert {name.lower() for name in re.findall(r"DLL Name: (\S+)", tables)} <= WINDOWS
    exported = set(re.findall(r"^\t\[ *\d+\] ([A-Za-z_]\w*)$", tables, flags=re.MULTILINE))
    assert {name for name in exported if "nanobind" not in name} == {"PyInit__core"}  # nanobind names its two errors
    assert "class OutputFile" in (folder / "vorogeo" / "_core.pyi").read_text()
