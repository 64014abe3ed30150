// Filter: the distance of two points, from the index.
#include <chrono>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "field/geodesic_query.h"
#include "filters/help.h"
#include "filters/rows.h"
#include "host/logged_length.h"
#include "layers/end_points.h"
#include "layers/index_of_layer.h"
#include "path/path_query.h"

namespace vorogeo::plugin {

namespace {

RichParameterList two_points_parameters(const MeshDocument& document) {
  RichParameterList list;
  add_end_point_parameters(list, document, 0);
  return list;
}

std::string name_of(const LayerMesh& layer_mesh, const Mesh& mesh, const SurfacePoint& point) {
  return point.is_vertex() ? "Vertex " + std::to_string(layer_mesh.host_vertex(point.vertex))
                           : "Point in face " + std::to_string(layer_mesh.host_face(mesh, point.face));
}

Results distance_between_points(FilterCall& call) {
  const LayerMesh layer_mesh(call);
  const auto mesh = read_mesh(call, layer_mesh);
  const EndPoints ends = end_points(call, layer_mesh, mesh);
  const auto& [source, target] = ends;
  const IndexOfLayer found = index_of_layer(call, layer_mesh);
  double distance = 0.0;
  double seconds = 0.0;
  auto measured = [&](auto&& call_of_query) {
    const auto start = std::chrono::steady_clock::now();
    distance = call_of_query();
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  if (source.point.is_vertex() && target.point.is_vertex()) {
    GeodesicQuery query(found.index, 1);
    measured([&] { return query.distance(source.point.vertex, target.point.vertex); });
  } else {
    PathQuery query(found.index);
    measured([&] { return query.path(source.point, target.point).length; });
  }
  std::ostringstream text;
  text << name_of(layer_mesh, *mesh, source.point) << " to " << name_of(layer_mesh, *mesh, target.point)
       << ": ";
  if (std::isfinite(distance)) {
    text << "distance " << logged_length(distance) << ", in " << std::setprecision(3) << seconds << " s";
  } else {
    text << "no path, they lie in different components";
  }
  call.log(text.str());
  Results results = {{"distance", distance}, {"seconds", seconds}};
  results.merge(about_end_points(ends));
  results.merge(about_index(found));
  return results;
}

}  // namespace

FilterRow distance_between_points_row() {
  return {
      "Geodesic distance between two points (VoroGeo)",
      "get_vorogeo_distance_between_points",
      "<p>Geodesic distance of two points: the length of the shortest path over the surface, in the unit of "
      "the mesh. It is logged and returned as <i>distance</i>; infinity if no path leads from one to the "
      "other. For two vertices it comes from the index, for other points it is the length of the refined "
      "path. "
      "The mesh is not changed.</p><p>How to choose: for the path itself take <i>Shortest path between two "
      "points (VoroGeo)</i>.</p>" +
          help_on_end_points() + help_on_index() + references_of_index(),
      FilterPlugin::Measure,
      MeshModel::MM_NONE,
      two_points_parameters,
      distance_between_points};
}

}  // namespace vorogeo::plugin
