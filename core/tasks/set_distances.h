// How far two sets of points are from each other along the surface.
#pragma once

#include "tasks/workers.h"

namespace vorogeo {

/// \throw InvalidInput for a set without points or with one that is not on the mesh; Cancelled.
/// Complexity: a field from each set.
SetDistances set_distances(Surface& surface, const PointList& first, const PointList& second,
                           const TaskOptions& options = {});

}  // namespace vorogeo
