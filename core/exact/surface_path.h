// Paths over a surface, and the check that one is valid and as long as it says.
#pragma once

#include <span>
#include <vector>

#include "mesh/surface_point.h"

namespace vorogeo {

/// A path over the surface: consecutive points share a face; each lies on a vertex, an edge or in a face.
struct SurfacePath {
  std::vector<SurfacePoint> points;
  double length = 0.0;
};

/// Lengths of paths agree if they differ by no more than this (relative), beyond what rounding of the weights
/// of their points explains.
inline constexpr double path_tolerance = 1e-9;

/// A length measured along points.
struct MeasuredLength {
  double length = unreachable;
  double rounding = 0.0;  ///< how far it may be off, as weights in a face are rounded

  bool agrees_with(double distance) const;
};

/// The sum of the straight steps between consecutive points, each in a face that holds both ends.
/// `unreachable` if there is no point or two share no face. Complexity: O(points) for each face at a point.
MeasuredLength measured_length(const Mesh& mesh, std::span<const SurfacePoint> points);

/// What a line costs from its first point to its last: its measured length, and the rise of the potential
/// there (Mesh::potential).
double cost_of_line(const Mesh& mesh, std::span<const SurfacePoint> points);

/// The first face that holds both points; no_index if there is none.
Index common_face(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b);

/// Whether two points are the same up to rounding of their weights. Points at the same place in space, on two
/// sides of a slit say, are not.
bool is_same_point(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b);

/// By point: whether the step to the next one runs over a gap, through bridges only and no face of the input.
/// The last point has none.
std::vector<bool> steps_over_gaps(const Mesh& mesh, std::span<const SurfacePoint> points);

/// Whether a path runs from `first` to `last`, every two consecutive points share a face, and its steps sum
/// to `distance` and to the length that the path states.
bool is_path(const Mesh& mesh, const SurfacePath& path, const MeasuredLength& measured,
             const SurfacePoint& first, const SurfacePoint& last, double distance);
/// The same for a path that has not been measured along its points.
bool is_path(const Mesh& mesh, const SurfacePath& path, const SurfacePoint& first, const SurfacePoint& last,
             double distance);

}  // namespace vorogeo
