// Searches over the border nodes of patches: one source, many at a time, and followers of a full search.
#include "index/boundary_dijkstra.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "index/scans.h"
#include "index/unfolding.h"
#include "support/progress.h"

namespace vorogeo {

// ---- A full search from the leader, and the followers in lanes

void BatchDijkstra::search_from_each(std::span<const Index> sources,
                                     std::span<const std::uint8_t> patch_allowed,
                                     const std::function<void(std::size_t i)>& done) {
  // Twice the radius would be enough if unfolding kept the triangle inequality to the last bit.
  constexpr double slack_per_radius = 2.1;
  // Near the source, the order of nodes may differ from that by distance from the leader.
  constexpr double near_per_radius = 3.0;
  lane_ = no_index;
  const std::size_t leader = sources.size() / 2;
  search_all(sources[leader], patch_allowed);
  done(leader);
  std::vector<std::size_t> reached, others;
  double radius = 0.0;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (i == leader) continue;
    const double distance = search_.distance(sources[i]);
    (distance < unreachable ? reached : others).push_back(i);
    if (distance < unreachable) radius = std::max(radius, distance);
  }
  if (!reached.empty()) sweep_.prepare(search_, patch_allowed, slack_per_radius * radius);
  for (std::size_t begin = 0; begin < reached.size(); begin += FollowerSweep::lanes) {
    const std::size_t count = std::min<std::size_t>(FollowerSweep::lanes, reached.size() - begin);
    follow(sources, {reached.data() + begin, count}, patch_allowed, near_per_radius * radius, done);
  }
  for (std::size_t i : others) {
    checkpoint();
    search_all(sources[i], patch_allowed);
    done(i);
  }
}

void BatchDijkstra::follow(std::span<const Index> sources, std::span<const std::size_t> followers,
                           std::span<const std::uint8_t> patch_allowed, double near,
                           const std::function<void(std::size_t i)>& done) {
  sweep_.clear();
  for (std::size_t lane = 0; lane < followers.size(); ++lane) {
    search_.reset();
    search_.add(sources[followers[lane]], 0.0);
    search_.run(patch_allowed, near);
    sweep_.add(static_cast<Index>(lane), search_, near);
  }
  const std::uint32_t unsettled = sweep_.run();
  for (std::size_t lane = 0; lane < followers.size(); ++lane) {
    const std::size_t i = followers[lane];
    if ((unsettled >> lane & 1u) == 0) {
      lane_ = static_cast<Index>(lane);
      done(i);
      lane_ = no_index;
    } else {
      search_all(sources[i], patch_allowed);
      done(i);
    }
  }
}

void BatchDijkstra::search_all(Index source, std::span<const std::uint8_t> patch_allowed) {
  search_.reset();
  search_.add(source, 0.0);
  search_.run(patch_allowed);
}

// ---- The search, and the correction of each node when it is settled

namespace {

/// On the test meshes no node is relaxed more than a few dozen times.
constexpr Index max_relaxed = 1000;
constexpr Index nodes_between_checkpoints = 256;

}  // namespace

BoundaryDijkstra::BoundaryDijkstra(const PatchLayer& layer)
    : layer_(layer),
      distance_(layer.node_count(), unreachable),
      state_(layer.node_count()),
      bucket_width_(0.5 * layer.typical_border_edge) {
  queue_.resize(layer.node_count());
  queue_.reset(bucket_width_);
}

void BoundaryDijkstra::reset() {
  for (Index node : touched_) {
    distance_[node] = unreachable;
    state_[node] = {};
  }
  touched_.clear();
  queue_.reset(bucket_width_);
}

void BoundaryDijkstra::relax(Index node, double distance, Index patch, Index row) {
  if (distance >= distance_[node]) return;
  if (distance_[node] == unreachable) touched_.push_back(node);
  distance_[node] = distance;
  state_[node] = {patch, row, state_[node].relaxed + 1};
  queue_.push(node, distance);
}

void BoundaryDijkstra::add(Index node, double distance, Index wave) { relax(node, distance, no_index, wave); }

double BoundaryDijkstra::across(Index patch, Index row, Index column, double sum) const {
  const auto nodes = layer_.nodes(patch);
  const Index node = nodes[row];
  if (state_[node].patch == patch) return sum;
  const PatchLayer::Column targets = layer_.column_of(patch, column);
  Crossing<double> crossing{distance_[node], targets.distance(row)};
  for (const BorderNeighbour& next : layer_.neighbours(patch, row)) {
    const Index other = nodes[next.row];
    if (distance_[other] == unreachable || state_[other].patch == patch ||
        !may_share_wave(predecessor(node), predecessor(other))) {
      continue;
    }
    crossing.add({distance_[other], targets.distance(next.row), next.length});
  }
  return std::min(sum, crossing_distance(crossing));
}

