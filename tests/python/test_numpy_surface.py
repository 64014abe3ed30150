"""vorogeo.Surface and vorogeo.estimate against formulas, the exact field and the index."""

import threading

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid, plane_grid, side_by_side


def exact_of(mesh, sources, **options):
    return vorogeo.exact_distance_field(*mesh, sources, **options)


def test_first_answers_are_exact_and_need_no_index():
    mesh = bent_grid(30, 20)
    surface = vorogeo.Surface(*mesh)
    assert surface.last is None
    np.testing.assert_array_equal(surface.distance_field([3, 200]), exact_of(mesh, [3, 200]))
    assert surface.last.by == "exact"
    assert surface.last.index_seconds == 0
    assert surface.index is None
    assert "no index yet" in repr(surface)


def test_the_method_is_the_one_asked_for():
    mesh = bent_grid(30, 20)
    surface = vorogeo.Surface(*mesh)
    exact = exact_of(mesh, 3)
    for method in ("quick", "exact", "index"):
        field, label = surface.distance_field(3, method=method, return_labels=True, dtype=np.float32)
        assert surface.last.by == method
        assert field.dtype == np.float32
        assert (label == 0).all()
        others = exact > 0
        assert np.abs(field[others] / exact[others] - 1).mean() < (0.01 if method == "quick" else 0.001)
    index = surface.index
    assert isinstance(index, vorogeo.GeodesicIndex)
    np.testing.assert_array_equal(surface.distance_field(3), index.distance_field(3))
    assert surface.last.by == "index"
    assert surface.distance(5, 77) == index.distance(5, 77)
    assert surface.build_index().statistics.vertices == len(mesh[0])


def test_an_index_is_built_when_exact_answers_took_as_long():
    mesh = bent_grid(14, 11)
    surface = vorogeo.Surface(*mesh, threads=1)
    answers = []
    for i in range(20000):
        surface.distance_field(i % len(mesh[0]))
        answers.append(surface.last)
        if surface.last.by == "index":
            break
    assert answers[-1].by == "index"
    assert answers[-1].remark
    rent = sum(answer.seconds for answer in answers[:-1])
    assert rent < 20 * answers[-1].index_seconds + 1


def test_offsets_labels_limits_and_sources_of_every_kind():
    vertices, faces = plane_grid(25, 25)
    surface = vorogeo.Surface(vertices, faces)
    points = surface.snap([[0.31, 0.42, 0.1], [0.8, 0.7, 0.0]])
    np.testing.assert_allclose(points.snap_distance, [0.1, 0.0], atol=1e-15)
    at = points.positions(vertices, faces)
    field, label = surface.distance_field(points, 0.4, offsets=[0.1, 0.0], return_labels=True)
    sums = np.linalg.norm(vertices[:, None] - at, axis=2) + np.array([0.1, 0.0])
    inside = sums.min(axis=1) < 0.4
    np.testing.assert_allclose(field[inside], sums.min(axis=1)[inside], rtol=1e-12)
    np.testing.assert_array_equal(label[inside], sums.argmin(axis=1)[inside])
    assert np.isinf(field[~inside]).all()
    assert (label[~inside] == -1).all()
    curve = vorogeo.EdgeCurve(np.arange(25))
    np.testing.assert_allclose(surface.distance_field(curve), vertices[:, 1], atol=0.003)


def test_paths_and_distances_are_exact_without_an_index():
    vertices, faces = plane_grid(25, 25)
    surface = vorogeo.Surface(vertices, faces)
    ends = surface.snap([[0.31, 0.42, 0.0], [0.8, 0.7, 0.0]])
    path = surface.path(ends[0], ends[1])
    assert path.certified
    assert path.length == pytest.approx(np.hypot(0.49, 0.28), rel=1e-12)
    np.testing.assert_allclose(path.points[[0, -1]], [[0.31, 0.42, 0], [0.8, 0.7, 0]], atol=1e-12)
    assert surface.distance(ends[0], ends[1]) == pytest.approx(path.length, rel=1e-12)
    several = surface.distance([0, 7], [624, 30])
    np.testing.assert_allclose(several, np.linalg.norm(vertices[[0, 7]] - vertices[[624, 30]], axis=1), rtol=1e-12)
    assert [p.certified for p in surface.exact_path([0, 7], [624, 30])] == [True, True]
    assert surface.last.by == "exact"


