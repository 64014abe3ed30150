// A distance field that also names the nearest source.
#pragma once

#include <vector>

#include "support/types.h"

namespace vorogeo {

/// A distance field and the source that each vertex is nearest to.
struct LabelledField {
  std::vector<double> distance;  ///< by vertex; unreachable where no source can be reached
  std::vector<Index> source;     ///< position in the list of sources; no_index where there is none
};

}  // namespace vorogeo
