// One pass over the first-layer tables, and one over the least distances of the transit table.
#include "index/access_bounds.h"

#include <algorithm>
#include <limits>

#include "index/bound_scans.h"
#include "index/index_data.h"
#include "support/checkpoint.h"

namespace vorogeo {

Index AccessBounds::width(Index patch) const {
  const auto count = static_cast<Index>(groups[patch].size());
  return (count + short_lanes - 1) / short_lanes * short_lanes;
}

std::size_t AccessBounds::memory_bytes() const {
  auto of = [](const auto& list) { return list.size() * sizeof(list[0]); };
  std::size_t bytes = of(begin) + of(least) + of(between_begin) + of(least_between);
  for (const auto& of_patch : groups) bytes += sizeof(of_patch) + of(of_patch);
  return bytes;
}

namespace {

/// Everything but the bounds themselves.
AccessBounds lay_out_bounds(const IndexData& data, const TransitTable& transit_table) {
  const PatchLayer& first = data.first;
  const PatchLayer& second = data.second;
  AccessBounds bounds;
  bounds.groups.resize(first.patch_count);
  for (Index p = 0; p < first.patch_count; ++p) {
    const auto nodes = first.nodes(p);
    auto& groups = bounds.groups[p];
    for (std::size_t row = 0; row < nodes.size(); ++row) {
      const Index group = transit_table.group_of[nodes[row]];
      // The nodes of a group belong to the same patches, so their rows are consecutive.
      if (groups.empty() || groups.back().group != group) groups.push_back({group, static_cast<Index>(row)});
    }
    groups.shrink_to_fit();
  }
  bounds.begin.push_back(0);
  for (Index p = 0; p < second.patch_count; ++p) {
    bounds.begin.push_back(bounds.begin.back() +
                           second.border_size(p) * bounds.groups[data.partition.parent[p]].size());
  }
  bounds.between_begin.push_back(0);
  for (Index q = 0; q < first.patch_count; ++q) {
    for (Index p = 0; p <= q; ++p) {
      bounds.between_begin.push_back(bounds.between_begin.back() + bounds.groups[p].size() * bounds.width(q));
    }
  }
  return bounds;
}

void fill_between(const TransitTable& transit_table, AccessBounds& bounds) {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  float greatest = 0.0f;
  for (float least : transit_table.least) {
    if (least < infinite) greatest = std::max(greatest, least);
  }
  bounds.unit_between = greatest / static_cast<float>(AccessBounds::greatest_between);
  bounds.least_between.assign(bounds.between_begin.back(), AccessBounds::greatest_between);
  if (!(bounds.unit_between > 0.0f)) {
    std::fill(bounds.least_between.begin(), bounds.least_between.end(), std::int16_t{0});
    return;
  }
  for (Index q = 0; q < static_cast<Index>(bounds.groups.size()); ++q) {
    for (Index p = 0; p <= q; ++p) {
      std::int16_t* row = bounds.least_between.data() + bounds.between_begin[AccessBounds::pair_of(p, q)];
      for (const GroupRows& from : bounds.groups[p]) {
        const float* least = transit_table.least_from(from.group);
        for (std::size_t k = 0; k < bounds.groups[q].size(); ++k) {
          const float distance = least[bounds.groups[q][k].group];
          if (!(distance < infinite)) continue;
          row[k] = static_cast<std::int16_t>(
              std::min(distance / bounds.unit_between, static_cast<float>(AccessBounds::greatest_between)));
        }
        row += bounds.width(q);
      }
    }
  }
}

}  // namespace

std::int64_t access_bounds_bytes(const IndexData& data) {
  if (data.first.node_count() == 0) return 0;
  const AccessBounds bounds = lay_out_bounds(data, group_nodes(data.first));
  return static_cast<std::int64_t>(bounds.memory_bytes() + bounds.begin.back() + byte_lanes +
                                   bounds.between_begin.back() * sizeof(bounds.least_between[0]));
}

AccessBounds make_access_bounds(const IndexData& data) {
  if (data.transit_table.count == 0) return {};
  AccessBounds bounds = lay_out_bounds(data, data.transit_table);
  const PatchLayer& second = data.second;
  // Scans read beyond the last row.
  bounds.least.assign(bounds.begin.back() + byte_lanes, AccessBounds::infinite_entry);
  for (Index p = 0; p < second.patch_count; ++p) {
    checkpoint();
    const Index parent = data.partition.parent[p];
    const auto rows = static_cast<std::size_t>(second.border_size(p));
    const TableScale scale = data.first.scale[parent];
    const float per_unit = scale.unit() > 0.0f ? 1.0f / AccessBounds::unit(scale) : 0.0f;
    for (std::size_t row = 0; row < rows; ++row) {
      const std::uint16_t* line = data.first.line(parent, data.parent_column[second.border_begin[p] + row]);
      std::uint8_t* bound = bounds.least.data() + bounds.begin[p] + row;
      for (const GroupRows& at : bounds.groups[parent]) {
        const std::uint16_t* entry = line + at.row;
        const std::uint16_t least = *std::min_element(entry, entry + data.transit_table.size(at.group));
        *bound = least == PatchLayer::infinite_entry
                     ? AccessBounds::infinite_entry
                     : static_cast<std::uint8_t>(scale.distance(least) * per_unit);
        bound += rows;
      }
    }
  }
  fill_between(data.transit_table, bounds);
  return bounds;
}

}  // namespace vorogeo
