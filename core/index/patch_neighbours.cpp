// Collecting touching patches node by node.
#include "index/patch_neighbours.h"

#include <algorithm>

#include "index/patch_layer.h"

namespace vorogeo {

PatchNeighbours::PatchNeighbours(const PatchLayer& layer) {
  begin_.reserve(layer.patch_count + 1);
  begin_.push_back(0);
  std::vector<Index> own;
  for (Index patch = 0; patch < layer.patch_count; ++patch) {
    own.clear();
    for (Index node : layer.nodes(patch)) {
      for (const PatchRow& at : layer.patches_of(node)) {
        if (at.patch != patch) own.push_back(at.patch);
      }
    }
    std::ranges::sort(own);
    const auto repeated = std::ranges::unique(own);
    neighbour_.insert(neighbour_.end(), own.begin(), repeated.begin());
    begin_.push_back(static_cast<Index>(neighbour_.size()));
  }
  neighbour_.shrink_to_fit();
}

bool PatchNeighbours::touch(Index a, Index b) const { return std::ranges::binary_search(of(a), b); }

}  // namespace vorogeo
