"""A layer with a transformation matrix is measured as it stands in the scene, as if the matrix were frozen."""

from __future__ import annotations

import filters
import numpy as np
import pymeshlab
import pytest
from support import (
    fails_and_changes_nothing,
    field,
    grid,
    layer_count,
    length,
    logged,
    mesh_set,
    select_vertices,
    sphere,
    tube,
)

ONE_WAY = ["Hiking time", "Uphill and downhill cost"]
SIDES, RINGS = 12, 9
RING = SIDES * 4 + np.append(np.arange(SIDES), 0)  # in the middle of the tube, closed


def matrix_of(linear: np.ndarray, moved: tuple[float, float, float] = (0, 0, 0)) -> np.ndarray:
    matrix = np.eye(4)
    matrix[:3, :3] = linear
    matrix[:3, 3] = moved
    return matrix


def rotation(rng: np.random.Generator) -> np.ndarray:
    """Any one, evenly distributed."""
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q * np.linalg.det(q)


def placed(matrix: np.ndarray, points: np.ndarray) -> np.ndarray:
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def set_matrix(ms: pymeshlab.MeshSet, layer: int, matrix: np.ndarray) -> None:
    current = ms.current_mesh_id()
    ms.set_current_mesh(layer)
    ms.apply_filter("set_matrix", transformmatrix=matrix, freeze=False)
    ms.set_current_mesh(current)


def in_scene(ms: pymeshlab.MeshSet, layer: int | None = None) -> np.ndarray:
    mesh = ms.current_mesh() if layer is None else ms.mesh(layer)
    return mesh.transformed_vertex_matrix()


# ---- Each filter on a layer with a matrix, and on the same layer with the matrix frozen

NEEDED = {
    filters.FROM_POINT: {"method": "exact"},
    filters.FROM_SELECTION: {"method": "exact"},
    filters.FROM_LAYER: {"source_layer": 1, "method": "exact"},
    filters.FROM_EDGES: {"from_border": True, "method": "exact"},
    filters.TWO_POINTS: {"source": -1, "target": -1, "method": "exact"},
    filters.PATH: {"method": "exact"},
    filters.NEAREST: {"source_layer": 1, "exact": True},
    filters.SETS: {"source_layer": 1, "exact": True},
    filters.PATH_THROUGH: {"point_layer": 1},
    filters.SMOOTH: {"point_layer": 1, "samples": 4},
    filters.POLYGON: {"surface_points": "37; 38; 50", "cut_out": True},
    filters.TIGHT: {"curve_layer": 1},
    filters.CUT_CURVE: {"curve_layer": 1},
    filters.SIGNED: {"curve_layer": 1},
    filters.BAND: {"curve_layer": 1, "exact": True},
    filters.PROFILE: {"curve_layer": 1, "up": np.array([1.0, -2.0, 0.5])},
    filters.REGION: {"curve_layer": 1},
    filters.ISOLINES: {"is_distance": False},
    filters.CUT: {"is_distance": False, "line_number": 3},
    filters.FARTHEST: {"sample_number": 9, "exact": True},
    filters.DIRECTIONS: {"per_wedge": True},
    filters.METHOD_TABLE: {"methods": "dijkstra, heat"},
    filters.COMPARISON: {"method": "Shortest edge path (Dijkstra)"},
}
# Times, and counts of what was there before; the number of points on an index is not compared.
NOT_COMPARED = ("seconds", "bytes", "reused", "index")


def scene(rng: np.random.Generator, matrix: np.ndarray, frozen: bool) -> pymeshlab.MeshSet:
    """A dented tube with a quality and a selection, and a ring of points in a layer with a matrix of its own."""
    vertices, faces = tube([1.0] * RINGS, SIDES, 0.7)
    vertices = vertices * rng.uniform(0.98, 1.02, (len(vertices), 1)) + rng.uniform(-0.1, 0.1, vertices.shape)
    ms = mesh_set(vertices, faces)
    ms.compute_scalar_by_function_per_vertex(q="1 + x * x + 2 * z")
    select_vertices(ms, [20, 61, 77])
    set_matrix(ms, 0, matrix)
    own = matrix_of(rotation(rng) @ np.diag(rng.uniform(0.5, 2.0, 3)), tuple(rng.normal(size=3)))
    ring = placed(matrix, vertices[RING] * 1.01)
    ms.add_mesh(pymeshlab.Mesh(placed(np.linalg.inv(own), ring)), "ring", set_as_current=False)
    set_matrix(ms, 1, own)
    if frozen:
        for layer in (1, 0):
            ms.set_current_mesh(layer)
            ms.apply_filter("apply_matrix_freeze")
    return ms


