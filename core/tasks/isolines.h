// Lines of equal value of a field given at the vertices.
#pragma once

#include <span>
#include <vector>

#include "tasks/surface_lines.h"

namespace vorogeo {

/// How a field varies along an edge between the values at its ends.
enum class Interpolation {
  linear,   ///< for any field
  distance  ///< as the distance from a point of the plane that has these distances from the ends: exact on
            ///< flat parts of the surface. Where the values differ by more than the edge's length: linear.
};

/// Isolines and the level of each of their points and segments.
struct Isolines {
  SurfaceLines lines;
  std::vector<Index> level_of_point;    ///< position in the list of levels
  std::vector<Index> level_of_segment;  ///< likewise
};

/// The lines on which the field has one of the levels: in each face at most one segment per level, straight
/// between two of its edges. Faces with a value that is not finite (unreachable) hold no line.
/// \throw InvalidInput if there are not as many values as vertices, or a level is not finite.
/// Complexity: O(m + crossings + l log l) for l levels and m faces.
Isolines isolines(const Mesh& mesh, std::span<const double> values, std::span<const double> levels,
                  Interpolation interpolation);

/// Where on an edge of the given length a field takes the value `level`, which lies between those at the
/// ends: a fraction in [0, 1], counted from the first end.
double crossing(double at_first, double at_second, double length, double level, Interpolation interpolation);

}  // namespace vorogeo
