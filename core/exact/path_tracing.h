// The best last segment of a path into a face, and paths back to the source, one face at a time.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <unordered_set>

#include "exact/solver_state.h"

namespace vorogeo {

/// Vertices and crossings of edges that a trace has passed: a crossing is a place on a half-edge of the face
/// that is left. Not whole edges: in a heap of faces without area, a path may have to cross an edge where a
/// dead end has crossed it elsewhere.
class PassedPlaces {
 public:
  /// \return whether the vertex is new.
  bool insert(Index vertex) { return vertices_.insert(vertex).second; }
  void insert(Index halfedge, double x) { crossings_.emplace(halfedge, x); }
  bool contains(Index vertex) const { return !vertices_.empty() && vertices_.contains(vertex); }
  bool contains(Index halfedge, double x, double rounding) const {
    const auto [begin, end] = crossings_.equal_range(halfedge);
    for (auto it = begin; it != end; ++it) {
      if (std::abs(it->second - x) <= rounding) return true;
    }
    return false;
  }

 private:
  std::unordered_set<Index> vertices_;
  std::unordered_multimap<Index, double> crossings_;
};

/// Where the straight segment that ends a shortest path at a point of a face comes from: the best of all
/// entries into that face.
struct BackStep {
  double distance = unreachable;  ///< of the point, by this path
  Index source = no_index;        ///< the source itself, in this face
  Index vertex = no_index;        ///< through this vertex
  Index halfedge = no_index;      ///< across this half-edge of the face, at position `x` of its edge
  double x = 0.0;
  /// In a run that finds directions: the angle at the source at which the path begins.
  double first_leg = std::numeric_limits<double>::quiet_NaN();
};

/// The best step back from a point given by barycentric coordinates in `face`, avoiding the places `avoided`.
/// Complexity: O(windows on the edges of the face).
BackStep best_back_step(const ExactSolver::State& state, Index face, const std::array<double, 3>& barycentric,
                        const PassedPlaces& avoided = {});

/// Barycentric coordinates in `face` of a source that lies in it or on one of its edges.
std::array<double, 3> source_in_face(const ExactSolver::State& state, Index source, Index face);

}  // namespace vorogeo
