"""Names of the filters, what each takes and changes, and groups of them."""

from __future__ import annotations

INDEX = "compute_geodesic_index_by_vorogeo"
FROM_POINT = "compute_scalar_by_vorogeo_distance_from_given_point_per_vertex"
FROM_SELECTION = "compute_scalar_by_vorogeo_distance_from_selection_per_vertex"
FROM_BORDER = "compute_scalar_by_vorogeo_distance_from_border_per_vertex"
EXACT_FROM_POINT = "compute_scalar_by_exact_geodesic_distance_from_given_point_per_vertex"
EXACT_FROM_SELECTION = "compute_scalar_by_exact_geodesic_distance_from_selection_per_vertex"
PATCHES = "compute_color_by_vorogeo_patches_per_face"
DESCRIBE_INDEX = "get_geodesic_index_by_vorogeo"
SAVE_INDEX = "save_geodesic_index_by_vorogeo"
LOAD_INDEX = "load_geodesic_index_by_vorogeo"
COMPARISON = "compute_scalar_by_geodesic_method_comparison_per_vertex"
METHOD_TABLE = "get_geodesic_method_table"
TWO_POINTS = "get_vorogeo_distance_between_points"
MATRIX = "get_vorogeo_distance_matrix_of_selection"
PAIRS_WITHIN = "get_vorogeo_pairs_within_radius_of_selection"
NEAREST = "get_vorogeo_nearest_points_of_layer"
VORONOI = "compute_color_by_vorogeo_voronoi_regions_per_face"
FARTHEST = "generate_sampling_vorogeo_farthest_point"
POISSON = "generate_sampling_vorogeo_poisson_disk"
LLOYD = "generate_sampling_vorogeo_lloyd_relaxation"
ISOLINES = "generate_polyline_by_vorogeo_isolines"
CUT = "generate_splitting_by_vorogeo_isolines"
DISK = "compute_selection_by_vorogeo_geodesic_disk"
AREA = "get_vorogeo_area_of_geodesic_disk"
EXTENT = "get_vorogeo_diameter_and_centre"
FROM_LAYER = "compute_scalar_by_vorogeo_distance_from_layer_per_vertex"
FROM_EDGES = "compute_scalar_by_vorogeo_distance_from_edges_per_vertex"
PATH = "generate_polyline_by_vorogeo_geodesic_path"
TIGHT = "generate_polyline_by_vorogeo_tight_curve"
LOOP = "generate_polyline_by_vorogeo_shortest_loop"
POLYGON = "generate_polyline_by_vorogeo_polygon"
CUT_CURVE = "generate_splitting_by_vorogeo_curve"
SETS = "get_vorogeo_distance_of_sets"
BAND = "get_vorogeo_area_of_band"
SMOOTH = "generate_polyline_by_vorogeo_smooth_curve"
CUT_LOCUS = "generate_polyline_by_vorogeo_cut_locus"
MEAN = "generate_sampling_vorogeo_mean"
SIGNED = "compute_scalar_by_vorogeo_signed_distance_per_vertex"
PATH_THROUGH = "generate_polyline_by_vorogeo_path_through_points"
PROFILE = "generate_polyline_by_vorogeo_profile"
REGION = "get_vorogeo_area_of_region"
GIRTH = "generate_polyline_by_vorogeo_girth"
DIRECTIONS = "compute_scalar_by_vorogeo_directions_from_given_point_per_vertex"

# What the host may take a filter to change.
VERTEX_COLOR, VERTEX_QUALITY, VERTEX_TEXTURE, FACE_COLOR, WEDGE_TEXTURE = 0x8, 0x10, 0x400, 0x8000, 0x200000
VERTEX_SELECTION, FACE_SELECTION = 0x1000000, 0x2000000
FIELD = VERTEX_COLOR | VERTEX_QUALITY
TASK_POINTS = {"point_layer", "surface_points", "max_snap_distance"}
END_POINTS = {"source", "target", "source_point", "target_point", "surface_points", "max_snap_distance"}

