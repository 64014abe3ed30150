"""What was seen when the geodesic ruler was used in MeshLab's window: lengths against formulas, hostile steps."""

from __future__ import annotations

import csv
import io
import re

import numpy as np
import pymeshlab
import pytest
import vorogeo
from make_meshes import HOLE, PLATE_AT, plate_with_hole, sphere
from results import FOLDER, written_down

PATH = "generate_polyline_by_vorogeo_geodesic_path"


@pytest.fixture(scope="module")
def saved() -> dict[int, dict[str, str]]:
    """The measurements that were saved, by number."""
    return measurements((FOLDER / "ruler.csv").read_text())


def measurements(text: str) -> dict[int, dict[str, str]]:
    """The rows of a file of the ruler, by number."""
    return {int(row["number"]): row for row in csv.DictReader(io.StringIO(text))}


def points_of(row: dict[str, str]) -> np.ndarray:
    """The points of a measurement."""
    return np.array([[float(x) for x in point.split()] for point in row["points"].split(";")])


def end(row: dict[str, str], which: int) -> np.ndarray:
    """One end of a measurement."""
    return points_of(row)[which]


def great_circle(a: np.ndarray, b: np.ndarray) -> float:
    """Length of the arc between the directions of two points."""
    return np.arccos(a @ b / (np.linalg.norm(a) * np.linalg.norm(b)))


def around_the_hole(a: np.ndarray, b: np.ndarray) -> float:
    """Length of the shortest path between two points of the plate that do not see each other."""
    a, b = (p[:2] - PLATE_AT[:2] for p in (a, b))
    turn = abs(np.angle(complex(*b) / complex(*a)))
    seen_from = [np.arccos(HOLE / np.linalg.norm(p)) for p in (a, b)]
    tangents = sum(np.sqrt(p @ p - HOLE**2) for p in (a, b))
    return tangents + HOLE * (turn - sum(seen_from))


def test_the_scenario_came_to_its_end(seen):
    assert seen["alive"] is True
    assert "seconds to quit" in seen


def test_no_plugin_complains_at_the_start(seen):
    lines = [
        line for line in seen["start"].splitlines() if re.search(r"vorogeo|plugin|symbol|fail", line, re.IGNORECASE)
    ]
    assert lines == []


def test_path_around_the_hole_has_the_length_of_tangents_and_arc(seen, saved):
    row = saved[1]
    expected = around_the_hole(end(row, 0), end(row, 1))
    assert expected > np.linalg.norm(end(row, 0) - end(row, 1)) * 1.02
    # The rim has 256 edges: a chord is shorter than its arc by 2.5e-5.
    length, straight = float(row["length"]), float(row["straight"])
    assert length == pytest.approx(expected, rel=5e-5)
    assert straight == pytest.approx(np.linalg.norm(end(row, 0) - end(row, 1)), rel=1e-12)
    assert float(row["ratio"]) == pytest.approx(length / straight, rel=1e-12)
    assert seen["tables"]["plate"][0] == [
        *("1", "distance 1", "distance", f"{length:.4g}", "model"),
        f"straight {straight:.4g}, ratio {length / straight:.4g}; exact",
    ]


def test_lengths_are_those_of_the_scene_whatever_the_layers_matrix():
    seen = written_down("ruler_layer")
    found = [re.match(r"Ruler: distance \d: .* straight ([0-9.]+)", line) for line in seen["log"]]
    before, scaled = (float(line[1]) for line in found if line)
    # The same two places of the view.
    assert before == pytest.approx(scaled, rel=1e-4)
    assert ["before an edit" in row[-1] for row in seen["rows"]] == [True, False]


def test_path_on_the_sphere_is_a_great_circle(seen, saved):
    row = saved[3]
    length = float(row["length"])
    assert length == pytest.approx(great_circle(end(row, 0), end(row, 1)), rel=2e-3)
    assert length > 0.5
    assert seen["tables"]["sphere"][2][3] == f"{length:.4g}"


def test_exact_paths_are_those_of_the_package(saved):
    for number, mesh in ((1, plate_with_hole()), (3, sphere(5))):
        vertices, faces = mesh[0].astype(np.float32).astype(float), mesh[1]
        index = vorogeo.GeodesicIndex(vertices, faces)
        ends = index.snap([end(saved[number], 0), end(saved[number], 1)])
        assert ends.snap_distance.max() < 1e-6
        assert index.exact_path(ends[0], ends[1]).length == pytest.approx(float(saved[number]["length"]), rel=1e-9)


