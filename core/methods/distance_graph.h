// Shortest paths in a graph over the vertices of a mesh.
#pragma once

#include <span>
#include <vector>

#include "support/types.h"

namespace vorogeo {

/// An arc to a vertex, with its length.
struct GraphArc {
  Index target;
  double length;
};

/// An undirected graph over vertices 0..n-1 with lengths, as lists of neighbours.
class DistanceGraph {
 public:
  /// Takes arcs by their tails; those of one pair of vertices become one, the shortest, in both directions.
  explicit DistanceGraph(std::vector<std::vector<GraphArc>> arcs_of);

  std::span<const GraphArc> arcs(Index vertex) const {
    return {arcs_.data() + begin_[vertex], arcs_.data() + begin_[vertex + 1]};
  }
  std::size_t arc_count() const { return arcs_.size(); }
  std::size_t bytes() const {
    return arcs_.capacity() * sizeof(GraphArc) + begin_.capacity() * sizeof(std::size_t);
  }

  /// Lengths of shortest paths from the nearest source (Dijkstra 1959). With a target: it ends when that
  /// one's is final; the others are then upper bounds. Shape (n).
  std::vector<double> field(std::span<const Index> sources, Index target = no_index) const;

 private:
  std::vector<std::size_t> begin_;
  std::vector<GraphArc> arcs_;
};

}  // namespace vorogeo
