"""Arrays of any layout are accepted; wrong shapes, types and ranges are ValueErrors that name the element."""

import numpy as np
import pytest
import vorogeo
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from sample_meshes import cube, plane_grid

VERTICES, FACES = plane_grid(5, 4)
EXPECTED = np.linalg.norm(VERTICES - VERTICES[0], axis=1)


def replaced(array, index, value):
    changed = array.copy()
    changed[index] = value
    return changed


@pytest.mark.parametrize(
    ("vertices", "faces"),
    [
        (VERTICES.tolist(), FACES.tolist()),
        (VERTICES.astype(np.float32), FACES.astype(np.int64)),
        (np.asfortranarray(VERTICES), np.asfortranarray(FACES)),
        (np.hstack([VERTICES, VERTICES])[:, 3:], np.repeat(FACES, 2, axis=0)[::2]),
        (VERTICES.astype(">f8"), FACES.astype(np.uint8)),
        (VERTICES.astype(np.longdouble), FACES.astype(">u8")),
    ],
    ids=["lists", "float32", "fortran", "strided", "big endian", "long double"],
)
def test_layouts_and_types_are_converted(vertices, faces):
    field = vorogeo.exact_distance_field(vertices, faces, 0)
    np.testing.assert_allclose(field, EXPECTED, rtol=1e-6)
    index = vorogeo.GeodesicIndex(vertices, faces)
    np.testing.assert_allclose(index.distance_field(0), EXPECTED, rtol=1e-2)


def test_integer_vertices_are_converted():
    vertices, faces = cube()
    field = vorogeo.exact_distance_field(vertices.astype(np.int16), faces, 0)
    assert field[7] == pytest.approx(np.sqrt(5))


def test_inputs_are_not_changed():
    vertices, faces = VERTICES.copy(), FACES.copy()
    vertices.setflags(write=False)
    faces.setflags(write=False)
    vorogeo.GeodesicIndex(vertices, faces).distance_field(0)
    vorogeo.exact_distance_field(vertices, faces, 0)


BAD_MESHES = [
    (VERTICES[:, :2], FACES, r"vertices: has shape \(20, 2\)"),
    (VERTICES.ravel(), FACES, r"vertices: has shape \(60,\)"),
    (VERTICES[None], FACES, r"vertices: has shape \(1, 20, 3\)"),
    ([[0, 0, 0], [1, 0]], FACES, "vertices: cannot be read"),
    ("mesh.ply", FACES, "vertices: is not an array of numbers"),
    (None, FACES, "vertices: is None; give positions"),
    (VERTICES + 0j, FACES, "vertices: is not an array of numbers"),
    (VERTICES > 0, FACES, "vertices: has type bool"),
    (replaced(VERTICES, (7, 1), np.nan), FACES, r"vertices\[7\]: .*nan.* is not finite"),
    (replaced(VERTICES, (19, 2), -np.inf), FACES, r"vertices\[19\]: .* is not finite"),
    (VERTICES, FACES[:, :2], r"faces: has shape \(24, 2\)"),
    (VERTICES, np.hstack([FACES, FACES[:, :1]]), r"faces: has shape \(24, 4\)"),
    (VERTICES, FACES.astype(float), "faces: has type float64, not integer"),
    (VERTICES, FACES > 0, "faces: has type bool, not integer"),
    (VERTICES, replaced(FACES, (3, 2), 20), r"faces\[3\]: names vertex 20, but the mesh has vertices 0 to 19"),
    (VERTICES, replaced(FACES, (5, 0), -1), r"faces\[5\]: names vertex -1"),
    (VERTICES, replaced(FACES.astype(np.int64), (5, 0), 2**32), r"faces\[5\]: names vertex 4294967296"),
    (np.empty((0, 3)), FACES, "the mesh has no vertices"),
    ([], FACES, r"vertices: has shape \(0,\)"),
]


@pytest.mark.parametrize(("vertices", "faces", "message"), BAD_MESHES)
def test_bad_meshes(vertices, faces, message):
    with pytest.raises(ValueError, match=message):
        vorogeo.GeodesicIndex(vertices, faces)
    with pytest.raises(ValueError, match=message):
        vorogeo.exact_distance_field(vertices, faces, 0)


def test_index_needs_a_face():
    with pytest.raises(ValueError, match="face"):
        vorogeo.GeodesicIndex(VERTICES, np.empty((0, 3), dtype=int))


