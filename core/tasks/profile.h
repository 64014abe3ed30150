// What lies along a path: its length so far, height, slope, curvature and thickness.
#pragma once

#include <functional>
#include <vector>

#include "mesh/surface_locator.h"
#include "mesh/surface_point.h"

namespace vorogeo {

/// The normal of the surface at a point, of length 1: that of its face, or the mean of the faces there, at a
/// vertex by their angles. Its side is that of the first face, whichever way the others are turned. 0 where
/// no face has an area.
Point normal_at(const Mesh& mesh, const SurfacePoint& point);

/// By point of a path, in space but for the length. Normals are those of most faces, whichever way some are
/// turned.
struct Profile {
  std::vector<double> along;   ///< length of the path up to the point
  std::vector<double> height;  ///< of its position in the direction `up`
  /// Of the normal with `up`, in radians: 0 on level ground turned upwards, pi/2 on a wall.
  std::vector<double> angle;
  /// Normal curvature in the direction of the path, 1/r along a great circle of a sphere whose normals lead
  /// outwards, negative in hollows: by how much the normals, interpolated between those of the vertices, tilt
  /// forwards over the steps beside the point. As rough as they are; 0 in flat faces between flat faces.
  std::vector<double> curvature;
  /// How far it is against the normal to the next face; `unreachable` where there is none.
  std::vector<double> thickness;
};

/// `locate`: returns a locator of the mesh. `turned_over`: normals are on the other side. \throw InvalidInput
/// for a point that is not on the mesh, two consecutive ones without a common face (names them), an `up`
/// without direction, or a surface without positions. Complexity: O(faces), and for each point mostly O(log
/// faces).
Profile profile(const Mesh& mesh, const std::function<const SurfaceLocator&()>& locate, const PointList& path,
                const Point& up, bool turned_over = false);

}  // namespace vorogeo
