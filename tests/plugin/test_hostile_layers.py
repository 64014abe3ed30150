"""Every filter on layers that are barely surfaces, and cancelled anywhere: answered whole, or refused in a sentence."""

from __future__ import annotations

from collections.abc import Callable

import filters
import numpy as np
import pymeshlab
import pytest
from support import (
    Arrays,
    arrays,
    fails_and_changes_nothing,
    grid,
    layer_count,
    length,
    logged,
    mesh_for,
    mesh_set,
    select_vertices,
    side_by_side,
    sphere,
    state,
)

CURVE_FILTERS = (
    filters.TIGHT,
    filters.CUT_CURVE,
    filters.SIGNED,
    filters.BAND,
    filters.PROFILE,
    filters.REGION,
    filters.LOOP,
)
NEEDED = {
    filters.FROM_LAYER: {"source_layer": 1},
    filters.FROM_EDGES: {"from_border": True},
    filters.NEAREST: {"source_layer": 1},
    filters.SETS: {"source_layer": 1},
    filters.PATH: {"target": 1, "source": 0},
    filters.TWO_POINTS: {"target": 1, "source": 0},
    **{name: {"curve_layer": 1} for name in CURVE_FILTERS},
    filters.ISOLINES: {"is_distance": False},
    filters.CUT: {"is_distance": False},
    filters.METHOD_TABLE: {"methods": "dijkstra"},
    filters.COMPARISON: {"method": "Shortest edge path (Dijkstra)"},
}


def corners(*places: tuple[float, float, float]) -> np.ndarray:
    return np.array(places, dtype=float)


def faces(*rows: tuple[int, int, int]) -> np.ndarray:
    return np.array(rows, dtype=np.int32)


