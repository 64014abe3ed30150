// One layer of patches: their members, their border nodes, and the tables of distances from border to
// members.
#pragma once

#include <cstdint>
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

/// Patches of one layer over the work mesh. A *node* is a vertex on the border of two or more patches.
///
/// Layer 2: members of a patch are all its vertices. Layer 1: its members are the layer-2 nodes in it. In
/// both, the nodes of the patch come first among the members, and table(p) holds for each of them (row) the
/// distance to each member (column).
struct PatchLayer {
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
  std::vector<std::size_t> table_begin;  ///< by patch, into table
  std::vector<float> table;

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
  /// Distances of a member from the border nodes of its patch, by row. Those of a border node itself are also
  /// its distances to the other border nodes.
  const float* line(Index patch, Index column) const {
    return table.data() + table_begin[patch] + static_cast<std::size_t>(column) * border_size(patch);
  }
  float* line(Index patch, Index column) {
    return table.data() + table_begin[patch] + static_cast<std::size_t>(column) * border_size(patch);
  }
  std::size_t memory_bytes() const;
};

/// Lays out a layer: nodes, members, borders and the places of the tables. `label`: patch of each face.
/// `candidate`: which vertices may be members (empty: all with a face in the patch).
PatchLayer lay_out_patches(const Mesh& mesh, std::span<const Index> label, Index patch_count,
                           std::span<const std::uint8_t> candidate);

/// Nodes of a patch as ranges of consecutive node numbers: nodes between the same patches follow one another.
struct NodeRange {
  Index begin;
  Index end;
};
std::vector<NodeRange> node_ranges(const PatchLayer& layer, Index patch);

/// Makes room for the tables; all distances are unreachable. Apart from the layout, as a damaged index file
/// could ask for tables of any size.
void make_tables(PatchLayer& layer);

/// Makes the distances between two nodes of a patch equal in both directions: the smaller one. The two can
/// differ since each row is solved in the surroundings of its own node.
void make_symmetric(PatchLayer& layer);

}  // namespace vorogeo
