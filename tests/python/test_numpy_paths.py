"""Paths on real meshes, and many of them: exact lengths, with landmarks where these pay."""

import numpy as np
import pytest
import vorogeo

from sample_meshes import plane_grid, real_mesh


@pytest.mark.parametrize("name", ["bunny10k_textured.obj", "spot", "fandisk", "gears"])
def test_prepared_exact_paths_have_the_exact_length(name):
    vertices, faces = real_mesh(name)
    index = vorogeo.GeodesicIndex(vertices, faces)
    sources, targets = np.random.default_rng(4).integers(0, len(vertices), size=(2, 100))
    before = index.exact_path(sources, targets)
    assert index.prepare_exact_paths(5) >= 4 * 5 * len(vertices)
    after = index.exact_path(sources, targets)
    assert all(path.certified for path in after)
    np.testing.assert_allclose([p.length for p in after], [p.length for p in before], rtol=1e-9)


def test_a_call_with_many_exact_pairs_prepares_itself_once():
    vertices, faces = plane_grid(20, 20, 1.0)
    index = vorogeo.GeodesicIndex(vertices, faces)
    sources, targets = np.random.default_rng(5).integers(0, len(vertices), size=(2, 1000))
    prepares = []
    for count, certify in ((999, True), (1000, False), (1000, True), (1000, True)):
        told = []
        paths = index.exact_path(
            sources[:count], targets[:count], certify=certify, progress=lambda *what, told=told: told.append(what)
        )
        straight = np.linalg.norm(vertices[sources[:count]] - vertices[targets[:count]], axis=1)
        np.testing.assert_allclose([path.length for path in paths], straight, rtol=1e-9, atol=1e-12)
        assert [fraction for fraction, _ in told] == sorted(fraction for fraction, _ in told)
        prepares.append(any("landmarks" in activity for _, activity in told))
    assert prepares == [False, False, True, False]


@pytest.mark.parametrize("name", ["bunny10k_textured.obj", "spot", "fandisk", "gears", "casting", "office_chair"])
def test_exact_paths_have_the_exact_length(name):
    vertices, faces = real_mesh(name)
    index = vorogeo.GeodesicIndex(vertices, faces)
    field = vorogeo.exact_distance_field(vertices, faces, 17)
    targets = np.random.default_rng(2).choice(np.flatnonzero(np.isfinite(field) & (field > 0)), 60)
    sources, exact = np.full(60, 17), field[targets]
    found = index.exact_path(sources, targets)
    assert all(path.certified for path in found)
    np.testing.assert_allclose([path.length for path in found], exact, rtol=1e-9)
    refined = np.array([path.length for path in index.path(sources, targets)])
    assert (refined >= exact * (1 - 1e-9)).all()
    assert np.mean(refined / exact - 1) < (1e-3 if name == "office_chair" else 1e-4)
    quick = np.array([path.length for path in index.exact_path(sources, targets, certify=False)])
    assert (quick >= exact * (1 - 1e-9)).all()
    assert (quick <= refined * (1 + 1e-9)).all()
