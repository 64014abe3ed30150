"""What was seen when MeshLab's window saved a filter script and applied one (by filter_script.py)."""

from __future__ import annotations

import xml.etree.ElementTree

import numpy as np
import vorogeo
from results import FOLDER
from test_window import saved_mesh

FILTER = "Exact geodesic distance from a given point (VoroGeo)"


def start_vertices(name: str) -> list[tuple[str, str]]:
    """Filters of a script, each with its start vertex."""
    root = xml.etree.ElementTree.parse(FOLDER / name).getroot()
    return [
        (entry.get("name"), value.get("value"))
        for entry in root.iter("filter")
        for value in entry.iter("Param")
        if value.get("name") == "vertex_index"
    ]


def test_script_saved_by_the_window_holds_the_filter(seen):
    assert start_vertices("saved.mlx") == [(FILTER, str(seen["first"]))]


def test_script_applied_by_the_window_gives_the_exact_distance(seen):
    assert seen["alive"] is True
    vertices, faces, quality = saved_mesh("field_script.ply")
    exact = vorogeo.exact_distance_field(vertices, faces, [seen["second"]])
    np.testing.assert_allclose(quality, exact, rtol=1e-6)  # the window holds quality in single precision
