// Puts the rows of all filters together.
#include "filters/rows.h"

namespace vorogeo::plugin {

std::vector<FilterRow> all_rows() {
  return {build_index_row(),
          describe_index_row(),
          save_index_row(),
          load_index_row(),
          distance_from_point_row(),
          distance_from_selection_row(),
          distance_from_border_row(),
          exact_distance_from_point_row(),
          exact_distance_from_selection_row(),
          patch_colors_row(),
          distance_between_points_row(),
          distance_matrix_row(),
          pairs_within_row(),
          nearest_points_row(),
          voronoi_regions_row(),
          farthest_sampling_row(),
          poisson_disk_sampling_row(),
          lloyd_relaxation_row(),
          isolines_row(),
          disk_selection_row(),
          extent_row(),
          distance_from_layer_row(),
          distance_from_edges_row(),
          geodesic_path_row(),
          method_comparison_row(),
          method_table_row()};
}

}  // namespace vorogeo::plugin
