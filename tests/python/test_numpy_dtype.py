"""float32 and exact results everywhere: the rounded doubles, and the distances of the plane and of the exact field."""

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid, plane_grid

MESH = bent_grid(40, 30)
POINTS = np.random.default_rng(5).integers(0, 1200, 12)
FLAT = plane_grid(15, 12, 1.4, 1.1)
APART = np.linalg.norm(FLAT[0][:, None] - FLAT[0][None], axis=2)


@pytest.fixture(scope="module")
def index():
    return vorogeo.GeodesicIndex(*MESH, patches=(5, 4))


@pytest.fixture(scope="module")
def flat():
    return vorogeo.GeodesicIndex(*FLAT, patches=(3, 2))


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


def test_float32_goes_to_files_and_arrays_of_the_caller(index, tmp_path):
    expected = index.distance_matrix(POINTS, dtype=np.float32)
    mapped = index.distance_matrix(POINTS, out=tmp_path / "m.npy", dtype=np.float32)
    assert mapped.dtype == np.float32
    np.testing.assert_array_equal(np.load(tmp_path / "m.npy"), expected)
    out = np.empty((12, 12), np.float32)
    assert index.distance_matrix(POINTS, out=out) is out
    np.testing.assert_array_equal(out, expected)
    assert vorogeo.matrix_bytes(12, 12, "float32") == out.nbytes == (tmp_path / "m.npy").stat().st_size - 128
    with pytest.raises(vorogeo.InvalidInput, match="out: is an array of float32"):
        index.fields(POINTS[:1], out=np.empty((1, 1200), np.float32), dtype=np.float64)


def test_pages_of_a_large_file_leave_the_process(index, tmp_path, monkeypatch):
    monkeypatch.setattr("vorogeo._output._MAPPED_BYTES", 20_000)
    everyone, seen = np.arange(0, 1200, 6), []
    index.distance_matrix(everyone, entries="fields", out=tmp_path / "m.npy", progress=lambda f, _: seen.append(f))
    np.testing.assert_array_equal(np.load(tmp_path / "m.npy"), index.distance_matrix(everyone, entries="fields"))
    assert seen[-1] == 1


def test_exact_fields_take_every_kind_of_source(flat):
    middle = flat.snap([0.53, 0.41, 0.0])
    curve = vorogeo.EdgeCurve([0, 1, 2, 3], spacing=0.01)
    sources = [middle, 179, curve]
    field, label = flat.distance_field(sources, offsets=[0.1, 0.0, 0.05], return_labels=True, method="exact")
    x, y = FLAT[0][:, 0], FLAT[0][:, 1]
    expected = np.stack(
        [
            np.hypot(x - 0.53, y - 0.41) + 0.1,
            np.hypot(x - 1.4, y - 1.1),
            np.hypot(np.maximum(x - 0.3, 0), y) + 0.05,
        ]
    )
    np.testing.assert_allclose(field, expected.min(axis=0), atol=1e-3)  # a curve is points 0.01 apart
    sure = np.sort(expected, axis=0)[1] - expected.min(axis=0) > 2e-3
    np.testing.assert_array_equal(label[sure], expected.argmin(axis=0)[sure])
    near, owner = flat.distance_field(179, max_distance=0.2, method="exact", return_labels=True)
    np.testing.assert_array_equal(np.isfinite(near), APART[179] <= 0.2)
    np.testing.assert_array_equal(owner, np.where(APART[179] <= 0.2, 0, -1))
