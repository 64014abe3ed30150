// Which border nodes of a layer are joined by a border edge.
#pragma once

#include <array>
#include <vector>

#include "support/types.h"

namespace vorogeo {

struct PatchLayer;

/// Neighbours of each node along the borders of its patches, up to four; where more borders meet, the rest
/// are left out.
class BorderEdges {
 public:
  BorderEdges() = default;
  explicit BorderEdges(const PatchLayer& layer);

  struct Edge {
    Index node = no_index;
    float length = 0.0f;
  };
  /// The edges of a node; those that do not exist lead to no_index.
  const std::array<Edge, 4>& at(Index node) const { return edges_[node]; }

  /// Median length of the border edges, each counted once for every adjacent patch; a few of whatever length
  /// do not change it. 0 if there are none.
  double typical_length() const { return typical_length_; }
  std::size_t memory_bytes() const { return edges_.size() * sizeof(edges_[0]); }

 private:
  std::vector<std::array<Edge, 4>> edges_;
  double typical_length_ = 0.0;
};

}  // namespace vorogeo
