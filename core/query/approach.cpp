// Starts are passed over for the groups they cannot serve.
#include "query/approach.h"

#include <algorithm>
#include <limits>

#include "support/min_plus.h"
#include "support/prefetch.h"

namespace vorogeo {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr float greatest_bound = 255.0f;
/// Of two bounds: a way to a far start and on through the patch may be longer than any entry of its table.
constexpr float greatest_sum = 2 * greatest_bound;

}  // namespace

/// A distance in units of the bounds, rounded down; at most `greatest`, which it is without a unit.
int Approach::in_bounds(float distance, float greatest) const {
  return static_cast<int>(bound_unit_ > 0.0f ? std::min(distance / bound_unit_, greatest) : greatest);
}

void Approach::add_start(Index column, double distance, std::size_t place) {
  line_.push_back(data_.first.line(parent_, column));
  bounds_.push_back(data_.approach_bounds.of_member(parent_, column));
  prefetch_line(bounds_.back());
  const auto rounded = static_cast<float>(distance);
  start_distance_.push_back(rounded);
  start_bound_.push_back(
      static_cast<std::uint8_t>(bound_unit_ > 0.0f ? in_bounds(rounded, greatest_bound) : 0));
  place_.push_back(static_cast<Index>(place));
}

void Approach::start(const RouteEnd& end, Index parent) {
  if (end.vertex != no_index && end.vertex == vertex_ && parent == parent_) return;
  const PatchLayer& second = data_.second;
  vertex_ = no_index;
  parent_ = parent;
  unit_ = data_.first.unit[parent];
  bound_unit_ = unit_ * ApproachBounds::step;
  line_.clear();
  bounds_.clear();
  start_distance_.clear();
  start_bound_.clear();
  place_.clear();
  if (end.patch == no_index) {
    for (std::size_t i = 0; i < end.starts.size(); ++i) {
      for (const PatchRow& at : second.patches_of(end.starts[i].node)) {
        if (data_.partition.parent[at.patch] != parent) continue;
        add_start(data_.parent_column[second.border_begin[at.patch] + at.row], end.starts[i].distance, i);
        break;
      }
    }
  } else {
    // The starts are the rows of the patch in their order, without those at an infinite distance.
    const auto nodes = second.nodes(end.patch);
    const Index* columns = data_.parent_column.data() + second.border_begin[end.patch];
    for (std::size_t row = 0, i = 0; i < end.starts.size(); ++row) {
      if (end.starts[i].node != nodes[row]) continue;
      add_start(columns[row], end.starts[i].distance, i);
      ++i;
    }
  }
  const auto of_parent = groups();
  const std::size_t count = of_parent.size();
  runs_.clear();
  for (std::size_t g = 0; g < count; ++g) {
    const auto at = static_cast<Index>(g);
    if (g == 0 || of_parent[g].group != of_parent[g - 1].group + 1) runs_.push_back({at, at});
    runs_.back().end = at + 1;
  }
  const std::size_t padded = count + bounds_at_once;
  least_bound_.resize(padded);
  best_start_.resize(padded);
  least_.resize(count);
  refined_.assign(count, 0.0f);
  distance_.assign(data_.first.border_size(parent), infinite);
  least_bounds(bounds_.data(), start_bound_.data(), static_cast<Index>(line_.size()),
               static_cast<Index>(count), least_bound_.data(), best_start_.data());
  for (std::size_t g = 0; g < count; ++g) {
    least_[g] = line_.empty() ? infinite : bound_unit_ * static_cast<float>(least_bound_[g]);
  }
  vertex_ = end.vertex;
}

void Approach::prefetch(std::size_t group) const {
  if (refined_[group] > 0.0f || line_.empty()) return;
  prefetch_line(line_[best_start(group)] + groups()[group].row);
}

void Approach::refine(std::size_t group, float limit) {
  if (line_.empty() || !(least_[group] < limit) || limit <= refined_[group]) return;
  const GroupRows& at = groups()[group];
  const Index size = data_.node_table.size(at.group);
  float* found = distance_.data() + at.row;
  // From the best start first: most of the others are then known to be of no use.
  const std::size_t best = best_start(group);
  const std::uint16_t* first_piece = line_[best] + at.row;
  lower_by_pieces(&first_piece, &start_distance_[best], 1, unit_, size, found);
  const float farthest = *std::max_element(found, found + size);
  refined_[group] = limit < farthest ? limit : infinite;
  limit = std::min(limit, farthest);
  const int limit_bound = in_bounds(limit, greatest_sum);
  piece_.clear();
  base_.clear();
  for (std::size_t i = 0; i < line_.size(); ++i) {
    if (start_bound_[i] + bounds_[i][group] > limit_bound || i == best) continue;
    piece_.push_back(line_[i] + at.row);
    prefetch_line(piece_.back());
    base_.push_back(start_distance_[i]);
  }
  lower_by_pieces(piece_.data(), base_.data(), static_cast<Index>(piece_.size()), unit_, size, found);
  least_[group] = std::max(least_[group], std::min(*std::min_element(found, found + size), refined_[group]));
}

Index Approach::start_of(std::size_t group, Index row) const {
  Index best = 0;
  float least = infinite;
  int least_bound = static_cast<int>(greatest_sum);
  for (std::size_t i = 0; i < line_.size(); ++i) {
    if (start_bound_[i] + bounds_[i][group] > least_bound) continue;
    const std::uint16_t entry = line_[i][row];
    if (entry == PatchLayer::no_way) continue;
    const float sum = start_distance_[i] + unit_ * static_cast<float>(entry);
    if (!(sum < least)) continue;
    least = sum;
    least_bound = in_bounds(sum, greatest_sum);
    best = place_[i];
  }
  return best;
}

}  // namespace vorogeo
