"""The package itself: names, version, stubs, error classes, and what the compiled part exposes."""

import inspect
import subprocess
from importlib.metadata import version
from pathlib import Path

import pytest
import vorogeo

PACKAGE = Path(vorogeo.__file__).parent


def test_every_public_name_exists_and_has_documentation():
    for name in set(vorogeo.__all__) - {"methods"}:  # a mapping
        assert inspect.getdoc(getattr(vorogeo, name)), name


def test_version_is_that_of_the_project():
    project = Path(__file__).resolve().parents[2]
    assert vorogeo.__version__ == version("vorogeo") == (project / "VERSION").read_text().strip()


def test_is_typed():
    assert (PACKAGE / "py.typed").is_file()
    assert "def distances(" in (PACKAGE / "_core.pyi").read_text()


def test_errors_are_also_builtin_ones():
    assert issubclass(vorogeo.InvalidInput, ValueError)
    assert issubclass(vorogeo.IndexFileError, OSError)
    assert issubclass(vorogeo.PluginError, RuntimeError)
    for name in ("InvalidInput", "IndexFileError", "Cancelled", "PluginError"):
        assert issubclass(getattr(vorogeo, name), vorogeo.Error)


def binutil(*command):
    try:
        run = subprocess.run([*command, vorogeo._core.__file__], capture_output=True, check=True, text=True)
    except FileNotFoundError:
        pytest.skip(f"{command[0]} (package binutils) is not installed")
    return run.stdout.splitlines()


def test_extension_shows_one_symbol_and_needs_the_cpp_runtime_only():
    exported = binutil("nm", "-D", "--defined-only")
    needed = binutil("readelf", "-d")
    assert [line.split()[-1] for line in exported] == ["PyInit__core"]
    libraries = {line.split("[")[1].split("]")[0] for line in needed if "(NEEDED)" in line}
    allowed = ("libstdc++.so", "libgcc_s.so", "libm.so", "libc.so", "libpthread.so", "ld-linux")
    assert all(library.startswith(allowed) for library in libraries), libraries
