// The shared paragraphs of the help texts.
#include "filters/help.h"

namespace vorogeo::plugin {

QString help_on_index() {
  return "<p>Answers come from a geodesic index: the surface is split into two layers of geodesic Voronoi "
         "patches, and distances inside the patches are computed exactly once. The first distance on a mesh "
         "builds the index, which takes seconds to minutes; later ones reuse it. After any edit of the mesh "
         "a "
         "new index is built. To choose its parameters, run <i>Geodesic index: build (VoroGeo)</i> first: "
         "the index it made is then used.</p>";
}

QString help_on_field() {
  return "<p>The distance goes into the quality of each vertex, in the unit of the mesh, and the vertices "
         "are "
         "coloured from red (the sources) to blue (the farthest vertex reached). Vertices that no path leads "
         "to, in another component or without a face, and vertices beyond <b>max_distance</b> get quality "
         "<b>-1</b> and the colour grey; both are counted in the log and in the returned values "
         "<i>unreachable_vertices</i> and <i>vertices_beyond_max_distance</i>. The largest distance found is "
         "returned as <i>max_distance</i>.</p><p><b>max_distance</b>: leave it at 0 unless only the "
         "surroundings of the sources matter; a limit makes the filter faster. The transformation matrix of "
         "the layer is not applied; freeze it first if it scales the mesh.</p>";
}

QString help_on_exact() {
  return "<p>The distances are exact on the triangle mesh up to rounding: windows of straight-line distances "
         "are "
         "propagated across the faces from all sources. Nothing is built or kept. For many fields on one "
         "mesh the filters with an index are much faster, with a small error; this one is the reference they "
         "are measured against.</p>";
}

QString help_on_selected_points() {
  return "<p>The points are the selected vertices of the layer, in the order of their numbers, counted from "
         "0. "
         "Select them first, for example with <i>Conditional Vertex Selection</i>.</p>";
}

QString help_on_exact_parameter() {
  return "<p><b>exact</b>: distances by exact propagation instead of the index: without its errors and "
         "without "
         "building one, but slower for each point.</p>";
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

}  // namespace vorogeo::plugin
