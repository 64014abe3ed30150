"""vorogeo.distance_field and vorogeo.methods, against potpourri3d and closed forms."""

import numpy as np
import pytest
import vorogeo

from sample_meshes import Mesh, bent_grid, cube, plane_grid, prism, prism_distances, real_mesh, side_by_side

METHODS = tuple(vorogeo.methods)


def equilateral(side: int) -> Mesh:
    """A flat parallelogram of equilateral triangles, without an obtuse corner."""
    vertices, _ = plane_grid(side, side)
    vertices[:, 0] += 0.5 * vertices[:, 1]
    vertices[:, 1] *= np.sqrt(0.75)
    a = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel()
    faces = np.vstack([np.column_stack([a, a + 1, a + side]), np.column_stack([a + 1, a + side + 1, a + side])])
    return vertices, faces.astype(np.int32)


def test_methods_say_what_they_take_and_claim():
    assert {"vorogeo", "mmp", "ammp", "fast_marching", "heat", "dijkstra"} <= set(METHODS)
    option = vorogeo.methods["heat"].options["time_step"]
    assert option.standard == 1
    assert option.least < 1 < option.greatest
    assert "mean edge" in option.meaning
    assert vorogeo.methods["mmp"].exact
    assert vorogeo.methods["mmp"].claims.bound == "exact"


@pytest.mark.parametrize("method", METHODS)
def test_every_method_gives_about_the_distances_of_a_prism(method):
    vertices, faces = prism(16, 13, 4.0)
    field = vorogeo.distance_field(vertices, faces, 5, method)
    expected = prism_distances(16, 13, 4.0, 5)
    assert np.abs(field - expected).mean() < 0.5  # of distances up to 5
    assert np.corrcoef(field, expected)[0, 1] > 0.95


def test_a_prepared_method_answers_many_times():
    vertices, faces = bent_grid(14, 11)
    method = vorogeo.GeodesicMethod(vertices, faces, "ammp", eps=0.0)
    np.testing.assert_array_equal(
        method.distance_field([3, 70]), vorogeo.exact_distance_field(vertices, faces, [3, 70])
    )
    assert method.distance(3, 100) == pytest.approx(vorogeo.exact_distance_field(vertices, faces, 3)[100], rel=1e-12)
    assert method.seconds >= 0
    assert method.bytes > 0
    assert method.info is vorogeo.methods["ammp"]


def test_campen_kobbelt_crosses_gaps_of_its_own():
    vertices, faces = side_by_side(plane_grid(9, 9), plane_grid(9, 12), 1.001)
    apart = vorogeo.distance_field(vertices, faces, 40, "campen_kobbelt")
    assert np.isinf(apart[81:]).all()
    field = vorogeo.distance_field(vertices, faces, 40, "campen_kobbelt", gap=2e-3)
    straight = np.linalg.norm(vertices - vertices[40], axis=1)
    assert np.abs(field - straight).max() < 0.1


@pytest.mark.parametrize("name", ["spot", "fandisk"])
def test_heat_equals_that_of_potpourri3d(name):
    """That package adds 1e-6 to the diagonal of its Laplacian; its equation is solved again without."""
    potpourri3d = pytest.importorskip("potpourri3d")
    linalg = pytest.importorskip("scipy.sparse.linalg")
    vertices, faces = real_mesh(name)
    theirs = potpourri3d.MeshHeatMethodDistanceSolver(vertices, faces, t_coef=1.0, use_robust=False).compute_distance(5)
    laplacian = potpourri3d.cotan_laplacian(vertices, faces).tocsc()
    theirs = theirs - theirs.mean()
    right_side = laplacian @ theirs + 1e-6 * theirs
    expected = np.zeros(len(vertices))
    expected[1:] = linalg.spsolve(laplacian[1:, 1:], right_side[1:])
    expected -= expected[5]
    field = vorogeo.distance_field(vertices, faces, 5, "heat")
    np.testing.assert_allclose(field, expected, atol=1e-6 * expected.max())


@pytest.mark.parametrize("side", [11, 41])
def test_fast_marching_equals_that_of_potpourri3d_on_acute_triangles(side):
    potpourri3d = pytest.importorskip("potpourri3d")
    vertices, faces = equilateral(side)
    source = side // 2 * (side + 1)
    theirs = potpourri3d.MeshFastMarchingDistanceSolver(vertices, faces).compute_distance([[(source, [])]])
    field = vorogeo.distance_field(vertices, faces, source, "fast_marching")
    np.testing.assert_allclose(field, theirs, rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize(
    ("method", "options", "words"),
    [
        ("walking", {}, "method: 'walking' is not known; give one of 'vorogeo', 'mmp'"),
        (7, {}, "method: 7 is not known"),
        ("mmp", {"eps": 1}, "The method mmp has no option eps; it has none."),
        ("ammp", {"eps": 2}, "The option eps of the method ammp is 2; give a number from 0 to 0.1."),
        ("ammp", {"eps": "small"}, "eps: 'small' is not a real number"),
        ("heat", {"delaunay": 0.5}, "give a whole number from 0 to 1."),
    ],
)
def test_what_is_refused_is_named(method, options, words):
    with pytest.raises(vorogeo.InvalidInput) as caught:
        vorogeo.distance_field(*cube(), 0, method, **options)
    assert words in str(caught.value)
    with pytest.raises(vorogeo.InvalidInput, match="sources: there is no vertex 8"):
        vorogeo.distance_field(*cube(), 8, "mmp")
