// Shortest paths between two points of the surface, refined from the index or exact.
#pragma once

#include <memory>

#include "exact/exact_landmarks.h"
#include "exact/exact_solver.h"
#include "index/geodesic_index.h"

namespace vorogeo {

/// A shortest path and what is known about it.
struct ExactPath {
  SurfacePath path;
  /// Whether it is proven that no path is shorter (up to rounding), and the path passes is_path() for the
  /// distance that was propagated: it runs between the points asked for, consecutive points share a face, and
  /// its steps sum to that distance. Otherwise the propagation was kept in a corridor by the index's
  /// distances less an error margin, or no path of that length was found among degenerate faces.
  bool certified = false;
};

/// Answers path queries on an index. Holds scratch memory: one object belongs to one thread.
///
/// Paths run from source to target over faces of the user's mesh; consecutive points share a face. Without a
/// path (other component, a vertex without a face) a path has no points and its length is `unreachable`.
class PathQuery {
 public:
  explicit PathQuery(std::shared_ptr<const GeodesicIndex> index);
  ~PathQuery();
  PathQuery(PathQuery&&) noexcept;
  PathQuery& operator=(PathQuery&&) noexcept;

  /// The refined path: the path that the index gives, shortened to a geodesic. Never shorter than the
  /// shortest path, up to rounding; in nearly all cases it is that path. Exact where the ends lie in one
  /// patch or in patches that touch. From target to source it is the same path. \throw InvalidInput for a
  /// point that is not on the mesh. Complexity: that of a two-point distance and some tens of passes over the
  /// faces crossed; if the result is doubtful, also that of exact propagation in the faces close to them.
  SurfacePath path(const SurfacePoint& source, const SurfacePoint& target);

  /// The shortest path, by exact propagation in a corridor given by the refined path's length and lower
  /// bounds of the rest. `certify`: use only proven lower bounds, the straight line in space and those of
  /// landmarks, so that the answer is always certified. Without it, the index's distance, less a margin that
  /// is not proven, narrows the corridor: faster on large curved surfaces, but on meshes of needles a few
  /// answers are too long.
  ExactPath exact_path(const SurfacePoint& source, const SurfacePoint& target, bool certify = true);

  /// From this call on, landmarks (distance_matrix.h) narrow the corridors of certified paths.
  void use_landmarks(std::shared_ptr<const ExactLandmarks> landmarks);

  const GeodesicIndex& index() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace vorogeo
