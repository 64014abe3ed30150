// All filters, in the order in which the host lists them, and their help.
#include "filters/rows.h"

namespace vorogeo::plugin {

// ---- The shared paragraphs of the help texts

QString help_on_index() {
  return "<p>If the mesh has no index, it is built first, which takes seconds to minutes; it is reused until "
         "the mesh is edited. <i>Geodesic index: build (VoroGeo)</i> builds it with chosen parameters.</p>";
}

QString help_on_field() {
  return "<p>The distance becomes the vertex quality, in the unit of the mesh, and a colour: red at the "
         "sources, blue at the farthest vertex. Vertices that no path leads to, or only one longer than "
         "<b>Max distance</b>, get quality <b>-1</b> and grey and are counted in the log. The transformation "
         "of the layer is not applied; freeze it first if it scales.</p>";
}

QString help_on_exact() {
  return "<p>How to choose: exact up to rounding, without an index; one propagation over the whole mesh for "
         "each call, which a <b>Max distance</b> shortens. For many fields on one mesh take the filter "
         "without <i>Exact</i> in its name: from an index they are much faster, with a small error.</p>";
}

QString help_on_choosing() {
  return "<p>How to choose: leave <b>Method</b> at automatic. It takes the index if there is one, and builds "
         "one when exact answers have taken as long as that would. The log says what answered.</p>";
}

QString help_on_task_points() {
  return "<p>The points are the selected vertices of the layer, in the order of their numbers, counted from "
         "0 (select them first, for example with <i>Conditional Vertex Selection</i>). If <b>Point layer</b> "
         "is another layer, they are all its vertices, each moved to the nearest point of the surface, which "
         "need not be a vertex: <i>snap_distance</i> is the farthest move, and one of more than <b>Max snap "
         "distance</b> is an error unless that is 0. If <b>Surface points</b> is not empty, they are the "
         "points it names, separated by semicolons: a vertex by its number, any other point by the number of "
         "a face and three barycentric weights, such as <tt>17; 203 0.2 0.3 0.5</tt>. A point is returned as "
         "the number of its vertex in its layer, or as its place in <b>Surface points</b>.</p>";
}

QString help_on_exact_parameter() {
  return "<p>How to choose: <b>Exact</b> propagates for each point: without the errors of the index and "
         "without building one, but slower for each point.</p>";
}

QString references_of_index() {
  return "<p>See:<br/><i>Rosario Aiello</i><br/><b>\"VoroGeo\"</b>, thesis, 2015.<br/>"
         "<i>Joseph S. B. Mitchell, David M. Mount, Christos H. Papadimitriou</i><br/>"
         "<b>\"The discrete geodesic problem\"</b><br/>SIAM Journal on Computing 16(4), 1987.</p>";
}

QString references_of_exact() {
  return "<p>See:<br/><i>Joseph S. B. Mitchell, David M. Mount, Christos H. Papadimitriou</i><br/>"
         "<b>\"The discrete geodesic problem\"</b><br/>SIAM Journal on Computing 16(4), 1987.<br/>"
         "<i>Vitaly Surazhsky, Tatiana Surazhsky, Danil Kirsanov, Steven J. Gortler, Hugues Hoppe</i><br/>"
         "<b>\"Fast exact and approximate geodesics on meshes\"</b><br/>ACM Transactions on Graphics 24(3), "
         "2005.</p>";
}

// ---- Puts the rows of all filters together

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
