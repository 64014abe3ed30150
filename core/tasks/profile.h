// What lies along a path: its length so far, height, and the slope of the surface.
#pragma once

#include <span>
#include <vector>

#include "mesh/surface_point.h"

namespace vorogeo {

/// The normal of the surface at a point, of length 1: that of its face, or the mean of the faces there, at a
/// vertex by their angles. Its side is that of the first face, whichever way the others are turned. 0 where
/// no face has an area.
Point normal_at(const Mesh& mesh, const SurfacePoint& point);

/// By point of a path.
struct Profile {
  std::vector<double> along;   ///< length of the path up to the point
  std::vector<double> height;  ///< of its position in the direction `up`
  std::vector<double>
      angle;  ///< of the normal with `up`, in radians: 0 on level ground turned upwards, pi/2 on a wall
};

/// \throw InvalidInput for a point that is not on the mesh, two consecutive ones without a common face (names
/// them), an `up` without direction, or a surface without positions. Complexity: O(points).
Profile profile(const Mesh& mesh, const PointList& path, const Point& up);

}  // namespace vorogeo
