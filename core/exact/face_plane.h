// A face laid into the plane.
#pragma once

#include <array>

#include "exact/exact_geometry.h"

namespace vorogeo {

/// Plane coordinates of a point of a face: half-edge 3 f on the x axis, one of its ends at 0, apex above.
struct FacePlane {
  FacePlane(const ExactGeometry& geometry, Index face);
  std::array<double, 2> at(const std::array<double, 3>& barycentric) const;
  std::array<std::array<double, 2>, 3> corner;
};

}  // namespace vorogeo
