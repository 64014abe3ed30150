// How far it is round a limb: by a plane section, by a tape measure, and along the surface.
#pragma once

#include <optional>
#include <vector>

#include "exact/surface_path.h"
#include "query/surface.h"
#include "tasks/workers.h"

namespace vorogeo {

/// Three lengths round a limb. Those of the section and the tape are in space, whatever the metric.
struct Girth {
  Point normal{};           ///< of the plane, of length 1
  SurfacePath section;      ///< where the plane cuts the surface, from the point round to the point
  std::vector<Point> tape;  ///< corners of the section's convex hull, in order
  double tape_length = 0.0;
  SurfacePath loop;  ///< the section pulled tight; one point, of length 0, where it slips off
};

/// The girth at a point. Without a normal, the plane is that of the shortest closed section among planes that
/// contain the surface's normal: 36 at equal angles, then more between the neighbours of the best. \throw
/// InvalidInput for a section that meets a border or an edge of three faces (names the edge), a plane that
/// only touches the surface, a vertex without a face, a normal without direction, a metric that jumps, or a
/// surface without positions; Cancelled. Complexity: O(faces cut) for each section; then that of tightened().
Girth girth(Surface& surface, const SurfacePoint& point, const std::optional<Point>& normal,
            const TaskOptions& options = {});

}  // namespace vorogeo
