// Points of the surface, lists of them, and distances between points of one face.
#pragma once

#include <array>
#include <compare>
#include <concepts>
#include <ranges>
#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

// ---- A point on the surface: a vertex, or a place in a face by barycentric coordinates

/// Where a point lies: exactly one of `vertex`, or `face` with `barycentric`, is set.
struct SurfacePoint {
  Index vertex = no_index;
  Index face = no_index;
  /// Weights of the corners of `face`: non-negative, sum 1. A point on an edge has a zero weight.
  std::array<double, 3> barycentric{};

  static SurfacePoint at_vertex(Index vertex) { return {vertex, no_index, {}}; }
  static SurfacePoint in_face(Index face, const std::array<double, 3>& barycentric) {
    return {no_index, face, barycentric};
  }
  bool is_vertex() const { return vertex != no_index; }
  /// Points in faces before vertices, then by their numbers.
  std::partial_ordering operator<=>(const SurfacePoint&) const = default;
};

/// The same point in its simplest form: one in a corner becomes that vertex, weights off by up to 1e-6 are
/// corrected.
/// \throw InvalidInput if an index is out of range, or if weights are more negative than that or their sum
/// farther from 1.
SurfacePoint validated(const Mesh& mesh, const SurfacePoint& point);

/// The one representation of a validated point, however it was given: a point on an edge is stored in the
/// first of the edge's faces. So the same point has the same members, up to rounding of its weights.
SurfacePoint canonical(const Mesh& mesh, const SurfacePoint& point);

/// The point at a fraction (0 to 1) of an edge from its first vertex; at the ends, the vertex.
SurfacePoint point_on_edge(const Mesh& mesh, Index edge, double fraction);

/// Distances of a point from the corners of its face, straight through the face. \pre It is not a vertex.
std::array<double, 3> distances_in_face(const Mesh& mesh, const SurfacePoint& point);

/// The component that a point lies in.
inline Index component_of(const Mesh& mesh, const SurfacePoint& point) {
  return mesh.component(point.is_vertex() ? point.vertex : mesh.face_vertices(point.face)[0]);
}

/// Position in space; NaN on a surface without positions.
Point position_of(const Mesh& mesh, const SurfacePoint& point);
std::vector<Point> positions_of(const Mesh& mesh, std::span<const SurfacePoint> points);

/// `Mesh::potential` at a point, interpolated linearly over its face.
double potential_at(const Mesh& mesh, const SurfacePoint& point);

/// Barycentric weights of a point in a face that holds it. \return false if the face does not hold it.
bool weights_in_face(const Mesh& mesh, const SurfacePoint& point, Index face, std::array<double, 3>& weights);

/// Calls `visit(face, weights)` for every face that holds the point, with its barycentric weights there: all
/// faces at a vertex, all faces around the edge of a point on an edge, else the face of the point. The face
/// of the point comes first.
template <class Visit>
void for_each_face_at(const Mesh& mesh, const SurfacePoint& point, Visit&& visit) {
  if (point.is_vertex()) {
    for (Index corner : mesh.corners(point.vertex)) {
      std::array<double, 3> weights{};
      weights[corner % 3] = 1.0;
      visit(Mesh::face_of(corner), weights);
    }
    return;
  }
  visit(point.face, point.barycentric);
  for (int i = 0; i < 3; ++i) {
    if (point.barycentric[(i + 2) % 3] > 0.0) continue;
    const Index own = 3 * point.face + i;
    for (Index h = mesh.next_around_edge(own); h != own; h = mesh.next_around_edge(h)) {
      const bool same = mesh.tail(h) == mesh.tail(own);
      std::array<double, 3> weights{};
      weights[h % 3] = point.barycentric[same ? i : (i + 1) % 3];
      weights[Mesh::next_in_face(h) % 3] = point.barycentric[same ? (i + 1) % 3 : i];
      visit(Mesh::face_of(h), weights);
    }
  }
}

// ---- The points that a task is asked about: vertices, or any points of the surface

/// A list of points on a mesh. Lists of vertices and of surface points convert to it implicitly, so that
/// every function that takes points accepts both.
class PointList {
 public:
  PointList() = default;
  template <std::ranges::input_range Range>
  requires std::same_as<std::remove_cv_t<std::ranges::range_value_t<Range>>, Index> PointList(
      const Range& vertices) {  // NOLINT(google-explicit-constructor)
    for (const Index vertex : vertices) points_.push_back(SurfacePoint::at_vertex(vertex));
  }
  template <std::ranges::input_range Range>
  requires std::same_as<std::remove_cv_t<std::ranges::range_value_t<Range>>, SurfacePoint> PointList(
      const Range& points)  // NOLINT(google-explicit-constructor)
      : points_(std::ranges::begin(points), std::ranges::end(points)) {}

  std::size_t size() const { return points_.size(); }
  bool empty() const { return points_.empty(); }
  const SurfacePoint& operator[](std::size_t i) const { return points_[i]; }
  auto begin() const { return points_.begin(); }
  auto end() const { return points_.end(); }

  bool only_vertices() const;
  /// \pre only_vertices()
  std::vector<Index> vertices() const;

 private:
  std::vector<SurfacePoint> points_;
};

/// The list in canonical form. \throw InvalidInput if a point is not on the mesh; the message names it by
/// `role` and its position in the list.
PointList points_on(const Mesh& mesh, const PointList& points, const char* role);

// ---- Distance of a point in a face, from the distances of the face's corners

/// Distances of the point with these barycentric weights from the corners of a triangle with sides of these
/// lengths, each from a corner to the next.
std::array<double, 3> distances_in_triangle(const std::array<double, 3>& length,
                                            const std::array<double, 3>& weights);

/// Distance of that point if the corners have these distances from one source: the least over paths through a
/// corner and over straight lines through an edge, from where the distances of its ends place the source in
/// the plane. If the third corner is farther from the source than it is from that place, the difference is
/// interpolated linearly. Exact where the wave of a single point crosses the face; elsewhere an
/// interpolation. Infinite corners are left out; `unreachable` if all are.
double distance_in_triangle(const std::array<double, 3>& length, const std::array<double, 3>& weights,
                            const std::array<double, 3>& corner_distance);

}  // namespace vorogeo
