"""What was seen when the plugin was loaded by MeshLab's dialog, installed for one user, and used in filter scripts."""

from __future__ import annotations

import xml.etree.ElementTree

import numpy as np
import pytest
import vorogeo
from test_window import FOLDER, all_filters, saved_mesh, written_down

FILTER = "Exact geodesic distance from a given point (VoroGeo)"


@pytest.fixture(scope="module")
def loading() -> dict:
    """What loading.py saw."""
    return written_down("loading")


@pytest.fixture(scope="module")
def extra_folder() -> dict:
    """What extra_folder.py saw."""
    return written_down("extra_folder")


@pytest.fixture(scope="module")
def scripting() -> dict:
    """What filter_script.py saw."""
    return written_down("filter_script")


def start_vertices(name: str) -> list[tuple[str, str]]:
    """Filters of a script, each with its start vertex."""
    root = xml.etree.ElementTree.parse(FOLDER / name).getroot()
    return [
        (entry.get("name"), value.get("value"))
        for entry in root.iter("filter")
        for value in entry.iter("Param")
        if value.get("name") == "vertex_index"
    ]


def test_load_plugins_adds_every_filter_to_the_menu(loading):
    assert loading["before"] == []
    assert set(loading["after"]) == all_filters()


def test_a_filter_of_a_loaded_plugin_is_applied(loading):
    assert loading["applied"] == ""
    assert f"Start: vertex {loading['source']}" in loading["log"]
    assert loading["alive"] is True


def test_plugin_installed_for_one_user_is_found_and_applied(extra_folder):
    assert set(extra_folder["filters"]) == all_filters()
    assert extra_folder["applied"] == ""
    assert f"Start: vertex {extra_folder['source']}" in extra_folder["log"]
    assert extra_folder["alive"] is True


def test_script_saved_by_the_window_holds_the_filter(scripting):
    assert start_vertices("saved.mlx") == [(FILTER, str(scripting["first"]))]


def test_script_applied_by_the_window_gives_the_exact_distance(scripting):
    assert scripting["alive"] is True
    vertices, faces, quality = saved_mesh("field_script.ply")
    exact = vorogeo.exact_distance_field(vertices, faces, [scripting["second"]])
    np.testing.assert_allclose(quality, exact, rtol=1e-6)  # the window holds quality in single precision
