// Which border nodes of a layer are joined by a border edge.
#pragma once

#include <array>
#include <vector>

#include "index/patch_layer.h"

namespace vorogeo {

/// Neighbours of each node along the borders of its patches, up to four: where more borders meet, the others
/// are left out.
class BorderEdges {
 public:
  explicit BorderEdges(const PatchLayer& layer);

  struct Edge {
    Index node = no_index;
    float length = 0.0f;
  };
  /// The edges of a node; those that do not exist lead to no_index.
  const std::array<Edge, 4>& at(Index node) const { return edges_[node]; }

  /// Whether two nodes are the same or joined by an edge. Sources (BorderSearch::wave_name) are the same or
  /// not; between a source and a node nothing is known: true.
  bool touch(Index a, Index b) const {
    if (a == b) return true;
    if (a < 0 || b < 0) return a >= 0 || b >= 0;
    for (const Edge& edge : edges_[a]) {
      if (edge.node == b) return true;
    }
    return false;
  }

 private:
  std::vector<std::array<Edge, 4>> edges_;
};

}  // namespace vorogeo
