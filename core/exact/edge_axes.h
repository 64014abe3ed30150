// The axes of an edge in the plane of one of its faces.
#pragma once

#include <algorithm>
#include <cmath>

#include "exact/exact_geometry.h"
#include "mesh/vectors.h"

namespace vorogeo {

/// The point from which positions on the edge count, and the unit vectors along the edge and into the face.
struct EdgeAxes {
  /// \pre The edge is longer than 0.
  EdgeAxes(const ExactGeometry& geometry, const FacePlane& plane, Index face, Index edge) {
    const auto& corners = geometry.mesh->face_vertices(face);
    const auto [a, b] = geometry.ends(edge);
    const auto first = std::ranges::find(corners, a) - corners.begin();
    const auto second = std::ranges::find(corners, b) - corners.begin();
    origin = plane.corner[first];
    const PlanePoint way = minus_in_plane(plane.corner[second], origin);
    const double length = std::hypot(way[0], way[1]);
    along = {way[0] / length, way[1] / length};
    inwards = {-along[1], along[0]};
    if (dot_in_plane(inwards, minus_in_plane(plane.corner[3 - first - second], origin)) < 0.0)
      inwards = {along[1], -along[0]};
  }

  PlanePoint origin, along, inwards;
};

}  // namespace vorogeo
