"""Pickling and copying: an index and its results are the same afterwards, also in other processes."""

import copy
import multiprocessing
import pickle

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid

MESH = bent_grid(30, 20)
POINTS = [0, 17, 333, 599]


@pytest.fixture(scope="module")
def index():
    return vorogeo.GeodesicIndex(*MESH, patches=(4, 3), threads=2)


def matrix_of(index):
    return index.distance_matrix(POINTS, entries="fields")


def test_large_parts_are_handed_over_without_a_copy(index):
    buffers = []
    head = pickle.dumps(index, 5, buffer_callback=buffers.append)
    assert len(buffers) == 3  # the index, vertices, faces
    assert len(head) < 2000
    np.testing.assert_array_equal(matrix_of(pickle.loads(head, buffers=buffers)), matrix_of(index))


def test_a_copy_shares_what_answers_and_remembers_its_own_last_answer(index):
    for other in (copy.copy(index), copy.deepcopy([index])[0]):
        assert type(other) is vorogeo.GeodesicIndex
        assert other.vertices is index.vertices
        before = other.last
        np.testing.assert_array_equal(index.distance_field(3), other.distance_field(3))
        assert other.last is not before
        assert index.last is not other.last


def test_the_mesh_can_be_asked_for_and_not_changed(index):
    np.testing.assert_array_equal(index.vertices, MESH[0])
    np.testing.assert_array_equal(index.faces, MESH[1])
    for array in (index.vertices, index.faces):
        with pytest.raises(ValueError, match="read-only"):
            array[0, 0] = 1
    assert MESH[0].flags.writeable
    mine = MESH[0].copy()
    other = vorogeo.GeodesicIndex(mine, MESH[1])
    mine[:] = 0
    np.testing.assert_array_equal(other.vertices, MESH[0])


def test_a_damaged_pickle_is_refused(index):
    buffers = []
    head = pickle.dumps(index, 5, buffer_callback=lambda buffer: buffers.append(bytearray(buffer.raw())))
    tables = max(buffers, key=len)
    tables[len(tables) // 2] ^= 1
    with pytest.raises(vorogeo.IndexFileError, match="damaged"):
        pickle.loads(head, buffers=buffers)


class Named(vorogeo.Surface):
    """A surface with attributes of its own."""

    __slots__ = ("slot",)


class NamedIndex(vorogeo.GeodesicIndex):
    """An index with an attribute of its own."""


def test_attributes_of_a_class_of_ones_own_are_kept():
    inside = MESH[0][MESH[1]].mean(axis=1)[:, 0] < 0.8
    surface = Named(*MESH, mask=inside, metric=vorogeo.VertexCost(1 + MESH[0][:, 1] ** 2))
    surface.slot, surface.name = 5, ["left"]
    index = NamedIndex(*MESH)
    index.name = ["right"]
    for protocol in (2, pickle.HIGHEST_PROTOCOL):
        other, other_index = pickle.loads(pickle.dumps((surface, index), protocol))
        assert (type(other), other.slot, other.name) == (Named, 5, ["left"])
        assert (type(other_index), other_index.name) == (NamedIndex, ["right"])
        assert repr(other) == repr(surface)
        np.testing.assert_array_equal(other.distance_field([0, 17]), surface.distance_field([0, 17]))
    assert copy.copy(surface).name is surface.name
    assert copy.deepcopy(surface).name is not surface.name


def results(index):
    snapped = index.snap([[0.3, 0.4, 0.1], [1.1, 0.9, 0.0]])
    return {
        "surface points": snapped,
        "curve": vorogeo.EdgeCurve([0, 1, 2]),
        "path": index.path(0, 599),
        "statistics": index.statistics,
        "sparse": index.pairs_within(POINTS, 1.0, as_arrays=True),
        "regions": index.voronoi([0, snapped]),
        "samples": index.sample_farthest(5),
        "isolines": index.isolines(index.distance_field(0), 3),
        "disk": index.disk(0, 0.5),
        "extent": index.extent(),
        "relaxed": index.relax([0, 5], rounds=1),
        "report": vorogeo.check_mesh(*MESH),
        "estimate": vorogeo.estimate(*MESH),
        "labelled field": index.distance_field([0, 5], return_labels=True),
        "nearest": index.nearest([0, 5], POINTS),
        "method": vorogeo.methods["heat"],
    }


def same(a, b):
    if isinstance(a, np.ndarray):
        return a.dtype == b.dtype and np.array_equal(a, b, equal_nan=True)
    if hasattr(a, "__dict__"):
        return type(a) is type(b) and all(same(vars(a)[name], vars(b)[name]) for name in vars(a))
    if isinstance(a, tuple):
        return len(a) == len(b) and all(map(same, a, b))
    return a == b


def every_metric():
    cost, tensors = np.linspace(1, 2, 600), np.tile(np.diag([1.0, 2.0, 3.0]), (600, 1, 1))
    faces = len(MESH[1])
    return [
        vorogeo.EdgeLengths(np.ones((faces, 3))),
        vorogeo.VertexCost(cost),
        vorogeo.VertexTensor(tensors),
        vorogeo.FaceCost(np.linspace(1, 2, faces)),
        vorogeo.FaceTensor(np.tile(np.eye(3), (faces, 1, 1))),
        vorogeo.slope_cost(*MESH, penalty=2),
        vorogeo.curvature_tensor(*MESH, weight=2),
    ]


@pytest.mark.parametrize("metric", every_metric(), ids=lambda metric: type(metric).__name__)
def test_every_metric_can_be_pickled_and_copied(metric):
    for other in (pickle.loads(pickle.dumps(metric)), copy.deepcopy(metric), copy.copy(metric)):
        assert same(other, metric)
        expected = vorogeo.exact_distance_field(*MESH, 0, metric=metric)
        np.testing.assert_array_equal(vorogeo.exact_distance_field(*MESH, 0, metric=other), expected)


def test_every_result_can_be_pickled_and_copied(index):
    for name, result in results(index).items():
        for other in (pickle.loads(pickle.dumps(result)), copy.deepcopy(result), copy.copy(result)):
            assert same(other, result), name


@pytest.mark.parametrize("start", ["spawn", "forkserver", "fork"])
@pytest.mark.filterwarnings("ignore:This process .* is multi-threaded")
def test_other_processes_answer_the_same(index, start):
    expected = matrix_of(index)  # threads have run before the fork
    with multiprocessing.get_context(start).Pool(1) as pool:
        np.testing.assert_array_equal(pool.apply_async(matrix_of, [index]).get(60), expected)


def test_joblib_workers_answer_the_same(index):
    joblib = pytest.importorskip("joblib")
    rows = joblib.Parallel(n_jobs=2)(joblib.delayed(index.distance_field)(point) for point in POINTS[:2])
    np.testing.assert_array_equal(rows, [index.distance_field(point) for point in POINTS[:2]])