BorderCrossing BoundaryDijkstra::crossing_before(Index node) const {
  const auto [patch, row, relaxed] = state_[node];
  const auto nodes = layer_.nodes(patch);
  const PatchLayer::Column targets = layer_.column_of(patch, layer_.row_of(node, patch));
  BorderCrossing crossing{nodes[row]};
  if (state_[nodes[row]].patch == patch) return crossing;
  for (const BorderNeighbour& next : layer_.neighbours(patch, row)) {
    const Index other = nodes[next.row];
    if (distance_[other] == unreachable || state_[other].patch == patch || !(next.length > 0.0f)) continue;
    crossing.offer(
        other, straight_crossing<double>(distance_[nodes[row]], targets.distance(row),
                                         {distance_[other], targets.distance(next.row), next.length}, 0.0));
  }
  return crossing;
}

double BoundaryDijkstra::sum(Index node) const {
  const NodeState& state = state_[node];
  if (state.patch == no_index) return distance_[node];
  return distance_[predecessor(node)] +
         layer_.distance(state.patch, state.row, layer_.row_of(node, state.patch));
}

double BoundaryDijkstra::corrected(Index node) const {
  const NodeState& state = state_[node];
  if (state.patch == no_index || state.relaxed > max_relaxed) return distance_[node];
  const double across_border =
      across(state.patch, state.row, layer_.row_of(node, state.patch), distance_[node]);
  return std::max(across_border, std::min(distance_[node], distance_[predecessor(node)]));
}

void BoundaryDijkstra::run(std::span<const std::uint8_t> patch_allowed, double max_distance) {
  int taken = 0;
  for (Index node = queue_.pop(); node != no_index; node = queue_.pop()) {
    if (++taken % nodes_between_checkpoints == 0) checkpoint();
    const NodeState state = state_[node];
    double& distance = distance_[node];
    if (distance > max_distance) continue;
    distance = corrected(node);
    for (const PatchRow& at : layer_.patches_of(node)) {
      if (at.patch == state.patch || (!patch_allowed.empty() && !patch_allowed[at.patch])) continue;
      line_.resize(layer_.border_size(at.patch));
      layer_.read_border(at.patch, at.row, line_.data());
      for (const BorderStretch& range : layer_.stretches[at.patch]) {
        const float* line = line_.data() + range.row;
        const Index count = range.end - range.begin;
        const double* reached = distance_.data() + range.begin;
        for (Index i = first_lower(line, distance, reached, 0, count); i < count;
             i = first_lower(line, distance, reached, i + 1, count)) {
          relax(range.begin + i, distance + line[i], at.patch, at.row);
        }
      }
    }
  }
}

void BoundaryDijkstra::settle(Index node, PatchRow from, double sum, double most) {
  if (distance_[node] == unreachable) touched_.push_back(node);
  state_[node] = {from.patch, from.row, 0};
  distance_[node] = sum;
  distance_[node] = std::min(corrected(node), most);
}

// ---- The stretches, the sweep, and the rounds for what comes later in the order

namespace {

/// A node is settled again only if a sum is below this part of its distance: not for a path round the other
/// side of a corner that only unfolding makes shorter.
constexpr float least_gain = 1.0f - 1e-4f;
/// Rounds in which nodes are settled again; a few suffice unless tables contradict each other, and then a
/// full search decides.
constexpr int max_rounds = 64;
/// Sums are in single precision: those that ought to be equal may differ by this part of them.
constexpr double rounding = 4.0 * std::numeric_limits<float>::epsilon();

template <class Visit>
void for_each_lane(std::uint32_t chosen, Visit&& visit) {
  for (; chosen != 0; chosen &= chosen - 1) visit(static_cast<Index>(std::countr_zero(chosen)));
}

}  // namespace

void FollowerSweep::prepare(const BoundaryDijkstra& leader, std::span<const std::uint8_t> patch_allowed,
                            double slack) {
  for (Index node : order_) rank_[node] = no_index;
  order_.assign(leader.reached().begin(), leader.reached().end());
  std::sort(order_.begin(), order_.end(), [&](Index a, Index b) {
    return std::pair(leader.distance(a), a) < std::pair(leader.distance(b), b);
  });
  patch_slot_.resize(layer_.patch_count, no_index);
  for (Index patch : reached_patches_) patch_slot_[patch] = no_index;
  reached_patches_.clear();
  Index slots = 0;
  for (std::size_t k = 0; k < order_.size(); ++k) {
    rank_[order_[k]] = static_cast<Index>(k);
    for (const PatchRow& at : layer_.patches_of(order_[k])) {
      if (patch_slot_[at.patch] != no_index || (!patch_allowed.empty() && !patch_allowed[at.patch])) continue;
      patch_slot_[at.patch] = slots;
      slots += layer_.border_size(at.patch);
      reached_patches_.push_back(at.patch);
    }
  }
  moved_.assign(slots, 0);
  find_stretches(leader, slack);
}

