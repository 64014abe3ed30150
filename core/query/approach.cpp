// Starts are passed over for the groups they cannot serve.
#include "query/approach.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

#include "support/bound_scans.h"
#include "support/min_plus.h"
#include "support/prefetch.h"

namespace vorogeo {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr std::uint8_t greatest_bound = 255;
/// Half of what bounds between borders go up to: the sum of one of these and two of those stays in 15 bits.
constexpr float greatest_to_border = 8191.0f;

}  // namespace

/// A distance in units of the bounds, rounded down and cut off.
std::uint8_t Approach::in_bounds(float distance) const {
  return bound_unit_ > 0.0f ? static_cast<std::uint8_t>(std::min(distance / bound_unit_, 255.0f))
                            : greatest_bound;
}

std::vector<Approach::Part>::iterator Approach::add_part(Index patch) {
  const auto begin = static_cast<Index>(start_bound_.size());
  const Index rows = data_.second.border_size(patch);
  const Index lanes = (rows + byte_lanes - 1) / byte_lanes * byte_lanes;
  parts_.push_back({patch, begin, rows});
  start_distance_.resize(begin + lanes, infinite);
  start_bound_.resize(begin + lanes, greatest_bound);
  place_.resize(begin + lanes, no_index);
  const Index* columns = data_.parent_column.data() + data_.second.border_begin[patch];
  column_.insert(column_.end(), columns, columns + rows);
  column_.resize(begin + lanes, 0);
  return parts_.end() - 1;
}

void Approach::add_start(Index lane, double distance, std::size_t place) {
  const auto rounded = static_cast<float>(distance);
  if (!(rounded < start_distance_[lane])) return;
  start_distance_[lane] = rounded;
  start_bound_[lane] = bound_unit_ > 0.0f ? in_bounds(rounded) : std::uint8_t{0};
  place_[lane] = static_cast<Index>(place);
}

void Approach::start(const RouteEnd& end, Index parent) {
  if (end.vertex != no_index && end.vertex == vertex_ && parent == parent_) return;
  const PatchLayer& second = data_.second;
  const ApproachBounds& bounds = data_.approach_bounds;
  vertex_ = no_index;
  parent_ = parent;
  unit_ = data_.first.unit[parent];
  bound_unit_ = unit_ * ApproachBounds::step;
  table_ = data_.first.line(parent, 0);
  table_rows_ = data_.first.border_size(parent);
  parts_.clear();
  start_distance_.clear();
  start_bound_.clear();
  column_.clear();
  place_.clear();
  if (end.patch == no_index) {
    for (std::size_t i = 0; i < end.starts.size(); ++i) {
      for (const PatchRow& at : second.patches_of(end.starts[i].node)) {
        if (data_.partition.parent[at.patch] != parent) continue;
        auto part = std::ranges::find(parts_, at.patch, &Part::patch);
        if (part == parts_.end()) part = add_part(at.patch);
        add_start(part->begin + at.row, end.starts[i].distance, i);
        break;
      }
    }
  } else {
    // The starts are the rows of the patch in their order, without those at an infinite distance.
    const auto nodes = second.nodes(end.patch);
    add_part(end.patch);
    for (std::size_t row = 0, i = 0; i < end.starts.size(); ++row) {
      if (end.starts[i].node != nodes[row]) continue;
      add_start(static_cast<Index>(row), end.starts[i].distance, i);
      ++i;
    }
  }
  const std::size_t count = groups().size();
  least_bound_.resize(2 * count);
  std::uint8_t* const of_part = least_bound_.data() + count;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    const Index lanes = (part.rows + byte_lanes - 1) / byte_lanes * byte_lanes;
    least_byte_sums(bounds.of_patch(part.patch), static_cast<Index>(count), part.rows,
                    start_bound_.data() + part.begin, lanes, i == 0 ? least_bound_.data() : of_part);
    for (std::size_t g = 0; i > 0 && g < count; ++g) least_bound_[g] = std::min(least_bound_[g], of_part[g]);
  }
  least_.resize(count);
  to_border_.assign(bounds.width(parent), static_cast<std::int16_t>(greatest_to_border));
  const float per_unit = bounds.unit_between > 0.0f ? 1.0f / bounds.unit_between : 0.0f;
  for (std::size_t g = 0; g < count; ++g) {
    least_[g] = parts_.empty() ? infinite : bound_unit_ * static_cast<float>(least_bound_[g]);
    if (parts_.empty()) continue;
    to_border_[g] = static_cast<std::int16_t>(std::min(least_[g] * per_unit, greatest_to_border));
  }
  best_lane_.assign(count, no_index);
  refined_.assign(count, 0.0f);
  distance_.assign(table_rows_, infinite);
  vertex_ = end.vertex;
}

