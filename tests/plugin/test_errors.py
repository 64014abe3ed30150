"""Bad input: a sentence that says what is wrong and what to do, and an unchanged layer."""

from __future__ import annotations

import filters
import numpy as np
import pymeshlab
import pytest
from support import fails_and_changes_nothing, grid, layer_count, length, mesh_set, select_vertices, sphere


@pytest.mark.parametrize("name", filters.ALL_FILTERS)
def test_what_is_no_surface(name):
    with pytest.raises(pymeshlab.PyMeshLabException):
        pymeshlab.MeshSet().apply_filter(name)
    cloud = mesh_set(grid(3, 3)[0])
    with fails_and_changes_nothing(cloud, "is a point cloud: it has vertices but no faces"):
        cloud.apply_filter(name)


def test_lines_are_no_surface():
    lines = mesh_set(*grid(3, 3))
    lines.generate_polyline_by_vorogeo_geodesic_path(source=0, target=8)
    with fails_and_changes_nothing(lines, "make the layer of the surface the current one"):
        lines.compute_scalar_by_vorogeo_distance_from_given_point_per_vertex(vertex_index=0)


@pytest.fixture
def ms():
    """A square with a selected vertex, a layer with a point half above it, and one without vertices."""
    result = mesh_set(*grid(3, 3))
    result.add_mesh(pymeshlab.Mesh(np.array([[1.0, 1.0, 0.5]])))
    result.add_mesh(pymeshlab.Mesh(np.zeros((1, 3))))
    result.apply_filter("set_selection_all")
    result.apply_filter("meshing_remove_selected_vertices")
    result.set_current_mesh(0)
    select_vertices(result, [3])
    return result


