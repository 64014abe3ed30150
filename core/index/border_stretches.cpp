// One pass over the border nodes of all patches.
#include "index/border_stretches.h"

#include "index/patch_layer.h"

namespace vorogeo {

BorderStretches::BorderStretches(const PatchLayer& layer) {
  begin_.reserve(layer.patch_count + 1);
  begin_.push_back(0);
  for (Index patch = 0; patch < layer.patch_count; ++patch) {
    const auto first = static_cast<std::size_t>(begin_.back());
    Index row = 0;
    for (Index node : layer.nodes(patch)) {
      if (stretch_.size() > first && stretch_.back().end == node) {
        ++stretch_.back().end;
      } else {
        stretch_.push_back({patch, row, node, node + 1});
      }
      ++row;
    }
    begin_.push_back(static_cast<Index>(stretch_.size()));
  }
  stretch_.shrink_to_fit();
}

}  // namespace vorogeo
