"""What was seen in MeshLab's window (by scenario.py) against what it has to be."""

from __future__ import annotations

import re

import numpy as np
import pymeshlab
import pytest
import vorogeo
from results import FOLDER, PROJECT

SCRIPT = "scenario"


def all_filters() -> set[str]:
    """Menu names in the sources of the plugin."""
    rows = (file.read_text() for file in (PROJECT / "plugin" / "filters").glob("*.cpp"))
    return {name for text in rows for name in re.findall(r'[({]\s*"([^"]+\(VoroGeo\))",\s*"[a-z_]+"', text)}


def documented_filters() -> set[str]:
    """Menu names in the documentation."""
    page = " ".join((PROJECT / "docs" / "filters.md").read_text().split())
    return set(re.findall(r"\*\*([^*]+\(VoroGeo\))\*\*", page))


def saved_mesh(name: str) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Vertices, faces and quality of a mesh saved by the window."""
    mesh_set = pymeshlab.MeshSet()
    mesh_set.load_new_mesh(str(FOLDER / name))
    mesh = mesh_set.current_mesh()
    return mesh.vertex_matrix(), mesh.face_matrix(), mesh.vertex_scalar_array()


def test_the_scenario_came_to_its_end(seen):
    assert "messages" in seen
    assert seen["alive"] is True


def test_no_plugin_complains_at_the_start(seen):
    lines = seen["start"].splitlines()
    complaints = [line for line in lines if re.search(r"vorogeo|plugin|symbol|fail", line, re.IGNORECASE)]
    assert complaints == []


def test_every_filter_is_in_the_menu(seen):
    assert {item.rpartition("/")[2] for item in seen["menu"]} == all_filters()
    assert documented_filters() == all_filters()


def test_every_filter_was_found_by_its_name_in_the_search_box(seen):
    assert set(seen["dialogs"]) == all_filters()


def test_every_parameter_has_a_label_and_a_tooltip_that_is_a_sentence(seen):
    for name, parameters in seen["dialogs"].items():
        for entry in parameters:
            assert re.fullmatch(r"[A-Z0-9][^_]*", entry["label"]), (name, entry)
            assert entry["tooltip"].endswith("."), (name, entry)
            assert len(entry["tooltip"]) > 20, (name, entry)


def test_every_help_text_says_how_to_choose_and_cites(seen):
    assert set(seen["help"]) == {name for name, parameters in seen["dialogs"].items() if parameters}
    for name, text in seen["help"].items():
        assert "How to choose: " in text, name
        assert "See:" in text, name


def test_help_texts_name_parameters_by_their_labels():
    for file in (PROJECT / "plugin" / "filters").glob("*.cpp"):
        assert re.findall(r"<b>[a-z]\w*</b>", file.read_text()) == [], file.name


@pytest.mark.parametrize("key", ["index", "exact"])
def test_saved_field_is_the_exact_distance(seen, key):
    vertices, faces, quality = saved_mesh(seen["fields"][key])
    exact = vorogeo.exact_distance_field(vertices, faces, [seen["source"]])
    others = exact > 0
    errors = np.abs(quality[others] / exact[others] - 1)
    if key == "exact":
        assert errors.max() < 1e-6  # the window holds quality in single precision
    else:
        assert errors.mean() < 5e-4
        assert errors.max() < 0.05
    assert quality[seen["source"]] == 0


def test_saved_distance_from_the_border(seen):
    vertices, faces, quality = saved_mesh(seen["fields"]["border"])
    edges = np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    unique, count = np.unique(edges, axis=0, return_counts=True)
    border = np.unique(unique[count == 1])
    exact = vorogeo.exact_distance_field(vertices, faces, border)
    inside = exact > 0
    assert np.count_nonzero(quality == 0) == len(border)
    assert np.abs(quality[inside] / exact[inside] - 1).mean() < 5e-4


def test_saved_comparison_is_the_error_of_fast_marching(seen):
    """MeshLab's fast marching is a tenth of a percent to some percent too long or too short on this mesh."""
    vertices, faces, quality = saved_mesh(seen["fields"]["comparison"])
    name = "compute_scalar_by_geodesic_distance_from_given_point_per_vertex"
    mesh_set = pymeshlab.MeshSet()
    mesh_set.add_mesh(pymeshlab.Mesh(vertices, faces))
    mesh_set.apply_filter(name, startpoint=vertices[seen["source"]], maxdistance=pymeshlab.PureValue(1000.0))
    exact = vorogeo.exact_distance_field(vertices, faces, [seen["source"]])
    others = exact > 0
    expected = mesh_set.current_mesh().vertex_scalar_array()[others] / exact[others] - 1
    np.testing.assert_allclose(quality[others], expected, atol=1e-4)
    assert np.abs(expected).max() > 1e-3


def test_index_file_is_written_and_read(seen):
    vertices, faces, _ = saved_mesh(seen["fields"]["index"])
    index = vorogeo.GeodesicIndex.load(FOLDER / "terrain.vgi", vertices, faces)
    assert index.statistics.vertices == 3500
    log = "\n".join(seen["log"])
    assert "Geodesic index: written to" in log
    assert "Geodesic index: read from" in log


def test_the_index_is_described(seen):
    assert any(re.match(r"Geodesic index.*: 3500 vertices, .* MiB$", line) for line in seen["log"])


def test_applied_filters_said_nothing_in_a_box(seen):
    assert set(seen["boxes"].values()) == {""}


def test_the_log_pane_gives_figures_with_units(seen):
    log = "\n".join(seen["log"])
    assert re.search(r"Geodesic index.*: 3500 vertices.*built in [0-9.]+ s", log)
    assert re.search(r"Distances from 1 source vert\w+ to 3500 vertices.* s\b", log)


def test_pictures_were_taken(seen):
    for name in ("start", "field_index", "patches"):
        assert (FOLDER / "shots" / f"{name}.png").stat().st_size > 10_000
