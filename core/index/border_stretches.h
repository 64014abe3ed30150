// The border of a patch as stretches of consecutive nodes.
#pragma once

#include <span>
#include <vector>

#include "support/types.h"

namespace vorogeo {

struct PatchLayer;

/// Consecutive nodes of a patch, whose rows are consecutive, too.
struct BorderStretch {
  Index patch;
  Index row;    ///< of the first node
  Index begin;  ///< first node
  Index end;
};

/// The border nodes of each patch, in the order of their rows, in as few stretches as possible: nodes between
/// the same patches have consecutive numbers.
class BorderStretches {
 public:
  BorderStretches() = default;
  explicit BorderStretches(const PatchLayer& layer);
  std::span<const BorderStretch> of(Index patch) const {
    return {stretch_.data() + begin_[patch], stretch_.data() + begin_[patch + 1]};
  }
  std::size_t memory_bytes() const {
    return begin_.size() * sizeof(Index) + stretch_.size() * sizeof(BorderStretch);
  }

 private:
  std::vector<Index> begin_;  ///< by patch, into stretch_
  std::vector<BorderStretch> stretch_;
};

}  // namespace vorogeo
