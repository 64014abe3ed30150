// Reads start_point and vertex_index.
#include "start_vertex.h"

#include <cmath>
#include <sstream>
#include <vector>

#include "support/error.h"

namespace vorogeo::plugin {

namespace {

/// The nearest vertex that has a face: others are reached by no path.
StartVertex nearest_vertex(const VcgMeshArrays& arrays, const Point& point) {
  std::vector<bool> has_face(arrays.positions.size(), false);
  for (const auto& face : arrays.faces) {
    for (Index v : face) has_face[v] = true;
  }
  StartVertex nearest;
  for (std::size_t v = 0; v < arrays.positions.size(); ++v) {
    if (!has_face[v]) continue;
    const Point& p = arrays.positions[v];
    const double distance = std::hypot(p[0] - point[0], p[1] - point[1], p[2] - point[2]);
    if (distance < nearest.distance) nearest = {static_cast<Index>(v), distance};
  }
  return nearest;
}

StartVertex read_start_vertex(const FilterCall& call, const LayerMesh& layer_mesh) {
  const int number = call.parameters.getInt("vertex_index");
  if (number != -1) return {layer_mesh.core_vertex(number, "vertex_index"), 0.0};
  const Point3m given = call.parameters.getPoint3m("start_point");
  const Point point{double(given[0]), double(given[1]), double(given[2])};
  for (double coordinate : point) {
    if (!std::isfinite(coordinate)) {
      throw InvalidInput(
          "start_point has a coordinate that is NaN or infinite. Give three finite coordinates, or the "
          "number of a vertex as vertex_index.");
    }
  }
  return nearest_vertex(layer_mesh.arrays(), point);
}

}  // namespace

void add_start_vertex_parameters(RichParameterList& list, const MeshModel& layer) {
  list.addParam(RichPosition(
      "start_point", layer.cm.bbox.min, "Start point",
      "Where distances start: at the vertex nearest to this point that has a face. Choose "
      "'Surf. Pos.' and press Get, then double-click on the surface. Used if the start vertex is -1."));
  list.addParam(
      RichInt("vertex_index", -1, "Start vertex",
              "Number of the vertex where distances start, counted from 0; -1: the vertex nearest to "
              "the start point."));
}

StartVertex start_vertex(const FilterCall& call, const LayerMesh& layer_mesh) {
  const StartVertex start = read_start_vertex(call, layer_mesh);
  std::ostringstream text;
  text << "Start: vertex " << layer_mesh.host_vertex(start.vertex);
  if (call.parameters.getInt("vertex_index") == -1)
    text << ", " << start.distance << " away from the given point";
  call.log(text.str());
  return start;
}

}  // namespace vorogeo::plugin
