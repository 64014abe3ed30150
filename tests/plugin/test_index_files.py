"""Index files, the description of the index, and how long an index lives."""

from __future__ import annotations

import gc
from pathlib import Path

import numpy as np
import pytest
from support import (
    DESCRIBE_INDEX,
    FROM_POINT,
    INDEX,
    LOAD_INDEX,
    SAVE_INDEX,
    fails_and_changes_nothing,
    field,
    grid,
    mesh_set,
    sphere,
)


def stretched(factor: float):
    """A mesh of its own for every test, so that no test finds the index of another."""
    vertices, faces = sphere(3)
    return mesh_set(vertices * np.array([1.0, 1.0, factor]), faces)


def test_description_before_and_after_building():
    ms = stretched(1.01)
    assert ms.apply_filter(DESCRIBE_INDEX) == {"has_index": False}
    built = ms.apply_filter(INDEX)
    assert ms.apply_filter(DESCRIBE_INDEX) == {**built, "has_index": True}


def test_description_after_an_edit():
    ms = stretched(1.02)
    ms.apply_filter(INDEX)
    ms.apply_filter("compute_matrix_from_translation", axisx=1.0)
    ms.apply_filter("apply_matrix_freeze")
    assert not ms.apply_filter(DESCRIBE_INDEX)["has_index"]


def test_saved_index_is_loaded_for_the_same_mesh_in_another_document(tmp_path):
    file = tmp_path / "sphere.vgi"
    ms = stretched(1.03)
    ms.apply_filter(FROM_POINT, vertex_index=5, method="index")
    expected = field(ms).copy()
    saved = ms.apply_filter(SAVE_INDEX, index_file=str(file))
    assert saved["file_bytes"] == file.stat().st_size
    del ms
    gc.collect()
    ms = stretched(1.03)
    loaded = ms.apply_filter(LOAD_INDEX, index_file=str(file))
    assert loaded["vertices"] == 642
    assert loaded["seconds"] == 0
    assert ms.apply_filter(FROM_POINT, vertex_index=5, method="index")["index_reused"]
    np.testing.assert_array_equal(field(ms), expected)


def test_nothing_to_save(tmp_path):
    ms = stretched(1.04)
    with fails_and_changes_nothing(ms, "There is no index for this mesh as it is. Run 'Geodesic index: build"):
        ms.apply_filter(SAVE_INDEX, index_file=str(tmp_path / "none.vgi"))
    assert list(tmp_path.iterdir()) == []


def test_index_of_another_mesh_is_refused(tmp_path):
    file = tmp_path / "grid.vgi"
    mesh_set(*grid(7, 5, spacing=1.05)).apply_filter(INDEX, index_file=str(file))
    ms = stretched(1.05)
    with fails_and_changes_nothing(ms, "another mesh"):
        ms.apply_filter(LOAD_INDEX, index_file=str(file))
    assert not ms.apply_filter(DESCRIBE_INDEX)["has_index"]


def test_damaged_index_is_refused(tmp_path):
    file = tmp_path / "cut.vgi"
    ms = stretched(1.06)
    ms.apply_filter(INDEX, index_file=str(file))
    file.write_bytes(file.read_bytes()[:-100])
    with fails_and_changes_nothing(ms, str(file)):
        ms.apply_filter(LOAD_INDEX, index_file=str(file))


@pytest.mark.parametrize(
    ("name", "file", "message"),
    [
        (LOAD_INDEX, "missing.vgi", "missing.vgi"),
        (LOAD_INDEX, "", "No index file is named"),
        (SAVE_INDEX, "", "No index file is named"),
        (SAVE_INDEX, "no/folder/x.vgi", "there is no folder"),
    ],
)
def test_files_that_cannot_be(tmp_path, name, file, message):
    ms = stretched(1.07)
    with fails_and_changes_nothing(ms, message):
        ms.apply_filter(name, index_file=str(tmp_path / file) if file else "")


def test_index_is_freed_with_its_document():
    ms = stretched(1.08)
    ms.apply_filter(INDEX)
    del ms
    gc.collect()
    assert not stretched(1.08).apply_filter(DESCRIBE_INDEX)["has_index"]


def test_index_lives_as_long_as_one_document_uses_it():
    first, second = stretched(1.09), stretched(1.09)
    first.apply_filter(INDEX)
    assert second.apply_filter(FROM_POINT, vertex_index=0)["index_reused"]
    del first
    gc.collect()
    assert second.apply_filter(DESCRIBE_INDEX)["has_index"]


def test_file_names_with_letters_of_other_languages(tmp_path: Path):
    file = tmp_path / "größe мир.vgi"
    ms = stretched(1.10)
    ms.apply_filter(INDEX)
    ms.apply_filter(SAVE_INDEX, index_file=str(file))
    assert file.is_file()
    assert ms.apply_filter(LOAD_INDEX, index_file=str(file))["vertices"] == 642
