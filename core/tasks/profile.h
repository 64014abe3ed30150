// What lies along a path: its length so far, height, slope, curvature and thickness.
#pragma once

#include <functional>

#include "mesh/surface_locator.h"
#include "mesh/surface_point.h"
#include "vorogeo/results.h"

namespace vorogeo {

/// The normal of the surface at a point, of length 1: that of its face, or the mean over the faces there, at
/// a vertex weighted by their angles. Its side is that of the first face, whichever way the others are
/// turned. 0 where no face has an area.
Point normal_at(const Mesh& mesh, const SurfacePoint& point);

/// `locate`: returns a locator of the mesh. `turned_over`: normals are on the other side. \throw InvalidInput
/// for a point that is not on the mesh, two consecutive ones without a common face (names them), an `up`
/// without direction, or a surface without positions. Complexity: O(faces), and for each point mostly O(log
/// faces).
Profile profile(const Mesh& mesh, const std::function<const SurfaceLocator&()>& locate, const PointList& path,
                const Point& up, bool turned_over = false);

}  // namespace vorogeo
