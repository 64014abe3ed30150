// Distances of the border nodes of a layer, by Dijkstra's algorithm over the patch tables, with unfolding at
// border edges.
#pragma once

#include <span>
#include <vector>

#include "index/patch_layer.h"
#include "support/bucket_queue.h"

namespace vorogeo {

/// Nodes are settled in buckets of distance about as wide as half a border edge. Nearly all arcs are longer
/// than that, so nearly every node is settled once, with its final distance; a node that is relaxed later is
/// settled again. No distance is corrected to less than that of the predecessor, so that nodes cannot relax
/// each other again and again; a node that was relaxed very often is no longer corrected, and searches by
/// plain sums always end.
///
/// One search at a time over the nodes of a layer; reset() takes time proportional to the nodes touched. The
/// layer must outlive it. One object belongs to one thread.
class BoundaryDijkstra {
 public:
  explicit BoundaryDijkstra(const PatchLayer& layer);

  /// Forgets the last search.
  void reset();
  /// Adds a seed: a node whose distance is known from outside the search. `wave` tells apart the sources that
  /// seeds come from.
  void add(Index node, double distance, Index wave = 0);
  /// Settles all nodes within max_distance over the patches p with patch_allowed[p] != 0 (empty: all).
  void run(std::span<const std::uint8_t> patch_allowed = {}, double max_distance = unreachable);

  /// Settles a single node with a given least sum, through a border node of one of its patches. `most`: what
  /// its distance is known not to exceed.
  void settle(Index node, PatchRow from, double sum, double most = unreachable);

  double distance(Index node) const { return distance_[node]; }
  /// The distance of a node before its correction at the preceding crossing.
  double sum(Index node) const;
  /// The predecessor of a node that was reached; source_name(wave) for a seed.
  Index predecessor(Index node) const {
    const NodeState& state = state_[node];
    return state.patch == no_index ? source_name(state.row)
                                   : layer_.border_node[layer_.border_begin[state.patch] + state.row];
  }
  /// The patch through which a node was reached; no_index for a seed.
  Index predecessor_patch(Index node) const { return state_[node].patch; }
  /// Represents a source in the place of a node number; less than no_index.
  static constexpr Index source_name(Index wave) { return no_index - 1 - wave; }

  /// Whether two nodes with these predecessors may have been reached by the same wave: not if the
  /// predecessors are different sources.
  static bool may_share_wave(Index predecessor, Index other_predecessor) {
    return predecessor >= 0 || other_predecessor >= 0 || predecessor == other_predecessor;
  }

  /// Distance of a member (column) of a patch through its border, given the least sum and the row at which it
  /// crosses: improved by unfolding the border edges at that row where their distances belong to one wave.
  double across(Index patch, Index row, Index column, double sum) const;
  /// Nodes with a finite distance.
  std::span<const Index> reached() const { return touched_; }

 private:
  struct NodeState {
    Index patch = no_index;  ///< the patch through which it was reached; no_index: a seed
    Index row = 0;           ///< the row of its predecessor; for a seed, the wave
    Index relaxed = 0;       ///< how often
  };
  void relax(Index node, double distance, Index patch, Index row);
  /// The distance of a node that is about to be settled, corrected at the preceding crossing.
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
