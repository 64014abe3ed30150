// Collecting touching patches node by node.
#include "index/patch_neighbours.h"

#include <algorithm>

namespace vorogeo {

PatchNeighbours::PatchNeighbours(const PatchLayer& layer) : neighbours_(layer.patch_count) {
  for (Index node = 0; node < layer.node_count(); ++node) {
    for (const PatchRow& a : layer.patches_of(node)) {
      auto& list = neighbours_[a.patch];
      for (const PatchRow& b : layer.patches_of(node)) {
        if (a.patch == b.patch || std::find(list.begin(), list.end(), b.patch) != list.end()) continue;
        list.push_back(b.patch);
      }
    }
  }
}

bool PatchNeighbours::touch(Index a, Index b) const {
  const auto& list = neighbours_[a];
  return std::find(list.begin(), list.end(), b) != list.end();
}

}  // namespace vorogeo
