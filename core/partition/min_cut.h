// Minimum cut between two nodes of a graph.
#pragma once

#include <cstdint>
#include <vector>

#include "support/types.h"

namespace vorogeo {

/// Minimum cut by shortest augmenting paths in layers (Dinic 1970). Keeps its memory between runs.
class MinCut {
 public:
  static constexpr Index source = 0;
  static constexpr Index sink = 1;

  /// Begins a graph with this many nodes, source and sink among them, and no arc.
  void reset(Index nodes);
  /// Joins two nodes in both directions; capacities between the same nodes add up.
  void join(Index a, Index b, std::int64_t capacity);
  /// Finds a minimum cut; returns its capacity. Complexity: O(nodes^2 arcs) at worst, usually some ten
  /// passes.
  std::int64_t run();
  /// After run(): whether a node is on the source's side.
  bool beside_source(Index node) const { return level_[node] >= 0; }

 private:
  struct Arc {
    Index to;
    Index next;  ///< of the same node
    std::int64_t room;
  };
  bool find_levels();
  std::int64_t augment();

  std::vector<Index> first_;  ///< arc, by node
  std::vector<Arc> arcs_;     ///< those of one edge are 2 k and 2 k + 1
  std::vector<Index> level_;
  std::vector<Index> next_arc_;
  std::vector<Index> queue_;
  std::vector<Index> path_;
};

}  // namespace vorogeo
