"""Files that replace their target once they are complete: full disks, and folders that may not be written to."""

from __future__ import annotations

import os
import subprocess
import tempfile
from pathlib import Path

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid

MESH = bent_grid(20, 15)


@pytest.fixture(scope="module")
def index():
    return vorogeo.GeodesicIndex(*MESH, patches=(3, 3))


@pytest.fixture
def small_disk(tmp_path):
    """A file system of 64 KiB."""
    folder = tmp_path / "disk"
    folder.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=64k", "vorogeo-test", str(folder)]
    if os.geteuid() != 0 or subprocess.run(mount, capture_output=True, check=False).returncode != 0:
        pytest.skip("mounting a small disk needs the rights of root")
    yield folder
    subprocess.run(["umount", "-l", str(folder)], check=True)


def test_a_full_disk_is_an_error_and_the_old_file_stays(index, small_disk):
    file = small_disk / "a.npy"
    small = index.distance_matrix(range(20), out=file)
    needed = 128 + 8 * 200 * 200
    asked = []
    with pytest.raises(vorogeo.FileError, match=rf"out: the file {file} cannot be written: it takes {needed} bytes"):
        index.distance_matrix(range(200), out=file, progress=lambda *news: asked.append(news))
    assert asked == [], "nothing is computed"
    np.testing.assert_array_equal(np.load(file), small)
    with pytest.raises(vorogeo.FileError, match="No space left on device"):
        index.fields(range(200), out=file)
    (small_disk / "a.vgi").write_bytes(b"old")
    with pytest.raises(vorogeo.IndexFileError, match=r"a.vgi cannot be written: .* \(No space left on device\)"):
        index.save(small_disk / "a.vgi")
    assert (small_disk / "a.vgi").read_bytes() == b"old"
    assert sorted(path.name for path in small_disk.iterdir()) == ["a.npy", "a.vgi"]


@pytest.fixture
def read_only_folder():
    """A folder that the user may not write to; root becomes another user for a while, whom permissions bind."""
    with tempfile.TemporaryDirectory() as name:  # others may not look into folders of pytest
        folder = Path(name)
        folder.chmod(0o555)
        was_root = os.geteuid() == 0
        if was_root:
            os.setegid(65534)
            os.seteuid(65534)
        yield folder
        if was_root:
            os.seteuid(0)
            os.setegid(0)
        folder.chmod(0o755)


def test_a_folder_that_may_not_be_written_is_named_and_stays_empty(index, read_only_folder):
    advice = r" cannot be written \(Permission denied\); check that its folder may be written to, or name another file"
    asked = []
    file = read_only_folder / "a.npy"
    with pytest.raises(vorogeo.FileError, match=rf"out: the file {file}{advice}"):
        index.distance_matrix(range(20), out=file, progress=lambda *news: asked.append(news))
    with pytest.raises(vorogeo.FileError, match=rf"out: the file {file}{advice}"):
        index.fields(range(20), out=file)
    assert asked == [], "nothing is computed"
    file = read_only_folder / "a.vgi"
    with pytest.raises(vorogeo.IndexFileError, match=rf"{file}{advice}"):
        index.save(file)
    with pytest.raises(vorogeo.IndexFileError, match=rf"{file}.unfinished{advice}"):
        vorogeo.GeodesicIndex(*MESH, file=file)
    assert list(read_only_folder.iterdir()) == []
