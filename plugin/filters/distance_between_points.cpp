// Filter: the distance of two points.
#include <cmath>
#include <iomanip>
#include <sstream>

#include "filters/help.h"
#include "filters/rows.h"
#include "host/logged_length.h"
#include "host/ticking.h"
#include "layers/end_points.h"
#include "layers/index_of_layer.h"
#include "layers/surface_of_layer.h"
#include "mesh/given_points.h"

namespace vorogeo::plugin {

namespace {

RichParameterList two_points_parameters(const MeshDocument& document) {
  RichParameterList list;
  add_end_point_parameters(list, document, 0);
  list.addParam(method_parameter());
  return list;
}

std::string name_of(const LayerMesh& layer_mesh, const Mesh& mesh, const SurfacePoint& point) {
  const Index face = given_face_at(mesh, point);
  return face == no_index ? "Vertex " + std::to_string(layer_mesh.host_vertex(point.vertex))
                          : "Point in face " + std::to_string(layer_mesh.arrays().input_of_face[face]);
}

Results distance_between_points(FilterCall& call) {
  const LayerMesh layer_mesh(call);
  const auto mesh = read_mesh(call, layer_mesh);
  const EndPoints ends = end_points(call, layer_mesh, mesh);
  const auto& [source, target] = ends;
  SurfaceOfLayer layer(call, layer_mesh, mesh);
  const AnswerMethod method = method_of(call);
  Answered answered;
  const double distance = run_ticking(call.progress, "Geodesic distance", [&](const Progress& inner) {
    return layer.surface().distance(source.point, target.point, method, answered, inner);
  });
  std::ostringstream text;
  text << name_of(layer_mesh, *mesh, source.point) << " to " << name_of(layer_mesh, *mesh, target.point)
       << ": ";
  if (std::isfinite(distance)) {
    text << "distance " << logged_length(distance) << ", in " << std::setprecision(3) << answered.seconds
         << " s";
  } else {
    text << "no path, they lie in different components";
  }
  call.log(text.str());
  Results results = {{"distance", distance}, {"seconds", answered.seconds}};
  results.merge(about_end_points(ends));
  results.merge(layer.finish(answered));
  return results;
}

}  // namespace

FilterRow distance_between_points_row() {
  return {"Geodesic distance between two points (VoroGeo)",
          "get_vorogeo_distance_between_points",
          "<p>Geodesic distance of two points: the length of the shortest path over the surface, in the unit "
          "of the mesh. It is logged and returned as <i>distance</i>; infinity if no path leads from one to "
          "the other. Without an index it is exact. With one it comes from the index for two vertices, and "
          "is the length of the refined path for other points. The mesh is not changed.</p><p>How to choose: "
          "for the path itself take <i>Shortest path between two points (VoroGeo)</i>.</p>" +
              help_on_end_points() + help_on_choosing() + references_of_index(),
          FilterPlugin::Measure,
          MeshModel::MM_NONE,
          two_points_parameters,
          distance_between_points};
}

}  // namespace vorogeo::plugin
