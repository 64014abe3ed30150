// What an index consists of.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <ranges>
#include <vector>

#include "exact/local_solver.h"
#include "index/index_options.h"
#include "index/inner_surface.h"
#include "index/patch_layer.h"
#include "index/transit_graph.h"
#include "index/transit_table.h"
#include "mesh/fingerprint.h"
#include "patches/partition.h"

namespace vorogeo {

/// The mesh and the options of an index: the beginning of its file.
struct IndexHead {
  /// Positions in `numbers`: seed, pairs of border nodes of both layers, form (0: tables, 1: graph), patches
  /// asked for, and a checksum of the places that tables have (checksum_of_layout).
  enum Number { seed, pairs, form, first_patches, second_patches, layout };

  Fingerprint fingerprint;
  double delta = 0.0;
  std::array<std::uint64_t, 6> numbers{};

  bool has_options_of(const IndexHead& other) const {
    return delta == other.delta &&
           std::ranges::all_of(std::array{seed, first_patches, second_patches},
                               [&](auto i) { return numbers[i] == other.numbers[i]; });
  }
};

/// Read by the queries, written by the builder and the index file.
struct IndexData {
  std::shared_ptr<const Mesh> mesh;  ///< the user's
  IndexHead head;
  IndexStatistics statistics;
  Partition partition;  ///< of the user's faces
  InnerSurface surface;
  std::shared_ptr<const LocalGeometry> geometry;  ///< of the inner surface
  PatchLayer first;
  PatchLayer second;
  TransitTable transit_table;  ///< of the first layer
  AccessBounds access_bounds;
  TransitGraph graph;              ///< the small form of the transit table; one of the two is there
  Landmarks landmarks;             ///< of the second-layer nodes
  std::vector<Index> home_patch;   ///< a second-layer patch of each place
  std::vector<Index> home_column;  ///< and its column among the members of that patch

  /// Column of a second-layer border node among the members of the first-layer patch around its patch, by
  /// second.slot(patch, row).
  std::vector<Index> parent_column;

  // Derived from the layout, so that queries need not compute it each time.
  std::vector<Index> first_face;     ///< by second-layer patch; then the number of faces
  std::vector<Index> first_child;    ///< second-layer patch, by first-layer patch; then their number
  std::vector<Index> second_node;    ///< second-layer node, by first-layer node
  std::vector<Point> node_position;  ///< by second-layer node: contiguous, unlike those in the mesh
  /// By second-layer patch, the greatest distance of two neighbouring points on its border: by the tables,
  /// what is shorter is mostly error.
  std::vector<double> longest_piece;
  /// Whether an edge has more than two faces: crossings are unfolded as on a manifold, so no margin for the
  /// index's error holds there.
  bool has_branches = false;

  /// Second-layer patches of a first-layer patch.
  auto children(Index first_layer_patch) const {
    return std::views::iota(first_child[first_layer_patch], first_child[first_layer_patch + 1]);
  }

  /// Column of a place among the members of a second-layer patch; no_index if it is not a member.
  Index column_in_patch(Index patch, Index vertex) const {
    const Index node = second.place_node[vertex];
    if (node != no_index) return second.row_of(node, patch);
    return home_patch[vertex] == patch ? home_column[vertex] : no_index;
  }
  /// Column of a second-layer node among the members of a first-layer patch; no_index if it is not a member.
  Index column_in_parent(Index parent, Index node) const {
    for (const PatchRow& at : second.patches_of(node)) {
      if (partition.parent[at.patch] == parent) return parent_column[second.slot(at.patch, at.row)];
    }
    return no_index;
  }

  /// Makes the inner surface, the layers without tables, and all that follows from them: from mesh and
  /// partition alone.
  void lay_out(int threads, const Progress& progress);
  IndexForm form() const { return head.numbers[IndexHead::form] == 1 ? IndexForm::graph : IndexForm::tables; }
  /// Memory held in addition to the user's mesh.
  std::int64_t bytes() const;
  /// Fills in the statistics that are counted from the parts.
  void count();
  /// Fills in that the large tables lie in a file.
  void note_mapped_bytes();
};

}  // namespace vorogeo
