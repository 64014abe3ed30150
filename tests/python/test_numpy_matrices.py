"""Matrices, pairs within a radius and nearest: types of entries, memory, and what is left when they are stopped."""

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid

MESH = bent_grid(40, 30)
POINTS = np.random.default_rng(5).integers(0, 1200, 12)


@pytest.fixture(scope="module")
def index():
    return vorogeo.GeodesicIndex(*MESH, patches=(5, 4))


CALLS = {
    "distances": lambda i, **how: i.distances(POINTS, POINTS[::-1], **how),
    "distance_matrix": lambda i, **how: i.distance_matrix(POINTS, **how),
    "distance_matrix of two lists": lambda i, **how: i.distance_matrix(POINTS, POINTS[:3], entries="fields", **how),
    "fields": lambda i, **how: i.fields(POINTS[:3], max_distance=0.7, **how),
    "nearest": lambda i, **how: i.nearest(POINTS, POINTS[:5], k=3, **how)[0],
    "pairs_within": lambda i, **how: i.pairs_within(POINTS, 0.9, as_arrays=True, **how).data,
    "distance_field": lambda i, **how: i.distance_field(POINTS[:2], **how),
    "labelled field": lambda i, **how: i.distance_field(POINTS[:2], return_labels=True, **how)[0],
    "exact_distance_field": lambda i, **how: vorogeo.exact_distance_field(*MESH, POINTS[:2], **how),
}


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS.keys())
def test_float32_is_the_rounded_float64(index, call):
    wide = call(index)
    narrow = call(index, dtype="float32")
    assert wide.dtype == np.float64
    assert narrow.dtype == np.float32
    assert np.isfinite(wide).any()
    np.testing.assert_array_equal(narrow, wide.astype(np.float32))


def test_pages_of_a_large_file_leave_the_process(index, tmp_path, monkeypatch):
    monkeypatch.setattr("vorogeo._output._MAPPED_BYTES", 20_000)
    everyone, seen = np.arange(0, 1200, 6), []
    index.distance_matrix(everyone, entries="fields", out=tmp_path / "m.npy", progress=lambda f, _: seen.append(f))
    np.testing.assert_array_equal(np.load(tmp_path / "m.npy"), index.distance_matrix(everyone, entries="fields"))
    assert seen[-1] == 1


def test_pairs_within_without_scipy(index, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "scipy.sparse", None)
    assert isinstance(index.pairs_within(POINTS, 0.3), vorogeo.SparseDistances)


def test_memory_is_checked_before_it_is_taken(index):
    assert vorogeo.matrix_bytes(12, 12) == 1152
    with pytest.raises(MemoryError, match=r"12 x 12.*allowed\. Give"):
        index.distance_matrix(POINTS, max_bytes=1151)
    with pytest.raises(vorogeo.InvalidInput, match="out: is an array of float32"):
        index.fields(POINTS[:1], out=np.empty((1, 1200), np.float32), dtype=np.float64)
    with pytest.raises(vorogeo.NotEnoughMemory, match="available"):
        index.distance_matrix(np.zeros(10**7, dtype=int))
    with pytest.raises(vorogeo.NotEnoughMemory, match="smaller radius"):
        index.pairs_within(POINTS, 10, max_bytes=100)
    estimate = index.pairs_within_bytes(POINTS, 0.5)
    assert 0.5 <= estimate / (28 * index.pairs_within(POINTS, 0.5).nnz) <= 2


def test_cancelled_leaves_no_file(index, tmp_path):
    with pytest.raises(vorogeo.Cancelled):
        index.distance_matrix(POINTS, entries="fields", out=tmp_path / "m.npy", progress=lambda *_: False)
    assert list(tmp_path.iterdir()) == []
