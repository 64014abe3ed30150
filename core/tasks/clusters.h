// Points divided into clusters around centres: k-means and k-medoids.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tasks/means.h"

namespace vorogeo {

struct Clusters {
  std::vector<SurfacePoint> centres;
  /// The nearest centre of each point, or of each vertex; no_index for a vertex without a face.
  std::vector<Index> label;
  /// The weighted sum of powers of the distances from the nearest centre, at the beginning and after each
  /// round; it never rises, except by errors of an index.
  std::vector<double> energy;
};

/// Clusters of points or, if none are given, of all vertices with a face. `power`: two for k-means, one for
/// k-medoids, whose centres are points of the list. Without weights, points count 1 and vertices a third of
/// their faces. Begins with random points, each chosen by its weight times the power of its distance from
/// those chosen before (k-means++, Arthur, Vassilvitskii 2007; for all vertices, distances are along edges).
/// In a round, each point goes to the nearest centre, then each centre to its cluster's mean (descend()) or
/// medoid, unless the energy would rise. Centres for all vertices are vertices and move as in relax_points().
/// Ends after `rounds`, or when no centre moves. \throw InvalidInput for a count below 1, above the number of
/// different points of positive weight or below the number of components that these lie on, weights as
/// checked_weights(), negative rounds; for means of points, also as descend(); Cancelled. Complexity: in a
/// round a field from each centre, bounded by three times the reach of the clusters, and the fields of
/// descend() or least_energies() within its cluster; for all vertices as relax_points(), whose fields may be
/// quick ones.
Clusters clusters_of(Surface& surface, Index count, const std::optional<PointList>& points,
                     std::span<const double> weights, Power power, Index rounds, std::uint64_t seed,
                     const TaskOptions& options = {});

}  // namespace vorogeo
