// What a path reaches without becoming longer: over faces without width and edges without length.
#pragma once

#include <vector>

#include "mesh/surface_point.h"
#include "weighted/face_norms.h"

namespace vorogeo {

/// A vertex or a point of an edge at no distance from another.
struct FlatPlace {
  SurfacePoint point;
  Index edge = no_index;   ///< of a point of an edge,
  double fraction = 0.0;   ///< from the edge's first vertex
  std::size_t from = 0;    ///< the place before it, by its number
  Index face = no_index;   ///< that is crossed from there; no_index: the step runs along
  Index along = no_index;  ///< this edge
  double length = 0.0;     ///< of the steps to it, which rounding leaves
};

/// What counts as no length across a face without area, where three points on a line leave a height by
/// rounding; 0 for a face with area.
double flat_height(const FaceNorms& norms, Index face);

/// All places at no length from a point, itself first, each once: where two sides of a seam of faces without
/// width, or vertices in one place, are one. `here` may be a vertex or a point in or on a face; the point of
/// an edge brings that edge and its fraction. Usually it is alone.
std::vector<FlatPlace> flat_places(const FaceNorms& norms, const FlatPlace& here);

}  // namespace vorogeo