NEAR = length(0.1)
NEGATIVE = length(-1)
OF_INDEX = [
    ({"n1": -1}, "(n1) is -1. Give a positive number of patches"),
    ({"n1": 1000}, "first-layer patches, n1, is 1000; give one from 0"),
    ({"n2": 1000}, "second-layer patches, n2, is 1000; give one from 0"),
    ({"n2": -7}, "(n2) is -7. Give a positive number of patches"),
    ({"delta": -0.5}, "(delta) is -0.5. Give a number from 0 to below 1"),
    ({"delta": 1.0}, "(delta) is 1. Give a number from 0 to below 1"),
    ({"delta": np.nan}, "(delta) is nan. Give a number from 0 to below 1"),
    ({"memory_budget": -1}, "(memory_budget) is -1"),
    ({"threads": -1}, "(threads) is -1. Give a number from 1 to 1024, or 0 for one per core"),
    ({"threads": 1025}, "(threads) is 1025. Give a number from 1 to 1024"),
    ({"threads": 2**31 - 1}, "(threads) is 2147483647. Give a number from 1 to 1024"),
    ({"seed": -1}, "(seed) is -1. Give 0 or a positive number"),
    ({"index_file": "/nowhere/index.vgi"}, "cannot be written: there is no folder"),
    ({"index_file": "/tmp"}, "is a folder; name a file in it"),
    ({"index_file": "/proc/vorogeo.vgi"}, "/proc/vorogeo.vgi"),
]
BAD_POINTS = [
    ({"surface_points": "7; two"}, '"two", point 1 of'),
    ({"surface_points": "7 0.5"}, "is not a surface point"),
    ({"surface_points": ";"}, "holds no point"),
    ({"surface_points": "99999"}, "is 99999, but the vertices of the current layer are numbered"),
    ({"surface_points": "700 0.2 0.3 0.5"}, "names face 700"),
    ({"surface_points": "7 0.2 0.3 0.6"}, "(surface_points): The point in face 7 has"),
    ({"surface_points": "7 nan 0.3 0.6"}, "point 0 of"),
    ({"point_layer": 9}, "(point_layer) is 9, but there is no such layer"),
    ({"point_layer": 1, "max_snap_distance": NEAR}, "Vertex 0 of layer 1 is 0.5"),
    ({"point_layer": 2}, "Layer 2 has no vertex"),
]
REFUSED = [
    *[(filters.INDEX, *row) for row in OF_INDEX],
    *[(filters.PATCHES, {"layer": n}, f"(layer) is {n}. The index has two layers") for n in (0, 3, -1)],
    # The parameter is named as the window shows it and as scripts call it.
    *[
        (
            name,
            {"vertex_index": n},
            f'"Start vertex" (vertex_index) is {n}, but the vertices of the current layer are numbered from 0 to 15',
        )
        for name in (*filters.FROM_A_POINT, filters.COMPARISON, filters.DIRECTIONS, filters.GIRTH, filters.LOOP)
        for n in (-2, 16, 2**31 - 1)
    ],
    *[
        (name, {"start_point": [0, np.nan, 0]}, "(start_point) has a coordinate that is NaN")
        for name in (*filters.FROM_A_POINT, filters.DIRECTIONS, filters.GIRTH, filters.LOOP)
    ],
    *[
        (name, {"max_distance": length(value)}, f"(max_distance) is {value}")
        for name in filters.FIELDS
        for value in (-0.5, np.nan, np.inf)
    ],
    *[
        (filters.TWO_POINTS, {end: n}, f"({end}) is {n}, but the vertices")
        for end in ("source", "target")
        for n in (-2, 16)
    ],
    *[
        (name, parameters, message)
        for name in (filters.PATH, filters.TWO_POINTS)
        for parameters, message in [
            ({"surface_points": "1; 2; 3"}, "holds 3 points. Give two"),
            ({"source": 0, "target": 5, "method": "quick"}, "The quick method computes fields only"),
            (
                {"source": -1, "source_point": [1, 1, 3.0], "target": 7, "max_snap_distance": NEAR},
                "(source_point) is 3",
            ),
        ]
    ],
    *[(name, row, message) for name in filters.OF_TASK_POINTS for row, message in BAD_POINTS],
    *[
        (name, parameters, message)
        for name in (filters.FROM_LAYER, filters.NEAREST, filters.SETS)
        for parameters, message in [
            ({"source_layer": 7}, "(source_layer) is 7, but there is no such layer"),
            ({"source_layer": 0}, "the current layer itself"),
            ({"source_layer": 1, "max_snap_distance": NEAR}, "Vertex 0 of layer 1 is 0.5"),
            ({"source_layer": 2}, "Layer 2 has no vertex"),
        ]
    ],
    (filters.FROM_EDGES, {}, "No edge is selected"),
    (filters.FROM_EDGES, {"from_border": True, "spacing": NEGATIVE}, "(spacing) is -1"),
    (filters.NEAREST, {"source_layer": 1, "neighbour_number": 0}, "(neighbour_number) is 0"),
    (filters.NEAREST, {"source_layer": 1, "matrix_file": "/nowhere/x.npy"}, "no folder"),
    (filters.MATRIX, {"matrix_file": "/nowhere/x.npy"}, "cannot be written"),
    (filters.PAIRS_WITHIN, {"radius": NEGATIVE}, "(radius) is -1"),
    (filters.POISSON, {"radius": length(0)}, "(radius) is 0"),
    (filters.POISSON, {"seed": -1}, "(seed) is -1"),
    (filters.FARTHEST, {"sample_number": 0}, "(sample_number) is 0"),
    (filters.FARTHEST, {"radius": NEGATIVE}, "(radius) is -1"),
    (filters.LLOYD, {"rounds": -1}, "(rounds) is -1"),
    *[(name, {"vertex_index": 9999}, "(vertex_index) is 9999") for name in (filters.DISK, filters.AREA)],
    *[(name, {"radius": NEGATIVE}, "(radius) is -1") for name in (filters.DISK, filters.AREA, filters.DIRECTIONS)],
    (filters.EXTENT, {"fields": 1}, "(fields) is 1"),
    *[(name, {"values": "1 two"}, "(values) holds 'two'") for name in (filters.ISOLINES, filters.CUT)],
    *[(name, {"line_number": 0}, "(line_number) is 0") for name in (filters.ISOLINES, filters.CUT)],
    (filters.PATH_THROUGH, {}, "There are 1 points to pass through; give at least two"),
    (filters.GIRTH, {"vertex_index": 5}, "is not closed: it meets the border at the edge between"),
    (filters.GIRTH, {"vertex_index": 5, "normal": [0, 0, 1]}, "The plane only touches the surface at vertex 5"),
    (filters.GIRTH, {"vertex_index": 5, "normal": [np.nan, 0, 0]}, "The normal of the plane has length nan"),
    (filters.LOOP, {"vertex_index": 5}, "Every loop through vertex 5 contracts to it"),
    *[
        (name, {}, "No edge is selected. Select edges, for example with 'Select Crease Edges', or choose a layer")
        for name in (filters.TIGHT, filters.BAND, filters.CUT_CURVE, filters.PROFILE)
    ],
    *[
        (name, {}, 'No face is selected. Select the faces of a region, or choose a layer with a closed curve as "Curve')
        for name in (filters.SIGNED, filters.REGION)
    ],
    *[
        (name, parameters, message)
        for name in (
            filters.TIGHT,
            filters.BAND,
            filters.CUT_CURVE,
            filters.SIGNED,
            filters.PROFILE,
            filters.REGION,
            filters.LOOP,
        )
        for parameters, message in [
            ({"curve_layer": 7}, "(curve_layer) is 7, but there is no such layer"),
            ({"curve_layer": 1, "max_snap_distance": NEAR}, "Vertex 0 of layer 1 is 0.5"),
            ({"curve_layer": 2}, "Layer 2 has no vertex"),
        ]
    ],
    (filters.TIGHT, {"curve_layer": 1}, "The curve has 1 points; give at least two, in order"),
    *[
        (name, {"curve_layer": 1}, "There are 1 points to pass through; give at least two")
        for name in (filters.CUT_CURVE, filters.SIGNED, filters.PROFILE, filters.REGION)
    ],
    (filters.PROFILE, {"csv_file": "/nowhere/table.csv"}, "/nowhere"),
    (filters.PATH_THROUGH, {"guides": True}, "The curve has 1 points; give at least two, in order"),
    (filters.PATH_THROUGH, {"surface_points": "0; 3; 15", "guides": True, "closed": True}, "slips off"),
    (filters.POLYGON, {"surface_points": "0; 3; 2", "convex_hull": True}, "on one line"),
    (filters.SMOOTH, {}, "There are 1 points for a curve; give at least 2"),
    (filters.SMOOTH, {"surface_points": "0; 3", "closed": True}, "There are 2 points for a curve; give at least 3"),
    (filters.SMOOTH, {"surface_points": "0; 3", "samples": 0}, "(samples) is 0. Give 1 or more"),
    *[
        (filters.CUT_LOCUS, {"min_angle": degrees}, f"(min_angle) is {degrees}. Give an angle from 0 to 180 degrees")
        for degrees in (-1, 181, np.nan)
    ],
    (filters.BAND, {"curve_layer": 1, "width": NEGATIVE}, "(width) is -1"),
    (filters.BAND, {"curve_layer": 1, "spacing": NEGATIVE}, "(spacing) is -1"),
    (filters.POLYGON, {}, "A polygon has three points or more; there are 1"),
    (filters.POLYGON, {"surface_points": "0; 15; 3; 12"}, "Legs 0 and 2 of the polygon cross or touch"),
    (filters.POLYGON, {"surface_points": "0; 3; 3"}, "Points 1 and 2 of the polygon are the same"),
    (filters.DIRECTIONS, {"vertex_index": 5, "scale": 0}, '"Scale" (scale) is 0. Give a number above 0'),
    (filters.DIRECTIONS, {"vertex_index": 5, "scale": np.nan}, "(scale) is nan. Give a number above 0"),
    (filters.DIRECTIONS, {"vertex_index": 5, "rotation": np.inf}, "(rotation) is inf. Give a finite number"),
    (filters.DIRECTIONS, {"vertex_index": 5, "rings": -1}, "(rings) is -1. Give 0 or a positive number"),
    (filters.METHOD_TABLE, {"methods": "walking"}, "The method walking is not known"),
    (filters.METHOD_TABLE, {"methods": "svg(K)"}, "The list of methods cannot be read"),
    (filters.METHOD_TABLE, {"sources": 0}, "Give 1 or more"),
    (filters.METHOD_TABLE, {"csv_file": "/nowhere/table.csv"}, "/nowhere"),
    (filters.LOAD_INDEX, {"index_file": "/nowhere/missing.vgi"}, "missing.vgi"),
    (filters.LOAD_INDEX, {"index_file": ""}, "No index file is named"),
    (filters.SAVE_INDEX, {"index_file": ""}, "No index file is named"),
    (filters.SAVE_INDEX, {"index_file": "/nowhere/x.vgi"}, "there is no folder"),
    (
        filters.SAVE_INDEX,
        {"index_file": "/tmp/x.vgi"},
        "There is no index for this mesh as it is. Run 'Geodesic index: build",
    ),
    (filters.EXACT_FROM_POINT, {"vertex_index": 0, "gap": NEGATIVE}, '"Bridge gaps up to" (gap) is -1'),
    (filters.EXACT_FROM_POINT, {"metric": "Slope penalty", "slope_penalty": -1}, "Give a number of at least 0."),
    (filters.EXACT_FROM_POINT, {"metric": "Slope penalty", "steepest_grade": -1}, "or 0 for any grade."),
    (
        filters.EXACT_FROM_POINT,
        {"metric": "Vertex quality as cost"},
        "(metric) is the quality, but vertex 0 has quality 0",
    ),
    (filters.EXACT_FROM_POINT, {"metric": "Face quality as cost"}, "The faces have no quality"),
]


