// Searches from a few sources close to each other: one full search limits where the shortest paths from its
// neighbours can lead.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "index/boundary_dijkstra.h"
#include "index/follower_sweep.h"

namespace vorogeo {

/// Distances from a *leader* to all nodes, by a full search; and from the others, its *followers*, in one
/// sweep over what the leader's distances leave possible (FollowerSweep). All but about one in a million of
/// the distances are those of full searches, as unfolding keeps the triangle inequality nearly, not to the
/// last bit.
///
/// The layer must outlive it. One object belongs to one thread.
class BatchDijkstra {
 public:
  explicit BatchDijkstra(const PatchLayer& layer) : search_(layer), sweep_(layer) {}

  /// Finds the distances from each of a few sources close to each other, over the patches allowed (empty:
  /// all). Calls `done(i)` when `distance()` is that from sources[i]: for the one in the middle first, then
  /// in no order.
  void search_from_each(std::span<const Index> sources, std::span<const std::uint8_t> patch_allowed,
                        const std::function<void(std::size_t i)>& done);
  double distance(Index node) const {
    return lane_ == no_index ? search_.distance(node) : sweep_.distance(node, lane_);
  }

 private:
  void search_all(Index source, std::span<const std::uint8_t> patch_allowed);
  /// The followers, as many as there are lanes: where they are among the sources.
  void follow(std::span<const Index> sources, std::span<const std::size_t> followers,
              std::span<const std::uint8_t> patch_allowed, double near,
              const std::function<void(std::size_t i)>& done);

  BoundaryDijkstra search_;
  FollowerSweep sweep_;
  Index lane_ = no_index;  ///< of the distances to be read; no_index: those of search_
};

/// First-layer nodes whose searches make a batch; a multiple of TransitTable::group_size, as both kinds
/// of groups begin where the patches at the border change.
inline constexpr Index nodes_per_leader = 16;

}  // namespace vorogeo
