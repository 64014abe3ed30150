"""vorogeo.check_mesh: every kind of finding, on meshes where it can be counted by eye."""

import numpy as np
import pytest
import vorogeo

from sample_meshes import cube, plane_grid, side_by_side

VERTICES, FACES = cube()


def check(vertices=VERTICES, faces=FACES):
    return vorogeo.check_mesh(vertices, faces)


def test_clean_mesh_has_no_findings():
    report = check()
    assert (report.vertices, report.faces, report.components, report.border_edges) == (8, 12, 1, 0)
    assert report.usable
    assert report.sentences == ()


def test_bad_elements_are_findings_not_errors():
    vertices = VERTICES.copy()
    vertices[5, 1] = np.nan
    faces = np.vstack([FACES, [[0, 1, 8], [-1, 0, 1], [2, 2**40, 1]]])
    report = check(vertices, faces)
    assert report.non_finite_vertices == vorogeo.MeshFinding(1, 5)
    assert report.faces_out_of_range == vorogeo.MeshFinding(3, 12)
    assert not report.usable
    assert any("5" in sentence for sentence in report.sentences)
    assert "12" in str(report)


@pytest.mark.parametrize("kind", [np.uint64, np.int8, np.uint8])
def test_integer_types(kind):
    faces = FACES.astype(kind)
    faces[4, 1] = np.iinfo(kind).max
    assert check(faces=faces).faces_out_of_range == vorogeo.MeshFinding(1, 4)


def test_faces_to_leave_out():
    report = check(faces=np.vstack([FACES, [[3, 3, 1]], FACES[2:3, ::-1]]))
    assert report.faces_with_repeated_vertex == vorogeo.MeshFinding(1, 12)
    assert report.duplicate_faces == vorogeo.MeshFinding(1, 13)
    assert report.usable


def test_non_manifold_edge_is_named():
    vertices, faces = np.vstack([VERTICES, [[-1, -1, 0.5]]]), np.vstack([FACES, [[0, 1, 8]]])
    report = check(vertices, faces)
    assert report.non_manifold_edges.count == 1
    assert report.first_non_manifold_edge == (0, 1)
    assert check().first_non_manifold_edge == (-1, -1)


def test_components_borders_and_isolated_vertices():
    vertices, faces = side_by_side(plane_grid(4, 3), cube())
    report = check(np.vstack([vertices, [[50, 0, 0]]]), faces)
    assert report.components == 2
    assert report.border_edges == 10
    assert report.isolated_vertices == vorogeo.MeshFinding(1, 20)


def test_component_sizes_and_border_loops():
    report = check(*side_by_side(plane_grid(4, 3), cube()))
    assert report.component_vertices == (12, 8)
    assert report.border_loops == 1
    assert report.longest_border_loop == pytest.approx(4.0)
    assert str(report).startswith("20 vertices, 24 faces, 2 components, 1 border loop (10 edges, 4 long, at vertex 0).")
    assert any("of 12 and 8 vertices" in sentence for sentence in report.sentences)


def test_gap_between_borders():
    vertices, faces = side_by_side(plane_grid(4, 3), plane_grid(4, 3), gap=1.001)
    report = check(vertices, faces)
    assert report.near_borders == vorogeo.MeshFinding(6, 3)
    assert report.nearest_borders in {(3, 12), (7, 16), (11, 20)}
    assert report.near_border_gaps == pytest.approx((0.001, 0.001))
    assert any("0.001 apart" in sentence for sentence in report.sentences)
    assert check().near_borders == vorogeo.MeshFinding(0, -1)


def test_t_junctions():
    vertices, faces = side_by_side(plane_grid(2, 2), plane_grid(2, 3), gap=1.0)
    report = check(vertices, faces)
    assert report.t_junctions == vorogeo.MeshFinding(1, 6)
    assert report.first_t_junction_edge == (1, 3)
    assert any("T-junction" in sentence for sentence in report.sentences)
    assert check().t_junctions == vorogeo.MeshFinding(0, -1)
    assert check().first_t_junction_edge == (-1, -1)


@pytest.mark.parametrize(
    ("scale", "usable", "by_index"), [(1e30, True, False), (1e-300, False, False), (1, True, True)]
)
def test_scale(scale, usable, by_index):
    vertices = scale * VERTICES
    report = check(vertices)
    assert (report.usable, report.usable_by_index) == (usable, by_index)
    assert any("multiply the coordinates" in sentence for sentence in report.sentences) == (not by_index)
    assert report.longest_edge_length == pytest.approx(np.sqrt(2) * scale, rel=0.2)
    if not by_index:
        with pytest.raises(vorogeo.InvalidInput, match="scale the mesh, for example by"):
            vorogeo.GeodesicIndex(vertices, FACES)


def test_no_faces_is_not_usable():
    assert not check(faces=np.empty((0, 3), dtype=int)).usable


BAD_ARRAYS = [(VERTICES[:, :2], FACES), (VERTICES, FACES.astype(float)), (None, FACES)]


@pytest.mark.parametrize(("vertices", "faces"), BAD_ARRAYS)
def test_wrong_shapes_and_types_are_errors(vertices, faces):
    with pytest.raises(ValueError, match=r"vertices|faces"):
        check(vertices, faces)
