// Routes through the transit table, from the access distances of both ends.
#include "query/table_route.h"

#include <algorithm>
#include <utility>

#include "index/scans.h"
#include "support/processor.h"

namespace vorogeo {

// ---- For each group, seeds that cannot matter to it are skipped

namespace {

/// Half of the greatest bound between borders: the sum of one such bound and two to borders has 15 bits.
constexpr float greatest_to_border = 8191.0f;
/// Bounds and distances are rounded differently, by far less than this.
constexpr float rounding_slack = 1.000001f;

}  // namespace

/// A distance in units of the bounds, rounded down and clamped.
std::uint8_t AccessDistances::in_bounds(float distance) const {
  return bound_unit_ > 0.0f ? static_cast<std::uint8_t>(std::min(distance / bound_unit_, 255.0f))
                            : AccessBounds::infinite_entry;
}

std::vector<AccessDistances::Part>::iterator AccessDistances::add_part(Index patch) {
  const auto begin = static_cast<Index>(seed_bound_.size());
  const Index rows = data_.second.border_size(patch);
  parts_.push_back({patch, begin, rows});
  const Index lanes = lanes_of(parts_.back());
  seed_distance_.resize(begin + lanes, unreachable_float);
  seed_bound_.resize(begin + lanes, AccessBounds::infinite_entry);
  place_.resize(begin + lanes, no_index);
  const Index* columns = data_.parent_column.data() + data_.second.border.begin[patch];
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

/// Lanes, ascending, of the seeds whose bounds of the distance to a group are within the limit.
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
  for (const Index lane : lanes_within(group, in_bounds(distance_[row] * rounding_slack))) {
    const std::uint16_t entry = piece(lane, group)[in_group];
    if (entry == PatchLayer::infinite_entry) continue;
    const float sum = seed_distance_[lane] + scale_.distance(entry);
    if (!(sum < least)) continue;
    least = sum;
    best = place_[lane];
  }
  return best;
}

// ---- First bounds for all cells between two first-layer borders, then the cells that these do not exclude

namespace {

/// This many cells are examined in the order of their bounds.
constexpr std::size_t first_cells = 4;

}  // namespace

/// A length in units of the bounds between borders, rounded down.
std::int16_t TableRouter::in_bounds(float length) const {
  constexpr float greatest = 32767.0f;
  const float unit = data_.access_bounds.unit_between;
  return static_cast<std::int16_t>(unit > 0.0f ? std::min(length * rounding_slack / unit, greatest)
                                               : greatest);
}

/// What remains of the least sum of bounds over a group after the bound of the distance to the group.
float TableRouter::rest(const AccessDistances& end, std::size_t group, std::int16_t least) const {
  return data_.access_bounds.unit_between * static_cast<float>(least - end.bounds_to_border()[group]);
}

/// The best sum in one cell, if it is better than the best so far; its rows are found later.
void TableRouter::look_into(AccessDistances& low, AccessDistances& high, const Candidate& candidate,
                            Joint& best) {
  const TransitTable& table = data_.transit_table;
  const auto i = static_cast<std::size_t>(candidate.group[0]);
  const auto j = static_cast<std::size_t>(candidate.group[1]);
  const Index from = low.groups()[i].group;
  const Index to = high.groups()[j].group;
  const float offset = table.least_from(from)[to];
  const float limit = best.length * rounding_slack;
  low.refine(i, limit - rest(low, i, low_least_[i]));
  if (!(low.least()[i] + offset + high.least()[j] < limit)) return;
  high.refine(j, limit - rest(high, j, high_least_[j]));
  if (!(low.least()[i] + offset + high.least()[j] < limit)) return;
  const float least = offset + least_in_cell(table.cell(from, to), table.size(from), table.size(to),
                                             low.distances(i), high.distances(j), table.scale);
  // Of equal sums the first, so that the route does not depend on what was known before.
  const bool is_first = std::pair(i, j) < std::pair(best.group[0], best.group[1]);
  if (!(least < best.length || (least == best.length && is_first))) return;
  best = {least, {i, j}, {low.groups()[i].row, high.groups()[j].row}};
}

/// Computes the sums of the best cell again, to find where the least one is; they may be rounded differently
/// here.
void TableRouter::find_rows(const AccessDistances& low, const AccessDistances& high, Joint& best) const {
  const TransitTable& table = data_.transit_table;
  const GroupRows& from = low.groups()[best.group[0]];
  const GroupRows& to = high.groups()[best.group[1]];
  const float* before = low.distances(best.group[0]);
  const float* beyond = high.distances(best.group[1]);
  const std::uint16_t* entry = table.cell(from.group, to.group);
  float found = unreachable_float;
  for (Index i = 0; i < table.size(from.group); ++i) {
    for (Index j = 0; j < table.size(to.group); ++j, ++entry) {
      if (*entry == TransitTable::infinite_entry) continue;
      const float sum = before[i] + table.scale.distance(*entry) + beyond[j];
      if (!(sum < found)) continue;
      found = sum;
      best.row[0] = from.row + i;
      best.row[1] = to.row + j;
    }
  }
}

/// The best pair of rows for the access distances of both ends; without rows if none is shorter than
/// `length`.
TableRouter::Joint TableRouter::join(AccessDistances& low, AccessDistances& high, float length) {
  const TransitTable& table = data_.transit_table;
  const AccessBounds& bounds = data_.access_bounds;
  const auto rows = static_cast<Index>(low.groups().size());
  const auto columns = static_cast<Index>(high.groups().size());
  const Index width = bounds.width(high.parent());
  const std::int16_t* between = bounds.between(low.parent(), high.parent());
  const std::int16_t* to_low = low.bounds_to_border().data();
  const std::int16_t* to_high = high.bounds_to_border().data();
  Joint best{length};
  if (rows == 0 || columns == 0) return best;
  low_least_.resize(rows);
  high_least_.resize(width);
  within_.resize(width);
  least_short_sums(to_low, between, to_high, rows, width, low_least_.data(), high_least_.data());
  const auto lowest = static_cast<Index>(std::ranges::min_element(low_least_) - low_least_.begin());
  std::int16_t max_bound = in_bounds(best.length);
  if (low_least_[lowest] > max_bound) return best;
  // Calls visit(column, bound) where a row has a sum of at most `limit`.
  const auto for_each_within = [&](Index row, std::int16_t limit, auto&& visit) {
    const std::int16_t* of_row = between + static_cast<std::size_t>(row) * width;
    short_sums_within(of_row, to_high, width, static_cast<std::int16_t>(limit - to_low[row]), within_.data());
    for_each_flag(within_.data(), width, [&](Index column) {
      if (column >= columns) return;
      visit(static_cast<std::int16_t>(column),
            static_cast<std::int16_t>(to_low[row] + of_row[column] + to_high[column]));
    });
  };
  Candidate likely{low_least_[lowest], {static_cast<std::int16_t>(lowest), 0}};
  for_each_within(lowest, low_least_[lowest], [&](std::int16_t column, std::int16_t) {
    likely.group[1] = std::max(likely.group[1], column);
  });
  look_into(low, high, likely, best);
  candidates_.clear();
  max_bound = in_bounds(best.length);
  for (Index row = 0; row < rows; ++row) {
    if (low_least_[row] > max_bound) continue;
    for_each_within(row, max_bound, [&](std::int16_t column, std::int16_t bound) {
      candidates_.push_back({bound, {static_cast<std::int16_t>(row), column}});
      // A row of a cell has 16 bytes, so that a full cell lies in three cache lines at most.
      const auto* cell =
          reinterpret_cast<const char*>(table.cell(low.groups()[row].group, high.groups()[column].group));
      for (int line : {0, 64, 127}) prefetch_line(cell + line);
    });
  }
  const float limit = best.length * rounding_slack;
  for (Index row = 0; row < rows; ++row) {
    if (low_least_[row] <= max_bound) low.prefetch(row, limit - rest(low, row, low_least_[row]));
  }
  for (Index column = 0; column < columns; ++column) {
    if (high_least_[column] <= max_bound)
      high.prefetch(column, limit - rest(high, column, high_least_[column]));
  }
  // The most promising cells first: they exclude others.
  const auto by_bound = [](const Candidate& a, const Candidate& b) { return a.bound < b.bound; };
  const std::size_t promising = std::min<std::size_t>(candidates_.size(), first_cells);
  std::partial_sort(candidates_.begin(), candidates_.begin() + promising, candidates_.end(), by_bound);
  for (const Candidate& candidate : candidates_) {
    if (candidate.bound <= in_bounds(best.length)) look_into(low, high, candidate, best);
  }
  if (best.row[0] != no_index) find_rows(low, high, best);
  return best;
}

void TableRouter::route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result) {
  const PatchLayer& first = data_.first;
  if (data_.transit_table.count == 0) return;
  auto length = static_cast<float>(result.length);
  for (Index source_parent : source.parents) {
    from_.reset(source, source_parent);
    for (Index target_parent : target.parents) {
      to_.reset(target, target_parent);
      // Bounds between borders are stored for pairs of patches with the smaller number first.
      const std::size_t at_source = source_parent <= target_parent ? 0 : 1;
      const Joint best = at_source == 0 ? join(from_, to_, length) : join(to_, from_, length);
      if (best.row[0] == no_index) continue;
      const std::size_t at_target = 1 - at_source;
      length = best.length;
      result.length = static_cast<double>(best.length);
      // The four nodes of the route; those that coincide appear once.
      result.nodes.clear();
      result.legs.clear();
      auto second_node = [&](Index parent, Index row) { return data_.second_node[first.nodes(parent)[row]]; };
      result.nodes.push_back(source.seeds[from_.seed_of(best.group[at_source], best.row[at_source])].node);
      result.go_on(Leg{Leg::Table::first, source_parent}, second_node(source_parent, best.row[at_source]));
      result.go_on(Leg{Leg::Table::transit}, second_node(target_parent, best.row[at_target]));
      result.go_on(Leg{Leg::Table::first, target_parent},
                   target.seeds[to_.seed_of(best.group[at_target], best.row[at_target])].node);
    }
  }
}

}  // namespace vorogeo
