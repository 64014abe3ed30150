// Texture coordinates of a disk around a point.
#pragma once

#include "tasks/directions.h"

namespace vorogeo {

/// How a picture is laid onto the surface.
struct Placement {
  double radius = 0.0;    ///< of the disk that gets coordinates, in the unit of the surface
  double rotation = 0.0;  ///< of the picture about the point, in radians, as angles grow in the frame there
  double scale = 1.0;     ///< of the picture; at 1 its side is twice the radius
};

/// By vertex and by face, as they were given. From the logarithmic map: lines through the middle of the
/// picture become shortest paths from the point, of their true length. Across the cut locus, where paths come
/// from different sides, faces are stretched arbitrarily. \throw InvalidInput as log_map(), for a radius or a
/// scale that is not above 0, and a rotation that is not finite. Complexity: that of the log map.
TextureCoordinates texture_coordinates(Surface& surface, const SurfacePoint& point,
                                       const Placement& placement, const TaskOptions& options);

}  // namespace vorogeo