def compared(ms: pymeshlab.MeshSet, name: str, **parameters: object) -> dict[str, np.ndarray]:
    """What a filter returns, writes and adds, with positions in the scene."""
    start = in_scene(ms)[40] + 0.01
    allowed = ms.filter_parameter_values(name)
    if "start_point" in allowed:
        parameters["start_point"] = start
    if "source_point" in allowed:
        parameters |= {"source_point": start, "target_point": in_scene(ms)[88]}
    if "normal" in allowed:
        ring = in_scene(ms, 1)
        parameters["normal"] = np.cross(ring[4] - ring[0], ring[8] - ring[0])
    found = ms.apply_filter(name, **{**NEEDED.get(name, {}), **parameters})
    result = {key: np.asarray(value) for key, value in found.items() if not any(word in key for word in NOT_COMPARED)}
    result["layers"] = np.array(layer_count(ms))
    for layer in range(layer_count(ms)):
        mesh = ms.mesh(layer)
        result |= {
            f"positions of {layer}": in_scene(ms, layer),
            f"quality of {layer}": mesh.vertex_scalar_array(),
            f"edges of {layer}": mesh.edge_matrix(),
            f"faces of {layer}": mesh.face_matrix(),
            f"selected of {layer}": mesh.vertex_selection_array(),
        }
    return result


# A mirrored layer that is frozen is turned inside out.
TURNED = (filters.DIRECTIONS, filters.PROFILE)
MATRICES = {
    "scaled": lambda rng: matrix_of(2 * np.eye(3)),
    "stretched": lambda rng: matrix_of(rotation(rng) @ np.diag([1, 2, 0.5]), (1, 2, 3)),
    "turned and moved": lambda rng: matrix_of(rotation(rng), tuple(10 * rng.normal(size=3))),
    "mirrored": lambda rng: matrix_of(rotation(rng) @ np.diag([-1, 1, 1]), (4, 5, 6)),
}


@pytest.mark.parametrize("matrix", MATRICES)
@pytest.mark.parametrize("name", [name for name in filters.ALL_FILTERS if name not in TURNED])
def test_a_filter_answers_as_on_the_frozen_layer(name, matrix):
    assert_as_frozen(name, matrix)


@pytest.mark.parametrize("matrix", [name for name in MATRICES if name != "mirrored"])
@pytest.mark.parametrize("name", TURNED)
def test_what_depends_on_the_outside_is_that_of_the_frozen_layer(name, matrix):
    assert_as_frozen(name, matrix)


@pytest.mark.parametrize("metric", ["Vertex quality as cost", "Slope penalty", "Along curvature", *ONE_WAY])
@pytest.mark.parametrize("matrix", MATRICES)
def test_metrics_are_those_of_the_frozen_layer(metric, matrix):
    assert_as_frozen(filters.EXACT_FROM_POINT, matrix, metric=metric)


def assert_as_frozen(name: str, matrix: str, **parameters: object) -> None:
    seed = np.random.SeedSequence().entropy
    rng = np.random.default_rng(seed)
    where = MATRICES[matrix](rng)
    seed_of_mesh = int(rng.integers(2**62))
    applied, frozen = (
        compared(scene(np.random.default_rng(seed_of_mesh), where, is_frozen), name, **parameters)
        for is_frozen in (False, True)
    )
    assert applied.keys() == frozen.keys()
    for key, value in frozen.items():
        np.testing.assert_allclose(applied[key], value, rtol=1e-9, atol=1e-9, err_msg=f"{key}, seed {seed}")


# ---- Lengths, areas and layers by their formulas


def test_lengths_and_areas_of_a_scaled_plane():
    vertices, faces = grid(8, 8)
    ms = mesh_set(vertices, faces)
    set_matrix(ms, 0, matrix_of(np.diag([2.0, 3.0, 5.0]), (1, 1, 1)))
    assert ms.apply_filter(filters.TWO_POINTS, source=0, target=80)["distance"] == pytest.approx(8 * 13**0.5, rel=1e-12)
    ms.apply_filter(filters.EXACT_FROM_POINT, start_point=[1.0, 1.0, 3.0])
    expected = np.hypot(2 * vertices[:, 0], 3 * vertices[:, 1])
    np.testing.assert_allclose(field(ms), expected, rtol=1e-12)
    # A circle in the scene, whose radius is half of it in percent of the diagonal.
    percent = getattr(pymeshlab, "PercentageValue", None) or pymeshlab.Percentage
    for radius in (length(3.0), percent(300 / (8 * 13**0.5))):
        found = ms.apply_filter(filters.AREA, vertex_index=40, radius=radius)
        assert found["area"] == pytest.approx(9 * np.pi, rel=1e-6)
        assert found["border_length"] == pytest.approx(6 * np.pi, rel=1e-6)
    found = ms.apply_filter(filters.DISK, vertex_index=40, radius=length(3.01))
    assert found["selected_vertices"] == 5  # one step of 3, or of 2, in each direction
    np.testing.assert_array_equal(ms.current_mesh().vertex_matrix(), vertices)