/// Lanes of starts whose bounds lead to a group within the limit, in their order.
std::span<const Index> Approach::lanes_within(std::size_t group, std::uint8_t limit) {
  flags_.resize(start_bound_.size());
  lanes_.resize(start_bound_.size());
  for (const Part& part : parts_) {
    const Index lanes = (part.rows + byte_lanes - 1) / byte_lanes * byte_lanes;
    byte_sums_within(data_.approach_bounds.of_patch(part.patch) + group * part.rows,
                     start_bound_.data() + part.begin, lanes, limit, flags_.data() + part.begin);
  }
  std::size_t count = 0;
  for (std::size_t begin = 0; begin < flags_.size(); begin += sizeof(std::uint64_t)) {
    std::uint64_t flags;
    std::memcpy(&flags, flags_.data() + begin, sizeof(flags));
    for (; flags != 0; flags &= flags - 1) {
      const auto lane = static_cast<Index>(begin) + std::countr_zero(flags) / 8;
      lanes_[count] = lane;
      count += start_distance_[lane] < infinite ? 1 : 0;
    }
  }
  return {lanes_.data(), count};
}

void Approach::prefetch(std::size_t group) {
  if (refined_[group] > 0.0f || best_lane_[group] != no_index || parts_.empty()) return;
  const auto lanes = lanes_within(group, least_bound_[group]);
  if (lanes.empty()) return;
  best_lane_[group] = lanes.front();
  prefetch_line(piece(lanes.front(), group));
}

void Approach::refine(std::size_t group, float limit) {
  if (parts_.empty() || !(least_[group] < limit) || limit <= refined_[group]) return;
  const GroupRows& at = groups()[group];
  const Index size = data_.node_table.size(at.group);
  float* found = distance_.data() + at.row;
  // From the best start first: most of the others are then known to be of no use.
  prefetch(group);
  const Index best = best_lane_[group];
  if (best != no_index) {
    const std::uint16_t* first_piece = piece(best, group);
    lower_by_pieces(&first_piece, &start_distance_[best], 1, unit_, size, found);
  }
  const float farthest = *std::max_element(found, found + size);
  refined_[group] = limit < farthest ? limit : infinite;
  limit = std::min(limit, farthest);
  piece_.clear();
  base_.clear();
  for (const Index lane : lanes_within(group, in_bounds(limit))) {
    if (lane == best) continue;
    piece_.push_back(piece(lane, group));
    prefetch_line(piece_.back());
    base_.push_back(start_distance_[lane]);
  }
  lower_by_pieces(piece_.data(), base_.data(), static_cast<Index>(piece_.size()), unit_, size, found);
  least_[group] = std::max(least_[group], std::min(*std::min_element(found, found + size), refined_[group]));
}

Index Approach::start_of(std::size_t group, Index row) {
  Index best = 0;
  float least = infinite;
  const Index in_group = row - groups()[group].row;
  // The distance may have been rounded in another way.
  constexpr float slack = 1.000001f;
  for (const Index lane : lanes_within(group, in_bounds(distance_[row] * slack))) {
    const std::uint16_t entry = piece(lane, group)[in_group];
    if (entry == PatchLayer::no_way) continue;
    const float sum = start_distance_[lane] + unit_ * static_cast<float>(entry);
    if (!(sum < least)) continue;
    least = sum;
    best = place_[lane];
  }
  return best;
}

}  // namespace vorogeo