def test_places_beside_the_current_layer_measure_nothing(seen):
    assert seen["tables"]["beside the layer"] == seen["tables"]["plate"]


def test_another_component_has_no_path(seen, saved):
    assert seen["tables"]["other component"][1][3] == "no path"
    assert saved[2]["length"] == "inf"


def test_each_line_is_saved_as_a_layer_of_its_name(seen):
    layers = [name.removesuffix(" *") for name in seen["layers"]]
    assert [name for name in layers if name.startswith("distance")] == ["distance 1", "distance 3"]  # 2 has no path


def test_saved_layer_is_that_of_the_filter(saved):
    """Point by point, along the path; the edges between them are not written by MeshLab's dialog."""
    layer = pymeshlab.MeshSet()
    layer.load_new_mesh(str(FOLDER / "ruler_paths.ply"))
    lines = layer.current_mesh()
    vertices, faces = sphere(5)
    mesh_set = pymeshlab.MeshSet()
    mesh_set.add_mesh(pymeshlab.Mesh(vertices.astype(np.float32).astype(float), faces))
    ends = {"source_point": end(saved[3], 0), "target_point": end(saved[3], 1)}
    found = mesh_set.apply_filter(PATH, exact=True, **ends)
    path = mesh_set.current_mesh()
    assert found["length"] == pytest.approx(float(saved[3]["length"]), rel=1e-6)
    assert lines.vertex_number() == path.vertex_number()
    np.testing.assert_allclose(lines.vertex_matrix(), path.vertex_matrix(), atol=1e-5)
    assert lines.vertex_scalar_array()[-1] == pytest.approx(float(saved[3]["length"]), rel=1e-6)


def test_a_field_becomes_the_quality_of_the_vertices(seen):
    line = next(line for line in seen["lines"] if line.startswith("Ruler: distances"))
    assert "(exact)" in line
    assert float(re.search(r"the largest ([0-9.]+)", line)[1]) == pytest.approx(np.pi, rel=0.02)


def test_measurements_are_kept_and_removed_one_by_one(seen):
    tables = seen["tables"]
    assert tables["left"] == []
    assert tables["entered again"] == tables["sphere"]
    assert tables["deleted"] == tables["sphere"][:2]


def test_all_views_of_a_document_share_one_list(seen):
    tables = seen["tables"]
    assert [row[0] for row in tables["second view"]] == ["1", "2", "4"]
    assert tables["second view"][:2] == tables["layer deleted"][:2]


def test_the_table_is_copied(seen):
    assert all(name in seen["copied"] for name in ("No.", "Name", "Kind", "Value", "Unit", "Details"))
    assert all(cell in seen["copied"] for row in seen["tables"]["sphere"] for cell in row)


def test_a_layer_without_faces_is_refused_in_a_sentence(seen):
    assert "has lines but no faces" in seen["on a layer without faces"]


def frames(line: str) -> float:
    """Frames a second of a drag."""
    return float(re.search(r"([0-9.e+]+) a second", line)[1])


def test_drags_show_many_paths_a_second(seen):
    """The processor draws the scene here, beside other work; docs/window.md has figures."""
    drags = [line for line in seen["large lines"] if re.search(r"paths .*shown", line)]
    assert frames(next(line for line in drags if "; exact" in line)) > 1
    assert frames([line for line in drags if "; refined" in line][-1]) > 3


def test_the_index_is_built_on_the_side_and_not_used_after_an_edit(seen):
    assert seen["status exact"].startswith("Paths: exact, without an index. Distances: exact.")
    assert seen["status with index"].startswith("Paths: from the index, exact at the end. Distances: index.")
    assert seen["status edited"].startswith("Paths: exact, without an index.")
    methods = {row[5].partition("; ")[2] for row in seen["tables"]["large edited"]}
    assert methods == {"exact, before an edit"}


def test_quitting_while_the_index_is_built_leaves_nothing_running(seen):
    assert seen["building"]
    assert seen["seconds to quit"] < 15
