// The parameters by which every filter bridges gaps of the surface.
#pragma once

#include "host/filter_row.h"
#include "mesh/gaps.h"

namespace vorogeo::plugin {

/// Adds gap and bridge_folds.
void add_gap_parameters(RichParameterList& list, const MeshDocument& document);

/// Their values; no gap where a list does not have them, as one from an older filter script.
/// \throw InvalidInput for a length that is negative or not finite.
GapLimit gap_of(const FilterCall& call);

}  // namespace vorogeo::plugin
