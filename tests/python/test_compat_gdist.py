"""vorogeo.compat.gdist: gdist's published examples on both, formulas where gdist is not installed, and conventions."""

import numpy as np
import pytest
import vorogeo
from vorogeo.compat import gdist as ours

from sample_meshes import bent_grid, plane_grid, prism, prism_distances, side_by_side

# As gdist's flat_triangular_mesh.txt: 121 vertices 0.2 apart, 200 triangles.
FLAT = plane_grid(11, 11, 2.0, 2.0)
APART = np.linalg.norm(FLAT[0][:, None] - FLAT[0][None], axis=2)


@pytest.fixture(params=["vorogeo", "gdist"])
def gdist(request):
    """Ours, then the package itself."""
    if request.param == "vorogeo":
        return ours
    try:
        import gdist as theirs
    except (ImportError, ValueError) as error:  # its binary packages were built for numpy 1
        pytest.skip(f"gdist cannot be imported: {error}")
    return theirs


def ids(*values):
    return np.array(values, dtype=np.int32)


def test_the_example_of_compute_gdist(gdist):
    found = gdist.compute_gdist(*FLAT, source_indices=ids(1), target_indices=ids(2))
    np.testing.assert_allclose(found, [0.2])


def test_the_example_of_local_gdist_matrix(gdist):
    found = gdist.local_gdist_matrix(*FLAT, max_distance=1.05)
    assert found.format == "csc"
    assert found.shape == (121, 121)
    assert found.nnz == ((APART <= 1.05) & (APART > 0)).sum()
    entries = found.tocoo()
    np.testing.assert_allclose(entries.data, APART[entries.row, entries.col], rtol=1e-9)


def test_the_example_of_selected_points(gdist):
    points = ids(2, 5, 10)
    found = gdist.distance_matrix_of_selected_points(*FLAT, points)
    assert found.nnz == 6
    np.testing.assert_allclose(found.toarray()[np.ix_(points, points)], APART[np.ix_(points, points)], rtol=1e-9)


def test_without_sources_and_targets_vertex_0_and_all(gdist):
    np.testing.assert_allclose(gdist.compute_gdist(*FLAT), APART[0], atol=1e-12)
    several = gdist.compute_gdist(*FLAT, source_indices=ids(0, 120), target_indices=ids(7, 60, 100), max_distance=0.1)
    np.testing.assert_allclose(several, APART[[0, 120]][:, [7, 60, 100]].min(axis=0))


def test_ids_from_1_and_a_limit(gdist):
    vertices, faces = FLAT
    found = gdist.compute_gdist(vertices, faces + np.int32(1), source_indices=ids(3), is_one_indexed=True)
    np.testing.assert_allclose(found, APART[3], atol=1e-12)
    limited = gdist.local_gdist_matrix(vertices, faces + np.int32(1), 0.5, True)
    assert limited.nnz == ((APART <= 0.5) & (APART > 0)).sum()


def test_what_no_path_reaches_is_infinite(gdist):
    vertices, faces = side_by_side(FLAT, FLAT)
    found = gdist.compute_gdist(vertices, faces, source_indices=ids(0))
    assert np.isinf(found[121:]).all()
    assert gdist.local_gdist_matrix(vertices, faces).nnz == 2 * 121 * 120


def test_both_agree_where_the_surface_bends():
    theirs = pytest.importorskip("gdist", exc_type=(ImportError, ValueError))
    vertices, faces = bent_grid(17, 13)
    a, b = (package.local_gdist_matrix(vertices, faces, max_distance=0.9).toarray() for package in (ours, theirs))
    near = (a > 0) & (b > 0)
    assert near.sum() > 10_000
    np.testing.assert_allclose(a[near], b[near], rtol=1e-6)


def test_a_tube_unrolls():
    vertices, faces = prism(12, 6, 3.0)
    found = ours.compute_gdist(vertices, faces.astype(float), source_indices=ids(5))
    np.testing.assert_allclose(found, prism_distances(12, 6, 3.0, 5), rtol=1e-12, atol=1e-14)


