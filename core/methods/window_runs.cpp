// Runs of the exact solver for all vertices, or until one is final.
#include "methods/window_runs.h"

#include <array>

namespace vorogeo {

std::vector<double> WindowRuns::field(std::span<const Index> sources, const Progress& progress) {
  ExactLimits limits;
  limits.merge_tolerance = merge_tolerance_;
  limits.distances_only = true;
  limits.progress = &progress;
  solver_.run_from_vertices(sources, limits);
  std::vector<double> distances(solver_.mesh().vertex_count());
  for (Index v = 0; v < solver_.mesh().vertex_count(); ++v) distances[v] = solver_.distance(v);
  return distances;
}

double WindowRuns::pair(Index source, Index target) {
  const std::array targets{target};
  ExactLimits limits;
  limits.merge_tolerance = merge_tolerance_;
  limits.distances_only = true;
  limits.targets = targets;
  solver_.run_from_vertices({&source, 1}, limits);
  return solver_.distance(target);
}

}  // namespace vorogeo
