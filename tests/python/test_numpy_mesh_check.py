"""vorogeo.check_mesh: every kind of finding, on meshes where it can be counted by eye."""

import numpy as np
import pytest
import vorogeo

from sample_meshes import cube, plane_grid, side_by_side

VERTICES, FACES = cube()
NONE = vorogeo.MeshFinding(0, -1)


def spoilt():
    """A vertex that is not finite, and faces that name vertices which are not there."""
    vertices = VERTICES.copy()
    vertices[5, 1] = np.nan
    return vertices, np.vstack([FACES, [[0, 1, 8], [-1, 0, 1], [2, 2**40, 1]]])


def parts():
    """A plane, a cube and a vertex without a face."""
    vertices, faces = side_by_side(plane_grid(4, 3), cube())
    return np.vstack([vertices, [[50, 0, 0]]]), faces


def beyond(kind):
    """A face that names the greatest number of a type."""
    faces = FACES.astype(kind)
    faces[4, 1] = np.iinfo(kind).max
    return VERTICES, faces


def found(count, first):
    return vorogeo.MeshFinding(count, first)


REPORTS = {
    "a cube": (cube(), {
        "vertices": 8, "faces": 12, "components": 1, "border_edges": 0, "usable": True, "sentences": (),
        "near_borders": NONE, "t_junctions": NONE, "first_t_junction_edge": (-1, -1),
        "first_non_manifold_edge": (-1, -1),
    }),
    "bad elements": (spoilt(), {
        "non_finite_vertices": found(1, 5), "faces_out_of_range": found(3, 12), "usable": False,
    }),
    "uint64": (beyond(np.uint64), {"faces_out_of_range": found(1, 4)}),
    "int8": (beyond(np.int8), {"faces_out_of_range": found(1, 4)}),
    "uint8": (beyond(np.uint8), {"faces_out_of_range": found(1, 4)}),
    "no faces": ((VERTICES, np.empty((0, 3), int)), {"usable": False}),
    "faces to leave out": ((VERTICES, np.vstack([FACES, [[3, 3, 1]], FACES[2:3, ::-1]])), {
        "faces_with_repeated_vertex": found(1, 12), "duplicate_faces": found(1, 13), "usable": True,
    }),
    "an edge of three faces": ((np.vstack([VERTICES, [[-1, -1, 0.5]]]), np.vstack([FACES, [[0, 1, 8]]])), {
        "first_non_manifold_edge": (0, 1),
    }),
    "parts": (parts(), {
        "components": 2, "component_vertices": (12, 8), "isolated_vertices": found(1, 20),
        "border_edges": 10, "border_loops": 1, "longest_border_loop": pytest.approx(4.0),
    }),
    "a gap": (side_by_side(plane_grid(4, 3), plane_grid(4, 3), gap=1.001), {
        "near_borders": found(6, 3), "near_border_gaps": pytest.approx((0.001, 0.001)),
    }),
    "a T-junction": (side_by_side(plane_grid(2, 2), plane_grid(2, 3), gap=1.0), {
        "t_junctions": found(1, 6), "first_t_junction_edge": (1, 3),
    }),
    "far from the origin": ((VERTICES * 1e-4 + 1e9, FACES), {"rounded_edges": found(18, 0), "usable": True}),
    "lengths too large for an index": ((1e30 * VERTICES, FACES), {"usable": True, "usable_by_index": False}),
    "lengths too small": ((1e-300 * VERTICES, FACES), {"usable": False, "usable_by_index": False}),
}  # fmt: skip


@pytest.mark.parametrize("case", REPORTS)
def test_findings(case):
    mesh, expected = REPORTS[case]
    report = vorogeo.check_mesh(*mesh)
    assert {name: getattr(report, name) for name in expected} == expected


def test_sentences_name_elements_and_say_what_to_do():
    assert "12" in str(vorogeo.check_mesh(*spoilt()))
    summary = "21 vertices, 24 faces, 2 components, 1 border loop (10 edges, 4 long, at vertex 0)."
    assert str(vorogeo.check_mesh(*parts())).startswith(summary)
    for case, words in (
        ("parts", "of 12 and 8 vertices"),
        ("a gap", "0.001 apart"),
        ("a T-junction", "T-junction"),
        ("lengths too large for an index", "multiply the coordinates"),
    ):
        assert any(words in sentence for sentence in vorogeo.check_mesh(*REPORTS[case][0]).sentences), case
    with pytest.raises(vorogeo.InvalidInput, match="scale the mesh, for example by"):
        vorogeo.GeodesicIndex(1e30 * VERTICES, FACES)


@pytest.mark.parametrize(("vertices", "faces"), [(VERTICES[:, :2], FACES), (VERTICES, FACES + 0.5), (None, FACES)])
def test_wrong_shapes_and_types_are_errors(vertices, faces):
    with pytest.raises(ValueError, match=r"vertices|faces"):
        vorogeo.check_mesh(vertices, faces)
