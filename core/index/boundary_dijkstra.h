// Searches over the border nodes of patches: one source, many at a time, and followers of a full search.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "index/patch_layer.h"
#include "index/scans.h"
#include "index/unfolding.h"
#include "support/bucket_queue.h"

namespace vorogeo {

/// Where a path crosses a border: at a node, or on the edge from there to another one.
struct BorderCrossing {
  Index node = no_index;
  Index beside = no_index;
  double part = 0.0;  ///< of that edge between the node and the path
  double gain = 0.0;

  /// Takes the edge to a neighbour if a path gains more there than on those that were offered before.
  template <class Number>
  void offer(Index neighbour, const StraightCrossing<Number>& across) {
    if (!(across.gain > gain)) return;
    beside = neighbour;
    part = across.part;
    gain = across.gain;
  }
};

// ---- Distances of the border nodes of a layer, by Dijkstra's algorithm over the patch tables

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

  /// Settles a single node with a given least sum, through a border node of one of its patches. `most`: an
  /// upper bound of its distance.
  void settle(Index node, PatchRow from, double sum, double most = unreachable);

  double distance(Index node) const { return distance_[node]; }
  /// The distance of a node before its correction at the preceding crossing.
  double sum(Index node) const;
  /// The predecessor of a node that was reached; source_name(wave) for a seed.
  Index predecessor(Index node) const {
    const NodeState& state = state_[node];
    return state.patch == no_index ? source_name(state.row) : layer_.node_at({state.patch, state.row});
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
  /// Where the path to a node crosses the border behind it. \pre It was reached, and is no seed.
  BorderCrossing crossing_before(Index node) const;
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

// ---- Searches from the followers of a leader, all in one sweep over the nodes

/// Distances from up to 16 sources close to a leader, whose search is finished; each source has a *lane* of
/// its own, and what is read of a table serves all lanes.
///
/// Let D be distances from the leader, E those from a source whose distance from the leader is at most r. If
/// the shortest path to t ends with the arc (u, t), then D(u) + |ut| - D(t) is at most E(u) + r + |ut| -
/// (E(t) - r) = 2 r. One scan of the arcs with the leader's distances finds for each t the u that can matter
/// to any of the sources, as a stretch of each piece of border. The sources then need no queue: nodes are
/// taken in the leader's order, and the least sum of each over its stretches is its distance, corrected as by
/// BoundaryDijkstra. The order by distance from a source may differ from the leader's for two nodes within
/// about r of the source, where an ordinary search is run, and where a path runs along a border: stretches of
/// a node also have nodes that come *later* in the leader's order. Further rounds look at these.
///
/// The layer must outlive it. One object belongs to one thread.
class FollowerSweep {
 public:
  static constexpr Index lanes = lane_count;

  explicit FollowerSweep(const PatchLayer& layer) : layer_(layer), rank_(layer.node_count(), no_index) {}

  /// Finds the stretches from a leader's search over the patches allowed (empty: all), with all arcs over
  /// which the leader's sum exceeds its distance by up to `slack`.
  void prepare(const BoundaryDijkstra& leader, std::span<const std::uint8_t> patch_allowed, double slack);
  /// Empties all lanes.
  void clear();
  /// Whether the leader reached a node: those are the nodes that have distances.
  bool has(Index node) const { return rank_[node] != no_index; }
  /// Gives a lane the distances up to `near` that a search from its source has found.
  void add(Index lane, const BoundaryDijkstra& search, double near);
  /// Finds the remaining distances. \return the lanes, as bits, whose distances did not settle, or that miss
  /// a node which the leader reached.
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
  /// Whether a node of a stretch changed in this round or the last.
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
  /// Sets the distance of a node as a predecessor: infinite in the patch through which it was reached.
  void set_above(Index node, Index lane, Index from_patch, float distance);
  /// A round over stretches with nodes that changed, or also over later parts. \return lanes that changed.
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

// ---- Searches from a few sources close to each other

/// Distances from a *leader* to all nodes, by a full search; and from the others, its *followers*, in one
/// sweep over what the leader's distances leave possible (FollowerSweep). All but about one in a million of
/// the distances equal those of full searches: unfolding keeps the triangle inequality only nearly.
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
  /// Finds the distances from `followers`, given by their positions in `sources`: at most one for each lane.
  void follow(std::span<const Index> sources, std::span<const std::size_t> followers,
              std::span<const std::uint8_t> patch_allowed, double near,
              const std::function<void(std::size_t i)>& done);

  BoundaryDijkstra search_;
  FollowerSweep sweep_;
  Index lane_ = no_index;  ///< lane of sweep_ that distance() reads; no_index: it reads search_
};

/// First-layer nodes whose searches make a batch; a multiple of TransitTable::group_size, as both kinds
/// of groups begin where the patches at the border change.
inline constexpr Index nodes_per_leader = 16;

}  // namespace vorogeo
