// Exact propagation from one point to another, within a bound of the length of the path.
#pragma once

#include <memory>

#include "weighted/local_solver.h"

namespace vorogeo {

/// A path and what is known about it. It has no points and infinite length if none was found.
struct FoundPath {
  SurfacePath path{{}, unreachable};
  /// The distance by exact propagation, if only proven bounds limited it; otherwise unreachable.
  double distance = unreachable;
  bool on_user_mesh = false;  ///< with an index: whether the path runs over that, rather than the work mesh

  /// Keeps the shorter of both paths, and the distance that either of them knows.
  void join(FoundPath other);
  /// The same path, of which nothing is proven.
  FoundPath unproven() &&;
};

/// Makes a path begin and end with exactly these points where it does so up to rounding, and corrects a
/// length that its points do not have. \return the length measured along its points.
MeasuredLength set_ends(const Mesh& mesh, const SurfacePoint& first, const SurfacePoint& last,
                        SurfacePath& path);

/// Up to edges this many typical ones long, exact distances between the other vertices keep their digits.
inline constexpr double provable_edges = 1e13;
/// Whether a propagated distance is a proof on this mesh.
inline bool is_provable(const Mesh& mesh) {
  return mesh.longest_edge_length() <= provable_edges * mesh.typical_edge_length();
}

/// Runs of one exact solver from point to point. Each run ends: the solver passes a window on only where it
/// shortens a distance by more than rounding. One object belongs to one thread.
class CorridorSearch {
 public:
  explicit CorridorSearch(const std::shared_ptr<const LocalGeometry>& geometry) : solver_(geometry) {}

  /// The path and the propagated distance. limits.max_distance is an upper bound of the distance: what cannot
  /// lie on a path of that length is not followed.
  FoundPath run(const SurfacePoint& from, const SurfacePoint& to, ExactLimits limits);
  /// The same over the faces allowed (ExactLimits::face_allowed; empty: all). The distance is known only if
  /// no shorter path can have left them.
  FoundPath within(const SurfacePoint& from, const SurfacePoint& to, double max_distance,
                   std::span<const std::uint8_t> face_allowed = {});

 private:
  LocalSolver solver_;
};

}  // namespace vorogeo
