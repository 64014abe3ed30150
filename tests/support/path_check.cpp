// Connectedness by the sets of faces at consecutive points, length by positions in space.
#include "support/path_check.h"

#include <algorithm>
#include <cmath>

namespace vorogeo::test {

namespace {

/// The faces that contain a point, in increasing order.
std::vector<Index> faces_at(const Mesh& mesh, const SurfacePoint& point) {
  std::vector<Index> faces;
  if (point.is_vertex()) {
    for (Index h : mesh.corners(point.vertex)) faces.push_back(Mesh::face_of(h));
  } else {
    faces.push_back(point.face);
    for (int i = 0; i < 3; ++i) {
      if (point.barycentric[(i + 2) % 3] != 0.0) continue;  // the corner opposite of half-edge i
      const Index edge_side = 3 * point.face + i;
      for (Index h = mesh.next_around_edge(edge_side); h != edge_side; h = mesh.next_around_edge(h)) {
        faces.push_back(Mesh::face_of(h));
      }
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

double distance_in_space(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  const Point p = position_of(mesh, a);
  const Point q = position_of(mesh, b);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

}  // namespace

std::string path_fault(const Mesh& mesh, const SurfacePath& path, const SurfacePoint& target,
                       const SurfacePoint& source) {
  if (path.points.empty()) return "the path is empty";
  const double tolerance = 1e-9 * (1.0 + path.length);
  if (distance_in_space(mesh, path.points.front(), target) > tolerance)
    return "it does not begin at the target";
  if (distance_in_space(mesh, path.points.back(), source) > tolerance) return "it does not end at the source";
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
    const SurfacePoint a = validated(mesh, path.points[i]);
    const SurfacePoint b = validated(mesh, path.points[i + 1]);
    const auto faces_a = faces_at(mesh, a);
    const auto faces_b = faces_at(mesh, b);
    std::vector<Index> common;
    std::set_intersection(faces_a.begin(), faces_a.end(), faces_b.begin(), faces_b.end(),
                          std::back_inserter(common));
    if (common.empty()) {
      return "points " + std::to_string(i) + " and " + std::to_string(i + 1) + " share no face";
    }
    length += distance_in_space(mesh, a, b);
  }
  if (std::abs(length - path.length) > tolerance) {
    return "its steps sum to " + std::to_string(length) + ", not " + std::to_string(path.length);
  }
  return {};
}

}  // namespace vorogeo::test
