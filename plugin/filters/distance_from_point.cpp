// Filters: distance of every vertex from a given point, from the index or exact.
#include <cmath>
#include <limits>
#include <sstream>

#include "distance_field.h"
#include "filters/help.h"
#include "filters/rows.h"
#include "support/error.h"

namespace vorogeo::plugin {

namespace {

RichParameterList from_point_parameters(const MeshModel& layer) {
  RichParameterList list;
  list.addParam(
      RichPosition("start_point", layer.cm.bbox.min, "Start point",
                   "Where distances start: the nearest vertex with a face is taken. Used if the start "
                   "vertex is -1."));
  list.addParam(
      RichInt("vertex_index", -1, "Start vertex",
              "Number of the vertex where distances start, counted from 0; -1: the vertex nearest to "
              "the start point."));
  list.addParam(max_distance_parameter());
  return list;
}

struct NearestVertex {
  Index vertex = no_index;
  double distance = std::numeric_limits<double>::infinity();
};

/// The nearest vertex that has a face: others are reached by no path.
NearestVertex nearest_vertex(const VcgMeshArrays& arrays, const Point& point) {
  std::vector<bool> has_face(arrays.positions.size(), false);
  for (const auto& face : arrays.faces) {
    for (Index v : face) has_face[v] = true;
  }
  NearestVertex nearest;
  for (std::size_t v = 0; v < arrays.positions.size(); ++v) {
    if (!has_face[v]) continue;
    const Point& p = arrays.positions[v];
    const double distance = std::hypot(p[0] - point[0], p[1] - point[1], p[2] - point[2]);
    if (distance < nearest.distance) nearest = {static_cast<Index>(v), distance};
  }
  return nearest;
}

/// The start vertex named by number, else the one nearest to the start point.
NearestVertex start_vertex(const FilterCall& call, const LayerMesh& layer_mesh) {
  const int number = call.parameters.getInt("vertex_index");
  if (number != -1) return {layer_mesh.core_vertex(number, "vertex_index"), 0.0};
  const Point3m given = call.parameters.getPoint3m("start_point");
  const Point point{double(given[0]), double(given[1]), double(given[2])};
  for (double coordinate : point) {
    if (!std::isfinite(coordinate)) {
      throw InvalidInput(
          "start_point has a coordinate that is NaN or infinite. Give three finite coordinates, or the "
          "number of "
          "a vertex as vertex_index.");
    }
  }
  return nearest_vertex(layer_mesh.arrays(), point);
}

Results distances_from_point(FilterCall& call, Method method) {
  const LayerMesh layer_mesh(call.layer.cm);
  const NearestVertex start = start_vertex(call, layer_mesh);
  std::ostringstream text;
  text << "Start: vertex " << layer_mesh.host_vertex(start.vertex) << ", " << start.distance
       << " away from the given point";
  call.log(text.str());
  Results results = write_distance_field(call, layer_mesh, {start.vertex}, method);
  results["start_vertex"] = layer_mesh.host_vertex(start.vertex);
  results["snap_distance"] = start.distance;
  return results;
}

Results index_distances_from_point(FilterCall& call) { return distances_from_point(call, Method::index); }
Results exact_distances_from_point(FilterCall& call) { return distances_from_point(call, Method::exact); }

QString help_on_start() {
  return "<p>Distances start at the vertex <b>vertex_index</b>, or, if this is -1, at the vertex nearest to "
         "<b>start_point</b>. The log and the returned values <i>start_vertex</i> and <i>snap_distance</i> "
         "say "
         "which vertex was taken and how far it is from the point. The host passes points on in single "
         "precision; a vertex number is exact.</p>";
}

FilterPlugin::FilterClass field_class() {
  return FilterPlugin::FilterClass(FilterPlugin::VertexColoring | FilterPlugin::Quality);
}

}  // namespace

FilterRow distance_from_point_row() {
  return {"Geodesic distance from a given point (VoroGeo)",
          "compute_scalar_by_vorogeo_distance_from_given_point_per_vertex",
          "<p>Geodesic distance of every vertex from a given point: the length of the shortest path over the "
          "surface.</p>" +
              help_on_start() + help_on_field() + help_on_index() + references_of_index(),
          field_class(),
          MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR,
          from_point_parameters,
          index_distances_from_point};
}

FilterRow exact_distance_from_point_row() {
  return {
      "Exact geodesic distance from a given point (VoroGeo)",
      "compute_scalar_by_exact_geodesic_distance_from_given_point_per_vertex",
      "<p>Exact geodesic distance of every vertex from a given point: the length of the shortest path over "
      "the surface.</p>" +
          help_on_start() + help_on_field() + help_on_exact() + references_of_exact(),
      field_class(),
      MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR,
      from_point_parameters,
      exact_distances_from_point};
}

}  // namespace vorogeo::plugin
