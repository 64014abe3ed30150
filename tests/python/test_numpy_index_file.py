"""Index files: round trip, and every damaged, foreign or stale file is refused."""

import shutil
from pathlib import Path

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid

MESH = bent_grid(30, 25)


@pytest.fixture(scope="module")
def index():
    return vorogeo.GeodesicIndex(*MESH, patches=(3, 3))


@pytest.fixture(scope="module")
def saved(index, tmp_path_factory):
    file = tmp_path_factory.mktemp("index") / "mesh with spaces ö.index"
    index.save(file)
    return file


@pytest.mark.skipif(not Path("/proc/self/maps").exists(), reason="this system does not list mappings")
def test_large_tables_lie_in_the_file_unless_they_are_copied(index, saved, tmp_path):
    file = shutil.copy(saved, tmp_path / "own.index")
    mine = vorogeo.GeodesicIndex.load(file, *MESH, mapped=False)
    assert str(file) not in Path("/proc/self/maps").read_text()
    assert mine.statistics.mapped_bytes == index.statistics.mapped_bytes == 0
    shared = vorogeo.GeodesicIndex.load(file, *MESH)
    assert str(file) in Path("/proc/self/maps").read_text()
    assert 0 < shared.statistics.mapped_bytes < file.stat().st_size
    assert shared.statistics.bytes == mine.statistics.bytes
    vorogeo.GeodesicIndex(*bent_grid(12, 9)).save(file)  # what lay there stays as long as it is used
    np.testing.assert_array_equal(shared.distance_field(7), mine.distance_field(7))
    file.unlink()
    np.testing.assert_array_equal(shared.distance_field(11), mine.distance_field(11))
    del shared
    assert str(file) not in Path("/proc/self/maps").read_text()


@pytest.mark.parametrize("file", ["", "a\0b", 3, None])
def test_bad_file_names(index, file):
    with pytest.raises(ValueError, match="file: "):
        index.save(file)
    with pytest.raises(ValueError, match="file: "):
        vorogeo.GeodesicIndex.load(file, *MESH)
