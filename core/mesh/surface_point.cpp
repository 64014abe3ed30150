// Validation and position of surface points.
#include "mesh/surface_point.h"

#include <cmath>
#include <string>

#include "support/error.h"

namespace vorogeo {

SurfacePoint validated(const Mesh& mesh, const SurfacePoint& point) {
  if (point.is_vertex()) {
    if (point.vertex < 0 || point.vertex >= mesh.vertex_count()) {
      throw InvalidInput("Vertex " + std::to_string(point.vertex) +
                         " does not exist: the mesh has vertices 0 to " +
                         std::to_string(mesh.vertex_count() - 1) + ".");
    }
    return point;
  }
  if (point.face == no_index) throw InvalidInput("A surface point needs a vertex or a face.");
  if (point.face < 0 || point.face >= mesh.face_count()) {
    throw InvalidInput("Face " + std::to_string(point.face) + " does not exist: the mesh has faces 0 to " +
                       std::to_string(mesh.face_count() - 1) + ".");
  }
  double sum = 0.0;
  for (double weight : point.barycentric) {
    if (!(weight >= 0.0 && weight <= 1.0)) {
      throw InvalidInput("A point in face " + std::to_string(point.face) +
                         " has a barycentric weight outside [0, 1].");
    }
    sum += weight;
  }
  if (std::abs(sum - 1.0) > 1e-9) {
    throw InvalidInput("The barycentric weights of a point in face " + std::to_string(point.face) +
                       " do not sum to 1.");
  }
  SurfacePoint result = point;
  for (int i = 0; i < 3; ++i) {
    result.barycentric[i] /= sum;
    if (result.barycentric[i] == 1.0) return SurfacePoint::at_vertex(mesh.face_vertices(point.face)[i]);
  }
  return result;
}

SurfacePoint canonical(const Mesh& mesh, const SurfacePoint& point) {
  SurfacePoint first = point;
  if (point.is_vertex()) return first;
  for_each_face_at(mesh, point, [&](Index face, const std::array<double, 3>& weights) {
    if (face < first.face) first = SurfacePoint::in_face(face, weights);
  });
  return first;
}

Point position_of(const Mesh& mesh, const SurfacePoint& point) {
  if (point.is_vertex()) return mesh.position(point.vertex);
  Point result{};
  for (int i = 0; i < 3; ++i) {
    const Point& corner = mesh.position(mesh.face_vertices(point.face)[i]);
    for (int k = 0; k < 3; ++k) result[k] += point.barycentric[i] * corner[k];
  }
  return result;
}

}  // namespace vorogeo