BAD_IDS = [
    (20, ": there is no vertex 20; the mesh has vertices 0 to 19"),
    (-1, ": there is no vertex -1"),
    (2**40, ": there is no vertex 1099511627776"),
    ([0, 1, 20], r"\[2\]: there is no vertex 20"),
    ([0, -3, 20], r"\[1\]: there is no vertex -3"),
    (1.5, ": has type float64, not integer"),
    ([0.0, 1.25], ": has type float64, not integer"),
    (1e300, ": there is no vertex"),
    (float("nan"), ": has type float64"),
    (True, ": has type bool"),
    ([[0, 1]], r": has shape \(1, 2\)"),
    ("0", ": is not an array of numbers"),
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


@pytest.mark.parametrize("empty", [[], (), np.empty(0, dtype=int)])
def test_empty_sources(index, empty):
    with pytest.raises(ValueError, match="sources: is empty; give at least one vertex id"):
        index.distance_field(empty)
    with pytest.raises(ValueError, match="sources: is empty"):
        vorogeo.exact_distance_field(VERTICES, FACES, empty)


def test_pairs_have_equal_lengths(index):
    with pytest.raises(ValueError, match="source has 2 points, target 3; give as many of one as of the other"):
        index.distance([0, 1], [0, 1, 2])
    assert index.distance([], []).shape == (0,)


def test_one_point_goes_with_each_of_many(index):
    expected = [index.distance(3, i) for i in range(5)]
    np.testing.assert_array_equal(index.distance(3, range(5)), expected)
    np.testing.assert_array_equal(index.distances(np.arange(5.0)[:, None], 3.0), expected)
    assert [path.length for path in index.path(3, range(5))] == pytest.approx(
        [p.length for p in (index.path(3, i) for i in range(5))]
    )


@pytest.mark.parametrize("bad", [-0.1, float("nan"), "far", [1.0, 2.0], True, -np.inf])
def test_bad_max_distance(index, bad):
    with pytest.raises(ValueError, match="max_distance: "):
        index.distance_field(0, max_distance=bad)
    with pytest.raises(ValueError, match="max_distance: "):
        vorogeo.exact_distance_field(VERTICES, FACES, 0, max_distance=bad)


BAD_OPTIONS = [
    ({"delta": -0.001}, "delta: -0.001 is out of range"),
    ({"delta": 1.0}, "delta: 1.0 is out of range"),
    ({"delta": float("nan")}, "delta: is NaN"),
    ({"delta": "small"}, "delta: 'small' is not a real number"),
    ({"threads": 0}, "threads: 0 is out of range"),
    ({"threads": -2}, "threads: -2 is out of range"),
    ({"threads": 1.5}, "threads: 1.5 is not an integer"),
    ({"threads": 10**6}, "threads: 1000000 is out of range"),
    ({"seed": -1}, "seed: -1 is out of range"),
    ({"seed": 2**64}, "seed: 18446744073709551616 is out of range"),
    ({"seed": 0.0}, "seed: 0.0 is not an integer"),
    ({"patches": (2, 3, 4)}, "patches: has 3 entries"),
    ({"patches": 4}, "patches: 4 is not a pair"),
    ({"patches": "44"}, "patches: '44' is not a pair"),
    ({"patches": (-1, 2)}, r"patches\[0\]: -1 is out of range"),
    ({"patches": (2, 2.5)}, r"patches\[1\]: 2.5 is not an integer"),
    ({"progress": "yes"}, "progress: 'yes' is not a function"),
]


@pytest.mark.parametrize(("options", "message"), BAD_OPTIONS)
def test_bad_options(options, message):
    with pytest.raises(ValueError, match=message):
        vorogeo.GeodesicIndex(VERTICES, FACES, **options)


def test_numpy_scalars_are_numbers(index):
    assert index.distance(np.uint8(3), np.array(3)) == 0.0
    assert isinstance(index.distance(np.int64(0), 1), float)
    options = {"patches": np.array([2, 2]), "delta": np.float32(0), "threads": np.int8(1), "seed": np.uint64(2**64 - 1)}
    assert vorogeo.GeodesicIndex(VERTICES, FACES, **options).statistics.seed == 2**64 - 1


@pytest.mark.parametrize("layer", [0, 3, -1, 1.0, "1", None])
def test_bad_layer(index, layer):
    with pytest.raises(ValueError, match="layer: "):
        index.face_patches(layer)


ID_TYPES = st.sampled_from([np.int64, np.int8, np.uint64, np.float64])


@given(arrays.arrays(ID_TYPES, arrays.array_shapes(max_dims=2, max_side=4), elements={"min_value": 0, "max_value": 19}))
def test_any_small_array_is_answered_or_refused(ids):
    flat = ids[:, 0] if ids.ndim == 2 and ids.shape[1] == 1 else ids
    if flat.ndim == 1 and (flat == np.rint(flat)).all():
        assert (vorogeo.exact_distance_field(VERTICES, FACES, ids)[flat.astype(int)] == 0).all()
    else:
        with pytest.raises(vorogeo.InvalidInput, match="sources: has "):
            vorogeo.exact_distance_field(VERTICES, FACES, ids)