@pytest.mark.parametrize(("name", "parameters", "message"), REFUSED)
def test_what_is_refused_is_named(ms, name, parameters, message):
    with fails_and_changes_nothing(ms, message):
        ms.apply_filter(name, **parameters)
    assert layer_count(ms) == 3


@pytest.mark.parametrize("point", ["99", "700 0.2 0.3 0.5", "7 0.2 0.3 0.6"])
def test_a_surface_point_is_named_once(ms, point):
    with pytest.raises(pymeshlab.PyMeshLabException) as found:
        ms.apply_filter(filters.TWO_POINTS, surface_points=f"7; {point}")
    assert str(found.value).count("(surface_points)") == 1


@pytest.mark.parametrize("name", [*filters.FROM_A_SELECTION, *filters.OF_TASK_POINTS])
def test_an_empty_selection_is_an_error(name):
    ms = mesh_set(*grid(3, 3))
    with fails_and_changes_nothing(ms, "No vertex is selected. Select the vertices "):
        ms.apply_filter(name)


@pytest.mark.parametrize(
    ("name", "parameters"), [(filters.FROM_BORDER, {}), (filters.FROM_EDGES, {"from_border": True})]
)
def test_surface_without_border(name, parameters):
    ms = mesh_set(*sphere(1))
    with fails_and_changes_nothing(ms, "The surface has no border"):
        ms.apply_filter(name, **parameters)


def test_layer_without_vertices(ms):
    ms.set_current_mesh(2)
    with pytest.raises(pymeshlab.PyMeshLabException, match=r"is empty: it has no vertices\. Load or create"):
        ms.apply_filter(filters.VORONOI)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_coordinate_that_is_not_finite(value):
    vertices, faces = grid(3, 3)
    vertices[6, 1] = value
    ms = mesh_set(vertices, faces)
    with fails_and_changes_nothing(ms, "Vertex 6 has a coordinate that is NaN or infinite"):
        ms.apply_filter(filters.INDEX)


def test_a_filter_that_failed_leaves_earlier_results_alone(ms):
    ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=3)
    with fails_and_changes_nothing(ms, "(vertex_index) is 99"):
        ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=99)
