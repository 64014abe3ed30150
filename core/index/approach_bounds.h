// Least distances between pieces of the borders of the two layers: most of a first-layer table need then not
// be read for two points.
#pragma once

#include <cstdint>
#include <vector>

#include "index/node_table.h"
#include "index/patch_layer.h"

namespace vorogeo {

/// A group of the node table, as rows of a first-layer patch.
struct GroupRows {
  Index group;
  Index row;  ///< of its first node
};

/// For each member of a first-layer patch and each group of the node table on the border of the patch: the
/// least of the distances between them, rounded down to a multiple of `step` table entries, in 8 bits. They
/// follow from the tables; empty in an index in the form of a graph.
struct ApproachBounds {
  /// Table entries that a bound of 1 stands for: the greatest entry gives 254.
  static constexpr std::uint16_t step = 129;
  static constexpr std::uint8_t no_way = 255;

  std::vector<std::vector<GroupRows>> groups;  ///< by first-layer patch
  std::vector<std::size_t> begin;              ///< by first-layer patch, into least
  std::vector<std::uint8_t> least;             ///< by member of the patch, then by group

  /// Bounds of a member (column) of a first-layer patch, by group.
  const std::uint8_t* of_member(Index patch, Index column) const {
    return least.data() + begin[patch] + static_cast<std::size_t>(column) * groups[patch].size();
  }
  std::size_t memory_bytes() const;
};

/// Memory that they take for a laid out layer, in bytes.
std::int64_t approach_bounds_bytes(const PatchLayer& first);

/// Complexity: that of reading the first-layer tables.
ApproachBounds make_approach_bounds(const PatchLayer& first, const NodeTable& node_table);

}  // namespace vorogeo
