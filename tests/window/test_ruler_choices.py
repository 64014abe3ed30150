"""What was seen when the ruler snapped, measured in other metrics, backed out and read its table again."""

from __future__ import annotations

import re

import numpy as np
import pymeshlab
import pytest
from make_meshes import HOLE, PLATE_AT, plate_with_hole, sphere
from results import FOLDER
from test_ruler import PATH, measurements, points_of


@pytest.fixture(scope="module")
def saved() -> dict[int, dict[str, str]]:
    """The measurements that were saved, by number."""
    return measurements((FOLDER / "ruler_choices.csv").read_text())


def test_the_script_came_to_its_end(seen):
    assert seen["alive"] is True


def test_the_dock_says_where_points_snap(seen):
    assert seen["snaps"] == ["vertex (V)", "edge (E)", "border (B)", "free (F)"]


def away_from_edges(points: np.ndarray, faces_of: tuple[np.ndarray, np.ndarray]) -> np.ndarray:
    """How far points are from the nearest edge of a mesh."""
    vertices, faces = faces_of
    a, b = vertices[faces].reshape(-1, 3), vertices[np.roll(faces, -1, axis=1)].reshape(-1, 3)
    along = np.clip(np.einsum("pek,ek->pe", points[:, None] - a, b - a) / ((b - a) ** 2).sum(axis=1), 0, 1)
    return np.linalg.norm(a + along[..., None] * (b - a) - points[:, None], axis=2).min(axis=1)


def test_points_snap_to_vertices_edges_and_the_border(saved):
    vertices, faces = plate_with_hole()
    picked, nearest = points_of(saved[4]), {}
    for number, reach in ((1, 0.05), (2, 0.03), (3, 0.5)):
        nearest[number] = points_of(saved[number])
        assert np.linalg.norm(nearest[number] - picked, axis=1).max() < reach
    apart = np.linalg.norm(nearest[1][:, None] - vertices, axis=2).min(axis=1)
    assert apart.max() < 1e-6
    assert away_from_edges(nearest[2], (vertices, faces)).max() < 1e-6
    assert away_from_edges(picked, (vertices, faces)).max() > 1e-4
    x, y = (nearest[3] - PLATE_AT)[:, :2].T
    away = np.minimum(abs(np.maximum(abs(x), abs(y)) - 1), abs(np.hypot(x, y) - HOLE))
    assert away.max() < 1e-4  # the rim of the hole has 256 edges


def test_a_gap_is_crossed_only_if_it_is_bridged(seen, saved):
    assert saved[5]["length"] == "inf"
    assert float(saved[6]["length"]) == pytest.approx(float(saved[6]["straight"]), rel=1e-6)
    assert [float(saved[number]["gap"]) for number in (5, 6)] == [0, 0.25]
    assert "; gap 0.25; exact" in seen["saved"][5][5]


def test_quality_is_the_cost_and_is_kept_while_it_is_overwritten(seen, saved):
    """Where the cost is the distance from a point, a ray from that costs half the difference of squares."""
    start = points_of(saved[7])[0]
    near, far = (np.linalg.norm(point - start) for point in points_of(saved[8]))
    assert float(saved[8]["length"]) == pytest.approx((far**2 - near**2) / 2, rel=1e-2)
    assert float(saved[9]["length"]) == pytest.approx(float(saved[8]["length"]), rel=1e-6)
    assert [saved[number]["metric"] for number in (7, 8, 9)] == ["Length", *["Vertex quality as cost"] * 2]
    assert all("vertex quality as cost, gap 0.25; exact" in row[5] for row in seen["saved"][7:9])


def test_what_is_no_metric_is_refused_in_a_sentence(seen):
    assert "faces have no quality" in seen["without quality"]
    assert "Give a number" in seen["no number"]


def test_the_slope_costs_what_it_costs_in_the_filter(saved):
    vertices, faces = sphere(5)
    mesh_set = pymeshlab.MeshSet()
    mesh_set.add_mesh(pymeshlab.Mesh(vertices.astype(np.float32).astype(float), faces))
    ends = dict(zip(("source_point", "target_point"), points_of(saved[10]), strict=True))
    choice = {"metric": "Slope penalty", "slope_penalty": 2.0, "exact": True}
    found = mesh_set.apply_filter(PATH, **ends, **choice)
    assert found["length"] == pytest.approx(float(saved[10]["length"]), rel=1e-6)
    assert found["length"] > 1.05 * float(saved[10]["straight"])


def test_escape_in_a_drag_measures_nothing(seen):
    assert seen["backed out"] == seen["before"]


def test_the_dock_says_that_a_preview_is_shown(seen):
    assert seen["during a drag"] == ["Exact.", "Preview: refined, from the index; exact once it ends."]
    assert all(row[5].endswith("exact") for row in seen["saved"])


def test_the_table_is_read_again(seen, saved):
    assert [row[1:] for row in seen["opened"]] == [row[1:] for row in seen["saved"]]
    lines = seen["lines"][seen["lines before"] :]
    assert any("12 measurements read" in line for line in lines)
    for row in saved.values():  # each is measured, for its lines, once its layer is current
        if row["length"] == "inf":
            continue
        again = [line for line in lines if line.startswith(f"Ruler: {row['name']}: ")]
        value = float(re.search(r"length ([0-9.]+)", again[0])[1])
        assert value == pytest.approx(float(row["length"]), rel=1e-6)


def test_another_file_is_refused_in_a_sentence(seen):
    assert "columns kind and points" in seen["no table"]
