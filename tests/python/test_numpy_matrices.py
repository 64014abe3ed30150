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


@pytest.mark.parametrize("method", ["automatic", "pairs", "fields"])
def test_matrix_is_symmetric_and_near_the_exact_fields(index, method):
    matrix = index.distance_matrix(ACROSS, entries=method)
    assert matrix.dtype == np.float64
    np.testing.assert_array_equal(matrix, matrix.T)
    exact = np.array([vorogeo.exact_distance_field(*MESH, point)[ACROSS] for point in ACROSS])
    np.testing.assert_array_equal(np.isinf(matrix), np.isinf(exact))
    np.testing.assert_array_equal(matrix == 0, exact == 0)
    np.testing.assert_allclose(matrix, exact, rtol=0.02)


def test_matrix_by_pairs_equals_distance(index):
    rows, columns = POINTS[:6], ACROSS
    a, b = (part.ravel() for part in np.meshgrid(rows, columns, indexing="ij"))
    expected = index.distance(a, b)
    np.testing.assert_array_equal(index.distances(a, b), expected)
    np.testing.assert_array_equal(index.distance_matrix(rows, columns, entries="pairs").ravel(), expected)


def test_fields_equal_distance_field(index):
    fields = index.fields(POINTS[:4], max_distance=0.5)
    for row, source in zip(fields, POINTS[:4], strict=True):
        np.testing.assert_array_equal(row, index.distance_field(source, max_distance=0.5))


def test_pairs_within_equal_brute_force(index):
    sparse = pytest.importorskip("scipy.sparse")
    full = index.distance_matrix(ACROSS, entries="fields")
    found = index.pairs_within(ACROSS, 0.6)
    assert sparse.issparse(found)
    assert found.format == "csr"
    expected = (full <= 0.6) & ~np.eye(len(ACROSS), dtype=bool)
    stored = found.tocoo()
    assert set(zip(stored.row.tolist(), stored.col.tolist(), strict=True)) == set(
        map(tuple, np.argwhere(expected).tolist())
    )
    # A field that ends at the radius and one over the whole mesh may differ within their errors.
    np.testing.assert_allclose(stored.data, full[stored.row, stored.col], rtol=0.02)


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


def test_nearest_are_the_least_of_the_fields(index):
    for points, queries in [(POINTS, ACROSS), (ACROSS, np.arange(0, 1225, 9))]:
        distances, positions = index.nearest(points, queries, k=3)
        matrix = index.distance_matrix(points, queries, entries="fields").T
        np.testing.assert_allclose(distances, np.sort(matrix, axis=1)[:, :3], rtol=0.02)
        reached = positions >= 0
        np.testing.assert_array_equal(reached, np.isfinite(distances))
        rows = np.broadcast_to(np.arange(len(queries))[:, None], positions.shape)
        np.testing.assert_allclose(distances[reached], matrix[rows[reached], positions[reached]], rtol=0.02)


def test_nearest_with_k_above_the_size_of_the_set(index):
    distances, positions = index.nearest([7, 1201], [7], k=4)
    np.testing.assert_array_equal(positions, [[0, -1, -1, -1]])
    np.testing.assert_array_equal(distances, [[0, np.inf, np.inf, np.inf]])


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


def test_matrix_in_an_array_of_the_caller(index):
    out = np.empty((3, 3))
    assert index.distance_matrix(POINTS[:3], out=out) is out
    for bad in (np.empty((3, 2)), np.empty((3, 3), dtype=np.float16), np.empty((3, 3), order="F")):
        with pytest.raises(vorogeo.InvalidInput, match="out"):
            index.distance_matrix(POINTS[:3], out=bad)


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


def test_nothing_asked_gives_empty_results(index):
    assert index.distances([], []).shape == (0,)
    assert index.distance_matrix([]).shape == (0, 0)
    assert index.distance_matrix([], POINTS).shape == (0, 25)
    assert index.fields([]).shape == (0, 1225)
    assert index.pairs_within([], 1).shape == (0, 0)
    assert index.pairs_within_bytes([], 1) == 0
    assert index.nearest([], [1, 2])[1].tolist() == [[-1], [-1]]


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
