// The two-layer graph over the second-layer nodes, pruned, with landmarks for its lower bounds.
#pragma once

#include <span>
#include <vector>

#include "index/patch_layer.h"
#include "support/progress.h"

namespace vorogeo {

/// An arc of the two-layer graph: a distance inside one patch of one layer.
struct Arc {
  Index target;  ///< second-layer node
  float length;
  Leg leg;  ///< the patch that it leads through
};

/// Undirected graph: each arc is stored at both ends. Nodes are those of the second layer. In an index in the
/// form of tables it holds only landmarks; the entries of the tables take the place of arcs.
struct SearchGraph {
  std::vector<std::int64_t> arc_begin;  ///< by node
  std::vector<Arc> arc;
  std::int64_t arcs_before_pruning = 0;
  static constexpr int landmark_count = 8;
  /// Distance of each node from each landmark over the whole graph, 0 where a landmark does not reach.
  std::vector<double> landmark_distance;  ///< shape (nodes, landmark_count)

  bool has_arcs() const { return !arc_begin.empty(); }
  std::span<const Arc> arcs(Index node) const {
    return {arc.data() + arc_begin[node], arc.data() + arc_begin[node + 1]};
  }
  const double* landmarks(Index node) const {
    return landmark_distance.data() + static_cast<std::size_t>(node) * landmark_count;
  }
  std::size_t memory_bytes() const {
    return arc_begin.size() * sizeof(arc_begin[0]) + arc.size() * sizeof(Arc) +
           landmark_distance.size() * sizeof(double);
  }
};

/// Makes the graph from the tables of both layers. An arc is dropped if other kept arcs of its patch form a
/// path at most (1 + delta) times as long; in the first layer, delta is divided by the mean number of
/// second-layer patches in a first-layer patch, since its arcs are longer by about that factor. With delta =
/// 0 all distances stay as they are.
SearchGraph make_search_graph(const PatchLayer& second, const PatchLayer& first,
                              std::span<const Index> parent, double delta, int threads,
                              const Progress& progress);

/// Only the landmarks, their distances by a search over the second-layer tables, and the number of arcs that
/// a graph would have before pruning.
SearchGraph make_landmarks(const PatchLayer& second, const PatchLayer& first, const Progress& progress);

}  // namespace vorogeo
