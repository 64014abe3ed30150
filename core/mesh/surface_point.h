// A point on the surface: in a face, given by barycentric coordinates (vertices and edge points included).
#pragma once

#include <array>
#include <compare>

#include "mesh/mesh.h"

namespace vorogeo {

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
/// first of the edge's faces. So two points are the same (up to rounding of their weights) only if their
/// numbers are.
SurfacePoint canonical(const Mesh& mesh, const SurfacePoint& point);

/// The point of an edge at a fraction of it, 0 to 1 from its first vertex; a vertex at its ends.
SurfacePoint point_on_edge(const Mesh& mesh, Index edge, double fraction);

/// Distances of a point from the corners of its face, straight through the face. \pre It is not a vertex.
std::array<double, 3> distances_in_face(const Mesh& mesh, const SurfacePoint& point);

/// Position in space; NaN on a surface without positions.
Point position_of(const Mesh& mesh, const SurfacePoint& point);

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

}  // namespace vorogeo
