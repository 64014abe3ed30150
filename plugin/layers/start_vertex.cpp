// Reads start_point and vertex_index.
#include "layers/start_vertex.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "host/logged_length.h"
#include "layers/parameters.h"
#include "mesh/given_points.h"
#include "mesh/surface_locator.h"

namespace vorogeo::plugin {

namespace {

/// The nearest vertex that has a face: no path reaches the others.
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

/// The vertex that is named by number; no_index if the start point is used.
Index named_vertex(const FilterCall& call, const LayerMesh& layer_mesh) {
  const int number = call.parameters.getInt("vertex_index");
  return number == -1 ? no_index : vertex_of(call, layer_mesh, "vertex_index");
}

double straight(const Point& p, const Point& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }

/// The corner of the point's face that the host has, if the point equals it up to the precision in which the
/// host passes points on.
SurfacePoint at_corner(const Mesh& mesh, const SurfacePoint& point) {
  if (point.is_vertex()) return point;
  constexpr double precision = 1e-6;
  const Point at = position_of(mesh, point);
  double scale = 0.0;
  for (double coordinate : at) scale = std::max(scale, std::abs(coordinate));
  for (Index v : mesh.face_vertices(point.face)) {
    if (v < mesh.given_vertex_count() && straight(at, mesh.position(v)) <= precision * scale)
      return SurfacePoint::at_vertex(v);
  }
  return point;
}

}  // namespace

void add_start_vertex_parameters(RichParameterList& list, const MeshDocument& document,
                                 const QString& where) {
  list.addParam(RichPosition("start_point", document.mm()->cm.bbox.min, "Start point",
                             "Where distances start: at " + where +
                                 ". Choose 'Surf. Pos.' and press Get, then double-click on the surface. "
                                 "Used if the start vertex is -1."));
  list.addParam(
      RichInt("vertex_index", -1, "Start vertex",
              "Number of the vertex where distances start, counted from 0; -1: the start point is used."));
}

StartPoint start_point(const FilterCall& call, const LayerMesh& layer_mesh,
                       const std::shared_ptr<const Mesh>& mesh) {
  std::ostringstream text;
  StartPoint start;
  const Index vertex = named_vertex(call, layer_mesh);
  if (vertex != no_index) {
    start.point = SurfacePoint::at_vertex(vertex);
  } else {
    const SnappedPoint found = SurfaceLocator(mesh).nearest(point_of(call, "start_point"));
    start = {at_corner(*mesh, found.point), found.distance};
  }
  if (const Index face = given_face_at(*mesh, start.point); face == no_index) {
    text << "Start: vertex " << layer_mesh.host_vertex(start.point.vertex);
  } else {
    text << "Start: a point in face " << layer_mesh.arrays().input_of_face[face];
  }
  if (vertex == no_index) text << ", " << logged_length(start.distance) << " away from the given point";
  call.log(text.str());
  return start;
}

StartVertex start_vertex(const FilterCall& call, const LayerMesh& layer_mesh) {
  const Index vertex = named_vertex(call, layer_mesh);
  const StartVertex start = vertex != no_index
                                ? StartVertex{vertex, 0.0}
                                : nearest_vertex(layer_mesh.arrays(), point_of(call, "start_point"));
  std::ostringstream text;
  text << "Start: vertex " << layer_mesh.host_vertex(start.vertex);
  if (vertex == no_index) text << ", " << logged_length(start.distance) << " away from the given point";
  call.log(text.str());
  return start;
}

}  // namespace vorogeo::plugin
