// The table of all filters: one row each, made in the file of the filter.
#pragma once

#include <vector>

#include "host/filter_row.h"

namespace vorogeo::plugin {

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
