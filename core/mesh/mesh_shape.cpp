// Angles and areas of faces, by the cross product of two sides, and the mean angle defect.
#include <cmath>
#include <numbers>

#include "mesh/length_limits.h"
#include "mesh/mesh.h"

namespace vorogeo {

namespace {

Point from_to(const Point& a, const Point& b) { return {b[0] - a[0], b[1] - a[1], b[2] - a[2]}; }

double scalar_product(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double cross_length(const Point& a, const Point& b) {
  return std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
}

}  // namespace

double Mesh::corner_angle(Index halfedge) const {
  const auto corners = face_corners(face_of(halfedge));
  const Point& corner = corners[halfedge % 3];
  const Point to_next = from_to(corner, corners[next_in_face(halfedge) % 3]);
  const Point to_previous = from_to(corner, corners[previous_in_face(halfedge) % 3]);
  return std::atan2(cross_length(to_next, to_previous), scalar_product(to_next, to_previous));
}

double Mesh::face_area(Index face) const {
  // Cross product of the two shorter sides: relative to them, the rounding of a product is small even in
  // needles.
  int longest = 0;
  for (int i = 1; i < 3; ++i) {
    if (edge_length_[halfedge_edge_[3 * face + i]] > edge_length_[halfedge_edge_[3 * face + longest]])
      longest = i;
  }
  const Index opposite = 3 * face + longest;
  const auto corners = face_corners(face);
  const Point& corner = corners[previous_in_face(opposite) % 3];
  return 0.5 * cross_length(from_to(corner, corners[opposite % 3]),
                            from_to(corner, corners[next_in_face(opposite) % 3]));
}

double Mesh::mean_angle_defect() const {
  double sum = 0.0;
  Index count = 0;
  for (Index v = 0; v < vertex_count(); ++v) {
    if (fan_[v] != Fan::closed) continue;
    sum += std::abs(total_angle_[v] - 2.0 * std::numbers::pi);
    ++count;
  }
  return count == 0 ? 0.0 : sum / count;
}

void require_lengths(const Mesh& mesh, const std::string& what, double least_mean, double greatest) {
  require_lengths(mesh.mean_edge_length(), mesh.longest_edge_length(), what, {least_mean, greatest});
}

}  // namespace vorogeo
