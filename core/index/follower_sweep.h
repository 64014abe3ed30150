// Searches from the followers of a leader, all in one sweep over the nodes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "index/boundary_dijkstra.h"
#include "index/lane_sums.h"

namespace vorogeo {

/// Distances from up to 16 sources close to a leader, whose search is finished; each source has a *lane* of
/// its own, and what is read of a table serves all lanes.
///
/// Let D be distances from the leader, E those from a source whose distance from the leader is at most r. If
/// the shortest path to t ends with the arc (u, t), then D(u) + |ut| - D(t) is at most E(u) + r + |ut| -
/// (E(t) - r) = 2 r. One scan of the arcs with the leader's distances finds for each t the u that can matter
/// to any of the sources, as a stretch of each piece of border. The sources then need no queue: nodes are
/// taken in the leader's order, and the least sum of each over its stretches is its distance, corrected as by
/// BoundaryDijkstra. The order of a source may differ for two nodes within about r of it, where an ordinary
/// search is run, and where a path runs along a border: the stretches of a node also have nodes that come
/// *later*. These are looked at in further rounds.
///
/// The layer must outlive it. One object belongs to one thread.
class FollowerSweep {
 public:
  static constexpr Index lanes = lane_count;

  explicit FollowerSweep(const PatchLayer& layer) : layer_(layer), rank_(layer.node_count(), no_index) {}

  /// Finds the stretches from a leader's search over the patches allowed (empty: all), for sources
  /// for which the sum over an arc exceeds the distance by up to `slack`.
  void prepare(const BoundaryDijkstra& leader, std::span<const std::uint8_t> patch_allowed, double slack);
  /// Empties all lanes.
  void clear();
  /// Whether the leader reached a node: those are the nodes that have distances.
  bool has(Index node) const { return rank_[node] != no_index; }
  /// Gives a lane the distances up to `near` that a search from its source has found.
  void add(Index lane, const BoundaryDijkstra& search, double near);
  /// Finds the others. \return the lanes, as bits, whose distances did not settle, or that miss a node which
  /// the leader reached.
  std::uint32_t run();
  double distance(Index node, Index lane) const {
    return has(node) ? static_cast<double>(distance_[at(rank_[node], lane)]) : unreachable;
  }

 private:
  /// Consecutive rows of a patch from which a node may be reached.
  struct Stretch {
    const std::uint16_t* entries;  ///< distances of the node from them
    Index patch;
    Index slot;  ///< of the first of them, in above_
    Index count;
    Index later_begin, later_end;  ///< those after the node in the leader's order are in this part
  };
  /// The least sums of a node, by lane.
  struct Sums {
    float least[lanes];
    Index slot[lanes];  ///< where they come from
  };

  static std::size_t at(Index place, Index lane) { return static_cast<std::size_t>(place) * lanes + lane; }
  std::span<const Stretch> stretches_of(Index rank) const {
    return {stretch_.data() + begin_[rank], stretch_.data() + begin_[rank + 1]};
  }
  void find_stretches(const BoundaryDijkstra& leader, double slack);
  /// Whether a node that changed in this round or the last is among those of a stretch.
  bool is_moved(const Stretch& stretch) const;
  void reset(Sums& sums) const;
  /// Takes part of a stretch into account.
  void pull(const Stretch& stretch, Index begin, Index end, Sums& sums) const;
  /// Has the processor load the entries of stretches that will be needed soon.
  static void fetch(std::span<const Stretch> stretches);
  /// Lanes, as bits, in which a node that is not yet final has a sum worth taking.
  std::uint32_t lower_lanes(Index rank, const Sums& sums) const;
  /// Sets the distance of a node in some lanes: the sums, corrected where the path crosses.
  void settle(Index rank, std::uint32_t chosen, const Sums& sums);
  /// What a node is worth as a predecessor: in a patch through which it was reached, nothing.
  void set_above(Index node, Index lane, Index from_patch, float distance);
  /// A round over stretches with nodes that moved, or over the later parts. \return lanes that changed.
  std::uint32_t run_round(bool over_later_parts);

  const PatchLayer& layer_;
  std::vector<Index> rank_;         ///< by node: its place in order_
  std::vector<Index> order_;        ///< nodes by distance from the leader
  std::vector<std::size_t> begin_;  ///< by rank, into stretch_
  std::vector<Stretch> stretch_;
  std::vector<Index> patch_slot_;  ///< by patch: the slot of its first row; no_index: no row is reached
  std::vector<Index> reached_patches_;
  std::vector<float> leader_above_;  ///< by slot: the leader's distances
  std::vector<float> above_;         ///< by slot and lane: distance of a border node seen from its patch
  std::vector<std::uint8_t> moved_;  ///< by slot: 1 if its node changed in this round or the last
  std::vector<Index> moved_last_;
  std::vector<Index> moved_now_;
  std::vector<float> distance_;       ///< by rank and lane
  std::uint32_t used_ = 0;            ///< lanes that have a source, as bits
  std::vector<std::uint32_t> final_;  ///< by rank: lanes in which the distance is that of add()
};

}  // namespace vorogeo
