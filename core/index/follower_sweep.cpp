// The stretches, the sweep, and the rounds for what comes later in the order.
#include "index/follower_sweep.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <utility>

#include "index/crossing_gains.h"
#include "index/unfolding.h"
#include "support/checkpoint.h"

namespace vorogeo {

namespace {

/// A node is settled again only if a sum is below this part of its distance, and not for a path round the
/// other side of a corner that unfolding makes a little shorter.
constexpr float least_gain = 1.0f - 1e-4f;
/// Rounds in which nodes are settled again; a few suffice unless tables contradict each other, and then a
/// full search decides.
constexpr int max_rounds = 64;
constexpr Index nodes_between_checkpoints = 256;
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
      for (const BorderStretch& piece : layer_.stretches.of(to.patch)) {
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
  float corrected[Crossings::capacity];
  std::uint32_t alone = 0;
  for_each_lane(chosen, [&](Index lane) {
    const Index slot = sums.slot[lane];
    PatchRow to = layer_.patches_of(node)[0];
    for (const PatchRow& other : layer_.patches_of(node)) {
      const Index begin = patch_slot_[other.patch];
      if (begin != no_index && slot >= begin && slot < begin + layer_.border_size(other.patch)) to = other;
    }
    from_patch[lane] = to.patch;
    const Index begin = patch_slot_[to.patch];
    const PatchLayer::Column column = layer_.column_of(to.patch, to.row);
    const TableScale scale = layer_.scale[to.patch];
    auto target = [&](Index row) {
      const std::uint16_t entry = column.first[row * column.step];
      return entry == PatchLayer::infinite_entry ? unreachable_float : scale.distance(entry);
    };
    crossings.source[lane] = above_[at(slot, lane)];
    crossings.target[lane] = target(slot - begin);
    // Where more borders meet, the neighbours beyond the first few are left out.
    std::array<BorderSample, 4> neighbours{};
    std::size_t known = 0;
    for (const BorderNeighbour& next : layer_.neighbours(to.patch, slot - begin)) {
      const float source = above_[at(begin + next.row, lane)];
      if (source == unreachable_float) continue;
      if (known == neighbours.size()) break;
      neighbours[known++] = {source, target(next.row), next.length};
    }
    if (known > 2) {
      alone |= 1u << lane;
      corrected[lane] = static_cast<float>(
          crossing_distance(crossings.source[lane], crossings.target[lane], {neighbours.data(), known}));
      return;
    }
    for (std::size_t side = 0; side < known; ++side) {
      if (neighbours[side].target == unreachable) continue;
      crossings.side[side].source[lane] = static_cast<float>(neighbours[side].source);
      crossings.side[side].target[lane] = static_cast<float>(neighbours[side].target);
      crossings.side[side].length[lane] = static_cast<float>(neighbours[side].length);
    }
  });
  float gain[Crossings::capacity];
  crossing_gains(crossings, 0.0f, gain);
  for_each_lane(chosen, [&](Index lane) {
    const float sum = sums.least[lane];
    const float improved = (alone >> lane & 1u) != 0 ? std::min(sum, corrected[lane]) : sum - gain[lane];
    // Not less than that of the predecessor.
    const float distance = std::max(improved, std::min(sum, crossings.source[lane]));
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
  // What moved in this round has been seen by the nodes behind it only.
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
