// All filters, in the order in which the host lists them, and their help.
#include "filters/rows.h"

namespace vorogeo::plugin {

// ---- The shared paragraphs of the help texts

QString help_on_index() {
  return "<p>If the mesh has no index, it is built first, which takes seconds to minutes; it is reused until "
         "the mesh is edited. <i>Geodesic index: build (VoroGeo)</i> builds it with chosen parameters.</p>";
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
         "without building one, but slower for each point.</p>" +
         help_on_index();
}

QString references_of_index() {
  return "<p>See:<br/><i>Rosario Aiello</i><br/><b>\"VoroGeo\"</b>, thesis, 2015.<br/>" +
         reference_of_exact() + "</p>";
}

QString reference_of_exact() {
  return "<i>Joseph S. B. Mitchell, David M. Mount, Christos H. Papadimitriou</i><br/><b>\"The discrete "
         "geodesic problem\"</b><br/>SIAM Journal on Computing 16(4), 1987.";
}

// ---- Puts the rows of all filters together

std::vector<FilterRow> all_rows() {
  std::vector<FilterRow> all;
  for (const auto& rows : {index_rows(), distance_rows(), path_rows(), matrix_rows(), region_rows(),
                           sampling_rows(), comparison_rows()}) {
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

}  // namespace vorogeo::plugin
