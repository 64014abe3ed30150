// Searches from a few sources close to each other: one full search limits where the shortest paths from its
// neighbours can lead.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "index/boundary_dijkstra.h"

namespace vorogeo {

/// Distances from a *leader* to all nodes; and, derived from them for each node and each of its patches, the
/// nodes of that patch to which shortest paths from sources near the leader may continue.
///
/// Let D be distances from the leader, E those from a source whose distance from the leader is at most r. If
/// the shortest path to t ends with the arc (u, t), then D(u) + |ut| - D(t) is at most E(u) + r + |ut| -
/// (E(t) - r) = 2 r. One scan of the arcs with the leader's distances finds all that can matter to any of the
/// sources, as one stretch of each piece of border. A source then needs no queue: it processes the nodes in
/// the leader's order and relaxes the stretches of each. The order may differ within about r of the source,
/// where an ordinary search is run, and for a few nodes where waves from two sides meet, which are processed
/// again. All but about one in a million of the distances are those of a full search, as unfolding keeps the
/// triangle inequality nearly, not to the last bit.
///
/// The layer must outlive it. One object belongs to one thread.
class BatchDijkstra {
 public:
  explicit BatchDijkstra(const PatchLayer& layer)
      : search_(layer), least_(layer.node_count()), taken_(layer.node_count()), best_(layer.node_count()) {}

  /// Finds the distances from each of a few sources close to each other, over the patches allowed (empty:
  /// all): from the one in the middle by a full search, from the others over the stretches that this one
  /// finds. Calls `done(i)` when `search()` holds the distances from sources[i].
  void search_from_each(std::span<const Index> sources, std::span<const std::uint8_t> patch_allowed,
                        const std::function<void(std::size_t i)>& done);
  const BoundaryDijkstra& search() const { return search_; }

 private:
  /// Consecutive nodes to be relaxed from a node in one of its patches.
  struct Stretch {
    const std::uint16_t* entries;
    Index place;  ///< of node and patch, in PatchLayer::incidence
    Index begin;  ///< first node
    Index count;
  };
  void fit(std::span<const std::uint8_t> patch_allowed, double slack);
  void search_all(Index source, std::span<const std::uint8_t> patch_allowed);
  /// Finds the distances from a source: those up to `near` by a search, the others in the leader's order.
  /// \return false if they did not settle.
  bool follow(Index source, std::span<const std::uint8_t> patch_allowed, double near);

  BoundaryDijkstra search_;
  std::vector<float> least_;        ///< by node: least sum so far
  std::vector<float> taken_;        ///< by node: the sum with which it was last processed
  std::vector<Index> best_;         ///< by node: where least_ comes from, a place in PatchLayer::incidence
  std::vector<Index> order_;        ///< nodes by distance from the leader
  std::vector<std::size_t> begin_;  ///< by place in order_, into stretch_
  std::vector<Stretch> stretch_;
};

/// First-layer nodes whose searches make a batch; a multiple of TransitTable::group_size, as both kinds
/// of groups begin where the patches at the border change.
inline constexpr Index nodes_per_leader = 16;

}  // namespace vorogeo
