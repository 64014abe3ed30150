// One scan of all arcs with the leader's distances.
#include "index/batch_dijkstra.h"

#include <algorithm>
#include <limits>

#include "index/min_plus.h"
#include "support/checkpoint.h"

namespace vorogeo {

namespace {

/// Sums that a scan computes at a time.
constexpr Index scan_width = 16;
/// A node is processed again only if its sum decreased below this part of the earlier one, and not for a path
/// round the other side of a corner that unfolding makes a little shorter.
constexpr float least_gain = 1.0f - 1e-4f;
/// Rounds in which nodes are processed again; a few suffice unless tables contradict each other, and then a
/// full search decides.
constexpr int max_rounds = 64;

}  // namespace

void BatchDijkstra::search_from_each(std::span<const Index> sources,
                                     std::span<const std::uint8_t> patch_allowed,
                                     const std::function<void(std::size_t i)>& done) {
  // Twice the radius would be enough if unfolding kept the triangle inequality to the last bit.
  constexpr double slack_per_radius = 2.1;
  // Near the source, the order of nodes may differ from that by distance from the leader.
  constexpr double near_per_radius = 3.0;
  const std::size_t leader = sources.size() / 2;
  search_all(sources[leader], patch_allowed);
  done(leader);
  double radius = 0.0;
  for (Index source : sources) {
    if (search_.distance(source) < unreachable) radius = std::max(radius, search_.distance(source));
  }
  if (sources.size() == 1) return;
  fit(patch_allowed, slack_per_radius * radius);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (i == leader) continue;
    checkpoint();
    if (std::find(order_.begin(), order_.end(), sources[i]) == order_.end()) {
      search_all(sources[i], patch_allowed);
    } else {
      const bool settled = follow(sources[i], patch_allowed, near_per_radius * radius);
      if (!settled) search_all(sources[i], patch_allowed);
    }
    done(i);
  }
}

void BatchDijkstra::search_all(Index source, std::span<const std::uint8_t> patch_allowed) {
  search_.reset();
  search_.add(source, 0.0);
  search_.run(patch_allowed);
}

void BatchDijkstra::fit(std::span<const std::uint8_t> patch_allowed, double slack) {
  const PatchLayer& layer = search_.layer();
  order_.assign(search_.reached().begin(), search_.reached().end());
  std::sort(order_.begin(), order_.end(), [&](Index a, Index b) {
    return std::pair(search_.distance(a), a) < std::pair(search_.distance(b), b);
  });
  // The uncorrected sums, with the sign that range_within expects.
  std::vector<float>& below = least_;
  std::fill(below.begin(), below.end(), unreachable_float);
  for (Index node : order_) below[node] = -static_cast<float>(search_.sum(node));
  begin_.assign(1, 0);
  stretch_.clear();
  for (Index node : order_) {
    const auto bound = static_cast<float>(slack - search_.distance(node));
    for (Index place = layer.incidence_begin[node]; place < layer.incidence_begin[node + 1]; ++place) {
      const PatchRow at = layer.incidence[place];
      if (!patch_allowed.empty() && !patch_allowed[at.patch]) continue;
      for (const BorderStretch& piece : layer.stretches.of(at.patch)) {
        layer.for_each_run(piece, at.row, [&](const BorderStretch& run, const std::uint16_t* entries) {
          const Index count = run.end - run.begin;
          const IndexRange range =
              range_within(below.data() + run.begin, entries, layer.scale[at.patch], bound, count);
          if (range.begin == range.end) return;
          // Whole blocks are scanned faster than partial ones.
          const Index end = std::min(
              count, range.begin + (range.end - range.begin + scan_width - 1) / scan_width * scan_width);
          stretch_.push_back({entries + range.begin, place, run.begin + range.begin, end - range.begin});
        });
      }
    }
    begin_.push_back(stretch_.size());
  }
}

bool BatchDijkstra::follow(Index source, std::span<const std::uint8_t> patch_allowed, double near) {
  const PatchLayer& layer = search_.layer();
  search_.reset();
  search_.add(source, 0.0);
  search_.run(patch_allowed, near);
  std::fill(least_.begin(), least_.end(), unreachable_float);
  std::fill(taken_.begin(), taken_.end(), unreachable_float);
  std::fill(best_.begin(), best_.end(), no_index);
  auto take = [&](std::size_t k) {
    const Index node = order_[k];
    taken_[node] = least_[node];
    if (best_[node] != no_index) search_.settle(node, layer.incidence[best_[node]], least_[node]);
    const auto distance = static_cast<float>(search_.distance(node));
    const Index from_patch = search_.predecessor_patch(node);
    for (std::size_t s = begin_[k]; s < begin_[k + 1]; ++s) {
      const Stretch& to = stretch_[s];
      const Index patch = layer.incidence[to.place].patch;
      if (patch == from_patch) continue;
      relax_by_line(to.entries, layer.scale[patch], distance, to.place, to.count, least_.data() + to.begin,
                    best_.data() + to.begin);
    }
  };
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const Index node = order_[k];
    if (search_.distance(node) <= near) {
      least_[node] = 0.0f;
      best_[node] = no_index;
    } else if (best_[node] == no_index) {
      continue;
    }
    take(k);
  }
  // Where waves from two sides meet, the order of a few nodes may differ, too.
  for (int round = 0; round < max_rounds; ++round) {
    bool changed = false;
    for (std::size_t k = 0; k < order_.size(); ++k) {
      if (!(least_[order_[k]] < least_gain * taken_[order_[k]])) continue;
      take(k);
      changed = true;
    }
    if (!changed) return true;
  }
  return false;
}

}  // namespace vorogeo