void FollowerSweep::clear() {
  above_.assign(at(static_cast<Index>(moved_.size()), 0), unreachable_float);
  distance_.assign(at(static_cast<Index>(order_.size()), 0), unreachable_float);
  final_.assign(order_.size(), 0);
  used_ = 0;
  std::fill(moved_.begin(), moved_.end(), 0);
  moved_last_.clear();
}

void FollowerSweep::find_stretches(const BoundaryDijkstra& leader, double slack) {
  leader_above_.resize(moved_.size());
  for (Index patch : reached_patches_) {
    float* row = leader_above_.data() + patch_slot_[patch];
    for (Index node : layer_.nodes(patch)) *row++ = static_cast<float>(leader.distance(node));
  }
  begin_.assign(1, 0);
  stretch_.clear();
  for (Index node : order_) {
    const auto bound = static_cast<float>(slack + (1.0 + rounding) * leader.sum(node));
    const auto own = static_cast<float>(leader.distance(node));
    for (const PatchRow& to : layer_.patches_of(node)) {
      if (patch_slot_[to.patch] == no_index) continue;
      for (const BorderStretch& piece : layer_.stretches[to.patch]) {
        layer_.for_each_run(piece, to.row, [&](const BorderStretch& run, const std::uint16_t* entries) {
          const float* above = leader_above_.data() + patch_slot_[to.patch] + run.row;
          const IndexRange range =
              range_within(above, entries, layer_.scale[to.patch], bound, run.end - run.begin);
          if (range.begin == range.end) return;
          Index later_begin = range.begin;
          while (later_begin < range.end && above[later_begin] < own) ++later_begin;
          Index later_end = range.end;
          while (later_end > later_begin && above[later_end - 1] < own) --later_end;
          stretch_.push_back({entries + range.begin, to.patch, patch_slot_[to.patch] + run.row + range.begin,
                              range.end - range.begin, later_begin - range.begin, later_end - range.begin});
        });
      }
    }
    begin_.push_back(stretch_.size());
  }
}

void FollowerSweep::set_above(Index node, Index lane, Index from_patch, float distance) {
  for (const PatchRow& to : layer_.patches_of(node)) {
    if (patch_slot_[to.patch] == no_index) continue;
    above_[at(patch_slot_[to.patch] + to.row, lane)] = to.patch == from_patch ? unreachable_float : distance;
  }
}

void FollowerSweep::add(Index lane, const BoundaryDijkstra& search, double near) {
  used_ |= 1u << lane;
  for (Index node : search.reached()) {
    if (!has(node) || search.distance(node) > near) continue;
    const auto distance = static_cast<float>(search.distance(node));
    distance_[at(rank_[node], lane)] = distance;
    final_[rank_[node]] |= 1u << lane;
    set_above(node, lane, search.predecessor_patch(node), distance);
  }
}

void FollowerSweep::reset(Sums& sums) const {
  std::fill(std::begin(sums.least), std::end(sums.least), unreachable_float);
  std::fill(std::begin(sums.slot), std::end(sums.slot), no_index);
}

void FollowerSweep::pull(const Stretch& stretch, Index begin, Index end, Sums& sums) const {
  relax_lanes(stretch.entries + begin, layer_.scale[stretch.patch], end - begin,
              above_.data() + at(stretch.slot + begin, 0), stretch.slot + begin, sums.least, sums.slot);
}

std::uint32_t FollowerSweep::lower_lanes(Index rank, const Sums& sums) const {
  std::uint32_t lower = 0;
  for (Index lane = 0; lane < lanes; ++lane) {
    lower |= (sums.least[lane] < least_gain * distance_[at(rank, lane)] ? 1u : 0u) << lane;
  }
  return lower & ~final_[rank];
}

