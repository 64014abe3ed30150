"""The package itself: names, version, stubs, error classes, and what the compiled part exposes."""

import inspect
import shutil
import subprocess
import sys
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


def import_fails(folder, before="pass"):
    command = [sys.executable, "-c", f"{before}; import vorogeo"]
    run = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    return run.stderr.splitlines()[-1]


def test_what_cannot_be_loaded_is_said_in_one_sentence(tmp_path):
    what_to_do = "; 'pip install --force-reinstall vorogeo' brings what fits this system."
    found = import_fails(tmp_path, "import sys; sys.modules['numpy'] = None")
    assert found.startswith("ImportError: vorogeo cannot be loaded: import of numpy halted")
    assert found.endswith(what_to_do)
    shutil.copytree(PACKAGE, tmp_path / "vorogeo", ignore=shutil.ignore_patterns("plugins", "_core*.so"))
    (tmp_path / "vorogeo" / Path(vorogeo._core.__file__).name).write_bytes(b"made for another system")
    found = import_fails(tmp_path)
    assert "ImportError: vorogeo cannot be loaded: " in found
    assert found.endswith(what_to_do)


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
