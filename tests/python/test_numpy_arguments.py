"""Wrong shapes, types and ranges are ValueErrors that name the element; any number of numpy is a number."""

import numpy as np
import pytest
import vorogeo
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from sample_meshes import cube, plane_grid

VERTICES, FACES = plane_grid(5, 4)


BAD_IDS = [
    (2**40, ": there is no vertex 1099511627776"),
    ([0.0, 1.25], r": has type float64, not integer: (sources|source|target)\[1\] is 1\.25; give a vertex id"),
    (0.5, ": has type float64, not integer: (sources|source|target) is 0.5; give a vertex id"),
    (1e300, ": there is no vertex"),
    (float("nan"), ": has type float64"),
    (True, ": has type bool"),
    ([[0, 1]], r": has shape \(1, 2\)"),
    (None, ": is not an array of numbers"),
    (2**70, ": is not an array of numbers"),
    ([0, [1]], ": cannot be read as an array"),
]


@pytest.fixture(scope="module")
def index():
    return vorogeo.GeodesicIndex(VERTICES, FACES)


@pytest.mark.parametrize(("ids", "message"), BAD_IDS)
def test_bad_ids(index, ids, message):
    other = [0] * len(ids) if isinstance(ids, list) else 0
    with pytest.raises(ValueError, match="sources" + message):
        index.distance_field(ids)
    with pytest.raises(ValueError, match="sources" + message):
        vorogeo.exact_distance_field(VERTICES, FACES, ids)
    with pytest.raises(ValueError, match="source" + message):
        index.distance(ids, other)
    with pytest.raises(ValueError, match="target" + message):
        index.distance(other, ids)


def test_one_point_goes_with_each_of_many(index):
    expected = [index.distance(3, i) for i in range(5)]
    np.testing.assert_array_equal(index.distance(3, range(5)), expected)
    np.testing.assert_array_equal(index.distances(np.arange(5.0)[:, None], 3.0), expected)
    assert [path.length for path in index.path(3, range(5))] == pytest.approx(
        [p.length for p in (index.path(3, i) for i in range(5))]
    )


REFUSED = {
    "max_distance: ": [
        (lambda i, bad=bad: i.distance_field(0, max_distance=bad)) for bad in ("far", [1.0, 2.0], True, -np.inf)
    ],
    "layer: ": [(lambda i, bad=bad: i.face_patches(bad)) for bad in (0, 3, -1, 1.0, "1", None)],
    "delta: -0.001 is out of range": [lambda i: made(delta=-0.001)],
    "delta: is NaN": [lambda i: made(delta=float("nan"))],
    "delta: 'small' is not a real number": [lambda i: made(delta="small")],
    "threads: -2 is out of range": [lambda i: made(threads=-2), lambda i: vorogeo.Surface(VERTICES, FACES, threads=-2)],
    "threads: 1.5 is not an integer": [lambda i: made(threads=1.5)],
    "threads: 1000000 is out of range": [lambda i: made(threads=10**6)],
    "seed: -1 is out of range": [lambda i: made(seed=-1), lambda i: i.sample_poisson_disk(1, seed=-1)],
    "seed: 18446744073709551616 is out of range": [lambda i: made(seed=2**64)],
    "seed: 0.0 is not an integer": [lambda i: made(seed=0.0)],
    "patches: has 3 entries": [lambda i: made(patches=(2, 3, 4))],
    "patches: 4 is not a pair": [lambda i: made(patches=4)],
    "patches: '44' is not a pair": [lambda i: made(patches="44")],
    r"patches\[0\]: -1 is out of range": [lambda i: made(patches=(-1, 2))],
    r"patches\[1\]: 2.5 is not an integer": [lambda i: made(patches=(2, 2.5))],
    "memory_budget: ": [lambda i, bad=bad: made(memory_budget=bad) for bad in (0, -5, 1.5, "much")],
    "progress: 'yes' is not a function": [lambda i: made(progress="yes")],
    "Level 0 is nan": [lambda i: i.isolines(np.zeros(20), [float("nan")])],
    "count: 0 is out of range": [lambda i: i.sample_farthest(0)],
    "landmarks: ": [lambda i: i.prepare_exact_paths(0), lambda i: i.prepare_exact_paths(33)],
}


def made(**options):
    return vorogeo.GeodesicIndex(VERTICES, FACES, **options)


@pytest.mark.parametrize("message", REFUSED)
def test_bad_options(index, message):
    for call in REFUSED[message]:
        with pytest.raises(vorogeo.InvalidInput, match=message):
            call(index)


def test_numpy_scalars_are_numbers(index):
    assert index.distance(np.uint8(3), np.array(3)) == 0.0
    assert isinstance(index.distance(np.int64(0), 1), float)
    assert vorogeo.exact_distance_field(cube()[0].astype(np.int16), cube()[1], 0)[7] == pytest.approx(np.sqrt(5))
    options = {"patches": np.array([2, 2]), "delta": np.float32(0), "threads": np.int8(1), "seed": np.uint64(2**64 - 1)}
    assert vorogeo.GeodesicIndex(VERTICES, FACES, **options).statistics.seed == 2**64 - 1


ID_TYPES = st.sampled_from([np.int64, np.int8, np.uint64, np.float64])


@given(arrays.arrays(ID_TYPES, arrays.array_shapes(max_dims=2, max_side=4), elements={"min_value": 0, "max_value": 19}))
def test_any_small_array_is_answered_or_refused(ids):
    flat = ids[:, 0] if ids.ndim == 2 and ids.shape[1] == 1 else ids
    if flat.ndim == 1 and (flat == np.rint(flat)).all():
        assert (vorogeo.exact_distance_field(VERTICES, FACES, ids)[flat.astype(int)] == 0).all()
    else:
        with pytest.raises(vorogeo.InvalidInput, match="sources: has "):
            vorogeo.exact_distance_field(VERTICES, FACES, ids)
