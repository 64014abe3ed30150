// One pass over the first-layer tables.
#include "index/approach_bounds.h"

#include <algorithm>

#include "support/checkpoint.h"
#include "support/min_plus.h"

namespace vorogeo {

std::size_t ApproachBounds::memory_bytes() const {
  std::size_t bytes = begin.size() * sizeof(begin[0]) + least.size() * sizeof(least[0]);
  for (const auto& of_patch : groups) bytes += sizeof(of_patch) + of_patch.size() * sizeof(GroupRows);
  return bytes;
}

namespace {

/// Without the bounds themselves.
ApproachBounds lay_out_bounds(const PatchLayer& first, const NodeTable& node_table) {
  ApproachBounds bounds;
  bounds.groups.resize(first.patch_count);
  bounds.begin.push_back(0);
  for (Index p = 0; p < first.patch_count; ++p) {
    const auto nodes = first.nodes(p);
    auto& groups = bounds.groups[p];
    for (std::size_t row = 0; row < nodes.size(); ++row) {
      const Index group = node_table.group_of[nodes[row]];
      // The nodes of a group belong to the same patches, so they are rows one after the other.
      if (groups.empty() || groups.back().group != group) groups.push_back({group, static_cast<Index>(row)});
    }
    groups.shrink_to_fit();
    bounds.begin.push_back(bounds.begin.back() + first.member_count(p) * groups.size());
  }
  return bounds;
}

}  // namespace

std::int64_t approach_bounds_bytes(const PatchLayer& first) {
  if (first.node_count() == 0) return 0;
  const ApproachBounds bounds = lay_out_bounds(first, group_nodes(first));
  return static_cast<std::int64_t>(bounds.memory_bytes() + bounds.begin.back() + bounds_at_once);
}

ApproachBounds make_approach_bounds(const PatchLayer& first, const NodeTable& node_table) {
  if (node_table.count == 0) return {};
  ApproachBounds bounds = lay_out_bounds(first, node_table);
  bounds.least.reserve(bounds.begin.back() + bounds_at_once);
  for (Index p = 0; p < first.patch_count; ++p) {
    checkpoint();
    for (Index column = 0; column < first.member_count(p); ++column) {
      const std::uint16_t* line = first.line(p, column);
      for (const GroupRows& at : bounds.groups[p]) {
        const std::uint16_t* entry = line + at.row;
        const std::uint16_t least = *std::min_element(entry, entry + node_table.size(at.group));
        bounds.least.push_back(least == PatchLayer::no_way
                                   ? ApproachBounds::no_way
                                   : static_cast<std::uint8_t>(least / ApproachBounds::step));
      }
    }
  }
  // Scans read beyond the last line.
  bounds.least.resize(bounds.begin.back() + bounds_at_once, ApproachBounds::no_way);
  return bounds;
}

}  // namespace vorogeo
