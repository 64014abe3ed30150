"""Gaps up to the width that is given are bridged, at the cost of their width, in every way of asking."""

from __future__ import annotations

import pickle
from pathlib import Path

import ask
import numpy as np
import pytest
import surfaces
import vorogeo
from surfaces import Floats, Mesh

WIDTH = 1e-3
WAYS = ask.FIELDS


def beside(first: Mesh, second: Mesh, shift: list[float]) -> Mesh:
    """Both meshes, the second one moved."""
    return np.vstack([first[0], second[0] + shift]), np.vstack([first[1], second[1] + len(first[0])]).astype(np.int32)


def plates(width: float = WIDTH) -> Mesh:
    """Two squares with a gap between them, at which they have different vertices."""
    return beside(surfaces.plain_grid(8, 8, 1, 1), surfaces.plain_grid(8, 11, 1, 1), [1 + width, 0, 0])


def tolerance(by: str) -> float:
    """The relative error of a field on a plane."""
    return {"index": 2e-2, "quick": 1e-2}.get(by, 1e-9)


def straight(vertices: Floats, source: int) -> Floats:
    return np.linalg.norm(vertices - vertices[source], axis=1)


@pytest.mark.parametrize("by", WAYS)
@pytest.mark.parametrize("mesh", [plates(), plates(0.0)], ids=["plates", "T-junctions"])
def test_a_plane_in_parts_is_one(by: str, mesh: Mesh) -> None:
    for source in (0, len(mesh[0]) - 1):
        field = ask.gap_field(by, mesh, source, 2 * WIDTH)
        np.testing.assert_allclose(field, straight(mesh[0], source), rtol=tolerance(by), atol=1e-9)


#: A metric that costs 2 left of the gap and 5 right of it, and across the gap what the dearer side does.
SIDES = {
    "vertices": lambda right, m: vorogeo.VertexCost(np.where(right, 5.0, 2.0)),
    "faces": lambda right, m: vorogeo.FaceCost(np.where(right[plates()[1][:, 0]], 5.0, 2.0)),
    "tensors": lambda right, m: vorogeo.FaceTensor(
        np.where(right[plates()[1][:, 0]], 25.0, 4.0)[:, None, None] * np.eye(3)
    ),
    "drifts": lambda right, m: vorogeo.FaceRanders(
        np.where(right[plates()[1][:, 0]], 25.0, 4.0)[:, None, None] * np.eye(3), np.tile([0.75, 0.0, 0.0], (m, 1))
    ),
}


@pytest.mark.parametrize("kind", SIDES)
def test_a_bridge_costs_its_length_times_the_dearer_side(kind: str) -> None:
    vertices, faces = plates()
    surface = vorogeo.Surface(
        vertices, faces, metric=SIDES[kind](vertices[:, 0] > 1 + WIDTH / 2, len(faces)), gap=2 * WIDTH
    )
    source, across = 0, np.flatnonzero((vertices[:, 1] == 0) & (vertices[:, 0] > 1 + WIDTH / 2))
    drift = 0.75 if kind == "drifts" else 0.0
    beyond = vertices[across, 0] - 1 - WIDTH
    there = 2 + drift + 5 * WIDTH + (5 + drift) * beyond
    back = 2 - drift + 5 * WIDTH + (5 - drift) * beyond
    np.testing.assert_allclose(surface.distance_field(source)[across], there, rtol=1e-9)
    np.testing.assert_allclose(surface.distance_field(source, to=True)[across], back, rtol=1e-9)
    np.testing.assert_allclose(surface.distance(source, across), there, rtol=1e-9)


@pytest.mark.parametrize("by", ["exact", "index", "function"])
def test_one_cost_everywhere_holds_over_gaps_too(by: str) -> None:
    vertices, faces = plates()
    for metric in (vorogeo.VertexCost(np.full(len(vertices), 3.0)), vorogeo.FaceCost(np.full(len(faces), 3.0))):
        for source in (0, len(vertices) - 1):
            field = ask.gap_field(by, (vertices, faces), source, 2 * WIDTH, metric=metric)
            np.testing.assert_allclose(field, 3 * straight(vertices, source), rtol=tolerance(by), atol=1e-9)


