// A point on the surface: in a face, given by barycentric coordinates (vertices and edge points included).
#pragma once

#include <array>

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
};

/// The same point in its simplest form: a point in a corner becomes that vertex.
/// \throw InvalidInput if an index is out of range or the weights are negative or do not sum to 1.
SurfacePoint validated(const Mesh& mesh, const SurfacePoint& point);

/// Position in space.
Point position_of(const Mesh& mesh, const SurfacePoint& point);

}  // namespace vorogeo
