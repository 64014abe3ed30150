"""Files that replace their target once they are complete: full disks, links, writers that are killed.

VOROGEO_KILLS: how often a writer is killed at a random moment (default 20).
"""

from __future__ import annotations

import os
import random
import signal
import subprocess
import time

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid

MESH = bent_grid(20, 15)
KILLS = int(os.environ.get("VOROGEO_KILLS", "20"))


@pytest.fixture(scope="module")
def index():
    return vorogeo.GeodesicIndex(*MESH, patches=(3, 3))


def save(index, file):
    index.save(file)


def write_matrix(index, file):
    index.distance_matrix(range(30), out=file)


def write_fields(index, file):
    index.fields(range(30), out=file)


WRITERS = pytest.mark.parametrize("write", [save, write_matrix, write_fields])


def read(file):
    """The contents, after a check that they are complete."""
    if file.suffix == ".vgi":
        vorogeo.GeodesicIndex.load(file, *MESH)
    else:
        np.load(file)
    return file.read_bytes()


def name_for(write):
    return "a.vgi" if write is save else "a.npy"


@WRITERS
def test_links_stay_and_their_targets_are_written(index, tmp_path, write):
    (tmp_path / "far").mkdir()
    target = tmp_path / "far" / name_for(write)
    link = tmp_path / "link"
    link.symlink_to(target)
    for _ in range(2):  # first a link to nothing
        write(index, link)
        assert link.is_symlink()
        assert not target.is_symlink()
        read(target)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["far", "link"]
    assert [path.name for path in target.parent.iterdir()] == [target.name]


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


@WRITERS
def test_writers_killed_at_any_moment_leave_the_old_or_the_new(index, tmp_path, write):
    file = tmp_path / name_for(write)
    other = vorogeo.GeodesicIndex(*MESH, patches=(3, 3), seed=5)
    write(index, file)
    contents = [read(file)]
    began = time.perf_counter()
    write(other, file)
    duration = time.perf_counter() - began
    contents.append(read(file))
    assert contents[0] != contents[1]
    moments = random.Random(2)
    halves = 0
    for _ in range(KILLS):
        child = os.fork()
        if child == 0:
            while True:
                write(index, file)
                write(other, file)
        time.sleep(moments.uniform(0, 4 * duration))
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        assert read(file) in contents
        left = [path.name for path in tmp_path.iterdir() if path != file]
        assert all(name.startswith(f"{file.name}.vorogeo-") and name.endswith(".part") for name in left)
        assert len(left) <= 1, "each writer removes what the one before has left"
        halves += len(left)
    write(index, file)
    assert read(file) == contents[0]
    assert list(tmp_path.iterdir()) == [file]
    print(f"{write.__name__}: {KILLS} writers killed, {halves} of them in the middle of a file")
