"""What systems do in different ways: locks, replacing open files, names, large files, patterns, interrupts.

Runs on this system, and under wine on Windows, with nothing but numpy, meshio and pytest.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import vorogeo
from vorogeo import _core, _output

NAME = "Maße der Höhle, 2. Versuch Ω"


def plane(columns: int, rows: int) -> tuple[Any, Any]:
    """A flat rectangle of unit squares: every distance is Euclidean."""
    x, y = np.meshgrid(np.arange(columns), np.arange(rows))
    corner = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    lower = np.column_stack([corner, corner + 1, corner + columns + 1])
    upper = np.column_stack([corner, corner + columns + 1, corner + columns])
    vertices = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)]).astype(float)
    return vertices, np.vstack([lower, upper]).astype(np.int32)


MESH = plane(30, 25)
APART = np.linalg.norm(MESH[0][:, None] - MESH[0][None], axis=2)


def new_index(**options: Any) -> vorogeo.GeodesicIndex:
    """An index of the plane."""
    return vorogeo.GeodesicIndex(*MESH, patches=(3, 3), **options)


@pytest.fixture(scope="module")
def index() -> vorogeo.GeodesicIndex:
    """The index that tests save."""
    return new_index()


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with a name that only whole paths survive."""
    place = tmp_path / NAME
    place.mkdir()
    return place


def names(folder: Path) -> list[str]:
    """What is in a folder."""
    return sorted(file.name for file in folder.iterdir())


def test_an_index_that_is_in_use_is_replaced_and_nothing_is_left(index, folder):
    file = folder / f"{NAME}.vgi"
    index.save(file)
    used = vorogeo.GeodesicIndex.load(file, *MESH)
    assert used.statistics.mapped_bytes > 0
    other = vorogeo.GeodesicIndex(MESH[0] * 2, MESH[1], patches=(3, 3))
    other.save(file)
    np.testing.assert_allclose(used.distance_field(7), APART[7], rtol=0.02)
    found = vorogeo.GeodesicIndex.load(file, MESH[0] * 2, MESH[1])
    np.testing.assert_allclose(found.distance_field(7), 2 * APART[7], rtol=0.02)
    del used, found
    index.save(file)
    assert names(folder) == [file.name]
    assert "ß" in file.name


def test_an_index_is_built_in_its_file_by_one_at_a_time(index, folder):
    file = folder / "built.vgi"
    seen: list[str] = []

    def build_again(fraction: float, activity: str) -> bool:
        if not seen and names(folder) == ["built.vgi.unfinished"]:
            with pytest.raises(vorogeo.IndexFileError, match="is being written by another process") as refused:
                new_index(file=file)
            seen.append(str(refused.value))
        return True

    built = new_index(file=file, progress=build_again)
    assert NAME in seen[0]
    assert names(folder) == ["built.vgi"]
    saved = folder / "saved.vgi"
    index.save(saved)
    assert file.read_bytes() == saved.read_bytes(), "what the build kept behind the index is cut off"
    np.testing.assert_array_equal(built.distance_field(7), index.distance_field(7))
    with pytest.raises(vorogeo.Cancelled):
        new_index(
            file=folder / "stopped.vgi", progress=lambda fraction, activity: not activity.startswith("Tabulating")
        )
    assert (folder / "stopped.vgi.unfinished").exists()
    new_index(file=folder / "stopped.vgi")
    assert (folder / "stopped.vgi").read_bytes() == saved.read_bytes()


