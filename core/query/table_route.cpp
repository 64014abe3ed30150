// Min-plus scans over the tables of two first-layer patches and the block between their borders.
#include "query/table_route.h"

#include <algorithm>
#include <limits>

#include "support/min_plus.h"

namespace vorogeo {

TableRouter::TableRouter(const IndexData& data) : data_(data) {
  if (data.node_table.count == 0) return;
  ranges_.reserve(data.first.patch_count);
  for (Index p = 0; p < data.first.patch_count; ++p) ranges_.push_back(node_ranges(data.first, p));
}

void TableRouter::approach(const RouteEnd& end, Index parent, Approach& result) const {
  const PatchLayer& second = data_.second;
  const Index rows = data_.first.border_size(parent);
  result.parent = parent;
  result.distance.assign(rows, std::numeric_limits<float>::infinity());
  result.start.assign(rows, no_index);
  for (std::size_t s = 0; s < end.starts.size(); ++s) {
    const auto [node, distance] = end.starts[s];
    for (const PatchRow& at : second.patches_of(node)) {
      if (data_.partition.parent[at.patch] != parent) continue;
      const Index column = data_.parent_column[second.border_begin[at.patch] + at.row];
      const auto base = static_cast<float>(distance);
      lower_by_entries(data_.first.line(parent, column), data_.first.unit[parent], base,
                       static_cast<Index>(s), rows, result.distance.data(), result.start.data());
      break;
    }
  }
}

GraphRoute TableRouter::route(const RouteEnd& source, const RouteEnd& target) {
  const PatchLayer& first = data_.first;
  GraphRoute best;
  for (Index source_parent : source.parents) {
    approach(source, source_parent, from_);
    for (Index target_parent : target.parents) {
      approach(target, target_parent, to_);
      const auto source_nodes = first.nodes(source_parent);
      const auto target_nodes = first.nodes(target_parent);
      auto least = static_cast<float>(best.length);
      Index best_row = no_index;
      for (std::size_t r = 0; r < source_nodes.size(); ++r) {
        const float* row = data_.node_table.row(source_nodes[r]);
        std::size_t column = 0;
        for (const NodeRange& range : ranges_[target_parent]) {
          const Index count = range.end - range.begin;
          const float sum =
              from_.distance[r] + least_sum(row + range.begin, to_.distance.data() + column, count);
          column += count;
          if (sum < least) {
            least = sum;
            best_row = static_cast<Index>(r);
          }
        }
      }
      if (best_row == no_index) continue;
      const float* row = data_.node_table.row(source_nodes[best_row]);
      Index best_column = 0;
      for (std::size_t c = 1; c < target_nodes.size(); ++c) {
        if (row[target_nodes[c]] + to_.distance[c] <
            row[target_nodes[best_column]] + to_.distance[best_column]) {
          best_column = static_cast<Index>(c);
        }
      }
      best.length = static_cast<double>(from_.distance[best_row]) + row[target_nodes[best_column]] +
                    to_.distance[best_column];
      // The four nodes of the route; those that coincide appear once.
      best.nodes.clear();
      best.arc_patches.clear();
      auto visit = [&](Index node, Index arc_patch) {
        if (!best.nodes.empty() && best.nodes.back() == node) return;
        if (!best.nodes.empty()) best.arc_patches.push_back(arc_patch);
        best.nodes.push_back(node);
      };
      auto second_node = [&](Index first_node) {
        return data_.second.vertex_node[first.node_vertex[first_node]];
      };
      visit(source.starts[from_.start[best_row]].node, no_index);
      visit(second_node(source_nodes[best_row]), -1 - source_parent);
      visit(second_node(target_nodes[best_column]), by_node_table);
      visit(target.starts[to_.start[best_column]].node, -1 - target_parent);
    }
  }
  return best;
}

}  // namespace vorogeo
