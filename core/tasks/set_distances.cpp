// How far two sets of points are from each other along the surface.
#include "tasks/set_distances.h"

#include <algorithm>
#include <numeric>

#include "support/error.h"

namespace vorogeo {

SetDistances set_distances(Surface& surface, const PointList& given_first, const PointList& given_second,
                           const TaskOptions& options) {
  const PointList first = points_on(*surface.mesh(), given_first, "First set, point");
  const PointList second = points_on(*surface.mesh(), given_second, "Second set, point");
  if (first.empty() || second.empty()) throw InvalidInput("A set has no point; name at least one in each.");
  require_both_ways_alike(*surface.mesh(), "Distances of two sets");
  Workers workers(surface, options, 2.0);
  const Watch watch(workers.progress(), "Distances between sets");
  SetDistances result;
  const auto read = [&](const PointList& from, const PointList& to, std::vector<double>& distances) {
    const auto distance_at = workers.field_at_points(from, unreachable);
    for (const SurfacePoint& point : to) distances.push_back(distance_at(point));
    result.mean +=
        0.5 * std::accumulate(distances.begin(), distances.end(), 0.0) / static_cast<double>(to.size());
  };
  read(second, first, result.to_second);
  read(first, second, result.to_first);
  result.nearest = std::min(std::ranges::min(result.to_second), std::ranges::min(result.to_first));
  result.hausdorff = std::max(std::ranges::max(result.to_second), std::ranges::max(result.to_first));
  return result;
}

}  // namespace vorogeo
