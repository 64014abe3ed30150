"""The host knows every filter by name, with its parameters, help and masks."""

from __future__ import annotations

import pymeshlab
import pytest
from support import (
    ALL_FILTERS,
    COMPARISON,
    DESCRIBE_INDEX,
    DISK,
    EXACT_FROM_POINT,
    EXACT_FROM_SELECTION,
    EXTENT,
    FARTHEST,
    FROM_BORDER,
    FROM_EDGES,
    FROM_LAYER,
    FROM_POINT,
    FROM_SELECTION,
    INDEX,
    ISOLINES,
    LLOYD,
    LOAD_INDEX,
    MATRIX,
    METHOD_TABLE,
    NEAREST,
    PAIRS_WITHIN,
    PATCHES,
    PATH,
    POISSON,
    SAVE_INDEX,
    TWO_POINTS,
    VORONOI,
    grid,
    mesh_set,
)

VERTEX_COLOR, VERTEX_QUALITY, FACE_COLOR = 0x8, 0x10, 0x8000
VERTEX_SELECTION, FACE_SELECTION = 0x1000000, 0x2000000


@pytest.mark.parametrize("name", ALL_FILTERS)
def test_filter_is_in_the_list_of_filters(name):
    assert name in pymeshlab.filter_list()


METRIC = {"metric", "slope_penalty", "curvature_weight"}
TASK_POINTS = {"point_layer", "surface_points", "max_snap_distance"}
END_POINTS = {"source", "target", "source_point", "target_point", "surface_points", "max_snap_distance"}


@pytest.mark.parametrize(
    ("name", "parameters"),
    [
        (INDEX, {"n1", "n2", "delta", "memory_budget", "index_file", "threads", "seed"}),
        (FROM_POINT, {"start_point", "vertex_index", "method", "max_distance"}),
        (EXACT_FROM_POINT, {"start_point", "vertex_index", "max_distance"}),
        (FROM_SELECTION, {"method", "max_distance"}),
        (EXACT_FROM_SELECTION, {"max_distance"}),
        (FROM_BORDER, {"method", "max_distance"}),
        (PATCHES, {"layer"}),
        (TWO_POINTS, {"method"} | END_POINTS),
        (DESCRIBE_INDEX, set()),
        (SAVE_INDEX, {"index_file"}),
        (LOAD_INDEX, {"index_file"}),
        (COMPARISON, {"start_point", "vertex_index", "method", "reference"}),
        (MATRIX, {"matrix_file", "exact"} | TASK_POINTS),
        (PAIRS_WITHIN, {"radius", "matrix_file", "exact"} | TASK_POINTS),
        (NEAREST, {"source_layer", "neighbour_number", "matrix_file", "exact"} | TASK_POINTS),
        (VORONOI, {"borders", "exact"} | TASK_POINTS),
        (FARTHEST, {"sample_number", "radius", "from_selection", "seed", "exact"} | TASK_POINTS),
        (POISSON, {"radius", "seed", "exact"}),
        (LLOYD, {"rounds", "exact"} | TASK_POINTS),
        (ISOLINES, {"line_number", "values", "is_distance"}),
        (DISK, {"radius", "vertex_index", "exact"} | TASK_POINTS),
        (EXTENT, {"fields", "vertex_index", "exact"}),
        (METHOD_TABLE, {"methods", "sources", "csv_file"}),
        (
            FROM_LAYER,
            {"source_layer", "spacing", "max_snap_distance", "quality_as_offset", "method", "max_distance"},
        ),
        (FROM_EDGES, {"from_border", "spacing", "method", "max_distance"}),
        (PATH, {"method", "exact", "certify"} | END_POINTS),
    ],
)
def test_parameters_have_python_names(name, parameters):
    in_space = name in (COMPARISON, METHOD_TABLE)  # MeshLab's own methods measure lengths in space
    common = {"gap", "bridge_folds"} | (set() if in_space else METRIC)
    assert set(mesh_set(*grid(2, 2)).filter_parameter_values(name)) == parameters | common


@pytest.mark.parametrize(
    ("name", "changes"),
    [
        (INDEX, 0),
        (FROM_POINT, VERTEX_COLOR | VERTEX_QUALITY),
        (EXACT_FROM_POINT, VERTEX_COLOR | VERTEX_QUALITY),
        (FROM_SELECTION, VERTEX_COLOR | VERTEX_QUALITY),
        (EXACT_FROM_SELECTION, VERTEX_COLOR | VERTEX_QUALITY),
        (FROM_BORDER, VERTEX_COLOR | VERTEX_QUALITY),
        (PATCHES, FACE_COLOR),
        (TWO_POINTS, 0),
        (DESCRIBE_INDEX, 0),
        (SAVE_INDEX, 0),
        (LOAD_INDEX, 0),
        (COMPARISON, VERTEX_COLOR | VERTEX_QUALITY),
        (MATRIX, 0),
        (PAIRS_WITHIN, 0),
        (NEAREST, 0),
        (VORONOI, FACE_COLOR | VERTEX_QUALITY),
        (FARTHEST, 0),
        (POISSON, 0),
        (LLOYD, 0),
        (ISOLINES, 0),
        (DISK, VERTEX_SELECTION | FACE_SELECTION),
        (EXTENT, 0),
        (METHOD_TABLE, 0),
        (FROM_LAYER, VERTEX_COLOR | VERTEX_QUALITY),
        (FROM_EDGES, VERTEX_COLOR | VERTEX_QUALITY),
        (PATH, 0),
    ],
)
def test_help_and_masks(name, changes):
    result = mesh_set(*grid(2, 2)).apply_filter("probe_help", filter=name)
    assert result["help_length"] > 500
    assert result["cites"]
    assert result["names_itself"]
    assert result["filter_class"] != 0
    assert result["changes"] == changes
    assert not result["sends_to_docs"]  # an installed plugin has no such file


@pytest.mark.parametrize("name", ALL_FILTERS)
def test_metric_and_gaps_stand_last_and_are_shown_on_request(name):
    result = mesh_set(*grid(2, 2)).apply_filter("probe_help", filter=name)
    assert result["advanced_parameters"] == (2 if name in (COMPARISON, METHOD_TABLE) else 5)
    assert result["advanced_last"]
