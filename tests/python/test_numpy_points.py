"""Points and curves: edges in any order, and what is refused."""

import numpy as np
import pytest
import vorogeo

from sample_meshes import plane_grid

PLANE = plane_grid(31, 21, 3.0, 2.0)


@pytest.fixture(scope="module")
def plane():
    return vorogeo.GeodesicIndex(*PLANE, patches=(4, 4))


def test_a_curve_is_its_edges_in_any_order_and_has_one_offset(plane):
    line = np.arange(31 * 10, 31 * 11)  # the row y = 1
    edges = np.column_stack([line[:-1], line[1:]])[::-1]
    above = np.abs(PLANE[0][:, 1] - 1)
    for vertices in (line, edges, edges.astype(float), line[:, None]):
        field = plane.distance_field(vorogeo.EdgeCurve(vertices, spacing=0.02), offsets=[0.5], method="exact")
        np.testing.assert_allclose(field, above + 0.5, atol=1e-2)


@pytest.mark.parametrize(
    ("curve", "message"),
    [
        (vorogeo.EdgeCurve([0, 2]), "no edge between vertex 0 and vertex 2"),
        (vorogeo.EdgeCurve([0]), "at least"),
        (vorogeo.EdgeCurve([0, 10**6]), "no vertex 1000000"),
        (vorogeo.EdgeCurve(np.zeros((2, 3), int)), r"shape \(2, 3\)"),
        (vorogeo.EdgeCurve([0, 1], spacing=-1), "spacing"),
        (vorogeo.EdgeCurve("ab"), "vertices: is not an array of numbers"),
    ],
)
def test_bad_curves_are_named(plane, curve, message):
    with pytest.raises(vorogeo.InvalidInput, match=message):
        plane.distance_field([3, curve])


def test_masked_entries_are_named(plane):
    with pytest.raises(vorogeo.InvalidInput, match="sources: has masked entries"):
        plane.distance_field(np.ma.array([0, 3], mask=[0, 1]))


def test_a_path_is_one_source_with_its_own_points(plane):
    path = plane.path(0, 31 * 20 + 17)
    field = plane.distance_field(path, method="exact")
    end = PLANE[0][31 * 20 + 17]
    nearest = np.clip(PLANE[0] @ end / (end @ end), 0, 1)[:, None] * end
    np.testing.assert_allclose(field, np.linalg.norm(PLANE[0] - nearest, axis=1), atol=0.02)
    assert plane.distance_field(plane.path(0, 30), method="exact")[:31].max() == 0


def test_values_of_vertices_become_those_of_points(plane):
    points = plane.snap([[0.1, 0.1, 0], [2.9, 1.9, 0]])
    for columns in ([0], [1, 0, 1, 1]):
        values = points.positions(PLANE[0][:, columns], PLANE[1])
        np.testing.assert_array_equal(values, points.positions(*PLANE)[:, columns])


def test_faces_of_another_mesh_are_named(plane):
    points = plane.snap([[0.1, 0.1, 0], [2.9, 1.9, 0]])
    with pytest.raises(vorogeo.InvalidInput, match=r"faces: has 3 rows, but a point lies in face \d+"):
        points.positions(PLANE[0], PLANE[1][:3])
    with pytest.raises(vorogeo.InvalidInput, match=r"faces\[0\]: names vertex"):
        points.to_sparse(PLANE[1], 2)


def test_weights_that_are_wrong_are_named(plane):
    with pytest.raises(vorogeo.InvalidInput, match="2 faces but 1 rows"):
        plane.fields(vorogeo.SurfacePoints(np.array([3, 4]), np.full((1, 3), 1 / 3)))
    for weights, wrong in (([0.5, 0.5, 2e-6], "do not sum to 1"), ([-2e-6, 0.5, 0.5], r"outside \[0, 1\]")):
        points = vorogeo.SurfacePoints(np.array([4, 7]), np.array([[1 / 3, 1 / 3, 1 / 3], weights]))
        with pytest.raises(vorogeo.InvalidInput, match=rf"1 is not on the mesh.*face 7.*{wrong}.*give weights"):
            plane.distance_field(points)


def test_faces_may_be_a_column_of_whole_numbers_stored_as_reals(plane):
    weights = np.full((2, 3), 1 / 3)
    points, same = (vorogeo.SurfacePoints(faces, weights) for faces in (np.array([3, 4]), np.array([[3.0], [4.0]])))
    np.testing.assert_array_equal(plane.fields(same), plane.fields(points))
    np.testing.assert_array_equal(same.positions(*PLANE), points.positions(*PLANE))
    assert same.to_text() == points.to_text()