def test_what_a_killed_process_left_is_removed_by_the_next_and_what_another_writes_stays(index, folder):
    index.save(folder / "a.vgi")
    (folder / "a.vgi.vorogeo-00000001.part").write_bytes(b"half")
    script = (
        f"import sys; from vorogeo import _core; out = _core.OutputFile.make({str(folder / 'a.vgi')!r}, '', b'', 9);"
        "print(flush=True); sys.stdin.read()"
    )
    with subprocess.Popen([sys.executable, "-c", script], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as other:
        assert other.stdout
        assert other.stdout.readline().strip() == b""
        both = names(folder)
        assert len(both) == 2, "it has removed what was left"
        index.save(folder / "a.vgi")
        assert names(folder) == both
        other.kill()
    index.save(folder / "a.vgi")
    assert names(folder) == ["a.vgi"]


def test_a_result_in_a_file_is_replaced_while_the_one_before_is_used(index, folder):
    file = folder / "matrix.npy"
    first = index.distance_matrix([0, 7], [1, 2, 3], out=file)
    expected = np.array(first)
    np.testing.assert_allclose(expected, APART[[0, 7], 1:4], rtol=0.02)
    second = index.distance_matrix([9], out=file, dtype="float32")
    np.testing.assert_array_equal(first, expected)
    np.testing.assert_array_equal(np.load(file), second)
    del first, second
    index.distance_matrix([0, 7], [1, 2, 3], out=file)
    np.testing.assert_array_equal(np.load(file), expected)
    assert names(folder) == ["matrix.npy"]


def test_a_file_is_larger_than_4_gib(folder):
    rows, columns = 24_000, 24_000
    if shutil.disk_usage(folder).free < 20 * 2**30:
        pytest.skip("a large file is tried on disks with 20 GiB left")
    file = folder / "large.npy"
    with _output.matrix(rows, columns, file, None) as array:
        array[-1, -3:] = [1.5, 2.5, 3.5]
        del array
    assert file.stat().st_size == 128 + 8 * rows * columns
    with open(file, "rb") as end:
        end.seek(-24, os.SEEK_END)
        assert np.frombuffer(end.read()).tolist() == [1.5, 2.5, 3.5]


def test_files_that_cannot_be_written_are_refused_by_name(index, folder):
    folder_of_none = folder / "none" / "a.vgi"
    with pytest.raises(vorogeo.IndexFileError, match="there is no folder") as refused:
        index.save(folder_of_none)
    assert str(folder_of_none.parent) in str(refused.value)
    with pytest.raises(vorogeo.IndexFileError, match="is a folder; name a file in it"):
        index.save(folder)
    with pytest.raises(vorogeo.IndexFileError, match="There is no index file"):
        vorogeo.GeodesicIndex.load(folder / "a.vgi", *MESH)
    with pytest.raises(vorogeo.IndexFileError, match="is a folder"):
        vorogeo.GeodesicIndex.load(folder, *MESH)
    with pytest.raises(vorogeo.IndexFileError, match="is a device or a pipe; name a plain file"):
        index.save(os.devnull)
    protected = folder / "protected.vgi"
    protected.write_bytes(b"old")
    protected.chmod(0o444)
    if not os.access(protected, os.W_OK):
        with pytest.raises(vorogeo.IndexFileError, match=r"cannot be written \(Permission denied\)"):
            index.save(protected)
        assert protected.read_bytes() == b"old"
    protected.chmod(0o644)
    assert names(folder) == ["protected.vgi"]
    _core.require_memory(1.0, 0, "A byte", "Wait.")
    with pytest.raises(vorogeo.NotEnoughMemory, match=r"of memory available\. Wait"):
        _core.require_memory(2.0**50, 0, "A petabyte", "Wait.")


def program(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """Run the program in a folder; no shell sees its words."""
    command = [sys.executable, "-X", "utf8", "-m", "vorogeo", *words]
    return subprocess.run(command, cwd=folder, capture_output=True, encoding="utf-8", check=False)


def write_off(file: Path, vertices: Any, faces: Any) -> None:
    """A mesh as OFF."""
    lines = ["OFF", f"{len(vertices)} {len(faces)} 0", *(" ".join(map(repr, row)) for row in vertices.tolist())]
    file.write_text("\n".join([*lines, *(f"3 {a} {b} {c}" for a, b, c in faces.tolist())]) + "\n")


def test_the_program_expands_patterns_and_writes_names_with_spaces_and_umlauts(folder):
    (folder / "Netze").mkdir()
    for name in ("eins", "zwei ä", NAME):
        write_off(folder / "Netze" / f"{name}.off", *plane(7, 6))
    found = program(folder, "matrix", os.path.join("Netze", "*.off"), "--out", "Ergebnisse/", "--exact", "--jobs", "2")
    assert found.returncode == 0, found.stderr
    assert found.stdout.splitlines()[-1] == "3 done, 0 kept, 0 failed"
    assert f"{NAME}.npy" in found.stdout
    expected = np.linalg.norm(plane(7, 6)[0][:, None] - plane(7, 6)[0][None], axis=2)
    for name in ("eins", "zwei ä", NAME):
        np.testing.assert_allclose(np.load(folder / "Ergebnisse" / f"{name}.npy"), expected, rtol=1e-9, atol=1e-9)
    mesh = str(folder / "Netze" / f"{NAME}.off")
    printed = program(folder, "distance", mesh, "--from", "0", "--to", "6", "41", "--exact")
    assert [float(line) for line in printed.stdout.split()] == pytest.approx([6.0, np.hypot(6, 5)])
    assert program(folder, "index", mesh, "--out", "ä.vgi", "--quiet").returncode == 0
    asked = program(folder, "field", mesh, "--index", "ä.vgi", "--from", "0", "--out", "feld ü.npy", "--quiet")
    assert asked.returncode == 0, asked.stderr
    np.testing.assert_allclose(np.load(folder / "feld ü.npy"), expected[0], rtol=0.02)
    refused = program(folder, "info", "keine/*.off")
    assert (refused.returncode, refused.stdout) == (1, "")
    assert "keine/*.off: there is no mesh; give files, a folder, or a pattern in quotes." in refused.stderr


def test_ctrl_c_stops_the_program_and_leaves_at_most_what_it_goes_on_from(folder):
    write_off(folder / "a.off", *plane(300, 250))
    pressed = (
        "import signal, sys, threading, vorogeo; from vorogeo.cli.main import main;"
        "signal.signal(signal.SIGINT, signal.default_int_handler);"  # a shell may have it ignored
        "build = vorogeo.GeodesicIndex.__init__;"
        "press = threading.Timer(0.3, signal.raise_signal, [signal.SIGINT]);"
        "vorogeo.GeodesicIndex.__init__ = lambda *mesh, **options: (press.start(), build(*mesh, **options))[1];"
        "sys.exit(main(['index', 'a.off', '--out', 'a.vgi', '--quiet']))"
    )
    stopped = subprocess.run(
        [sys.executable, "-c", pressed], cwd=folder, capture_output=True, encoding="utf-8", check=False
    )
    assert (stopped.returncode, stopped.stdout) == (130, ""), stopped.stderr
    assert stopped.stderr == "vorogeo: interrupted\n"
    # The second one stays if it has begun to fill tables.
    assert set(names(folder)) <= {"a.off", "a.vgi.unfinished"}


def test_the_program_prints_names_that_its_output_cannot_hold(folder):
    write_off(folder / f"{NAME}.off", *plane(4, 4))
    command = [sys.executable, "-m", "vorogeo", "sample", f"{NAME}.off", "--count", "2", "--out", f"{NAME}.npy"]
    environment = {**os.environ, "PYTHONIOENCODING": "ascii"}
    done = subprocess.run(command, cwd=folder, capture_output=True, env=environment, check=False)
    assert done.returncode == 0, done.stderr
    assert rb"Ma\xdfe der H\xf6hle" in done.stdout
    assert np.load(folder / f"{NAME}.npy").shape[0] == 2
