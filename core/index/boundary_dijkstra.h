// Distances of the border nodes of a layer, by Dijkstra's algorithm over the patch tables with edge
// unfolding.
#pragma once

#include <span>
#include <vector>

#include "index/patch_layer.h"
#include "support/bucket_queue.h"

namespace vorogeo {

/// Nodes are taken in buckets of distance about as wide as half a border edge. Arcs are longer than that but
/// for a few, so nearly every node is taken once, with its final distance; a node that is relaxed later is
/// taken again. No distance is corrected to below that of the node before it, so that nodes cannot lower each
/// other in turns; a node that was relaxed very often is no longer corrected, and plain sums always end.
///
/// One search at a time over the nodes of a layer; seeds anew in time of the nodes touched. The layer must
/// outlive it. One object belongs to one thread.
class BoundaryDijkstra {
 public:
  explicit BoundaryDijkstra(const PatchLayer& layer);

  /// Forgets the last search.
  void reset();
  /// A node whose distance is known from outside the search, as a start. `wave` tells the sources apart that
  /// seeds come from.
  void add(Index node, double distance, Index wave = 0);
  /// Settles all nodes within max_distance over the patches p with patch_allowed[p] != 0 (empty: all).
  void run(std::span<const std::uint8_t> patch_allowed = {}, double max_distance = unreachable);

  /// Settles one node by itself: its least sum, by a border node of one of its patches.
  void settle(Index node, PatchRow from, double sum);

  double distance(Index node) const { return distance_[node]; }
  /// The distance of a node before it was corrected at the crossing before it.
  double sum(Index node) const;
  const PatchLayer& layer() const { return layer_; }
  /// The node before a node that was reached; source_name(wave) for a start.
  Index predecessor(Index node) const {
    const NodeState& state = state_[node];
    return state.patch == no_index ? source_name(state.row)
                                   : layer_.border_node[layer_.border_begin[state.patch] + state.row];
  }
  /// The patch through which a node was reached; no_index for a start.
  Index predecessor_patch(Index node) const { return state_[node].patch; }
  /// Stands for a source where a node would stand; less than no_index.
  static constexpr Index source_name(Index wave) { return no_index - 1 - wave; }

  /// Whether two nodes with these predecessors may have been reached by one wave: not if these are different
  /// sources.
  static bool may_share_wave(Index predecessor, Index other_predecessor) {
    return predecessor >= 0 || other_predecessor >= 0 || predecessor == other_predecessor;
  }

  /// Distance of a member (column) of a patch through its border, the least sum given as the row of the
  /// crossing: improved by unfolding the border edges at that row where their distances belong to one wave.
  double across(Index patch, Index row, Index column, double sum) const;
  /// Nodes with a finite distance.
  std::span<const Index> reached() const { return touched_; }

 private:
  struct NodeState {
    Index patch = no_index;  ///< the patch through which it was reached; no_index: a start
    Index row = 0;           ///< the row of the node before it; for a start, the wave
    Index relaxed = 0;       ///< how often
  };
  void relax(Index node, double distance, Index patch, Index row);
  /// The distance of a node that is about to be settled, corrected at the crossing before it.
  double corrected(Index node) const;

  const PatchLayer& layer_;
  std::vector<double> distance_;
  std::vector<NodeState> state_;
  std::vector<Index> touched_;
  BucketQueue queue_;
  double bucket_width_;
  std::vector<float> line_;
};

}  // namespace vorogeo
