// Exact shortest paths from one point to many, one after the other: propagation only as far as they need.
#pragma once

#include <memory>

#include "exact/local_solver.h"

namespace vorogeo {

/// Keeps the windows of a propagation around a point, so that paths to all targets within its reach are
/// traced without another one. For a target beyond it, the propagation is repeated with a larger reach. One
/// object belongs to one thread.
class PathsFromPoint {
 public:
  explicit PathsFromPoint(const std::shared_ptr<const LocalGeometry>& geometry);

  /// Later paths begin here. \throw InvalidInput for a point that is not on the mesh.
  void reset(const SurfacePoint& source);
  /// The shortest path from the source; without points and of length `unreachable` in another component.
  /// \throw InvalidInput for a point that is not on the mesh; Cancelled.
  /// Complexity: that of a path within the reach; otherwise that of exact propagation up to at most a
  /// constant factor beyond the target.
  SurfacePath path_to(const SurfacePoint& target, const Progress& progress = {});

  /// The distance that the last path_to(target) went by.
  double distance(const SurfacePoint& target) const { return solver_.distance(target); }
  const SurfacePoint& source() const { return source_; }

  /// Whether path_to(target) needs no propagation. \throw InvalidInput for a point that is not on the mesh.
  bool reaches(const SurfacePoint& target) const;
  /// Propagates, if need be, so that targets up to this distance are reached. \throw Cancelled; nothing is
  /// reached then.
  void propagate_to(double distance, const Progress& progress = {});

 private:
  bool extend(double reach, const Progress& progress);

  std::shared_ptr<const Mesh> mesh_;
  double longest_side_;  ///< no point of a face is farther than this from its corners
  LocalSolver solver_;
  SurfacePoint source_;
  double reach_ = 0.0;  ///< distances up to this one are known
};

}  // namespace vorogeo
