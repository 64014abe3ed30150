// Min-plus scans over the tables of two first-layer patches and the cells between their borders.
#include "query/table_route.h"

#include <algorithm>
#include <limits>

#include "support/min_plus.h"

namespace vorogeo {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

}  // namespace

TableRouter::TableRouter(const IndexData& data) : data_(data) {
  const NodeTable& table = data.node_table;
  if (table.count == 0) return;
  groups_.resize(data.first.patch_count);
  for (Index p = 0; p < data.first.patch_count; ++p) {
    const auto nodes = data.first.nodes(p);
    for (std::size_t row = 0; row < nodes.size(); ++row) {
      const Index group = table.group_of[nodes[row]];
      // The nodes of a group belong to the same patches, so they are rows one after the other.
      if (groups_[p].empty() || groups_[p].back().group != group) {
        groups_[p].push_back({group, static_cast<Index>(row)});
      }
    }
  }
}

/// Column of a start in the table of a first-layer patch; no_index if it is not in the patch.
Index TableRouter::column_of(const RouteEnd::Start& start, Index parent) const {
  for (const PatchRow& at : data_.second.patches_of(start.node)) {
    if (data_.partition.parent[at.patch] != parent) continue;
    return data_.parent_column[data_.second.border_begin[at.patch] + at.row];
  }
  return no_index;
}

void TableRouter::approach(const RouteEnd& end, Index parent, Approach& result) const {
  const Index rows = data_.first.border_size(parent);
  result.parent = parent;
  result.distance.assign(rows, infinite);
  for (const RouteEnd::Start& start : end.starts) {
    const Index column = column_of(start, parent);
    if (column == no_index) continue;
    lower_by_entries(data_.first.line(parent, column), data_.first.unit[parent],
                     static_cast<float>(start.distance), rows, result.distance.data());
  }
  result.least.clear();
  for (const GroupRows& at : groups_[parent]) {
    const float* first = result.distance.data() + at.row;
    result.least.push_back(*std::min_element(first, first + data_.node_table.size(at.group)));
  }
}

/// The best pair of rows in one cell, if it is better than what is known.
void TableRouter::look_into(std::size_t from, std::size_t to, Joint& best) const {
  const NodeTable& table = data_.node_table;
  const GroupRows& source = groups_[from_.parent][from];
  const GroupRows& target = groups_[to_.parent][to];
  const float* source_distance = from_.distance.data() + source.row;
  const float* target_distance = to_.distance.data() + target.row;
  const Index rows = table.size(source.group);
  const Index columns = table.size(target.group);
  const float offset = table.least_from(source.group)[target.group];
  const std::uint16_t* cell = table.cell(source.group, target.group);
  const float least = least_in_cell(cell, rows, columns, source_distance, target_distance, table.unit);
  if (!(least + offset < best.length)) return;
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
  best.length = least + offset;
}

/// The best pair of rows for the two approaches; without rows if none is shorter than `length`.
TableRouter::Joint TableRouter::join(float length) {
  const NodeTable& table = data_.node_table;
  const auto& sources = groups_[from_.parent];
  const auto& targets = groups_[to_.parent];
  bounds_.resize(sources.size() * targets.size());
  float lowest = infinite;
  std::size_t lowest_at = 0;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const float* between = table.least_from(sources[i].group);
    float* bounds = bounds_.data() + i * targets.size();
    for (std::size_t j = 0; j < targets.size(); ++j) {
      bounds[j] = from_.least[i] + between[targets[j].group] + to_.least[j];
    }
    const float* least = std::min_element(bounds, bounds + targets.size());
    if (*least < lowest) {
      lowest = *least;
      lowest_at = static_cast<std::size_t>(least - bounds_.data());
    }
  }
  Joint best{length};
  if (!(lowest < best.length)) return best;
  look_into(lowest_at / targets.size(), lowest_at % targets.size(), best);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const float* bounds = bounds_.data() + i * targets.size();
    for (std::size_t j = 0; j < targets.size(); ++j) {
      if (bounds[j] < best.length) look_into(i, j, best);
    }
  }
  return best;
}

/// The start over which an end reaches a row.
const RouteEnd::Start& TableRouter::start_of(const RouteEnd& end, Index parent, Index row) const {
  const RouteEnd::Start* best = &end.starts.front();
  double least = unreachable;
  for (const RouteEnd::Start& start : end.starts) {
    const Index column = column_of(start, parent);
    if (column == no_index) continue;
    const double sum = start.distance + static_cast<double>(data_.first.distance(parent, row, column));
    if (!(sum < least)) continue;
    least = sum;
    best = &start;
  }
  return *best;
}

void TableRouter::route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result) {
  const PatchLayer& first = data_.first;
  result.length = unreachable;
  result.nodes.clear();
  result.arc_patches.clear();
  for (Index source_parent : source.parents) {
    approach(source, source_parent, from_);
    for (Index target_parent : target.parents) {
      approach(target, target_parent, to_);
      const Joint best = join(static_cast<float>(result.length));
      if (best.source_row == no_index) continue;
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
      visit(start_of(source, source_parent, best.source_row).node, no_index);
      visit(second_node(source_parent, best.source_row), -1 - source_parent);
      visit(second_node(target_parent, best.target_row), by_node_table);
      visit(start_of(target, target_parent, best.target_row).node, -1 - target_parent);
    }
  }
}

}  // namespace vorogeo
