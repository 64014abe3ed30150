// Distances between all first-layer nodes: far pairs are then read instead of searched.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "index/patch_layer.h"
#include "index/table_room.h"
#include "support/progress.h"
#include "support/shared_array.h"

namespace vorogeo {

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

/// Memory that the table of a laid out layer takes, in bytes.
std::int64_t transit_table_bytes(const PatchLayer& first);

/// A table with the groups of the nodes, which follow from the layer alone, and without distances.
TransitTable group_nodes(const PatchLayer& first);

/// Where the table is filled: first its rows, search by search, then the table of both directions, which may
/// take their place.
struct TransitRoom {
  TransitRoom() = default;
  /// In memory, in one place.
  explicit TransitRoom(const PatchLayer& first);

  TableRoom table;              ///< the entries of the finished table; its parts are not used
  TableRoom rows;               ///< the entries of the rows; by batch of searches
  std::span<float> least;       ///< least distances of the rows; shape (groups, groups)
  std::span<TableScale> scale;  ///< of the rows, by group
  std::shared_ptr<const void> owner;
};

/// Number of batches of searches.
std::size_t transit_batch_count(const PatchLayer& first);

/// Fills the table by a search over the first layer from each of its nodes, most of them in batches
/// (BatchDijkstra). Besides the table, only a few rows take memory. Batches whose rows the room holds already
/// are left as they are. Complexity: O(nodes^2 (w + b / 16)), for b nodes on the border of a patch, of which
/// w are on its stretches.
TransitTable make_transit_table(const PatchLayer& first, const TransitRoom& room, int threads,
                                const Progress& progress);

}  // namespace vorogeo
