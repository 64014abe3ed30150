// The best last segment of a path into a face, and paths back to the source, one face at a time.
#pragma once

#include <array>
#include <unordered_set>

#include "exact/solver_state.h"

namespace vorogeo {

/// Vertices and edges: vertices are items [0, n), edges follow.
using PassedItems = std::unordered_set<Index>;

/// Where the straight segment that ends a shortest path at a point of a face comes from: the best of all
/// entries into that face.
struct BackStep {
  double distance = unreachable;  ///< of the point, by this path
  Index source = no_index;        ///< the source itself, in this face
  Index vertex = no_index;        ///< through this vertex
  Index halfedge = no_index;      ///< across this half-edge of the face, at position `x` of its edge
  double x = 0.0;
};

/// The best step back from a point given by barycentric coordinates in `face`, avoiding the items `avoided`.
/// Complexity: O(windows on the edges of the face).
BackStep best_back_step(const ExactSolver::State& state, Index face, const std::array<double, 3>& barycentric,
                        const PassedItems& avoided = {});

/// Barycentric coordinates in `face` of a source that lies in it or on one of its edges.
std::array<double, 3> source_in_face(const ExactSolver::State& state, Index source, Index face);

}  // namespace vorogeo
