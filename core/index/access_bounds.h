// Least distances between pieces of patch borders, from the second layer to the first and within the first:
// with them, two points need to read only a small part of the first-layer tables and of the transit table.
#pragma once

#include <cstdint>
#include <vector>

#include "index/patch_layer.h"
#include "index/transit_table.h"

namespace vorogeo {

struct IndexData;

/// A group of the transit table, as rows of a first-layer patch.
struct GroupRows {
  Index group;
  Index row;  ///< of its first node
};

/// For each node on the border of a second-layer patch, and each group of the transit table on the border of
/// the first-layer patch around it: the least distance between them, rounded down to a 254th part of the
/// greatest distance in the first-layer table, in 8 bits. And for each pair of groups on the borders of two
/// first-layer patches: the least distance, rounded down to 15 bits. Both follow from the tables; empty in an
/// index in the form of a graph.
struct AccessBounds {
  static constexpr std::uint8_t greatest_bound = 254;
  static constexpr std::uint8_t infinite_entry = 255;
  /// The distance of a bound of 1, for the scale of a first-layer table.
  static float unit(const TableScale& scale) {
    return scale.distance(PatchLayer::greatest_entry) / static_cast<float>(greatest_bound);
  }
  /// Greatest bound between borders; also used for infinite distances and behind the last group.
  static constexpr std::int16_t greatest_between = 16383;

  std::vector<std::vector<GroupRows>> groups;  ///< by first-layer patch
  std::vector<std::size_t> begin;              ///< by second-layer patch, into least
  std::vector<std::uint8_t> least;             ///< by second-layer patch, group and row of that patch
  float unit_between = 0.0f;                   ///< distance of a bound of 1 between borders
  std::vector<std::size_t> between_begin;      ///< by pair, into least_between
  std::vector<std::int16_t> least_between;     ///< by pair, groups of the first, groups of the second

  /// Bounds of the border nodes of a second-layer patch, for the first group; group by group.
  const std::uint8_t* of_patch(Index patch) const { return least.data() + begin[patch]; }
  /// Number of groups of a first-layer patch, rounded up for scans.
  Index width(Index patch) const;
  /// Bounds between two first-layer patches, p <= q. Shape (groups of p, width(q)).
  const std::int16_t* between(Index p, Index q) const {
    return least_between.data() + between_begin[pair_of(p, q)];
  }
  static std::size_t pair_of(Index p, Index q) {
    return static_cast<std::size_t>(q) * (static_cast<std::size_t>(q) + 1) / 2 + static_cast<std::size_t>(p);
  }
  std::size_t memory_bytes() const;
};

/// Memory that the bounds take for an index that is laid out, in bytes.
std::int64_t access_bounds_bytes(const IndexData& data);

/// \pre The first layer and the transit table are filled. Complexity: one pass over the first-layer tables,
/// and O(1) for each pair of groups.
AccessBounds make_access_bounds(const IndexData& data);

}  // namespace vorogeo
