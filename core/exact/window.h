// A window: the part of an edge that one (pseudo-)source reaches through one chain of faces.
#pragma once

#include <algorithm>
#include <cmath>

#include "support/types.h"

namespace vorogeo {

/// Distances seen through the interval [begin, end] of an edge from one pseudo-source.
///
/// The faces the window came through are unfolded into the plane of the edge: the edge lies on the x axis
/// with its first vertex at 0, the pseudo-source at (source_x, source_y) with source_y >= 0.
struct Window {
  double begin, end;
  double source_x, source_y;
  double offset;    ///< distance from the source to the pseudo-source
  Index came_from;  ///< half-edge of the edge in the face the window came through; see entry()
  Index source;     ///< which of the sources

  /// A window that was taken across the faces on the other side keeps the complement of its half-edge.
  bool is_propagated() const { return came_from < 0; }
  void set_propagated() { came_from = std::min(came_from, ~came_from); }
  Index entry() const { return std::max(came_from, ~came_from); }

  /// The whole of an edge seen from a point of an adjacent face.
  static Window from_source(double length, double x, double y, double offset, Index halfedge, Index source) {
    return {0.0, length, x, y, offset, halfedge, source};
  }

  double distance(double x) const { return offset + plane_distance(x); }
  double plane_distance(double x) const {
    const double dx = x - source_x;
    return std::sqrt(dx * dx + source_y * source_y);
  }
  double least_distance() const { return distance(std::clamp(source_x, begin, end)); }
};

/// Where a vertex at distance `from_vertex` overtakes a window: x with from_vertex + x = window.distance(x).
/// Positions count from that vertex; the caller knows that there is such a point.
inline double vertex_takeover(double from_vertex, double offset, double source_x, double source_y) {
  const double k = from_vertex - offset;
  return (source_x * source_x + source_y * source_y - k * k) / (2.0 * (k + source_x));
}

}  // namespace vorogeo