def two_fans() -> Arrays:
    """Two squares that have one vertex in common."""
    at = corners((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (-1, 0, 0), (-1, -1, 0), (0, -1, 0))
    return at, faces((0, 1, 2), (0, 2, 3), (0, 4, 5), (0, 5, 6))


def book() -> Arrays:
    """Three pages on one edge."""
    at = corners((0, 0, 0), (0, 1, 0), (1, 0.5, 0), (-1, 0.5, 0), (0, 0.5, 1))
    return at, faces((0, 1, 2), (1, 0, 3), (0, 1, 4))


def needles() -> Arrays:
    """A plane in which a vertex lies on its neighbour, so that two faces have no area, and one more beside it."""
    at, rows = grid(6, 6)
    at[24] = at[23]
    return np.vstack([at, [[5.5, 6, 0]]]), np.vstack([rows, faces((47, 48, 49))])


def with_isolated() -> Arrays:
    at, rows = grid(6, 6)
    return np.vstack([at, [[3.0, 3, 9]]]), rows


def twice() -> Arrays:
    """Faces that are there twice, turned round or name a vertex twice."""
    at, rows = grid(6, 6)
    return at, np.vstack([rows, rows[10:12], rows[5:6, ::-1], faces((3, 3, 4))])


def turned() -> Arrays:
    at, rows = grid(6, 6)
    rows[::3] = rows[::3, ::-1]
    return at, rows


LAYERS = {
    "two fans": two_fans,
    "a book": book,
    "faces without area": needles,
    "an isolated vertex": with_isolated,
    "two components": lambda: side_by_side(grid(6, 6), sphere(1)),
    "one triangle": lambda: (corners((0, 0, 0), (1, 0, 0), (0, 1, 0)), faces((0, 1, 2))),
    "one point": lambda: (np.zeros((3, 3)), faces((0, 1, 2))),
    "one line": lambda: (corners((0, 0, 0), (1, 0, 0), (2, 0, 0)), faces((0, 1, 2))),
    "faces twice": twice,
    "turned faces": turned,
}


def scene(layer: Arrays, seed: int) -> pymeshlab.MeshSet:
    """The layer with a quality and a selection, and beside it some of its places as a layer of points."""
    at, rows = layer
    random = np.random.default_rng(seed)
    ms = mesh_set(at, rows)
    ms.compute_scalar_by_function_per_vertex(q="1 + x + 2 * y")
    select_vertices(ms, sorted({0, *random.choice(len(at), 2).tolist()}))
    ms.add_mesh(pymeshlab.Mesh(at[random.choice(rows[random.integers(len(rows))], 3, replace=False)]), "c", False)
    return ms


def refusal(ms: pymeshlab.MeshSet, apply: Callable[[], object], told: str) -> str:
    """The last line of the error of a filter, after which all is as it was; empty if there was none."""
    before, count = state(ms), layer_count(ms)
    try:
        apply()
    except pymeshlab.PyMeshLabException as error:
        said = str(error).strip().splitlines()[-1]
    else:
        return ""
    assert layer_count(ms) == count, told
    for key, value in state(ms).items():
        np.testing.assert_array_equal(value, before[key], err_msg=f"{key}, {told}")
    return said


@pytest.mark.parametrize("layer", LAYERS)
@pytest.mark.parametrize("name", filters.ALL_FILTERS)
def test_a_filter_answers_whole_or_not_at_all(name, layer):
    seed = np.random.SeedSequence().entropy % 2**32
    ms = scene(LAYERS[layer](), seed)
    before = state(ms)
    parameters = dict(NEEDED.get(name, {}))
    if "vertex_index" in ms.filter_parameter_values(name):
        parameters["vertex_index"] = int(np.random.default_rng(seed).integers(len(before["vertices"])))
    found = {}
    said = refusal(ms, lambda: found.update(ms.apply_filter(name, **parameters) or {}), f"seed {seed}")
    if said:
        assert said.endswith("."), (said, seed)
        return
    for added in range(layer_count(ms)):
        mesh = ms.mesh(added)
        assert np.isfinite(mesh.vertex_matrix()).all(), seed
        assert np.isfinite(mesh.vertex_scalar_array()).all(), seed
        assert mesh.vertex_number() > 0, seed
    ms.set_current_mesh(0)
    np.testing.assert_array_equal(ms.current_mesh().vertex_matrix(), before["vertices"])
    np.testing.assert_array_equal(ms.current_mesh().face_matrix(), before["faces"])
    unreached = [value for key, value in found.items() if key == "unreachable_vertices"]
    assert all(0 <= value <= len(before["vertices"]) for value in unreached), seed


# ---- Directions, means, curves, sides and cut loci: where what they need is missing

BESIDE = "There are no directions at "
MISSING = [
    (filters.DIRECTIONS, "two fans", {"vertex_index": 0}, BESIDE + "vertex 0: its faces are not one fan"),
    (filters.DIRECTIONS, "a book", {"vertex_index": 1}, BESIDE + "vertex 1: its faces are not one fan"),
    (
        filters.DIRECTIONS,
        "a book",
        {"start_point": [0.0, 0.4, 0.0]},
        "from vertex 0 to 1: three faces or more meet there",
    ),
    (
        filters.DIRECTIONS,
        "faces without area",
        {"vertex_index": 24},
        "vertex 24: its faces are not one fan, or an edge there",
    ),
    (
        filters.DIRECTIONS,
        "an isolated vertex",
        {"vertex_index": 49},
        BESIDE + "vertex 49: no face has it; take another point",
    ),
    (filters.DIRECTIONS, "one line", {"vertex_index": 0}, BESIDE + "vertex 0: the angles of its faces sum to 0"),
    (filters.MEAN, "two fans", {"surface_points": "0; 1; 4"}, BESIDE + "vertex 0"),
    (
        filters.MEAN,
        "two components",
        {"surface_points": "0; 60"},
        "No path leads from point 0 (vertex 0) to point 1 (vertex 60)",
    ),
    (
        filters.MEAN,
        "an isolated vertex",
        {"surface_points": "0; 49"},
        "to point 1 (vertex 49): they are on two components",
    ),
    (
        filters.SMOOTH,
        "two components",
        {"surface_points": "0; 1; 60"},
        "from point 1 (vertex 1) to point 2 (vertex 60)",
    ),
    (filters.SMOOTH, "two fans", {"surface_points": "1; 0; 4"}, BESIDE + "vertex 0"),
    (filters.SIGNED, "two components", {"curve_layer": 1}, "they are on two components"),
]


@pytest.mark.parametrize(("name", "layer", "parameters", "message"), MISSING)
def test_what_is_missing_is_named(name, layer, parameters, message):
    at, rows = LAYERS[layer]()
    ms = mesh_set(at, rows)
    ms.add_mesh(pymeshlab.Mesh(at[[0, len(at) - 1, 1]]), "curve", set_as_current=False)
    with fails_and_changes_nothing(ms, message):
        ms.apply_filter(name, **parameters)
    assert layer_count(ms) == 2


def test_a_mean_on_the_spine_of_a_book_says_where_its_descent_ends():
    ms = mesh_set(*book())
    message = "The descent to the middle of the points cannot go on. There are no directions at a point of face "
    with fails_and_changes_nothing(ms, message):
        ms.apply_filter(filters.MEAN, surface_points="2; 3; 4")
    assert layer_count(ms) == 1


def test_a_sphere_seen_from_a_corner_of_a_flat_sheet_has_no_lines_and_no_layer():
    ms = mesh_set(*side_by_side(grid(6, 6), sphere(1)))
    found = ms.apply_filter(filters.CUT_LOCUS, surface_points="24")
    assert (found["segments"], found["length"], found["unreachable_vertices"]) == (0, 0, 42)
    assert layer_count(ms) == 1


def test_vertices_that_no_path_reaches_are_told():
    setup = (
        "ms.add_mesh(pymeshlab.Mesh(*side_by_side(grid(6, 6), sphere(1))))\n"
        "ms.compute_selection_by_condition_per_face(condselect='fi < 3')"
    )
    calls = [
        f"ms.apply_filter({name!r}, {parameters}); ms.set_current_mesh(0)"
        for name, parameters in [
            (filters.DIRECTIONS, "vertex_index=24"),
            (filters.CUT_LOCUS, "surface_points='3; 40'"),
            (filters.SIGNED, ""),
        ]
    ]
    assert ["No path leads to 42 vertices" in said for said in logged(setup, calls)] == [True] * 3


@pytest.mark.parametrize(
    "name",
    [
        *CURVE_FILTERS,
        filters.FROM_LAYER,
        filters.PATH_THROUGH,
        filters.SMOOTH,
    ],
)
def test_a_curve_with_a_coordinate_that_is_not_finite_is_named(name):
    ms = mesh_set(*grid(6, 6))
    ms.add_mesh(pymeshlab.Mesh(corners((1, 1, 0), (np.nan, 1, 0), (1, 3, 0))), "curve", set_as_current=False)
    parameter = {
        filters.FROM_LAYER: "source_layer",
        filters.PATH_THROUGH: "point_layer",
        filters.SMOOTH: "point_layer",
    }.get(name, "curve_layer")
    with fails_and_changes_nothing(ms, "Vertex 1 of layer 1"):
        ms.apply_filter(name, **{parameter: 1})
    assert layer_count(ms) == 2


# ---- Cancelled, not only at once


@pytest.mark.parametrize("name", filters.ALL_FILTERS)
def test_a_filter_that_is_cancelled_later_has_done_nothing_or_all(name):
    seed = np.random.SeedSequence().entropy % 2**32
    random = np.random.default_rng(seed)
    at, rows = mesh_for(name)
    at = at * random.uniform(1, 2)
    where = [3, 31, 143] if len(at) > 143 else [3, 31, 90]
    numbers = {**NEEDED.get(name, {}), **({"point_layer": 1} if name in (filters.POLYGON, filters.SMOOTH) else {})}
    text = ";".join(f"{key}={value}" for key, value in numbers.items() if isinstance(value, (int, bool)))
    calls = None
    for _ in range(5):
        ms = mesh_set(at, rows)
        select_vertices(ms, [0, 50])
        ms.add_mesh(pymeshlab.Mesh(at[where]), "points", set_as_current=False)
        how = {"filter": name, "numbers": text.lower()}
        if calls is None:
            calls = ms.apply_filter("probe_apply", **how)["probe_calls"]
            continue
        how["calls_allowed"] = int(random.integers(calls + 1))
        said = refusal(ms, lambda how=how, ms=ms: ms.apply_filter("probe_apply", **how), f"seed {seed}")
        assert not said or "Cancelled: nothing was changed." in said, seed


def test_a_radius_of_nothing_is_no_limit_and_a_small_one_leaves_a_vertex_alone():
    ms = mesh_set(*grid(6, 6))
    assert ms.apply_filter(filters.DIRECTIONS, vertex_index=24, radius=length(0))["reached_vertices"] == 49
    found = ms.apply_filter(filters.DIRECTIONS, vertex_index=24, radius=length(0.25))
    assert (found["reached_vertices"], found["vertices_beyond_max_distance"]) == (1, 48)
    assert (found["mean_distortion"], found["max_distortion"]) == (0, 0)
    np.testing.assert_allclose(ms.current_mesh().vertex_tex_coord_matrix()[24], [0.5, 0.5], atol=1e-7)
    for bad in (np.nan, np.inf):
        with fails_and_changes_nothing(ms, "(radius) is"):
            ms.apply_filter(filters.DIRECTIONS, vertex_index=24, radius=length(bad))
    assert len(arrays(ms)[0]) == 49
    assert ms.apply_filter(filters.DISK, vertex_index=24, radius=length(0.25))["selected_vertices"] == 1
