"""What was seen when the table of the ruler was filled and changed in MeshLab's window: values against formulas."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from make_meshes import HOLE, PLATE_AT
from results import FOLDER
from test_ruler import great_circle, measurements, points_of

KINDS = ["polygon", "loop", "angle", "path", "tape", "disk", "distance"]


@pytest.fixture(scope="module")
def saved() -> dict[int, dict[str, str]]:
    """The measurements that were saved, by number."""
    return measurements((FOLDER / "ruler_table.csv").read_text())


def test_the_script_came_to_its_end(seen):
    assert seen["alive"] is True
    assert [row[2] for row in seen["sphere"]] == KINDS


def test_polygon_has_the_area_and_perimeter_of_its_corners(saved):
    x, y, _ = points_of(saved[1]).T
    area = abs(x @ np.roll(y, 1) - y @ np.roll(x, 1)) / 2
    assert len(x) == 3
    assert float(saved[1]["area"]) == pytest.approx(area, rel=1e-6)
    assert float(saved[1]["perimeter"]) == pytest.approx(np.hypot(x - np.roll(x, 1), y - np.roll(y, 1)).sum(), rel=1e-6)


def test_loop_goes_round_the_hole(saved):
    away = np.linalg.norm(points_of(saved[2])[0] - PLATE_AT)
    expected = 2 * np.sqrt(away**2 - HOLE**2) + HOLE * (2 * np.pi - 2 * np.arccos(HOLE / away))
    assert float(saved[2]["length"]) == pytest.approx(expected, rel=5e-5)  # the rim has 256 edges


def test_angle_is_that_at_the_second_point(saved):
    a, b, c = points_of(saved[3])
    cosine = (a - b) @ (c - b) / np.linalg.norm(a - b) / np.linalg.norm(c - b)
    assert float(saved[3]["angle"]) == pytest.approx(np.degrees(np.arccos(cosine)), rel=1e-6)


def test_path_goes_through_the_points_but_that_taken_back(saved):
    a, b, c = points_of(saved[4])
    assert float(saved[4]["length"]) == pytest.approx(great_circle(a, b) + great_circle(b, c), rel=2e-3)


def test_tape_and_section_go_round_the_sphere(saved):
    assert float(saved[5]["tape"]) == pytest.approx(2 * np.pi, rel=2e-3)
    assert float(saved[5]["section"]) == pytest.approx(2 * np.pi, rel=2e-3)
    assert saved[5]["loop"] == "" or float(saved[5]["loop"]) <= float(saved[5]["section"])


def test_disk_is_a_cap_of_the_sphere(saved):
    radius = great_circle(*points_of(saved[6]))
    assert float(saved[6]["radius"]) == pytest.approx(radius, rel=2e-3)
    assert float(saved[6]["area"]) == pytest.approx(2 * np.pi * (1 - np.cos(radius)), rel=4e-3)
    assert float(saved[6]["border"]) == pytest.approx(2 * np.pi * np.sin(radius), rel=4e-3)


def test_values_in_the_table_are_those_of_the_file_with_four_digits(seen, saved):
    quantities = ("area", "length", "angle", "length", "tape", "area", "length")
    for row, quantity in zip(seen["changed"], quantities, strict=True):
        assert row[3] == f"{float(saved[int(row[0])][quantity]):.4g}"
    assert [row[4] for row in seen["sphere"]] == ["model²", "model", "°", "model", "model", "model²", "model"]
    assert [row[4] for row in seen["changed"]] == ["mm²", "mm", "°", "mm", "mm", "mm²", "mm"]


def test_a_loop_that_contracts_is_refused_in_a_sentence(seen):
    assert "contract" in seen["refused"]


def test_escape_takes_points_back_until_there_are_none(seen):
    assert seen["moved"][:6] == seen["sphere"][:6]
    assert len(seen["moved"]) == 7


def test_a_point_that_was_moved_measures_again(seen, saved):
    assert seen["moved"][6][:3] == seen["sphere"][6][:3]
    assert seen["moved"][6][3] != seen["sphere"][6][3]
    assert float(saved[7]["length"]) == pytest.approx(great_circle(*points_of(saved[7])), rel=2e-3)


def test_names_are_the_users(seen, saved):
    assert seen["changed"][5][1] == "neck, left"
    assert saved[6]["name"] == "neck, left"


def test_undo_brings_back_what_was_deleted(saved):
    assert sorted(saved) == [1, 2, 3, 4, 5, 6, 7]


def test_measurements_before_an_edit_say_so_and_are_measured_again(seen):
    assert ["before an edit" in row[5] for row in seen["edited"]] == [False] * 3 + [True] * 4
    assert not any("before an edit" in row[5] for row in seen["again"])
    stored = measurements(seen["stored"])
    arcs = {number: [great_circle(*ends) for ends in pairwise(points_of(stored[number]))] for number in (4, 6, 7)}
    assert float(stored[4]["length"]) == pytest.approx(2 * sum(arcs[4]), rel=2e-3)
    assert float(stored[5]["tape"]) == pytest.approx(4 * np.pi, rel=2e-3)
    assert float(stored[6]["area"]) == pytest.approx(8 * np.pi * (1 - np.cos(arcs[6][0])), rel=4e-3)
    assert float(stored[7]["length"]) == pytest.approx(2 * arcs[7][0], rel=2e-3)


def test_the_project_has_its_measurements_when_it_is_opened_again(seen):
    assert [row[:5] for row in seen["reopened"]] == [row[:5] for row in seen["again"]]
    # The scaled sphere was not saved.
    assert ["before an edit" in row[5] for row in seen["reopened"]] == [False] * 3 + [True] * 4
    assert [number for number, row in measurements(seen["stored"]).items() if row["hidden"] == "1"] == [5]


def test_the_file_is_written_beside_a_project_that_is_saved(seen):
    assert seen["stored again"] == seen["stored"]


def test_a_file_of_before_is_kept_under_another_name_that_the_log_names(seen):
    assert "no columns kind and points" in seen["unreadable line"]
    assert seen["unreadable line"].endswith("table.mlp.measurements.unreadable2.")
    assert seen["unreadable rows"] == []
    files = seen["unreadable files"]
    assert files["table.mlp.measurements.unreadable"] == "an earlier one"
    assert files["table.mlp.measurements.unreadable2"].startswith("VoroGeo measurements 1\n")
    assert len(files) == 2
