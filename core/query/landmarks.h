// Landmarks for exact paths on an index: far from one another, each with an exact field.
#pragma once

#include <memory>

#include "exact/exact_landmarks.h"
#include "index/geodesic_index.h"
#include "support/progress.h"

namespace vorogeo {

/// Exact distances, on the inner surface of the index, from `count` vertices that are far from one another,
/// all in the component with the most vertices. \throw InvalidInput for a count that is not in 1 to
/// ExactLandmarks::max_count, Cancelled. Complexity: an exact field for each, on `threads` threads (0: one
/// per core).
std::shared_ptr<const ExactLandmarks> landmarks_of(const std::shared_ptr<const GeodesicIndex>& index,
                                                   int count, int threads = 0, const Progress& progress = {});

}  // namespace vorogeo