# By filter: the names of its parameters, without those that all have, and what it changes.
FILTERS: dict[str, tuple[set[str], int]] = {
    INDEX: ({"n1", "n2", "delta", "memory_budget", "index_file", "threads", "seed"}, 0),
    DESCRIBE_INDEX: (set(), 0),
    SAVE_INDEX: ({"index_file"}, 0),
    LOAD_INDEX: ({"index_file"}, 0),
    FROM_POINT: ({"start_point", "vertex_index", "method", "max_distance", "to"}, FIELD),
    FROM_SELECTION: ({"method", "max_distance", "to"}, FIELD),
    FROM_BORDER: ({"method", "max_distance", "to"}, FIELD),
    EXACT_FROM_POINT: ({"start_point", "vertex_index", "max_distance", "to"}, FIELD),
    EXACT_FROM_SELECTION: ({"max_distance", "to"}, FIELD),
    FROM_LAYER: (
        {"source_layer", "spacing", "max_snap_distance", "quality_as_offset", "method", "max_distance", "to"},
        FIELD,
    ),
    FROM_EDGES: ({"from_border", "spacing", "method", "max_distance", "to"}, FIELD),
    SIGNED: ({"curve_layer", "max_snap_distance"}, FIELD),
    DIRECTIONS: (
        {"start_point", "vertex_index", "radius", "rotation", "scale", "rings", "per_wedge"},
        FIELD | VERTEX_TEXTURE | WEDGE_TEXTURE,
    ),
    TWO_POINTS: ({"method"} | END_POINTS, 0),
    PATH: ({"method", "exact", "certify"} | END_POINTS, 0),
    PATH_THROUGH: ({"closed", "guides"} | TASK_POINTS, 0),
    SMOOTH: ({"closed", "samples"} | TASK_POINTS, 0),
    TIGHT: ({"curve_layer", "max_snap_distance"}, 0),
    LOOP: ({"start_point", "vertex_index", "curve_layer", "max_snap_distance"}, 0),
    PROFILE: ({"curve_layer", "max_snap_distance", "up", "quality", "csv_file"}, 0),
    GIRTH: ({"start_point", "vertex_index", "normal"}, 0),
    MATRIX: ({"matrix_file", "exact"} | TASK_POINTS, 0),
    PAIRS_WITHIN: ({"radius", "matrix_file", "exact"} | TASK_POINTS, 0),
    NEAREST: ({"source_layer", "neighbour_number", "matrix_file", "exact", "to"} | TASK_POINTS, 0),
    SETS: ({"source_layer", "exact"} | TASK_POINTS, 0),
    PATCHES: ({"layer"}, FACE_COLOR),
    VORONOI: ({"borders", "exact", "to"} | TASK_POINTS, FACE_COLOR | VERTEX_QUALITY),
    CUT_LOCUS: ({"min_angle"} | TASK_POINTS, 0),
    ISOLINES: ({"line_number", "values", "is_distance"}, 0),
    CUT: ({"line_number", "values", "is_distance"}, 0),
    CUT_CURVE: ({"curve_layer", "max_snap_distance"}, 0),
    DISK: ({"radius", "vertex_index", "exact", "to"} | TASK_POINTS, VERTEX_SELECTION | FACE_SELECTION),
    AREA: ({"radius", "vertex_index", "exact", "to"} | TASK_POINTS, 0),
    BAND: ({"width", "curve_layer", "max_snap_distance", "spacing", "exact", "to"}, 0),
    REGION: ({"curve_layer", "max_snap_distance"}, 0),
    POLYGON: ({"cut_out", "convex_hull"} | TASK_POINTS, FACE_SELECTION),
    EXTENT: ({"fields", "vertex_index", "exact"}, 0),
    FARTHEST: ({"sample_number", "radius", "from_selection", "seed", "exact", "to"} | TASK_POINTS, 0),
    POISSON: ({"radius", "seed", "exact"}, 0),
    LLOYD: ({"rounds", "exact"} | TASK_POINTS, 0),
    MEAN: ({"median"} | TASK_POINTS, 0),
    COMPARISON: ({"start_point", "vertex_index", "method", "reference"}, FIELD),
    METHOD_TABLE: ({"methods", "sources", "csv_file"}, 0),
}
# Those that can be applied without a file.
ALL_FILTERS = [name for name in FILTERS if name not in (SAVE_INDEX, LOAD_INDEX)]
FROM_A_POINT = [FROM_POINT, EXACT_FROM_POINT]
FROM_A_SELECTION = [FROM_SELECTION, EXACT_FROM_SELECTION]
FIELDS = [*FROM_A_POINT, *FROM_A_SELECTION, FROM_BORDER]
OF_TASK_POINTS = [
    *(MATRIX, PAIRS_WITHIN, NEAREST, VORONOI, LLOYD, DISK, AREA, PATH_THROUGH, POLYGON, SETS),
    *(SMOOTH, CUT_LOCUS, MEAN),
]
