"""Metrics by which a way back costs something else, in the filters: against formulas, and what refuses them."""

from __future__ import annotations

import filters
import numpy as np
import pymeshlab
import pytest
from support import fails_and_changes_nothing, field, grid, host_version, length, mesh_set, select_vertices

SIZE, GRADE, SPEED = 12, 0.25, 2.0
MIDDLE = 6 * (SIZE + 1) + 6
BOTH = pytest.mark.parametrize("to", [False, True], ids=["from", "to"])


def slope() -> pymeshlab.MeshSet:
    """A plane that rises along x."""
    vertices, faces = grid(SIZE, SIZE)
    vertices[:, 2] = GRADE * vertices[:, 0]
    return mesh_set(vertices, faces)


def add_to_faces(mesh: pymeshlab.Mesh, vectors: np.ndarray, name: str) -> None:
    """An attribute of points, as winds are."""
    if host_version() == "2022.02":
        pytest.skip("PyMeshLab 2022.2 corrupts its memory where it adds an attribute of points to faces")
    mesh.add_face_custom_point_attribute(vectors, name)


def windy(random: np.random.Generator) -> tuple[pymeshlab.MeshSet, np.ndarray]:
    """A plane with a wind of its faces, which is the same in all, and that wind."""
    vertices, faces = grid(SIZE, SIZE)
    wind = np.append(random.uniform(-1, 1, 2), 0.0)
    ms = mesh_set(vertices, faces)
    add_to_faces(ms.current_mesh(), np.tile(wind, (len(faces), 1)), "wind")
    return ms, wind


WIND = {"metric": "Wind", "own_speed": SPEED}


def times(steps: np.ndarray, wind: np.ndarray) -> np.ndarray:
    """Zermelo: times of straight steps, each the least t for which the own step is as long as speed times t."""
    lam = SPEED**2 - wind @ wind
    along = steps @ wind
    return (np.sqrt(along**2 + lam * (steps * steps).sum(axis=-1)) - along) / lam


def from_vertices(sources: list[int], wind: np.ndarray, to: bool) -> np.ndarray:
    """The times between vertices and all others, a row for each."""
    vertices = grid(SIZE, SIZE)[0]
    steps = vertices[None] - vertices[sources][:, None]
    return times(-steps if to else steps, wind)


@pytest.fixture
def random() -> np.random.Generator:
    return np.random.default_rng()


def test_hiking_time_is_toblers_in_seconds_and_costs_of_height_are_added_to_lengths():
    ms = slope()
    low, high = 0, SIZE
    for metric, up, down in (
        ({"metric": "Hiking time"}, *(0.6 * np.exp(3.5 * (GRADE + sign * 0.05)) for sign in (1, -1))),
        ({"metric": "Uphill and downhill cost"}, *(np.hypot(1, GRADE) + cost * GRADE for cost in (8, 2))),
        (
            {"metric": "Uphill and downhill cost", "uphill_cost": 5, "downhill_cost": 0.5},
            *(np.hypot(1, GRADE) + cost * GRADE for cost in (5, 0.5)),
        ),
    ):
        assert ms.apply_filter(filters.TWO_POINTS, source=low, target=high, **metric)["distance"] == pytest.approx(
            SIZE * up
        )
        assert ms.apply_filter(filters.TWO_POINTS, source=high, target=low, **metric)["distance"] == pytest.approx(
            SIZE * down
        )
        for ends, expected in (((low, high), up), ((high, low), down)):
            found = ms.apply_filter(filters.PATH, source=ends[0], target=ends[1], **metric)
            assert found["length"] == pytest.approx(SIZE * expected)
            assert field(ms)[-1] == pytest.approx(found["length"])  # along the path
            assert found["answered_by"] == 2
            ms.set_current_mesh(0)
        for name in (filters.EXACT_FROM_POINT, filters.FROM_POINT):
            ms.apply_filter(name, vertex_index=low, **metric)
            assert field(ms)[high] == pytest.approx(SIZE * up, rel=1e-6)
            ms.apply_filter(name, vertex_index=low, to=True, **metric)
            assert field(ms)[high] == pytest.approx(SIZE * down, rel=1e-6)
    through = ms.apply_filter(filters.PATH_THROUGH, surface_points="0; 12; 0", metric="Uphill and downhill cost")
    assert through["length"] == pytest.approx(SIZE * (2 * np.hypot(1, GRADE) + 10 * GRADE))


def test_without_costs_of_height_it_is_the_length():
    ms = slope()
    ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=MIDDLE, metric=6, uphill_cost=0, downhill_cost=0)
    even = field(ms).copy()
    ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=MIDDLE)
    np.testing.assert_allclose(even, field(ms), rtol=1e-6)


def test_faces_that_are_too_steep_are_barriers_on_foot():
    ms = slope()
    for metric in ("Hiking time", "Uphill and downhill cost"):
        for steepest, barred in ((GRADE * 1.01, 0), (GRADE * 0.99, (SIZE + 1) ** 2 - 1)):
            found = ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=0, metric=metric, steepest_grade=steepest)
            assert found["unreachable_vertices"] == barred
        with fails_and_changes_nothing(ms, "(steepest_grade) is -1. Give a number above 0, or 0 for any grade"):
            ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=0, metric=metric, steepest_grade=-1)


