// Distances between all first-layer nodes: far pairs are then read instead of searched.
#pragma once

#include <vector>

#include "index/patch_layer.h"
#include "support/progress.h"

namespace vorogeo {

/// A symmetric table over the nodes of the first layer; empty if it would be too large.
struct NodeTable {
  Index count = 0;              ///< nodes; 0: there is no table
  std::vector<float> distance;  ///< shape (count, count)

  const float* row(Index node) const { return distance.data() + static_cast<std::size_t>(node) * count; }
  std::size_t memory_bytes() const { return distance.size() * sizeof(float); }
};

/// Whether the table of so many nodes is small enough for a mesh of so many vertices.
bool node_table_fits(Index nodes, Index vertices);

/// Fills the table by a search over the first layer from each of its nodes. Complexity: O(nodes arcs log
/// nodes).
NodeTable make_node_table(const PatchLayer& first, int threads, const Progress& progress);

}  // namespace vorogeo
