// Exact shortest paths between two points of a mesh that has no index.
#pragma once

#include <memory>
#include <optional>

#include "exact/paths_from_point.h"
#include "query/exact_search.h"
#include "query/path_query.h"
#include "query/path_refine.h"

namespace vorogeo {

/// An upper bound of the distance is enough to keep exact propagation in a corridor: the shortest path along
/// edges, pulled tight, gives one, and exact propagation in the faces around that a closer one. One object
/// belongs to one thread.
class MeshPathQuery {
 public:
  explicit MeshPathQuery(const std::shared_ptr<const LocalGeometry>& geometry);

  /// The shortest path, from source to target; see PathQuery::exact_path. Always proven where faces are not
  /// degenerate; where the metric jumps at edges, a refracted one of which nothing is proven. \throw
  /// InvalidInput for a point that is not on the mesh; Cancelled at a checkpoint.
  ExactPath exact_path(const SurfacePoint& source, const SurfacePoint& target);
  /// The same from the source of a propagation that serves many targets.
  ExactPath exact_path(PathsFromPoint& from_source, const SurfacePoint& target);

 private:
  /// The answer where no propagation is needed: to the point itself, or where no path exists.
  std::optional<ExactPath> known_path(const SurfacePoint& from, const SurfacePoint& to) const;
  /// What is found runs from `from` to `to` up to rounding, and is certified if it is valid.
  ExactPath checked(FoundPath found, const SurfacePoint& from, const SurfacePoint& to) const;
  bool needs_another_run(const ExactPath& found, const SurfacePoint& from, const SurfacePoint& to) const;
  double upper_bound(const SurfacePoint& source, const SurfacePoint& target);
  bool lay_strip(const SurfacePoint& source, const SurfacePoint& target, double& length);

  const Mesh& mesh_;
  CorridorSearch corridor_;
  std::optional<PathRefiner> refiner_;  ///< not where the metric jumps: there, lines refract
  PathNeighbourhood surroundings_;
  FaceStrip strip_;
};

}  // namespace vorogeo
