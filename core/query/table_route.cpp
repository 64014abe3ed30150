// Bounds for all cells between the borders of two first-layer patches, then the cells that are left.
#include "query/table_route.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "support/min_plus.h"
#include "support/prefetch.h"

namespace vorogeo {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

/// Cells that are taken in the order of their bounds.
constexpr std::size_t first_cells = 4;

/// Bounds and distances are rounded in different ways, by far less than this.
constexpr float rounding_slack = 1.000001f;

}  // namespace

/// The best pair of rows in one cell, if it is better than what is known.
void TableRouter::look_into(const Candidate& candidate, Joint& best) {
  const NodeTable& table = data_.node_table;
  const auto i = static_cast<std::size_t>(candidate.source_group);
  const auto j = static_cast<std::size_t>(candidate.target_group);
  const GroupRows& source = from_.groups()[i];
  const GroupRows& target = to_.groups()[j];
  const float offset = table.least_from(source.group)[target.group];
  const float limit = best.length * rounding_slack;
  from_.refine(i, limit - rest_of_source_[i]);
  if (!(from_.least()[i] + offset + to_.least()[j] < limit)) return;
  to_.refine(j, limit - rest_of_target_[j]);
  if (!(from_.least()[i] + offset + to_.least()[j] < limit)) return;
  ++cells_;
  const float* source_distance = from_.distances(i);
  const float* target_distance = to_.distances(j);
  const Index rows = table.size(source.group);
  const Index columns = table.size(target.group);
  const std::uint16_t* cell = table.cell(source.group, target.group);
  const float least = least_in_cell(cell, rows, columns, source_distance, target_distance, table.unit);
  // Of equal sums the first, so that what was known before has no influence on the route.
  const bool is_first = std::pair(i, j) < std::pair(best.source_group, best.target_group);
  if (!(least + offset < best.length || (least + offset == best.length && is_first))) return;
  // The sums again, to find where the least one is; they may be rounded in another way here.
  float found = infinite;
  for (Index row = 0; row < rows; ++row) {
    for (Index column = 0; column < columns; ++column) {
      const std::uint16_t entry = cell[row * columns + column];
      if (entry == NodeTable::no_way) continue;
      const float sum =
          source_distance[row] + table.unit * static_cast<float>(entry) + target_distance[column];
      if (!(sum < found)) continue;
      found = sum;
      best.source_row = source.row + row;
      best.target_row = target.row + column;
    }
  }
  best.source_group = i;
  best.target_group = j;
  best.length = least + offset;
}

/// The best pair of rows for the two approaches; without rows if none is shorter than `length`.
TableRouter::Joint TableRouter::join(float length) {
  const NodeTable& table = data_.node_table;
  const auto sources = from_.groups();
  const auto targets = to_.groups();
  const auto width = static_cast<Index>(targets.size());
  sums_.resize(sources.size() * targets.size());
  row_least_.resize(sources.size());
  rest_of_source_.resize(sources.size());
  rest_of_target_.assign(targets.size(), infinite);
  std::size_t lowest = 0;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const float* least = table.least_from(sources[i].group);
    float* sums = sums_.data() + i * targets.size();
    row_least_[i] = infinite;
    for (const Approach::Run& run : to_.runs()) {
      const Index j = run.begin;
      row_least_[i] = std::min(row_least_[i],
                               add_bounds(from_.least()[i], least + targets[j].group, to_.least().data() + j,
                                          run.end - run.begin, sums + j, rest_of_target_.data() + j));
    }
    if (row_least_[i] < row_least_[lowest]) lowest = i;
  }
  Joint best{length};
  if (sources.empty() || !(row_least_[lowest] < best.length * rounding_slack)) return best;
  // What is left of a sum after the way to the group.
  for (std::size_t i = 0; i < sources.size(); ++i) rest_of_source_[i] = row_least_[i] - from_.least()[i];
  for (std::size_t j = 0; j < targets.size(); ++j) rest_of_target_[j] -= to_.least()[j];
  const float* row = sums_.data() + lowest * targets.size();
  look_into({row_least_[lowest], static_cast<Index>(lowest),
             static_cast<Index>(std::min_element(row, row + width) - row)},
            best);
  candidates_.clear();
  const float most = best.length * rounding_slack;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (!(row_least_[i] < most)) continue;
    const float* sums = sums_.data() + i * targets.size();
    for (Index j = 0; j < width; ++j) {
      if (!(sums[j] < most)) continue;
      candidates_.push_back({sums[j], static_cast<Index>(i), j});
      // Rows of a cell are 16 bytes, so that a full one lies in three lines at most.
      const auto* cell = reinterpret_cast<const char*>(table.cell(sources[i].group, targets[j].group));
      for (int line : {0, 64, 127}) prefetch_line(cell + line);
      from_.prefetch(i);
      to_.prefetch(j);
    }
  }
  // The most promising first: they save others.
  const auto lower = [](const Candidate& a, const Candidate& b) { return a.bound < b.bound; };
  const std::size_t promising = std::min<std::size_t>(candidates_.size(), first_cells);
  std::partial_sort(candidates_.begin(), candidates_.begin() + promising, candidates_.end(), lower);
  for (const Candidate& candidate : candidates_) {
    if (candidate.bound < best.length * rounding_slack) look_into(candidate, best);
  }
  return best;
}

bool TableRouter::route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result, double below) {
  const PatchLayer& first = data_.first;
  cells_ = 0;
  if (data_.node_table.count == 0) return false;
  auto length = static_cast<float>(below);
  bool found = false;
  for (Index source_parent : source.parents) {
    from_.start(source, source_parent);
    for (Index target_parent : target.parents) {
      to_.start(target, target_parent);
      const Joint best = join(length);
      if (best.source_row == no_index) continue;
      found = true;
      length = best.length;
      result.length = static_cast<double>(best.length);
      // The four nodes of the route; those that coincide appear once.
      result.nodes.clear();
      result.arc_patches.clear();
      auto visit = [&](Index node, Index arc_patch) {
        if (!result.nodes.empty() && result.nodes.back() == node) return;
        if (!result.nodes.empty()) result.arc_patches.push_back(arc_patch);
        result.nodes.push_back(node);
      };
      auto second_node = [&](Index parent, Index row) {
        return data_.second.vertex_node[first.node_vertex[first.nodes(parent)[row]]];
      };
      visit(source.starts[from_.start_of(best.source_group, best.source_row)].node, no_index);
      visit(second_node(source_parent, best.source_row), -1 - source_parent);
      visit(second_node(target_parent, best.target_row), by_node_table);
      visit(target.starts[to_.start_of(best.target_group, best.target_row)].node, -1 - target_parent);
    }
  }
  return found;
}

}  // namespace vorogeo
