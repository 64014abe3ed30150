// Shortest paths between two points of a surface, with an index or without: refined from it, or exact.
#pragma once

#include <memory>
#include <optional>

#include "exact/paths_from_point.h"
#include "index/geodesic_index.h"
#include "query/between.h"
#include "query/index_bounds.h"
#include "query/path_refine.h"
#include "query/router.h"

namespace vorogeo {

/// Answers path queries. Holds scratch memory: one object belongs to one thread.
///
/// Paths run from source to target over faces of the user's mesh; consecutive points share a face. Without a
/// path (other component, a vertex without a face) a path has no points and its length is `unreachable`.
class PathQuery {
 public:
  explicit PathQuery(std::shared_ptr<const GeodesicIndex> index);
  /// Without an index: exact paths only.
  explicit PathQuery(const std::shared_ptr<const LocalGeometry>& geometry);

  /// The refined path: the path that the index gives, shortened to a geodesic. Never shorter than the
  /// shortest path, up to rounding; in nearly all cases it is that path. Exact where the ends lie in one
  /// patch or in patches that touch. From target to source it is the same path. \throw InvalidInput for a
  /// point that is not on the mesh. Complexity: that of a two-point distance and some tens of passes over the
  /// faces crossed; if the result is doubtful, also that of exact propagation in the faces close to them.
  SurfacePath path(const SurfacePoint& source, const SurfacePoint& target);

  /// The shortest path, by exact propagation in a corridor. That is limited by the length of the refined
  /// path, or without an index of the shortest path along edges pulled tight, and by lower bounds of the
  /// rest. Always proven where faces are not degenerate; where the metric jumps at edges, a refracted path of
  /// which nothing is proven. `certify`: with an index, use only proven lower bounds, the straight line in
  /// space and those of `landmarks`, where they are given. Without it, the index's distance, less a margin
  /// that is not proven, narrows the corridor: faster on large curved surfaces, but on meshes of needles a
  /// few answers are too long. \throw InvalidInput for a point that is not on the mesh; Cancelled at a
  /// checkpoint.
  ExactPath exact_path(const SurfacePoint& source, const SurfacePoint& target, bool certify = true,
                       const ExactLandmarks* landmarks = nullptr);
  /// The same from the source of a propagation that serves many targets.
  ExactPath exact_path(PathsFromPoint& from_source, const SurfacePoint& target);

 private:
  /// What only an index needs.
  struct Routes {
    explicit Routes(const IndexData& of) : data(of), router(of), unfolder(of), bounds(of) {}
    const IndexData& data;
    Router router;
    RouteUnfolder unfolder;
    IndexBounds bounds;
  };
  /// Both ends on the inner surface of the index, and the route between them.
  struct RoutedEnds {
    RoutedEnds(const IndexData& data, const SurfacePoint& source, const SurfacePoint& target)
        : from(data, source), to(data, target) {}
    IndexedEnd from;
    IndexedEnd to;
    GraphRoute route{};
    /// Length over border nodes: an upper bound of the distance, up to the precision of the tables.
    double length() const { return from.to_place + route.length + to.to_place; }
  };
  std::optional<ExactPath> known_path(const SurfacePoint& from, const SurfacePoint& to) const;
  ExactPath path_on_mesh(const SurfacePoint& from, const SurfacePoint& to);
  double length_by_edges(const PathEnd& from, const PathEnd& to);
  std::optional<ExactPath> solved(const SurfacePoint& from, const SurfacePoint& to, RoutedEnds& ends);
  void find_route(RoutedEnds& ends);
  SurfacePath refined(const SurfacePoint& from, const SurfacePoint& to, const RoutedEnds& ends);
  double expected_length(const RoutedEnds& ends);
  SurfacePath doubted(SurfacePath path, double expected, const SurfacePoint& from, const SurfacePoint& to);

  const std::shared_ptr<const GeodesicIndex> index_;           ///< null without one
  const std::shared_ptr<const Mesh> mesh_;                     ///< the user's
  const std::shared_ptr<const LocalGeometry> strip_geometry_;  ///< of the faces that strips are laid over
  ExactBetween exact_;
  std::unique_ptr<Routes> routes_;      ///< with an index
  std::optional<PathRefiner> refiner_;  ///< not where the metric jumps: there, lines refract
  FaceStrip strip_;
};

}  // namespace vorogeo
