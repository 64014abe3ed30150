// Polygons whose sides are shortest paths: their area, perimeter and angles, what lies inside, and convex
// hulls.
#pragma once

#include <vector>

#include "tasks/cut.h"
#include "tasks/workers.h"

namespace vorogeo {

struct GeodesicPolygon {
  double area = 0.0;       ///< of the inside: the side without border of the surface, else the smaller one
  double perimeter = 0.0;  ///< of all legs
  std::vector<Index> corners;  ///< positions of its points in the list: all; of a hull, those that span it
  std::vector<double> angles;  ///< by corner, of the inside, in radians
  /// Sum of the angle defects of the vertices inside. The n angles sum to (n - 2) pi plus this, where the
  /// inside is a disk and no leg turns at a vertex.
  double curvature = 0.0;
  /// Gauss-Bonnet: 2 pi times the Euler characteristic of the inside, minus its curvature, minus the turning
  /// of its border at points and vertices. It is 0 up to rounding, unless legs bend elsewhere, as where the
  /// metric jumps.
  double gauss_bonnet = 0.0;
  std::vector<Index> vertices;   ///< inside, not on the border; ascending
  std::vector<Index> faces;      ///< as given, those wholly inside; ascending
  std::vector<ExactPath> legs;   ///< from each point to the next, the last one to the first
  CutMesh cut;                   ///< along the legs
  std::vector<Index> cut_faces;  ///< the faces of `cut` that are inside; ascending
};

/// From each point to the next by the shortest path, and back to the first. Neighbouring legs may share their
/// beginning, as at a saddle vertex, where they enclose nothing. \throw InvalidInput for fewer than three
/// points, one that is not on the mesh or that the next one repeats or does not reach, legs that cross or
/// touch elsewhere, and legs with the same side left and right, as around a handle or a tube; Cancelled.
/// Complexity: the exact paths, and O(n log n) for the mesh.
GeodesicPolygon geodesic_polygon(Surface& surface, const PointList& points, const TaskOptions& options = {});

/// The shortest closed curve around points: the polygon of some of them that has all others inside and no
/// angle above pi, as a plane's convex hull. Gift wrapping (Jarvis 1973): from each corner to the next by the
/// path that has the others to its left. The result is that of geodesic_polygon(). The points must lie in a
/// part like a disk where any two have one shortest path; the hull is then the least part that contains the
/// path between any two of its points. \throw InvalidInput for fewer than three different points, points on
/// one line or on two components, a metric that jumps, and where that fails: paths that cross or have no
/// inside, an angle above pi, a point outside (names it), a hole or a handle inside; Cancelled. Complexity:
/// for each corner an exact field up to the farthest point, and a polygon.
GeodesicPolygon convex_hull(Surface& surface, const PointList& points, const TaskOptions& options = {});

}  // namespace vorogeo
