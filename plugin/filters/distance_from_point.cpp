// Filters: distance of every vertex from a given point, from the index or exact.

#include "filters/help.h"
#include "filters/rows.h"
#include "layers/distance_field.h"
#include "layers/index_of_layer.h"
#include "layers/start_vertex.h"
#include "mesh/given_points.h"

namespace vorogeo::plugin {

namespace {

constexpr const char* start_meaning = "the nearest point of the surface";

RichParameterList from_point_parameters(const MeshDocument& document) {
  RichParameterList list;
  add_start_vertex_parameters(list, document, start_meaning);
  add_field_parameters(list, document);
  return list;
}

RichParameterList exact_from_point_parameters(const MeshDocument& document) {
  RichParameterList list;
  add_start_vertex_parameters(list, document, start_meaning);
  list.addParam(max_distance_parameter(document));
  return list;
}

Results distances_from_point(FilterCall& call, AnswerMethod method) {
  const LayerMesh layer_mesh(call);
  const auto mesh = read_mesh(call, layer_mesh);
  const StartPoint start = start_point(call, layer_mesh, mesh);
  const Index face = given_face_at(*mesh, start.point);
  Results results;
  if (face == no_index) {
    results = write_distance_field(call, layer_mesh, {start.point.vertex}, method);
    results["start_vertex"] = layer_mesh.host_vertex(start.point.vertex);
  } else {
    results = write_distance_field(call, layer_mesh, mesh, {{start.point}}, nullptr, method);
    results.erase("source_points");
    results["source_vertices"] = 0;
    results["start_vertex"] = -1;
  }
  results["start_face"] = face == no_index ? -1 : layer_mesh.arrays().input_of_face[face];
  results["snap_distance"] = start.distance;
  return results;
}

Results chosen_distances_from_point(FilterCall& call) { return distances_from_point(call, method_of(call)); }
Results exact_distances_from_point(FilterCall& call) {
  return distances_from_point(call, AnswerMethod::exact);
}

QString help_on_start() {
  return "<p>Distances start at the point of the surface nearest to <b>Start point</b>, which need not be a "
         "vertex, or, if its number is given, at <b>Start vertex</b>; the log says where, and how far from "
         "the point.</p>";
}

}  // namespace

FilterRow distance_from_point_row() {
  return {"Geodesic distance from a given point (VoroGeo)",
          "compute_scalar_by_vorogeo_distance_from_given_point_per_vertex",
          "<p>Geodesic distance of every vertex from a given point: the length of the shortest path over the "
          "surface.</p>" +
              help_on_start() + help_on_field() + help_on_choosing() + references_of_index(),
          field_class(),
          MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR,
          from_point_parameters,
          chosen_distances_from_point};
}

FilterRow exact_distance_from_point_row() {
  return {"Exact geodesic distance from a given point (VoroGeo)",
          "compute_scalar_by_exact_geodesic_distance_from_given_point_per_vertex",
          "<p>Exact geodesic distance of every vertex from a given point: the length of the shortest path "
          "over the surface.</p>" +
              help_on_start() + help_on_field() + help_on_exact() + references_of_exact(),
          field_class(),
          MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR,
          exact_from_point_parameters,
          exact_distances_from_point};
}

}  // namespace vorogeo::plugin
