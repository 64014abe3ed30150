"""Matrices, pairs within a radius and nearest: values against distances and fields, files, memory, bad input."""

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid, plane_grid, side_by_side

GRID = bent_grid(40, 30)
MESH = side_by_side(GRID, plane_grid(5, 5))
POINTS = np.random.default_rng(3).integers(0, 1200, 25)
ACROSS = np.append(POINTS[:12], [1200, 1224, POINTS[0]])  # both components, one vertex twice


@pytest.fixture(scope="module")
def index():
    return vorogeo.GeodesicIndex(*MESH, patches=(5, 4))


def test_pairs_within_as_arrays_and_between_two_lists(index):
    found = index.pairs_within(POINTS[:5], 0.4, others=ACROSS, as_arrays=True)
    assert isinstance(found, vorogeo.SparseDistances)
    assert found.shape == (5, len(ACROSS))
    for row, point in enumerate(POINTS[:5]):
        columns = found.indices[found.indptr[row] : found.indptr[row + 1]]
        field = index.distance_field(point, max_distance=0.4)[ACROSS]
        np.testing.assert_array_equal(columns, np.flatnonzero(np.isfinite(field)))


def test_pairs_within_without_scipy(index, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "scipy.sparse", None)
    assert isinstance(index.pairs_within(POINTS, 0.3), vorogeo.SparseDistances)


def test_matrix_in_a_file_is_mapped(index, tmp_path):
    file = tmp_path / "matrix.npy"
    mapped = index.distance_matrix(POINTS, out=file)
    assert isinstance(mapped, np.memmap)
    np.testing.assert_array_equal(np.load(file), index.distance_matrix(POINTS))
    index.fields(POINTS[:2], out=str(file))
    np.testing.assert_array_equal(np.load(file), index.fields(POINTS[:2]))
    assert index.distance_matrix([], out=file).shape == (0, 0)
    assert np.load(file).shape == (0, 0)
    assert [path.name for path in tmp_path.iterdir()] == ["matrix.npy"]


def test_memory_is_checked_before_it_is_taken(index):
    assert vorogeo.matrix_bytes(25, 25) == 5000
    with pytest.raises(MemoryError, match=r"25 x 25.*max_bytes"):
        index.distance_matrix(POINTS, max_bytes=4999)
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


def test_progress_ends_at_one(index):
    seen = []
    index.fields(POINTS, progress=lambda fraction, text: seen.append(fraction))
    assert seen == sorted(seen)
    assert seen[-1] == 1


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda i: i.distance_matrix([0, 5000]), r"points\[1\]: there is no vertex 5000"),
        (lambda i: i.distance_matrix([0], entries="guess"), "entries: 'guess' is unknown"),
        (lambda i: i.distance_matrix([0], out="/nowhere/x.npy"), "out:"),
        (lambda i: i.distances([0, 1], [2]), "give as many of one as of the other"),
        (lambda i: i.fields([0], max_distance=-1), "max_distance: -1.0 is negative"),
        (lambda i: i.pairs_within([0], -1), "radius: -1.0 is negative"),
        (lambda i: i.pairs_within([0], float("nan")), "radius: is NaN"),
        (lambda i: i.nearest([0], [0], k=0), "k: 0 is out of range"),
    ],
)
def test_bad_arguments_are_named(index, call, message):
    with pytest.raises(vorogeo.InvalidInput, match=message):
        call(index)
