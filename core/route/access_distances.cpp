// For each group, seeds that cannot matter to it are skipped.
#include "route/access_distances.h"

#include <algorithm>
#include <limits>

#include "index/bound_scans.h"
#include "index/min_plus.h"
#include "support/prefetch.h"

namespace vorogeo {

namespace {

constexpr std::uint8_t greatest_bound = 255;
/// Half of the greatest bound between borders: the sum of one of those and two of these stays within 15 bits.
constexpr float greatest_to_border = 8191.0f;

}  // namespace

/// A distance in units of the bounds, rounded down and clamped.
std::uint8_t AccessDistances::in_bounds(float distance) const {
  return bound_unit_ > 0.0f ? static_cast<std::uint8_t>(std::min(distance / bound_unit_, 255.0f))
                            : greatest_bound;
}

std::vector<AccessDistances::Part>::iterator AccessDistances::add_part(Index patch) {
  const auto begin = static_cast<Index>(seed_bound_.size());
  const Index rows = data_.second.border_size(patch);
  parts_.push_back({patch, begin, rows});
  const Index lanes = lanes_of(parts_.back());
  seed_distance_.resize(begin + lanes, unreachable_float);
  seed_bound_.resize(begin + lanes, greatest_bound);
  place_.resize(begin + lanes, no_index);
  const Index* columns = data_.parent_column.data() + data_.second.border_begin[patch];
  column_.insert(column_.end(), columns, columns + rows);
  column_.resize(begin + lanes, 0);
  return parts_.end() - 1;
}

void AccessDistances::add_seed(Index lane, double distance, std::size_t place) {
  const auto rounded = static_cast<float>(distance);
  if (!(rounded < seed_distance_[lane])) return;
  seed_distance_[lane] = rounded;
  seed_bound_[lane] = bound_unit_ > 0.0f ? in_bounds(rounded) : std::uint8_t{0};
  place_[lane] = static_cast<Index>(place);
}

void AccessDistances::reset(const RouteEnd& end, Index parent) {
  if (end.vertex != no_index && end.vertex == vertex_ && parent == parent_) return;
  const PatchLayer& second = data_.second;
  const AccessBounds& bounds = data_.access_bounds;
  vertex_ = no_index;
  parent_ = parent;
  scale_ = data_.first.scale[parent];
  bound_unit_ = AccessBounds::unit(scale_);
  table_ = data_.first.line(parent, 0);
  table_rows_ = data_.first.border_size(parent);
  parts_.clear();
  seed_distance_.clear();
  seed_bound_.clear();
  column_.clear();
  place_.clear();
  if (end.patch == no_index) {
    for (std::size_t i = 0; i < end.seeds.size(); ++i) {
      for (const PatchRow& at : second.patches_of(end.seeds[i].node)) {
        if (data_.partition.parent[at.patch] != parent) continue;
        auto part = std::ranges::find(parts_, at.patch, &Part::patch);
        if (part == parts_.end()) part = add_part(at.patch);
        add_seed(part->begin + at.row, end.seeds[i].distance, i);
        break;
      }
    }
  } else {
    // The seeds are the rows of the patch in their order, without those at an infinite distance.
    const auto nodes = second.nodes(end.patch);
    add_part(end.patch);
    for (std::size_t row = 0, i = 0; i < end.seeds.size(); ++row) {
      if (end.seeds[i].node != nodes[row]) continue;
      add_seed(static_cast<Index>(row), end.seeds[i].distance, i);
      ++i;
    }
  }
  const std::size_t count = groups().size();
  least_bound_.resize(2 * count);
  std::uint8_t* const of_part = least_bound_.data() + count;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    least_byte_sums(bounds_of(part, 0), static_cast<Index>(count), part.rows, seed_bound_.data() + part.begin,
                    lanes_of(part), i == 0 ? least_bound_.data() : of_part);
    for (std::size_t g = 0; i > 0 && g < count; ++g) least_bound_[g] = std::min(least_bound_[g], of_part[g]);
  }
  least_.resize(count);
  to_border_.assign(bounds.width(parent), static_cast<std::int16_t>(greatest_to_border));
  const float per_unit = bounds.unit_between > 0.0f ? 1.0f / bounds.unit_between : 0.0f;
  for (std::size_t g = 0; g < count; ++g) {
    least_[g] = parts_.empty() ? unreachable_float : bound_unit_ * static_cast<float>(least_bound_[g]);
    if (parts_.empty()) continue;
    to_border_[g] = static_cast<std::int16_t>(std::min(least_[g] * per_unit, greatest_to_border));
  }
  refined_.assign(count, 0.0f);
  distance_.assign(table_rows_, unreachable_float);
  vertex_ = end.vertex;
}

/// Lanes of seeds whose bounds lead to a group within the limit, in their order.
std::span<const Index> AccessDistances::lanes_within(std::size_t group, std::uint8_t limit) {
  flags_.resize(seed_bound_.size());
  lanes_.resize(seed_bound_.size());
  for (const Part& part : parts_) {
    byte_sums_within(bounds_of(part, group), seed_bound_.data() + part.begin, lanes_of(part), limit,
                     flags_.data() + part.begin);
  }
  std::size_t count = 0;
  for_each_flag(flags_.data(), static_cast<Index>(flags_.size()), [&](Index lane) {
    lanes_[count] = lane;
    count += seed_distance_[lane] < unreachable_float ? 1 : 0;
  });
  return {lanes_.data(), count};
}

void AccessDistances::prefetch(std::size_t group, float limit) {
  if (parts_.empty() || limit <= refined_[group]) return;
  for (const Index lane : lanes_within(group, in_bounds(limit))) prefetch_line(piece(lane, group));
}

void AccessDistances::refine(std::size_t group, float limit) {
  if (parts_.empty() || !(least_[group] < limit) || limit <= refined_[group]) return;
  const GroupRows& at = groups()[group];
  const Index size = data_.transit_table.size(at.group);
  // Eight rows at once: a smaller group is scanned together with rows next to it, whose distances may stay
  // too long.
  const Index columns = std::min(table_rows_, TransitTable::group_size);
  const Index row = std::min(at.row, table_rows_ - columns);
  const Index first = at.row - row;
  for (const Part& part : parts_) {
    for (Index begin = 0; begin < lanes_of(part); begin += max_lanes) {
      const Index lane = part.begin + begin;
      const SeedLanes seeds{seed_distance_.data() + lane, seed_bound_.data() + lane, column_.data() + lane,
                            std::min(max_lanes, lanes_of(part) - begin)};
      relax_within(seeds, bounds_of(part, group) + begin, table_ + row, table_rows_, scale_, bound_unit_,
                   limit, columns, first, first + size, distance_.data() + row);
    }
  }
  const float* found = distances(group);
  const auto [least, farthest] = std::minmax_element(found, found + size);
  refined_[group] = limit < *farthest ? limit : unreachable_float;
  least_[group] = std::max(least_[group], std::min(*least, refined_[group]));
}

Index AccessDistances::seed_of(std::size_t group, Index row) {
  Index best = 0;
  float least = unreachable_float;
  const Index in_group = row - groups()[group].row;
  // The distance may have been rounded differently.
  constexpr float slack = 1.000001f;
  for (const Index lane : lanes_within(group, in_bounds(distance_[row] * slack))) {
    const std::uint16_t entry = piece(lane, group)[in_group];
    if (entry == PatchLayer::infinite_entry) continue;
    const float sum = seed_distance_[lane] + scale_.distance(entry);
    if (!(sum < least)) continue;
    least = sum;
    best = place_[lane];
  }
  return best;
}

}  // namespace vorogeo
