"""What was seen when a mesh was picked on, edited and emptied in MeshLab's window, and when memory was short."""

from __future__ import annotations

import re

import numpy as np
import vorogeo
from make_meshes import terrain
from test_window import saved_mesh


def test_point_picked_by_a_double_click_lies_on_the_mesh_and_distances_start_there(seen):
    assert seen["apply picked"] == ""
    vertices = terrain(70, 50)[0]
    assert np.linalg.norm(vertices - seen["picked"], axis=1).min() < 0.05  # the length of an edge
    starts = [
        re.match(r"Start: .* \d+, ([0-9.e-]+) mesh units away from the given point", line) for line in seen["log"]
    ]
    assert float(next(filter(None, starts))[1]) < 0.01  # what is picked is a pixel of the picture


def test_index_is_not_used_after_an_edit(seen):
    lines = seen["log"]
    before, after = lines[: seen["lines before the edit"]], lines[seen["lines before the edit"] :]
    assert any("reused, the mesh has not changed" in line for line in before)
    none = next(i for i, line in enumerate(after) if "none for this mesh as it is" in line)
    built = next(i for i, line in enumerate(after) if "built in" in line)
    assert none < built
    assert not any("reused, the mesh has not changed" in line for line in after[:built])
    assert "There is no index for this mesh as it is." in seen["save after the edit"]


def test_distance_after_an_edit_is_that_of_the_edited_mesh(seen):
    assert seen["apply after the edit"] == ""
    vertices, faces, quality = saved_mesh("field_edited.ply")
    np.testing.assert_allclose(np.ptp(vertices, axis=0)[:2], [3 * seen["scale"], 2 * seen["scale"]], rtol=1e-6)
    exact = vorogeo.exact_distance_field(vertices, faces, [seen["after"]])
    others = exact > 0
    assert np.abs(quality[others] / exact[others] - 1).mean() < 5e-4


def test_lack_of_memory_is_a_message_box_and_meshlab_goes_on_working(seen):
    assert "Failure of filter" in seen["without memory"]
    assert re.search(r"not enough memory|of memory available", seen["without memory"])
    assert seen["with memory"] == ""


def test_empty_layer_is_refused(seen):
    assert "The current layer is empty: it has no vertices." in seen["empty layer"]
    assert seen["alive"] is True