def test_a_path_over_a_box_that_the_matrix_makes_of_a_cube():
    ms = pymeshlab.MeshSet()
    ms.create_cube()
    set_matrix(ms, 0, matrix_of(np.diag([1.0, 2.0, 3.0])))
    corners = ms.current_mesh().vertex_matrix()
    ends = [int(np.argmin(corners.sum(axis=1))), int(np.argmax(corners.sum(axis=1)))]
    found = ms.apply_filter(filters.PATH, source=ends[0], target=ends[1])
    assert found["length"] == pytest.approx(18**0.5, rel=1e-12)  # over the sides of 1 and 2, unfolded, and 3
    steps = np.linalg.norm(np.diff(in_scene(ms), axis=0), axis=1)
    assert steps.sum() == pytest.approx(18**0.5, rel=1e-12)
    at = ms.current_mesh().vertex_matrix()  # in the frame of the cube, on its sides
    np.testing.assert_allclose(np.abs(at - corners.mean(axis=0)).max(axis=1), 0.5, atol=1e-12)
    ms.apply_filter("apply_matrix_freeze")
    np.testing.assert_allclose(np.ptp(ms.current_mesh().vertex_matrix(), axis=0), [1, 2, 3], atol=1e-12)


def test_girth_of_a_cylinder_that_is_made_wider():
    ms = mesh_set(*tube([1.0] * 5, SIDES))
    set_matrix(ms, 0, matrix_of(np.diag([3.0, 3.0, 1.0])))
    found = ms.apply_filter(filters.GIRTH, vertex_index=int(2 * SIDES), normal=[0, 0, 1])
    around = SIDES * 6 * np.sin(np.pi / SIDES)
    for kind in ("section", "tape", "loop"):
        assert found[f"{kind}_length"] == pytest.approx(around, rel=1e-9)
    np.testing.assert_allclose(np.hypot(*in_scene(ms)[:, :2].T).max(), 3.0)
    # A layer that a filter has made is a curve for the next one, each with its matrix.
    ms.set_current_mesh(0)
    assert ms.apply_filter(filters.TIGHT, curve_layer=3)["length"] == pytest.approx(around, rel=1e-9)


def test_slopes_are_those_of_the_scene():
    ms = mesh_set(*grid(4, 4))
    set_matrix(ms, 0, matrix_of(np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])))  # a wall
    found = ms.apply_filter(filters.TWO_POINTS, source=0, target=24, metric="Slope penalty", slope_penalty=1.0)
    assert found["distance"] == pytest.approx(2 * 32**0.5, rel=1e-9)


def test_directions_turn_counter_clockwise_as_the_scene_is_seen():
    """The outside of the plane leads upwards, in the layer as in the scene."""
    for mirror in (1.0, -1.0):
        ms = mesh_set(*grid(4, 4))
        set_matrix(ms, 0, matrix_of(np.diag([mirror, 1.0, 1.0])))
        ms.apply_filter(filters.DIRECTIONS, vertex_index=12, radius=length(0))
        at = in_scene(ms) - in_scene(ms)[12]
        angle = np.delete(np.arctan2(at[:, 1], at[:, 0]) - field(ms), 12)
        np.testing.assert_allclose(np.exp(1j * angle), np.exp(1j * angle[0]), atol=1e-9)


def test_a_mirrored_ball_is_as_thick_and_round_as_it_was():
    vertices, faces = sphere(3)
    ms = mesh_set(vertices, faces)
    set_matrix(ms, 0, matrix_of(np.diag([2.0, -2.0, 2.0])))
    ms.apply_filter(filters.PATH, source=5, target=100)
    ms.set_current_mesh(0)
    found = ms.apply_filter(filters.PROFILE, curve_layer=1)
    np.testing.assert_allclose(found["thickness"], 4, rtol=0.02)
    np.testing.assert_allclose(found["curvature"][1:-1].mean(), 0.5, rtol=0.05)
    np.testing.assert_allclose(2 * np.cos(found["angle"]), found["height"], atol=0.1)