void FollowerSweep::settle(Index rank, std::uint32_t chosen, const Sums& sums) {
  const Index node = order_[rank];
  std::array<Index, lanes> from_patch;
  Crossings crossings{};
  for_each_lane(chosen, [&](Index lane) {
    const Index slot = sums.slot[lane];
    PatchRow to = layer_.patches_of(node)[0];
    for (const PatchRow& other : layer_.patches_of(node)) {
      const Index begin = patch_slot_[other.patch];
      if (begin != no_index && slot >= begin && slot < begin + layer_.border_size(other.patch)) to = other;
    }
    from_patch[lane] = to.patch;
    const Index begin = patch_slot_[to.patch];
    const PatchLayer::Column targets = layer_.column_of(to.patch, to.row);
    Crossing<float> crossing{above_[at(slot, lane)], targets.distance(slot - begin)};
    for (const BorderNeighbour& next : layer_.neighbours(to.patch, slot - begin)) {
      const float source = above_[at(begin + next.row, lane)];
      if (source != unreachable_float) crossing.add({source, targets.distance(next.row), next.length});
    }
    crossings.set(lane, crossing);
  });
  float gain[Crossings::capacity];
  crossing_gains(crossings, 0.0f, gain);
  for_each_lane(chosen, [&](Index lane) {
    // Not less than the distance of the predecessor.
    const float sum = sums.least[lane];
    const float distance = std::max(sum - gain[lane], std::min(sum, crossings.source[lane]));
    distance_[at(rank, lane)] = distance;
    set_above(node, lane, from_patch[lane], distance);
  });
}

bool FollowerSweep::is_moved(const Stretch& stretch) const {
  return std::memchr(moved_.data() + stretch.slot, 1, static_cast<std::size_t>(stretch.count)) != nullptr;
}

std::uint32_t FollowerSweep::run_round(bool over_later_parts) {
  std::uint32_t changed = 0;
  moved_now_.clear();
  for (Index rank = 0; rank < static_cast<Index>(order_.size()); ++rank) {
    if (rank % nodes_between_checkpoints == 0) checkpoint();
    if ((used_ & ~final_[rank]) == 0) continue;
    Sums sums;
    bool is_reset = false;
    for (const Stretch& stretch : stretches_of(rank)) {
      const bool is_whole = is_moved(stretch);
      const bool is_later = over_later_parts && stretch.later_begin < stretch.later_end;
      if (!is_whole && !is_later) continue;
      if (!is_reset) reset(sums);
      is_reset = true;
      if (is_whole) {
        pull(stretch, 0, stretch.count, sums);
      } else {
        pull(stretch, stretch.later_begin, stretch.later_end, sums);
      }
    }
    const std::uint32_t lower = is_reset ? lower_lanes(rank, sums) : 0;
    if (lower == 0) continue;
    settle(rank, lower, sums);
    changed |= lower;
    for (const PatchRow& to : layer_.patches_of(order_[rank])) {
      if (patch_slot_[to.patch] == no_index) continue;
      moved_[patch_slot_[to.patch] + to.row] = 1;
      moved_now_.push_back(patch_slot_[to.patch] + to.row);
    }
  }
  // A node that changed in this round was seen only by nodes that come after it.
  for (Index slot : moved_last_) moved_[slot] = 0;
  for (Index slot : moved_now_) moved_[slot] = 1;
  std::swap(moved_last_, moved_now_);
  return changed;
}

void FollowerSweep::fetch(std::span<const Stretch> stretches) {
  constexpr Index entries_per_line = 32;
  for (const Stretch& stretch : stretches) {
    for (Index i = 0; i < stretch.count; i += entries_per_line) __builtin_prefetch(stretch.entries + i);
  }
}

std::uint32_t FollowerSweep::run() {
  constexpr std::size_t nodes_ahead = 2;
  for (Index rank = 0; rank < static_cast<Index>(order_.size()); ++rank) {
    if (rank % nodes_between_checkpoints == 0) checkpoint();
    if ((used_ & ~final_[rank]) == 0) continue;
    const auto ahead = static_cast<std::size_t>(rank) + nodes_ahead;
    if (ahead < order_.size()) fetch(stretches_of(static_cast<Index>(ahead)));
    Sums sums;
    reset(sums);
    for (const Stretch& stretch : stretches_of(rank)) pull(stretch, 0, stretch.count, sums);
    const std::uint32_t lower = lower_lanes(rank, sums);
    if (lower != 0) settle(rank, lower, sums);
  }
  std::uint32_t changed = run_round(true);
  for (int round = 1; changed != 0 && round < max_rounds; ++round) changed = run_round(false);
  for (std::size_t place = 0; place < distance_.size(); ++place) {
    if (distance_[place] == unreachable_float) changed |= used_ & (1u << (place % lanes));
  }
  return changed;
}

}  // namespace vorogeo
