// Distances inside a patch from those on its border.
#pragma once

#include <span>
#include <vector>

#include "index/border_search.h"

namespace vorogeo {

/// Scratch memory of a sweep; one object belongs to one thread.
class FieldSweep {
 public:
  /// Distances of all members of a patch through its border, in the order of its members: for a border node
  /// that of the search, for the others the least sum over the border, unfolded there.
  std::span<const double> sweep(const PatchLayer& layer, const BorderSearch& search, Index patch);

 private:
  std::vector<float> base_;
  std::vector<double> result_;
};

}  // namespace vorogeo