def test_parts_of_a_mirrored_layer_are_turned_as_it_is():
    ms = mesh_set(*grid(4, 4))
    ms.compute_scalar_by_function_per_vertex(q="x")
    set_matrix(ms, 0, matrix_of(np.diag([-2.0, 1.0, 1.0])))
    assert ms.apply_filter(filters.CUT, values="1.5", is_distance=False)["parts"] == 2
    for part, width in ((1, 1.5), (2, 2.5)):
        a, b, c = ms.mesh(part).vertex_matrix()[ms.mesh(part).face_matrix()].transpose(1, 0, 2)
        areas = np.cross(b - a, c - a) / 2
        assert (areas[:, 2] > 0).all()
        np.testing.assert_allclose(areas.sum(axis=0), [0, 0, 4 * width], atol=1e-12)


# ---- What is kept, said and refused


def test_a_change_of_the_matrix_alone_is_seen(tmp_path):
    ms = mesh_set(*grid(12, 12))
    for scale in (1.25, 2.75):
        set_matrix(ms, 0, matrix_of(scale * np.eye(3)))
        ms.apply_filter(filters.INDEX)
        found = ms.apply_filter(filters.TWO_POINTS, source=0, target=168, method="index")
        assert found["index_reused"]
        assert found["distance"] == pytest.approx(scale * 288**0.5, rel=1e-3)
        file = str(tmp_path / f"{scale}.vgi")
        ms.apply_filter(filters.SAVE_INDEX, index_file=file)
    assert ms.apply_filter(filters.LOAD_INDEX, index_file=file)["vertices"] == 169
    set_matrix(ms, 0, matrix_of(1.25 * np.eye(3)))
    found = ms.apply_filter(filters.TWO_POINTS, source=0, target=168, method="index")
    assert found["index_reused"]
    assert found["distance"] == pytest.approx(1.25 * 288**0.5, rel=1e-3)
    with pytest.raises(pymeshlab.PyMeshLabException):
        ms.apply_filter(filters.LOAD_INDEX, index_file=file)


def test_the_log_says_that_the_matrix_was_applied():
    setup = "ms.add_mesh(pymeshlab.Mesh(*grid(4, 4)))"
    moved = "ms.apply_filter('set_matrix', transformmatrix=np.diag([2.0, 2, 2, 1]), freeze=False)"
    call = "ms.apply_filter(EXACT_FROM_POINT, vertex_index=0)"
    said = [seen.count("The layer's matrix was applied: lengths are those in the scene") for seen in
            logged(setup, [call, f"{moved};{call}", call])]  # fmt: skip
    assert said == [0, 1, 1]


REFUSED = {
    "is singular: it presses the layer flat. Take it back by 'Matrix: Reset Current Matrix'": np.diag([1.0, 0, 1, 1]),
    "has an element that is NaN or infinite": np.diag([1.0, np.nan, 1, 1]),
    "is projective, as its last row is not 0 0 0 1": np.eye(4) + np.outer([0, 0, 0, 1], [0.5, 0, 0, 0]),
}


@pytest.mark.parametrize("message", REFUSED)
@pytest.mark.parametrize("name", filters.ALL_FILTERS)
def test_a_matrix_without_an_inverse_is_refused(name, message):
    ms = mesh_set(*grid(3, 3))
    select_vertices(ms, [3])
    ms.add_mesh(pymeshlab.Mesh(np.array([[1.0, 1, 0]])), "point", set_as_current=False)
    set_matrix(ms, 0, REFUSED[message])
    with fails_and_changes_nothing(ms, message):
        ms.apply_filter(name)
    assert layer_count(ms) == 2


@pytest.mark.parametrize("name", [filters.FROM_LAYER, filters.NEAREST, filters.SETS])
def test_so_is_that_of_another_layer(name):
    ms = mesh_set(*grid(3, 3))
    select_vertices(ms, [3])
    ms.add_mesh(pymeshlab.Mesh(np.array([[1.0, 1, 0]])), "scars", set_as_current=False)
    set_matrix(ms, 1, np.diag([1.0, 0, 1, 1]))
    with fails_and_changes_nothing(ms, 'The transformation matrix of the layer "scars" is singular'):
        ms.apply_filter(name, source_layer=1)


def test_a_layer_without_a_name_is_named_by_its_number():
    ms = mesh_set(*grid(3, 3))
    set_matrix(ms, 0, np.diag([1.0, 0, 1, 1]))
    label = ms.current_mesh().label()
    with fails_and_changes_nothing(ms, f'the layer "{label}" is singular' if label else "of layer 0 is singular"):
        ms.apply_filter(filters.EXACT_FROM_POINT)
