// Which patches of a layer have a border node in common.
#pragma once

#include <span>
#include <vector>

#include "support/types.h"

namespace vorogeo {

struct PatchLayer;

/// Lists of touching patches.
class PatchNeighbours {
 public:
  PatchNeighbours() = default;
  explicit PatchNeighbours(const PatchLayer& layer);
  /// The patches that have a node in common with a patch, without itself, ascending.
  std::span<const Index> of(Index patch) const {
    return {neighbour_.data() + begin_[patch], neighbour_.data() + begin_[patch + 1]};
  }
  /// Whether two different patches have a node in common. Complexity: O(log(neighbours of a patch)).
  bool touch(Index a, Index b) const;
  std::size_t memory_bytes() const { return (begin_.size() + neighbour_.size()) * sizeof(Index); }

 private:
  std::vector<Index> begin_;  ///< by patch, into neighbour_
  std::vector<Index> neighbour_;
};

}  // namespace vorogeo
