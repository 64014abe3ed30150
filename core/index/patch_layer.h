// One layer of patches: their members, their border nodes, and the tables of distances from border to
// members.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

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

/// How the table of a patch lies in memory. *Lines*: column by column, so that all distances of one member
/// follow one another. *Tiles*: tile_width columns at a time, row by row, so that a scan finds the least sums
/// of all columns of a tile at once; the last tile is filled up with no_way.
enum class TableOrder { lines, tiles };

/// Patches of one layer over the work mesh. A *node* is a vertex on the border of two or more patches.
///
/// Layer 2: members of a patch are all its vertices. Layer 1: its members are the layer-2 nodes in it. In
/// both, the nodes of the patch come first among the members, and the table of a patch holds for each of them
/// (row) the distance to each member (column): a whole multiple, of 15 bits, of the patch's unit. The unit is
/// the greatest distance of the table divided by greatest_entry, so that an entry is off by at most a
/// 65,532nd part of that, and the sum of two entries needs no more than 16 bits.
struct PatchLayer {
  static constexpr Index tile_width = 32;
  static constexpr std::uint16_t greatest_entry = 32766;
  static constexpr std::uint16_t no_way = 32767;  ///< the entry for an infinite distance

  Index patch_count = 0;
  std::vector<Index> node_vertex;      ///< work vertex, by node
  std::vector<Index> vertex_node;      ///< node, by work vertex; no_index: not on a border of this layer
  std::vector<Index> border_begin;     ///< by patch, into border_node
  std::vector<Index> border_node;      ///< node, by patch and row
  std::vector<Index> member_begin;     ///< by patch, into member
  std::vector<Index> member;           ///< work vertex, by patch and column
  std::vector<Index> incidence_begin;  ///< by node, into incidence
  std::vector<PatchRow> incidence;     ///< patches of each node, ascending
  std::vector<Index> neighbour_begin;  ///< by border_begin[patch] + row, into neighbour
  std::vector<BorderNeighbour> neighbour;
  TableOrder order = TableOrder::lines;
  std::vector<std::size_t> table_begin;  ///< by patch, into table
  std::vector<std::uint16_t> table;
  std::vector<float> unit;             ///< by patch: distance of an entry of 1
  std::vector<std::uint8_t> complete;  ///< by patch: 1 if no entry is no_way

  Index node_count() const { return static_cast<Index>(node_vertex.size()); }
  Index border_size(Index patch) const { return border_begin[patch + 1] - border_begin[patch]; }
  Index member_count(Index patch) const { return member_begin[patch + 1] - member_begin[patch]; }
  std::span<const Index> nodes(Index patch) const {
    return {border_node.data() + border_begin[patch], static_cast<std::size_t>(border_size(patch))};
  }
  std::span<const Index> members(Index patch) const {
    return {member.data() + member_begin[patch], static_cast<std::size_t>(member_count(patch))};
  }
  std::span<const PatchRow> patches_of(Index node) const {
    return {incidence.data() + incidence_begin[node], incidence.data() + incidence_begin[node + 1]};
  }
  std::span<const BorderNeighbour> neighbours(Index patch, Index row) const {
    const Index slot = border_begin[patch] + row;
    return {neighbour.data() + neighbour_begin[slot], neighbour.data() + neighbour_begin[slot + 1]};
  }
  /// Where the entries of a member lie: that of `row` is first[row * step].
  struct Column {
    const std::uint16_t* first;
    std::size_t step;
  };
  Column column_of(Index patch, Index column) const {
    const std::uint16_t* of_patch = table.data() + table_begin[patch];
    const auto rows = static_cast<std::size_t>(border_size(patch));
    if (order == TableOrder::lines) return {of_patch + column * rows, 1};
    return {of_patch + column / tile_width * rows * tile_width + column % tile_width, tile_width};
  }
  std::uint16_t entry(Index patch, Index row, Index column) const {
    const Column entries = column_of(patch, column);
    return entries.first[row * entries.step];
  }
  float to_distance(Index patch, std::uint16_t entry) const {
    return entry == no_way ? std::numeric_limits<float>::infinity() : unit[patch] * static_cast<float>(entry);
  }
  float distance(Index patch, Index row, Index column) const {
    return to_distance(patch, entry(patch, row, column));
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
  /// Writes the distances of a member from the border nodes, by row (border_size of them).
  void read_column(Index patch, Index column, float* distances) const;
  /// The same for a border node, by its row: the table is symmetric there.
  void read_border(Index patch, Index row, float* distances) const;
  /// Cuts a stretch of border nodes where their distances from the one in row `from` stop to follow one
  /// another in memory: calls visit(part, entries).
  template <class Stretch, class Visit>
  void for_each_run(const Stretch& stretch, Index from, Visit&& visit) const;
  std::size_t memory_bytes() const;
};

template <class Stretch, class Visit>
void PatchLayer::for_each_run(const Stretch& stretch, Index from, Visit&& visit) const {
  if (order == TableOrder::lines) {
    visit(stretch, line(stretch.patch, from) + stretch.row);
    return;
  }
  Stretch part = stretch;
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
/// `candidate`: which vertices may be members (empty: all with a face in the patch).
PatchLayer lay_out_patches(const Mesh& mesh, std::span<const Index> label, Index patch_count,
                           std::span<const std::uint8_t> candidate, TableOrder order = TableOrder::lines);

/// Nodes of a patch as ranges of consecutive node numbers: nodes between the same patches follow one another.
struct NodeRange {
  Index begin;
  Index end;
};
std::vector<NodeRange> node_ranges(const PatchLayer& layer, Index patch);

/// Consecutive nodes of a patch, which stand in consecutive rows.
struct BorderStretch {
  Index patch;
  Index row;    ///< of the first node
  Index begin;  ///< first node
  Index end;
};

/// Tables while they are computed: single precision, in lines.
class TableDraft {
 public:
  /// Room for the tables of a layer; all distances are unreachable.
  explicit TableDraft(const PatchLayer& layer);
  /// Distances of a member (column), by row.
  float* line(Index patch, Index column) {
    return value_.data() + begin_[patch] + static_cast<std::size_t>(column) * rows_[patch];
  }
  /// Makes the distances between two nodes of a patch equal in both directions: the smaller one. The two can
  /// differ since each row is solved in the surroundings of its own node.
  void make_symmetric();
  /// Shortens the distances of a patch by the sums of two over one of its border nodes, until none is left
  /// that is shorter: rows were solved in different surroundings. Complexity: O(border size^2 members).
  void close(Index patch);
  /// Writes the tables into the layer it was made for.
  void finish(PatchLayer& layer);

 private:
  std::vector<std::size_t> begin_;
  std::vector<Index> rows_;
  std::vector<float> value_;
};

/// Gives up the tables of a layer; its layout stays.
void drop_tables(PatchLayer& layer);

/// Entries that the table of a patch takes.
std::size_t table_size(const PatchLayer& layer, Index patch);

/// Fills in which tables are complete.
void note_complete(PatchLayer& layer);

}  // namespace vorogeo
