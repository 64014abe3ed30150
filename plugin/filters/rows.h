// All filters, in the order in which the host lists them, and their help.
#pragma once

#include <QString>
#include <vector>

#include "host/filter_row.h"

namespace vorogeo::plugin {

// ---- Paragraphs of help text that several filters share, in the HTML subset that the host shows

/// What the index is, and that it follows the mesh.
QString help_on_index();
/// What ends up in quality and colour, and which vertices get -1.
QString help_on_field();
/// How to choose parameters of a distance field from the index.
QString help_on_choosing();
/// What exact means, and when to prefer the index.
QString help_on_exact();
/// Where a task takes its points from, and its parameter exact.
QString help_on_task_points();
QString help_on_exact_parameter();
/// The papers: the index method, and those of the exact solver.
QString references_of_index();
QString references_of_exact();

// ---- The table of all filters: one row each, made in the file of the filter

FilterRow build_index_row();
FilterRow distance_from_point_row();
FilterRow distance_from_selection_row();
FilterRow distance_from_border_row();
FilterRow exact_distance_from_point_row();
FilterRow exact_distance_from_selection_row();
FilterRow patch_colors_row();
FilterRow distance_between_points_row();
FilterRow distance_matrix_row();
FilterRow pairs_within_row();
FilterRow nearest_points_row();
FilterRow voronoi_regions_row();
FilterRow farthest_sampling_row();
FilterRow poisson_disk_sampling_row();
FilterRow lloyd_relaxation_row();
FilterRow isolines_row();
FilterRow disk_selection_row();
FilterRow extent_row();
FilterRow distance_from_layer_row();
FilterRow distance_from_edges_row();
FilterRow geodesic_path_row();
FilterRow describe_index_row();
FilterRow save_index_row();
FilterRow load_index_row();
FilterRow method_comparison_row();
FilterRow method_table_row();

/// In the order in which the host lists them.
std::vector<FilterRow> all_rows();

}  // namespace vorogeo::plugin
