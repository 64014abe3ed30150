// Distances between all border nodes of the first layer, and bounds that tell which of them to read.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "index/local_tables.h"
#include "index/patch_layer.h"
#include "support/file.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Distances between all first-layer nodes: far pairs are then read instead of searched

/// A symmetric table over the nodes of the first layer; empty in an index in the form of a graph.
///
/// Consecutive nodes on a border between the same patches form groups of up to eight. For two groups the
/// table holds the least distance between them, a lower bound that mostly makes the rest unnecessary, and for
/// each pair of nodes by how much its distance exceeds that, as an entry of 16 bits. The entries of two
/// groups, a *cell*, are contiguous in memory.
struct TransitTable {
  static constexpr Index group_size = 8;
  static constexpr std::uint16_t greatest_entry = 65534;
  static constexpr std::uint16_t infinite_entry = 65535;  ///< the entry for an infinite distance

  Index count = 0;                 ///< nodes; 0: there is no table
  std::vector<Index> group_begin;  ///< first node, by group; then count
  std::vector<Index> group_of;     ///< by node
  TableScale scale;
  std::vector<float> least;          ///< shape (groups, groups)
  SharedArray<std::uint16_t> entry;  ///< by cell

  Index group_count() const { return static_cast<Index>(group_begin.size()) - 1; }
  Index size(Index group) const { return group_begin[group + 1] - group_begin[group]; }
  /// Least distances of a group from all groups.
  const float* least_from(Index group) const {
    return least.data() + static_cast<std::size_t>(group) * group_count();
  }
  /// Entries of the nodes of two groups. Shape (size(a), size(b)).
  const std::uint16_t* cell(Index a, Index b) const { return entry.data() + cell_begin(a, b); }
  std::size_t cell_begin(Index a, Index b) const {
    return static_cast<std::size_t>(group_begin[a]) * count +
           static_cast<std::size_t>(size(a)) * group_begin[b];
  }
  float distance(Index a, Index b) const {
    const Index group_a = group_of[a];
    const Index group_b = group_of[b];
    const std::uint16_t found =
        cell(group_a, group_b)[(a - group_begin[group_a]) * size(group_b) + (b - group_begin[group_b])];
    return found == infinite_entry ? std::numeric_limits<float>::infinity()
                                   : least_from(group_a)[group_b] + scale.distance(found);
  }
  std::size_t memory_bytes() const {
    return entry.size() * sizeof(entry[0]) + least.size() * sizeof(least[0]) +
           (group_begin.size() + group_of.size()) * sizeof(Index);
  }
};

/// Memory that the table of a laid out layer takes, in bytes; with the entries in a file, that of its groups
/// and their least distances.
std::int64_t transit_bytes(const PatchLayer& first, bool entries_in_file);

/// Fills in the groups of the nodes, which follow from the layer alone.
void group_nodes(const PatchLayer& first, TransitTable& table);
/// The number of groups.
std::uint64_t transit_group_count(const PatchLayer& first);

/// Where the table is filled: first its rows, search by search, then the table of both directions, which may
/// take their place.
struct TransitSpace {
  TransitSpace() = default;
  /// In memory, which rows and table share.
  explicit TransitSpace(const PatchLayer& first);

  TableSpace table;             ///< the entries of the finished table; its parts are not used
  TableSpace rows;              ///< the entries of the rows; its parts are batches of searches
  std::span<float> least;       ///< least distances of the rows; shape (groups, groups)
  std::span<TableScale> scale;  ///< of the rows, by group
  std::shared_ptr<const void> owner;
};

/// Number of batches of searches.
std::size_t transit_batch_count(const PatchLayer& first);

/// Fills the table by a search over the first layer from each of its nodes, most of them in batches
/// (BatchDijkstra). Besides the table, only a few rows take memory. Batches whose rows the space holds
/// already are left as they are. Complexity: O(nodes^2 (w + b / 16)), for b nodes on the border of a patch,
/// of which w are on its stretches.
TransitTable make_transit_table(const PatchLayer& first, const TransitSpace& space, int threads,
                                const Progress& progress);

// ---- Least distances between pieces of patch borders

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

  Lists<GroupRows> groups;                  ///< by first-layer patch
  std::vector<std::size_t> begin;           ///< by second-layer patch, into least
  std::vector<std::uint8_t> least;          ///< by second-layer patch, group and row of that patch
  float unit_between = 0.0f;                ///< distance of a bound of 1 between borders
  std::vector<std::size_t> between_begin;   ///< by pair, into least_between
  std::vector<std::int16_t> least_between;  ///< by pair, groups of the first, groups of the second

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
