// Distances of the border nodes of a layer, by Dijkstra's algorithm over the patch tables with edge
// unfolding.
#pragma once

#include <span>
#include <vector>

#include "index/patch_layer.h"
#include "support/bucket_queue.h"

namespace vorogeo {

/// Nodes are taken in buckets of distance about as wide as half a border edge. Arcs are longer than that but
/// for a few, so nearly every node is taken once, with its final distance; a node that is lowered later is
/// taken again.
///
/// One search at a time over the nodes of a layer; starts anew in time of the nodes touched. The layer must
/// outlive it. One object belongs to one thread.
class BorderSearch {
 public:
  explicit BorderSearch(const PatchLayer& layer);

  /// Forgets the last search.
  void start();
  /// A node whose distance is known from outside the search, as a start. `wave` tells the sources apart that
  /// starts come from.
  void add(Index node, double distance, Index wave = 0);
  /// Settles all nodes within max_distance over the patches p with patch_allowed[p] != 0 (empty: all).
  void run(std::span<const std::uint8_t> patch_allowed = {}, double max_distance = unreachable);

  /// Settles one node by itself: its least sum, by a border node of one of its patches.
  void settle(Index node, PatchRow from, double sum);

  double distance(Index node) const { return distance_[node]; }
  /// The distance of a node before it was corrected at the crossing before it.
  double sum(Index node) const;
  const PatchLayer& layer() const { return layer_; }
  /// Row of a node in one of its patches.
  Index row_in(Index node, Index patch) const {
    for (const PatchRow& at : layer_.patches_of(node)) {
      if (at.patch == patch) return at.row;
    }
    return no_index;
  }
  /// All border nodes of a patch.
  std::span<const BorderStretch> border(Index patch) const { return border_[patch]; }
  /// The node before a node that was reached; wave_name(wave) for a start.
  Index before(Index node) const {
    const NodeState& state = state_[node];
    return state.patch == no_index ? wave_name(state.row)
                                   : layer_.border_node[layer_.border_begin[state.patch] + state.row];
  }
  /// The patch through which a node was reached; no_index for a start.
  Index patch_before(Index node) const { return state_[node].patch; }
  /// Stands for a source where a node would stand; less than no_index.
  static constexpr Index wave_name(Index wave) { return no_index - 1 - wave; }

  /// Distance of a member (column) of a patch through its border, the least sum given as the row of the
  /// crossing: improved by unfolding the border edges at that row where their distances belong to one wave.
  double across(Index patch, Index row, Index column, double sum) const;
  /// Nodes with a finite distance.
  std::span<const Index> reached() const { return touched_; }

 private:
  struct NodeState {
    Index patch = no_index;  ///< the patch through which it was reached; no_index: a start
    Index row = 0;           ///< the row of the node before it; for a start, the wave
  };
  void lower(Index node, double distance, Index patch, Index row);
  /// The distance of a node that is about to be settled, corrected at the crossing before it.
  double corrected(Index node) const;
  bool one_wave(const NodeState& a, const NodeState& b) const;

  const PatchLayer& layer_;
  std::vector<std::vector<BorderStretch>> border_;  ///< nodes of each patch
  std::vector<double> distance_;
  std::vector<NodeState> state_;
  std::vector<Index> touched_;
  BucketQueue queue_;
  double bucket_width_ = 0.0;
  std::vector<float> line_;
};

}  // namespace vorogeo
