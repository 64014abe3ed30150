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
    file.unlink()  # its contents stay as long as they are used
    np.testing.assert_array_equal(shared.distance_field(7), mine.distance_field(7))
    del shared
    assert str(file) not in Path("/proc/self/maps").read_text()


@pytest.mark.parametrize("file", ["", "a\0b", 3, None])
def test_bad_file_names(index, file):
    with pytest.raises(ValueError, match="file: "):
        index.save(file)
    with pytest.raises(ValueError, match="file: "):
        vorogeo.GeodesicIndex.load(file, *MESH)


def unfinished(file):
    return file.with_name(file.name + ".unfinished")


def test_built_in_its_file_it_is_the_one_that_is_saved(index, saved, tmp_path):
    file = tmp_path / "a.vgi"
    built = vorogeo.GeodesicIndex(*MESH, patches=(3, 3), file=file)
    assert file.read_bytes() == saved.read_bytes()
    assert [entry.name for entry in tmp_path.iterdir()] == ["a.vgi"]
    assert built.statistics.seconds > 0
    assert 0 < built.statistics.mapped_bytes < built.statistics.bytes == index.statistics.bytes
    again = vorogeo.GeodesicIndex(*MESH, patches=(3, 3), file=str(file))
    assert again.statistics.seconds == 0, "it is loaded"
    for one in (built, again):
        np.testing.assert_array_equal(one.distance_field([5, 600]), index.distance_field([5, 600]))


def test_a_build_that_was_stopped_goes_on(saved, tmp_path):
    file = tmp_path / "a.vgi"
    seen = []

    def until(text):
        def report(fraction, now):
            seen.append((fraction, now))
            return not now.startswith(text)

        return report

    for phase in ("Computing", "Composing", "Tabulating", "Placing landmarks"):
        with pytest.raises(vorogeo.Cancelled):
            vorogeo.GeodesicIndex(*MESH, patches=(3, 3), file=file, progress=until(phase))
        assert unfinished(file).exists()
        assert not file.exists()
        with pytest.raises(vorogeo.IndexFileError, match="is not an index file"):
            vorogeo.GeodesicIndex.load(unfinished(file), *MESH)
    del seen[:]
    vorogeo.GeodesicIndex(*MESH, patches=(3, 3), file=file, progress=until("nothing"))
    # All tables were there: each of these phases begins at its end.
    composing = [fraction for fraction, text in seen if text.startswith("Composing")]
    assert composing
    assert min(composing) > 0.849
    assert file.read_bytes() == saved.read_bytes()
    assert not unfinished(file).exists()


def test_a_build_does_not_go_on_for_another_mesh(tmp_path):
    file = tmp_path / "a.vgi"
    with pytest.raises(vorogeo.Cancelled):
        vorogeo.GeodesicIndex(*MESH, patches=(3, 3), file=file, progress=lambda _, text: "Compos" not in text)
    begun = unfinished(file).read_bytes()
    moved = MESH[0].copy()
    moved[17, 2] = np.nextafter(moved[17, 2], 9)
    with pytest.raises(vorogeo.IndexFileError, match=r"unfinished is of another mesh, .*; remove it or name another"):
        vorogeo.GeodesicIndex(moved, MESH[1], patches=(3, 3), file=file)
    with pytest.raises(vorogeo.IndexFileError, match="has other options"):
        vorogeo.GeodesicIndex(*MESH, patches=(3, 3), seed=1, file=file)
    assert unfinished(file).read_bytes() == begun
    with pytest.raises(vorogeo.IndexFileError, match="there is no folder"):
        vorogeo.GeodesicIndex(*MESH, file=tmp_path / "no" / "a.vgi")
