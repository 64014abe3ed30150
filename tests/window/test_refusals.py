"""What was seen in MeshLab's window (by refusals.py) against what it has to be."""

from __future__ import annotations

import re

import numpy as np
import pytest
from bad_input import BAD_INPUT, NO_PATH, NOT_FINITE, NOT_FINITE_SENTENCE
from make_meshes import terrain


@pytest.mark.parametrize("case", BAD_INPUT, ids=lambda case: case.name)
def test_refusal_is_a_message_box_with_our_sentence(seen, case):
    assert "Failure of filter" in seen["boxes"][case.name]
    assert case.sentence in seen["boxes"][case.name]


@pytest.mark.parametrize("name", NOT_FINITE)
def test_coordinate_that_is_no_finite_number_is_refused(seen, name):
    assert "Failure of filter" in seen["boxes"][name]
    assert NOT_FINITE_SENTENCE in seen["boxes"][name]


def test_corrected_coordinate_is_no_longer_refused(seen):
    assert seen["boxes"]["finite again"] == ""


@pytest.mark.parametrize("case", NO_PATH, ids=lambda case: case.name)
def test_what_no_path_leads_to_is_said_in_the_log(seen, case):
    asked = seen["no path"][case.name]
    assert asked["box"] == ""
    for start in case.lines:
        assert any(line.startswith(start) for line in asked["log"]), (start, asked["log"])


def test_meshlab_goes_on_working(seen):
    assert seen["alive"] is True
    assert seen["start_point"] == seen["source_layer"] == seen["path"] == ""


def test_start_point_is_taken_from_the_point_picker(seen):
    vertices = terrain(70, 50)[0]
    to_vertex = np.linalg.norm(vertices - np.array(seen["picked"]), axis=1).min()
    lines = [re.match(r"Start: .* \d+, ([0-9.e-]+) mesh units away from the given point", line) for line in seen["log"]]
    distance = float(list(filter(None, lines))[-1][1])  # earlier ones are of filters that were refused
    assert 0 < distance <= to_vertex  # the nearest point of the surface is no farther than its nearest vertex
    assert to_vertex - distance < 0.05  # the length of an edge


def test_layer_of_points_is_chosen_by_its_name(seen):
    assert any(line.startswith("Distances from 2 source points to 3500 vertices") for line in seen["log"])


def test_path_is_drawn(seen):
    lengths = [re.match(r"Geodesic path of length ([0-9.]+) mesh units over", line) for line in seen["log"]]
    vertices = terrain(70, 50)[0]
    straight = np.linalg.norm(vertices[35] - vertices[3460])
    assert straight < float(next(filter(None, lengths))[1]) < 1.5 * straight