def test_no_bridge_leads_to_a_barrier() -> None:
    vertices, faces = plates()
    cost = np.where(vertices[:, 0] > 1 + WIDTH / 2, np.inf, 1.0)
    surface = vorogeo.Surface(vertices, faces, metric=vorogeo.VertexCost(cost), gap=2 * WIDTH)
    np.testing.assert_array_equal(np.isinf(surface.distance_field(0)), np.isinf(cost))
    assert surface.last.unreached == np.isinf(cost).sum()


@pytest.mark.parametrize("by", WAYS)
def test_a_surface_that_turns_back_is_joined_only_with_bridged_folds(by: str) -> None:
    vertices, faces = surfaces.plain_grid(17, 8, 2, 1)
    folded = vertices.copy()
    folded[:, 0] = np.minimum(vertices[:, 0], 2 - vertices[:, 0])
    folded[:, 2] = np.where(vertices[:, 0] > 1, WIDTH, 0)
    along = 1 + np.hypot(1 / 8, WIDTH) + 7 / 8
    assert ask.gap_field(by, (folded, faces), 0, 2 * WIDTH)[16] == pytest.approx(along, rel=tolerance(by))
    assert ask.gap_field(by, (folded, faces), 0, 2 * WIDTH, folds=True)[16] == pytest.approx(WIDTH, rel=tolerance(by))


@pytest.mark.parametrize("by", ["exact", "index"])
def test_steps_over_a_gap_are_marked_in_paths(by: str) -> None:
    vertices, faces = plates()
    path = ask.bridged(by, (vertices, faces), 2 * WIDTH).path(0, len(vertices) - 1)
    assert path.length == pytest.approx(straight(vertices, 0)[-1], rel=1e-9 if by == "exact" else 3e-3)
    x = path.points[:, 0]
    middle = (x[1:] + x[:-1]) / 2
    np.testing.assert_array_equal(path.over_gap[:-1], (middle > 1) & (middle < 1 + WIDTH))
    assert path.over_gap.any()
    inside = (x > 1 + 1e-9) & (x < 1 + WIDTH - 1e-9)
    np.testing.assert_array_equal(path.surface_points.faces == -1, inside)


@pytest.mark.parametrize("by", ask.TASKS)
def test_bridges_have_no_area_and_faces_keep_their_numbers(by: str) -> None:
    vertices, faces = plates()
    surface = ask.bridged(by, (vertices, faces), 2 * WIDTH)
    regions = surface.voronoi([0, len(vertices) - 1], **ask.choice(by))
    assert regions.area.sum() == pytest.approx(2.0, rel=1e-9)
    assert len(regions.face_region) == len(faces)
    np.testing.assert_array_equal(surface.disk(0, 10.0, **ask.choice(by)).faces, np.arange(len(faces)))
    assert surface.snap([1 + WIDTH / 2, 0.5, 0]).snap_distance[0] == pytest.approx(WIDTH / 2, rel=1e-9)


def test_files_and_copies_know_the_gap(tmp_path: Path) -> None:
    index = ask.bridged("index", plates(), 2 * WIDTH)
    index.save(tmp_path / "plates.vgi")
    with ask.refused("other gaps bridged", vorogeo.IndexFileError):
        vorogeo.GeodesicIndex.load(tmp_path / "plates.vgi", *plates())
    loaded = vorogeo.GeodesicIndex.load(tmp_path / "plates.vgi", *plates(), gap=2 * WIDTH)
    copied = pickle.loads(pickle.dumps(index))
    for other in (loaded, copied):
        np.testing.assert_array_equal(other.distance_field(3), index.distance_field(3))
    assert copied.gap == index.gap


def test_the_report_says_which_gap_joins_all() -> None:
    mesh = plates()
    assert vorogeo.check_mesh(*mesh).gap_to_join_all == pytest.approx(WIDTH, rel=1e-9)
    assert vorogeo.check_mesh(*mesh, gap=0.9 * WIDTH).components_after_bridging == 2
    report = vorogeo.check_mesh(*mesh, gap=1.1 * WIDTH)
    assert (report.joined_borders, report.components_after_bridging) == (2, 1)
    assert any("joins 2 borders of 2" in sentence for sentence in report.sentences)


@pytest.mark.parametrize("gap", [-1.0, np.nan, np.inf, "wide"])
def test_a_gap_that_is_no_length_is_refused(gap: object) -> None:
    for question in (vorogeo.GeodesicIndex, vorogeo.Surface, vorogeo.check_mesh):
        with ask.refused("gap: "):
            question(*plates(), gap=gap)
