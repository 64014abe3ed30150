// How far two sets of points are from each other along the surface.
#pragma once

#include <vector>

#include "tasks/workers.h"

namespace vorogeo {

struct SetDistances {
  std::vector<double>
      to_second;  ///< by point of the first set, from the nearest of the second; or `unreachable`
  std::vector<double> to_first;  ///< the other way
  double nearest = 0.0;          ///< the least of them
  double mean = 0.0;             ///< of the means of both
  double hausdorff = 0.0;        ///< the greatest of them
};

/// \throw InvalidInput for a set without points or with one that is not on the mesh; Cancelled.
/// Complexity: a field from each set.
SetDistances set_distances(Surface& surface, const PointList& first, const PointList& second,
                           const TaskOptions& options = {});

}  // namespace vorogeo
