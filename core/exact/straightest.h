// Straightest geodesics: lines traced over the faces from a point, in a direction, for a length.
#pragma once

#include <cstdint>

#include "exact/tangent_frame.h"

namespace vorogeo {

/// What a line does at a border of the surface, when it has not got its length yet.
enum class AtBorder : std::uint8_t {
  end,   ///< it ends there
  slide  ///< it goes on along the border, to the side that it leans to, as far as the border goes
};

/// Where a line ends, and how long it is: shorter than was asked for where it met a border.
struct TracedEnd {
  SurfacePoint point;
  double length = 0.0;
};

/// Traces from the point of a frame along a vector in it, for the vector's length. A line is straight in its
/// faces and over their edges. Through a vertex it goes on with half the angle of the vertex on either side
/// (Polthier, Schmies 1998); vertices on a border, those whose faces are no fan and edges of three faces or
/// more count as borders. A line along a border that does not slide ends where that bends. A vector of length
/// 0 gives the point itself. \throw Cancelled. Complexity: O(faces crossed).
TracedEnd trace(const TangentFrame& frame, const Tangent& vector, AtBorder at_border = AtBorder::end);

}  // namespace vorogeo
