// A layer of patches: border nodes, members, and where tables hold their distances.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "support/file.h"
#include "support/lists.h"
#include "support/types.h"

namespace vorogeo {

// ---- What the entries of a table stand for

/// Entries are whole numbers. On an *even* scale they are multiples of a unit, which resolves all distances
/// of a table alike. That is too coarse for parts much smaller than the rest; so tables with such parts have
/// a *graded* scale: an entry is a multiple of the unit to the power of four. Its steps are twice to four
/// times those of an even scale for the greatest distances, and for a distance 10,000 times smaller still
/// less than a thousandth of it.
struct TableScale {
  float signed_unit = 0.0f;  ///< negative: graded

  /// The scale on which the greatest distance has the greatest entry.
  static TableScale even(float greatest, std::uint16_t greatest_entry) {
    return {greatest / static_cast<float>(greatest_entry)};
  }
  static TableScale graded(float greatest, std::uint16_t greatest_entry) {
    return {-std::sqrt(std::sqrt(greatest)) / static_cast<float>(greatest_entry)};
  }

  bool is_graded() const { return std::signbit(signed_unit); }
  float unit() const { return std::abs(signed_unit); }
  /// The distance of an entry that is not infinite.
  float distance(std::uint16_t entry) const {
    const float root = unit() * static_cast<float>(entry);
    return is_graded() ? (root * root) * (root * root) : root;
  }
  /// The difference of the two greatest distances: an entry is off by half of that at most.
  float widest_step(std::uint16_t greatest_entry) const {
    return distance(greatest_entry) - distance(static_cast<std::uint16_t>(greatest_entry - 1));
  }
  /// The entry nearest to a finite distance, at most the greatest one.
  std::uint16_t entry(double distance, std::uint16_t greatest_entry) const {
    if (!(unit() > 0.0f)) return 0;
    const double root = is_graded() ? std::sqrt(std::sqrt(distance)) : distance;
    return static_cast<std::uint16_t>(std::min<double>(greatest_entry, std::nearbyint(root / unit())));
  }
};

/// A node with this many others within this part of the greatest distance lies in a part so small that its
/// table has a graded scale.
inline constexpr int least_small_part = 16;
inline constexpr float small_part = 1.0f / 512.0f;
/// So does a border node that is fewer steps of an even scale from another one: rounding could change their
/// distance by a sixteenth or more.
inline constexpr float least_steps = 8.0f;

struct InnerSurface;

// ---- One layer of patches: their members, border nodes and tables

/// A border node as seen from one of its patches: `row` counts the border nodes of the patch.
struct PatchRow {
  Index patch;
  Index row;
};

/// A border edge that leaves a border node along a patch: the row of its other end, and its length.
struct BorderNeighbour {
  Index row;
  float length;
};

/// Consecutive nodes of a patch, whose rows are consecutive, too.
struct BorderStretch {
  Index patch;
  Index row;    ///< of the first node
  Index begin;  ///< first node
  Index end;
};

/// How the table of a patch lies in memory. *Lines*: column by column, so that all distances of one member
/// are consecutive. *Tiles*: tile_width columns at a time, row by row, so that a scan finds the least sums of
/// all columns of a tile at once; the last tile is padded with infinite_entry.
/// The values are binary logarithms of how many columns lie side by side.
enum class TableOrder : std::uint8_t { lines = 0, tiles = 5 };
constexpr Index width_of(TableOrder order) { return 1 << static_cast<int>(order); }

/// Patches of one layer over the inner surface. A *node* is a place on the border of two or more patches.
///
/// Layer 2: members of a patch are all its places. Layer 1: its members are the layer-2 nodes in it. In
/// both, the nodes of the patch come first among the members, and the table of a patch holds for each of them
/// (row) the distance to each member (column), as an entry of 15 bits on the scale of the patch. On an even
/// scale an entry is off by at most a 65,532nd part of the greatest distance of the table, and the sum of two
/// entries needs no more than 16 bits.
///
/// A *far* member of a layer of tiles is much further from all nodes than these are from one another. Its
/// entries hold its distances minus an offset, the least of them, so that it does not coarsen the unit for
/// all others. Scans are not affected: the offset is the same for all rows.
struct PatchLayer {
  static constexpr Index tile_width = width_of(TableOrder::tiles);
  static constexpr std::uint16_t greatest_entry = 32766;
  static constexpr std::uint16_t infinite_entry = 32767;  ///< the entry for an infinite distance
  /// Members are far if they are beyond this many times the greatest distance between two nodes of the patch.
  static constexpr float far_per_border = 8.0f;

  Index patch_count = 0;
  std::vector<Index> node_place;     ///< place, by node
  std::vector<Index> place_node;     ///< node, by place; no_index: not on a border of this layer
  Lists<Index> border;               ///< nodes, by patch and row
  Lists<Index> member;               ///< places, by patch and column
  Lists<PatchRow> incidence;         ///< patches of each node, ascending
  Lists<BorderNeighbour> neighbour;  ///< by slot()
  Lists<Index> touching;             ///< by patch: those with a node in common, without itself, ascending
  /// By patch: its border in the order of rows, in as few stretches as possible. Nodes between the same
  /// patches have consecutive numbers.
  Lists<BorderStretch> stretches;
  /// Median length of the border edges, each counted once for every patch beside it; 0 if there are none.
  double typical_border_edge = 0.0;
  TableOrder order = TableOrder::lines;
  std::vector<std::size_t> table_begin;  ///< by patch, into table
  SharedArray<std::uint16_t> table;
  std::vector<TableScale> scale;       ///< by patch
  std::vector<float> offset;           ///< by member.begin[patch] + column, 0 if not far; empty: none is far
  std::vector<std::uint8_t> complete;  ///< by patch: 1 if no entry is infinite_entry

