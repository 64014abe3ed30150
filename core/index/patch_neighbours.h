// Which patches of a layer have a border node in common.
#pragma once

#include <vector>

#include "index/patch_layer.h"

namespace vorogeo {

/// Lists of touching patches.
class PatchNeighbours {
 public:
  explicit PatchNeighbours(const PatchLayer& layer);
  /// Whether two different patches have a node in common. Complexity: O(neighbours of a patch).
  bool touch(Index a, Index b) const;

 private:
  std::vector<std::vector<Index>> neighbours_;
};

}  // namespace vorogeo
