"""The plugin binary: what it needs at run time, what it shows, and that a host it does not fit refuses it."""

from __future__ import annotations

import re
import subprocess

import pymeshlab
import pytest
from support import PROJECT, host_version

PLUGIN = PROJECT / "build" / f"plugin-{host_version()}-double" / "plugin" / "libfilter_vorogeo.so"
ALLOWED = {"libmeshlab-common", "libQt5Core", "libQt5Gui", "libQt5Widgets", "libQt5OpenGL", "libQt5Xml",
           "libstdc++", "libgcc_s", "libm", "libc", "libpthread", "ld-linux-x86-64"}  # fmt: skip


def output_of(*command: object) -> str:
    """What a command prints."""
    return subprocess.run([str(part) for part in command], capture_output=True, text=True, check=True).stdout


def test_needs_only_qt_the_host_and_the_runtime():
    dynamic = output_of("readelf", "-d", PLUGIN)
    needed = set(re.findall(r"NEEDED.*\[([\w+-]+)\.so", dynamic))
    assert needed <= ALLOWED
    assert re.findall(r"(RPATH|RUNPATH).*\[(.+)\]", dynamic) == [("RUNPATH", "$ORIGIN/../../../pymeshlab/lib")]


def test_shows_only_the_entry_points_of_qt():
    symbols = {line.split()[-1] for line in output_of("nm", "-D", "--defined-only", PLUGIN).splitlines()}
    assert symbols == {"qt_plugin_instance", "qt_plugin_query_metadata"}


def test_host_refuses_the_plugin_of_another_scalar():
    other = PROJECT / "build" / f"plugin-{host_version()}-float" / "plugin" / PLUGIN.name
    if not other.is_file():
        pytest.skip(f"there is no {other}: build the preset plugin-{host_version()}-float")
    with pytest.raises(pymeshlab.PyMeshLabException, match="different floating point precision"):
        pymeshlab.load_plugin(str(other))


def test_host_refuses_the_plugin_of_another_version():
    version = "2022.02" if host_version() == "2025.07" else "2025.07"
    other = PROJECT / "build" / f"plugin-{version}-double" / "plugin" / PLUGIN.name
    if not other.is_file():
        pytest.skip(f"there is no {other}: run 'bash samples/setup.sh --tests'")
    with pytest.raises(pymeshlab.PyMeshLabException, match="different version"):
        pymeshlab.load_plugin(str(other))