@BOTH
def test_fields_in_a_wind(to, random):
    ms, wind = windy(random)
    expected = from_vertices([MIDDLE], wind, to)[0]
    for name in (filters.EXACT_FROM_POINT, filters.FROM_POINT):
        ms.apply_filter(name, vertex_index=MIDDLE, to=to, **WIND)
        np.testing.assert_allclose(field(ms), expected, rtol=1e-5, atol=1e-9)
    sources = [3, 100]
    select_vertices(ms, sources)
    nearest = from_vertices(sources, wind, to).min(axis=0)
    ms.apply_filter(filters.FROM_SELECTION, to=to, **WIND)
    np.testing.assert_allclose(field(ms), nearest, rtol=1e-5, atol=1e-9)
    ms.add_mesh(pymeshlab.Mesh(grid(SIZE, SIZE)[0][sources]), "points", set_as_current=False)
    ms.apply_filter(filters.FROM_LAYER, source_layer=1, to=to, **WIND)
    np.testing.assert_allclose(field(ms), nearest, rtol=1e-5, atol=1e-9)
    vertices = grid(SIZE, SIZE)[0]
    border = np.flatnonzero(((vertices[:, :2] % SIZE) == 0).any(axis=1)).tolist()
    for name, how in ((filters.FROM_BORDER, {}), (filters.FROM_EDGES, {"from_border": True, "spacing": length(1.0)})):
        ms.apply_filter(name, to=to, **how, **WIND)
        np.testing.assert_allclose(field(ms), from_vertices(border, wind, to).min(axis=0), rtol=1e-5, atol=1e-9)
    lines = ms.apply_filter(filters.ISOLINES, line_number=3)
    assert lines["segments"] > 0


@BOTH
def test_tasks_in_a_wind(to, random):
    ms, wind = windy(random)
    vertices = grid(SIZE, SIZE)[0]
    sites = random.choice(len(vertices), 4, replace=False).tolist()
    rows = from_vertices(sites, wind, to)
    points = "; ".join(map(str, sites))
    found = ms.apply_filter(filters.VORONOI, surface_points=points, borders=False, to=to, **WIND)
    of_site = np.take_along_axis(rows, field(ms).astype(int)[None], axis=0)[0]
    np.testing.assert_allclose(of_site, rows.min(axis=0), rtol=1e-9, atol=1e-9)
    lam = 1 - wind @ wind / SPEED**2
    unit = lam**-1.5 / SPEED**2  # of area, in the squares of times
    assert sum(found["areas"]) == pytest.approx(SIZE**2 * unit)
    from_one = from_vertices([MIDDLE], wind, to)[0]
    radius = float(np.median(from_one)) * (1 + 1e-6)
    disk = ms.apply_filter(filters.DISK, vertex_index=MIDDLE, radius=length(radius), to=to, **WIND)
    assert disk["selected_vertices"] == (from_one <= radius).sum()
    area = ms.apply_filter(filters.AREA, vertex_index=MIDDLE, radius=length(0.9), to=to, **WIND)["area"]
    assert area == pytest.approx(np.pi * 0.9**2 * lam**-1.5, rel=1e-4)
    ms.add_mesh(pymeshlab.Mesh(vertices[sites]), "sites", set_as_current=False)
    nearest = ms.apply_filter(filters.NEAREST, source_layer=1, surface_points="0; 80", to=to, **WIND)
    np.testing.assert_allclose(nearest["distances"], rows[:, [0, 80]].min(axis=0), rtol=1e-9)
    band = ms.apply_filter(filters.BAND, curve_layer=1, width=length(0.2), to=to, **WIND)
    assert 0 < band["area"] < SIZE**2 * unit
    samples = ms.apply_filter(filters.FARTHEST, sample_number=5, to=to, **WIND)
    ids = np.asarray(samples["vertices"]).astype(int).tolist()
    assert samples["covering_radius"] == pytest.approx(from_vertices(ids, wind, to).min(axis=0).max(), rel=1e-9)


def test_matrices_hold_both_ways(random):
    ms, wind = windy(random)
    ids = random.choice((SIZE + 1) ** 2, 5, replace=False).tolist()
    expected = from_vertices(ids, wind, False)[:, ids]
    points = "; ".join(map(str, ids))
    found = ms.apply_filter(filters.MATRIX, surface_points=points, **WIND)
    np.testing.assert_allclose(np.reshape(found["distances"], (5, 5)), expected, rtol=1e-9, atol=1e-9)
    radius = float(np.median(expected)) * (1 + 1e-6)
    pairs = ms.apply_filter(filters.PAIRS_WITHIN, surface_points=points, radius=length(radius), **WIND)
    # The points are named by their places in the text.
    first, second = (np.asarray(pairs[key]).astype(int) for key in ("first", "second"))
    within = {(i, j) for i in range(5) for j in range(5) if i != j and expected[i, j] <= radius}
    assert {*zip(first.tolist(), second.tolist(), strict=True)} == within
    np.testing.assert_allclose(pairs["distances"], expected[first, second], rtol=1e-9)