def random_mesh(seed):
    """A grid of random size with noise, with faces taken out, turned over and joined, in random order."""
    random = np.random.default_rng(seed)
    vertices, faces = bent_grid(*random.integers(4, 9, 2))
    vertices += random.choice([0, 0.02, 0.1]) * random.normal(size=vertices.shape)
    faces = random.permutation(faces[random.random(len(faces)) > random.choice([0, 0.1, 0.4])])
    faces[::5] = faces[::5, ::-1]
    if random.random() < 0.3:  # two vertices become one
        faces[faces == random.integers(len(vertices))] = random.integers(len(vertices))
    return vertices * 10.0 ** random.integers(-3, 4), faces


def test_equals_exact_fields_on_random_meshes():
    first = np.random.SeedSequence().entropy % 10**9
    for seed in range(first, first + 50):
        vertices, faces = random_mesh(seed)
        count = len(vertices)
        random = np.random.default_rng(seed)
        sources, targets = random.integers(0, count, 3), random.integers(0, count, 10)
        field = vorogeo.exact_distance_field(vertices, faces, sources)
        found = ours.compute_gdist(vertices, faces + 1, sources, targets, is_one_indexed=True)
        np.testing.assert_allclose(found, field[targets], rtol=1e-9, err_msg=f"seed {seed}")
        all_fields = np.array([vorogeo.exact_distance_field(vertices, faces, v) for v in range(count)])
        finite = all_fields[np.isfinite(all_fields)]
        limit = float(np.median(finite[finite > 0]))
        near = np.abs(all_fields - limit) > 1e-9 * limit  # at the limit itself, rounding decides
        expected = np.where((all_fields <= limit) & near, all_fields, 0)
        matrix = ours.local_gdist_matrix(vertices, faces, limit).toarray()
        np.testing.assert_allclose(matrix * near, expected, rtol=1e-9, err_msg=f"seed {seed}")
        limited = ours.compute_gdist(vertices, faces, targets[:1], max_distance=limit)
        expected = np.where(all_fields[targets[0]] <= limit, all_fields[targets[0]], np.inf)
        at = near[targets[0]]
        np.testing.assert_allclose(limited[at], expected[at], rtol=1e-9, err_msg=f"seed {seed}")
        points = np.unique(targets)
        chosen = ours.distance_matrix_of_selected_points(vertices, faces, targets).toarray()
        expected = np.zeros((count, count))
        between = all_fields[np.ix_(points, points)]
        expected[np.ix_(points, points)] = np.where(np.isfinite(between), between, 0)
        np.testing.assert_allclose(chosen, expected, rtol=1e-9, err_msg=f"seed {seed}")


def test_beyond_the_limit_is_infinite_everywhere():
    found = ours.compute_gdist(*FLAT, source_indices=ids(0), max_distance=0.5)
    np.testing.assert_array_equal(np.isinf(found), APART[0] > 0.5)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: ours.compute_gdist(*FLAT, source_indices=[121]), "there is no vertex 121"),
        (lambda: ours.compute_gdist(*FLAT, target_indices=[-1]), "there is no vertex -1"),
        (lambda: ours.compute_gdist(FLAT[0], FLAT[1], is_one_indexed=True), "names vertex 0, but ids begin with 1"),
        (
            lambda: ours.local_gdist_matrix(FLAT[0], FLAT[1] + 0.5),
            r"has type float64, not integer: triangles\[0\]\[0\] is 0\.5",
        ),
        (lambda: ours.compute_gdist(FLAT[0], [[0, 1, 2], [1, 3]]), "triangles: cannot be read as an array"),
        (lambda: ours.compute_gdist(*FLAT, target_indices=[1], max_distance=-1), "max_distance: -1.0 is negative"),
        (lambda: ours.local_gdist_matrix(*FLAT, max_distance=-1), "max_distance: -1.0 is negative"),
    ],
)
def test_bad_arguments_are_named(call, message):
    with pytest.raises(vorogeo.InvalidInput, match=message):
        call()