def test_components_and_masks():
    mesh = side_by_side(plane_grid(5, 5), plane_grid(4, 4))
    surface = vorogeo.Surface(*mesh)
    assert surface.distance(0, 30) == np.inf
    assert surface.path(0, 30).length == np.inf
    vertices, faces = plane_grid(9, 9)
    middle = vertices[faces].mean(axis=1)
    mask = (np.abs(middle[:, 0] - 0.5) > 0.2) | (middle[:, 1] > 0.8)
    masked = vorogeo.Surface(vertices, faces, mask=mask)
    np.testing.assert_array_equal(masked.distance_field(0), exact_of((vertices, faces), 0, mask=mask))


def test_metrics():
    vertices, faces = plane_grid(15, 15)
    metric = vorogeo.VertexCost(np.full(len(vertices), 3.0))
    surface = vorogeo.Surface(vertices, faces, metric=metric)
    straight = 3 * np.linalg.norm(vertices - vertices[17], axis=1)
    np.testing.assert_allclose(surface.distance_field(17), straight, rtol=1e-9, atol=1e-12)
    assert surface.path(17, 200).length == pytest.approx(straight[200], rel=1e-9)
    np.testing.assert_allclose(surface.distance_field(17, method="quick"), straight, rtol=0.02, atol=1e-12)
    index = surface.build_index()
    assert index.distance(17, 200) == pytest.approx(straight[200], rel=1e-3)
    assert vorogeo.estimate(vertices, faces, metric=metric).bytes == pytest.approx(index.statistics.bytes, rel=0.5)


def test_several_threads_share_a_surface():
    mesh = bent_grid(20, 20)
    surface, exact = vorogeo.Surface(*mesh), exact_of(mesh, 9)
    found = []
    workers = [threading.Thread(target=lambda: found.append(surface.distance_field(9, method="exact"))) for _ in "abc"]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert len(found) == 3
    for field in found:
        np.testing.assert_array_equal(field, exact)


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda s: s.distance_field(0, method="fast"), "method: 'fast' is unknown"),
        (lambda s: s.distance(0, 1, method="quick"), "method: 'quick' is unknown"),
        (lambda s: s.distance_field([]), "sources: is empty"),
        (lambda s: s.distance_field(99), "there is no vertex 99"),
        (lambda s: s.distance([0, 1], [2]), "source has 2 points, target 1"),
        (lambda s: s.distance_field(0, -1.0), "max_distance: -1.0 is negative"),
    ],
)
def test_bad_arguments_are_named(call, sentence):
    surface = vorogeo.Surface(*plane_grid(4, 4))
    with pytest.raises(vorogeo.InvalidInput, match=sentence.replace("[", r"\[")):
        call(surface)
    assert surface.last is None


def test_progress_cancels():
    surface = vorogeo.Surface(*bent_grid(40, 40))
    with pytest.raises(vorogeo.Cancelled):
        surface.build_index(progress=lambda *_: False)
    assert surface.index is None
    assert surface.distance_field(0).max() > 0


def test_estimates_are_those_of_the_index():
    mesh = bent_grid(50, 40)
    guess = vorogeo.estimate(*mesh)
    statistics = vorogeo.GeodesicIndex(*mesh).statistics
    assert 0.5 < guess.bytes / statistics.bytes < 2
    assert guess.form == statistics.form
    assert 0 < guess.build_seconds <= guess.core_seconds
    assert guess.exact_field_seconds > 0
    assert guess.field_seconds > 0
    with pytest.raises(vorogeo.InvalidInput, match="no face"):
        vorogeo.estimate(np.zeros((3, 3)), np.empty((0, 3), int))


def test_quick_is_a_method_of_distance_field():
    mesh = bent_grid(20, 20)
    np.testing.assert_array_equal(
        vorogeo.distance_field(*mesh, 3, method="quick"), vorogeo.distance_field(*mesh, 3, method="gsp")
    )
    np.testing.assert_array_equal(vorogeo.distance_field(*mesh, 3, method="exact"), exact_of(mesh, 3))
