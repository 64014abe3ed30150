// Exact geodesic distances on small meshes by brute force: an independent check where no formula exists.
#pragma once

#include <vector>

#include "mesh/mesh.h"
#include "mesh/surface_point.h"

namespace vorogeo::test {

/// Every straight segment between two vertices, found by unfolding all face sequences that a segment can
/// cross, then shortest chains of segments (Floyd, Warshall). Only what is longer than a path along edges is
/// pruned. For meshes of a few hundred vertices; any connectivity that Mesh allows.
class ExhaustiveGeodesics {
 public:
  explicit ExhaustiveGeodesics(const Mesh& mesh);

  double distance(Index a, Index b) const { return table_[a][b]; }
  /// Distances of all vertices from any point.
  std::vector<double> field(const SurfacePoint& source) const;

 private:
  const Mesh& mesh_;
  std::vector<std::vector<double>> table_;
};

}  // namespace vorogeo::test
