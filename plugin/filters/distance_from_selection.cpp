// Filters: distance of every vertex from the nearest selected vertex, from the index or exact.
#include "filters/help.h"
#include "filters/rows.h"
#include "layers/distance_field.h"
#include "layers/selected_vertices.h"

namespace vorogeo::plugin {

namespace {

Results distances_from_selection(FilterCall& call, AnswerMethod method) {
  const LayerMesh layer_mesh(call);
  return write_distance_field(
      call, layer_mesh, selected_vertices(call.layer.cm, layer_mesh, "where distances shall start"), method);
}

Results chosen_distances_from_selection(FilterCall& call) {
  return distances_from_selection(call, method_of(call));
}
Results exact_distances_from_selection(FilterCall& call) {
  return distances_from_selection(call, AnswerMethod::exact);
}

RichParameterList from_selection_parameters(const MeshDocument& document) {
  RichParameterList list;
  add_field_parameters(list, document);
  return list;
}

}  // namespace

FilterRow distance_from_selection_row() {
  return {"Geodesic distance from the selection (VoroGeo)",
          "compute_scalar_by_vorogeo_distance_from_selection_per_vertex",
          "<p>Geodesic distance of every vertex from the nearest selected vertex: the length of the shortest "
          "path over the surface.</p>" +
              help_on_field() + help_on_choosing() + references_of_index(),
          field_class(),
          MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR,
          from_selection_parameters,
          chosen_distances_from_selection};
}

FilterRow exact_distance_from_selection_row() {
  return {"Exact geodesic distance from the selection (VoroGeo)",
          "compute_scalar_by_exact_geodesic_distance_from_selection_per_vertex",
          "<p>Exact geodesic distance of every vertex from the nearest selected vertex: the length of the "
          "shortest path over the surface.</p>" +
              help_on_field() + help_on_exact() + references_of_exact(),
          field_class(),
          MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR,
          only_max_distance,
          exact_distances_from_selection};
}

}  // namespace vorogeo::plugin
