// Exact shortest paths from one point to many, of which the first come at once, too.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>

#include "edit/background.h"
#include "exact/paths_from_point.h"
#include "query/path_query.h"

namespace vorogeo::plugin {

/// While the mouse drags, all paths begin in one point: a propagation around it serves them all in a fraction
/// of a millisecond each, but takes seconds on a large mesh. It runs in the background; until it has reached
/// far enough, each path is searched in a corridor. One object belongs to one thread.
class DragPaths {
 public:
  /// Paths that are found in a corridor in less time than this need no propagation.
  static constexpr std::chrono::milliseconds max_wait{5};

  explicit DragPaths(const std::shared_ptr<const LocalGeometry>& geometry,
                     std::chrono::milliseconds wait = max_wait);

  /// The shortest path; see PathsFromPoint::path_to. \throw Cancelled at a checkpoint, InvalidInput for a
  /// point that is not on the mesh.
  SurfacePath path(const SurfacePoint& source, const SurfacePoint& target);
  bool is_propagating() const { return propagation_.is_running(); }

 private:
  const std::chrono::milliseconds wait_;
  PathQuery corridors_;
  PathsFromPoint from_source_;  ///< the propagation's while that runs
  SurfacePoint source_;
  std::atomic<bool> has_failed_ = false;  ///< no memory was left: all paths are searched in corridors
  Background propagation_;                ///< last, so that it ends before anything else is destroyed
};

}  // namespace vorogeo::plugin