  Index node_count() const { return static_cast<Index>(node_place.size()); }
  Index border_size(Index patch) const { return border.size_of(patch); }
  Index member_count(Index patch) const { return member.size_of(patch); }
  std::span<const Index> nodes(Index patch) const { return border[patch]; }
  std::span<const Index> members(Index patch) const { return member[patch]; }
  std::span<const PatchRow> patches_of(Index node) const { return incidence[node]; }
  /// Position of a border node among those of all patches, by patch and row.
  Index slot(Index patch, Index row) const { return border.begin[patch] + row; }
  Index node_at(PatchRow at) const { return border.element[slot(at.patch, at.row)]; }
  /// Whether two different patches have a node in common. Complexity: O(log(touching patches)).
  bool touch(Index a, Index b) const { return std::ranges::binary_search(touching[a], b); }
  /// Row of a node among the border nodes of a patch; no_index if it is not on its border.
  Index row_of(Index node, Index patch) const {
    for (const PatchRow& at : patches_of(node)) {
      if (at.patch == patch) return at.row;
    }
    return no_index;
  }
  /// The same for a place; no_index also if it is on no border.
  Index row_in(Index place, Index patch) const {
    const Index node = place_node[place];
    return node == no_index ? no_index : row_of(node, patch);
  }
  std::span<const BorderNeighbour> neighbours(Index patch, Index row) const {
    return neighbour[slot(patch, row)];
  }
  /// What is to be added to the entries of a member; 0 for nodes.
  float offset_of(Index patch, Index column) const {
    return offset.empty() ? 0.0f : offset[member.begin[patch] + column];
  }
  /// The distances of a member from the border nodes, by row.
  struct Column {
    const std::uint16_t* first;
    std::size_t step;
    TableScale scale;
    float offset;  ///< see offset_of()

    const std::uint16_t& entry(Index row) const { return first[row * step]; }
    float distance(Index row) const {
      return entry(row) == infinite_entry ? unreachable_float : offset + scale.distance(entry(row));
    }
  };
  Column column_of(Index patch, Index column) const {
    const auto shift = static_cast<int>(order);
    const auto group = static_cast<std::size_t>(column >> shift) * border_size(patch) << shift;
    return {table.data() + table_begin[patch] + group + (column & (width_of(order) - 1)),
            static_cast<std::size_t>(width_of(order)), scale[patch], offset_of(patch, column)};
  }
  float distance(Index patch, Index row, Index column) const {
    return column_of(patch, column).distance(row);
  }
  /// Entries of a member by row; for the order of lines only.
  const std::uint16_t* line(Index patch, Index column) const {
    return table.data() + table_begin[patch] + static_cast<std::size_t>(column) * border_size(patch);
  }
  /// Entries of columns [tile tile_width, (tile + 1) tile_width), row by row; for the order of tiles only.
  const std::uint16_t* tile(Index patch, Index tile) const {
    return table.data() + table_begin[patch] +
           static_cast<std::size_t>(tile) * tile_width * border_size(patch);
  }
  /// Writes the distances of a border node (by its row) from all border nodes of its patch.
  void read_border(Index patch, Index row, float* distances) const;
  /// Cuts a stretch of border nodes into parts whose distances from the node in row `from` are contiguous in
  /// memory, and calls visit(part, entries) for each: the table is symmetric there.
  template <class Visit>
  void for_each_run(const BorderStretch& stretch, Index from, Visit&& visit) const;
  std::size_t memory_bytes() const;
};

template <class Visit>
void PatchLayer::for_each_run(const BorderStretch& stretch, Index from, Visit&& visit) const {
  if (order == TableOrder::lines) {
    visit(stretch, line(stretch.patch, from) + stretch.row);
    return;
  }
  BorderStretch part = stretch;
  while (part.begin < stretch.end) {
    const Index in_tile = part.row % tile_width;
    part.end = std::min(stretch.end, part.begin + tile_width - in_tile);
    visit(part,
          tile(part.patch, part.row / tile_width) + static_cast<std::size_t>(from) * tile_width + in_tile);
    part.row += part.end - part.begin;
    part.begin = part.end;
  }
}

/// Lays out a layer: nodes, members, borders and the places of the tables. `label`: patch of each face.
/// `candidate`: which places may be members (empty: all of the patch).
PatchLayer lay_out_patches(const InnerSurface& surface, std::span<const Index> label, Index patch_count,
                           std::span<const std::uint8_t> candidate, TableOrder order = TableOrder::lines);

/// Groups of consecutive nodes between the same patches, at most `max_nodes` in each: their first nodes, then
/// the number of nodes.
std::vector<Index> group_by_patches(const PatchLayer& layer, Index max_nodes);

/// Pairs of border nodes of one patch, in all patches.
std::int64_t pairs_of_nodes(const PatchLayer& layer);

/// Entries that the table of a patch takes.
std::size_t table_size(const PatchLayer& layer, Index patch);

}  // namespace vorogeo