def test_a_wind_of_vertices_is_that_of_their_faces_in_the_mean_and_turns_with_the_layer(random):
    ms, wind = windy(random)
    vertices = grid(SIZE, SIZE)[0]
    ms.current_mesh().add_vertex_custom_point_attribute(np.tile(wind, (len(vertices), 1)), "current")
    expected = from_vertices([MIDDLE], wind, False)[0]
    angle = random.uniform(0, 6)
    turn = np.eye(4)
    turn[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    for matrix in (np.eye(4), turn):
        ms.apply_filter("set_matrix", transformmatrix=matrix, freeze=False)
        for name in ("current", "wind"):
            ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=MIDDLE, wind_attribute=name, **WIND)
            np.testing.assert_allclose(field(ms), expected, rtol=1e-5, atol=1e-9)


def test_a_new_wind_is_a_new_metric(random):
    vertices, faces = grid(SIZE, SIZE)
    ms = mesh_set(vertices, faces)
    mesh = ms.current_mesh()
    winds = random.uniform(-1, 1, (2, 3)) * [1, 1, 0]
    for name, wind in zip(("wind", "other"), winds, strict=True):
        add_to_faces(mesh, np.tile(wind, (len(faces), 1)), name)
        ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=MIDDLE, wind_attribute=name, **WIND)
        np.testing.assert_allclose(field(ms), from_vertices([MIDDLE], wind, False)[0], rtol=1e-5, atol=1e-9)


STRONG = "The wind of face 7 has the speed 3"
BAD = [
    ({"metric": 6, "uphill_cost": -1}, "(uphill_cost) is -1. Give a number of at least 0"),
    ({"metric": 6, "uphill_cost": np.nan}, "(uphill_cost) is nan"),
    ({"metric": 6, "downhill_cost": -0.5}, "(downhill_cost) is -0.5. Give a number of at least 0"),
    ({"metric": 6, "downhill_cost": np.inf}, "(downhill_cost) is inf"),
    ({"metric": 7, "own_speed": 0}, "(own_speed) is 0. Give a number above 0"),
    ({"metric": 7, "own_speed": np.nan}, "(own_speed) is nan"),
    ({"metric": 7, "wind_attribute": "storm"}, "(wind_attribute) is 'storm', but neither the faces nor the vertices"),
    ({"metric": 7, "wind_attribute": ""}, "(wind_attribute) is '', but neither the faces nor the vertices"),
    ({"metric": 7, "wind_attribute": "strong", "own_speed": 2}, STRONG),
    ({"metric": 7, "wind_attribute": "unknown"}, "The drift of face 5 is not finite"),
]


@pytest.mark.parametrize(("parameters", "message"), BAD)
def test_bad_costs_and_winds(parameters, message, random):
    ms, _ = windy(random)
    count = 2 * SIZE**2
    strong, unknown = np.zeros((2, count, 3))
    strong[7], unknown[5, 1] = [0, 3, 0], np.nan
    for name, wind in (("strong", strong), ("unknown", unknown)):
        add_to_faces(ms.current_mesh(), wind, name)
    with fails_and_changes_nothing(ms, message):
        ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=0, **parameters)


REFUSED = [
    (filters.INDEX, {}, "Indexes"),
    (filters.FROM_POINT, {"vertex_index": 0, "method": "index"}, "Indexes"),
    (filters.FROM_POINT, {"vertex_index": 0, "method": "quick"}, "Quick distances"),
    (filters.POISSON, {"radius": length(1.0)}, "Poisson-disk samplings"),
    (filters.LLOYD, {"surface_points": "0; 80"}, "Lloyd relaxations"),
    (filters.MEAN, {"surface_points": "0; 80"}, "Means and medians"),
    (filters.SETS, {"surface_points": "0; 80", "source_layer": 1}, "Distances of two sets"),
    (filters.EXTENT, {}, "Diameter and centre"),
    (filters.POLYGON, {"surface_points": "0; 12; 80"}, "Polygons"),
    (filters.CUT_LOCUS, {"surface_points": "0"}, "Cut loci"),
    (filters.SIGNED, {"curve_layer": 1}, "Signed distances"),
]


@pytest.mark.parametrize(("name", "parameters", "what"), REFUSED)
def test_what_needs_both_ways_alike_is_refused_by_its_name(name, parameters, what, random):
    ms, _ = windy(random)
    ms.add_mesh(pymeshlab.Mesh(grid(SIZE, SIZE)[0][[40, 60, 45]]), "points", set_as_current=False)
    with fails_and_changes_nothing(ms, f"{what} need ways back that cost the same, and this metric goes one way"):
        ms.apply_filter(name, **parameters, **WIND)


@BOTH
def test_to_makes_no_difference_where_both_ways_cost_the_same(to):
    ms = slope()
    ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=MIDDLE, to=to)
    expected = np.linalg.norm(ms.current_mesh().vertex_matrix() - ms.current_mesh().vertex_matrix()[MIDDLE], axis=1)
    np.testing.assert_allclose(field(ms), expected, rtol=1e-6, atol=1e-9)
