"""Index files: round trip, and every damaged, foreign or stale file is refused."""

import shutil
from pathlib import Path

import numpy as np
import pytest
import vorogeo
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

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


def test_takes_strings_and_paths_and_overwrites(index, saved, tmp_path):
    file = tmp_path / "a.index"
    file.write_bytes(b"something else")
    index.save(str(file))
    assert file.read_bytes() == saved.read_bytes()
    assert [entry.name for entry in tmp_path.iterdir()] == ["a.index"]
    vorogeo.GeodesicIndex.load(str(file), *MESH, threads=1)


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


def test_stale_after_any_edit_of_the_mesh(saved):
    vertices, faces = MESH
    moved = vertices.copy()
    moved[17, 2] = np.nextafter(moved[17, 2], 9)
    swapped = faces.copy()
    swapped[[0, 1]] = swapped[[1, 0]]
    longer = np.vstack([vertices, [9, 9, 9]])
    for edited in ((moved, faces), (vertices, swapped), (vertices, faces[:-1]), (longer, faces)):
        with pytest.raises(vorogeo.IndexFileError, match="mesh"):
            vorogeo.GeodesicIndex.load(saved, *edited)


def test_missing_file_is_an_os_error(tmp_path):
    with pytest.raises(OSError, match=r"There is no index file .*no\.index; check the name"):
        vorogeo.GeodesicIndex.load(tmp_path / "no.index", *MESH)
    with pytest.raises(vorogeo.IndexFileError, match="is a folder; name a file in it"):
        vorogeo.GeodesicIndex.load(tmp_path, *MESH)


def test_unwritable_place(index, tmp_path):
    with pytest.raises(vorogeo.IndexFileError, match="nowhere"):
        index.save(tmp_path / "nowhere" / "a.index")
    with pytest.raises(vorogeo.IndexFileError, match="is a folder; name a file in it"):
        index.save(tmp_path)


@pytest.mark.parametrize("content", [b"", b"ply\nformat ascii 1.0\n", bytes(5000), b"\xff" * 5000])
def test_other_files_are_refused(tmp_path, content):
    file = tmp_path / "other"
    file.write_bytes(content)
    with pytest.raises(vorogeo.IndexFileError):
        vorogeo.GeodesicIndex.load(file, *MESH)


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.data())
def test_flipped_bits_are_refused(saved, tmp_path, data):
    content = bytearray(saved.read_bytes())
    place = data.draw(st.one_of(st.integers(0, 255), st.integers(0, len(content) - 1)))
    content[place] ^= 1 << data.draw(st.integers(0, 7))
    file = tmp_path / "flipped"
    file.write_bytes(content)
    with pytest.raises(vorogeo.IndexFileError):
        vorogeo.GeodesicIndex.load(file, *MESH)


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
