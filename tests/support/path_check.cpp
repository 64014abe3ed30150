// Connectedness and ends by the sets of faces at points, length by positions in space: no code of the core
// that makes or measures paths.
#include "support/path_check.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <vector>

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
  std::vector<std::vector<Index>> faces;
  std::vector<SurfacePoint> points;
  for (const SurfacePoint& point : path.points) {
    points.push_back(validated(mesh, point));
    faces.push_back(faces_at(mesh, points.back()));
  }
  auto share_a_face = [](const std::vector<Index>& a, const std::vector<Index>& b) {
    std::vector<Index> common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    return !common.empty();
  };
  // Positions in space are rounded in units of the coordinates.
  double greatest = 0.0;
  for (const SurfacePoint& point : points) {
    for (const double x : position_of(mesh, point)) greatest = std::max(greatest, std::abs(x));
  }
  const double rounding = 4e-15 * greatest * static_cast<double>(points.size());
  auto is_same = [&](const SurfacePoint& a, const SurfacePoint& b) {
    if (a.is_vertex() && b.is_vertex()) return a.vertex == b.vertex;
    return share_a_face(faces_at(mesh, a), faces_at(mesh, b)) &&
           distance_in_space(mesh, a, b) <= 1e-9 * path.length + rounding;
  };
  if (!is_same(points.front(), validated(mesh, target))) return "it does not begin at the target";
  if (!is_same(points.back(), validated(mesh, source))) return "it does not end at the source";
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const bool stays = points[i].is_vertex() && points[i].vertex == points[i + 1].vertex;
    if (!stays && !share_a_face(faces[i], faces[i + 1])) {
      return "points " + std::to_string(i) + " and " + std::to_string(i + 1) + " share no face";
    }
    length += distance_in_space(mesh, points[i], points[i + 1]);
  }
  if (!(std::abs(length - path.length) <= 1e-9 * path.length + rounding)) {
    std::ostringstream fault;
    fault.precision(17);
    fault << "its steps sum to " << length << ", not " << path.length;
    return fault.str();
  }
  return {};
}

}  // namespace vorogeo::test
