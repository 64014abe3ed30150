// Straightest geodesics: lines traced over the faces from a point, in a direction, for a length.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "exact/tangent_frame.h"

namespace vorogeo {

/// What a line does where it meets a border of the surface before it has its full length.
enum class AtBorder : std::uint8_t {
  end,   ///< it ends there
  slide  ///< it goes on along the border, to the side that it leans to, as far as the border goes
};

/// Where a line ends, and how long it is: shorter than was asked for where it met a border.
struct TracedEnd {
  SurfacePoint point;
  double length = 0.0;
};

/// What a line needs to cross a face, in one place for each half-edge: worth making for many lines.
struct FaceSteps {
  explicit FaceSteps(const ExactGeometry& geometry);

  /// A step into a face by a half-edge: the apex relative to the half-edge, and the faces to go on to.
  struct alignas(32) Step {
    double from_tail, from_head;  ///< of the foot of the apex, as parts of the length of the half-edge
    double depth;                 ///< of the apex, likewise
    /// The half-edges of the faces behind the sides at the tail and at the head; no_index where a line needs
    /// more care: at borders, where faces are not oriented alike, on edges without length or of three faces
    /// and more.
    std::array<Index, 2> behind;
  };
  std::vector<Step> step;  ///< by half-edge
};

/// Traces from the point of a frame along a vector in it, for the vector's length. A line is straight in its
/// faces and over their edges. Through a vertex it goes on with half the angle of the vertex on either side
/// (Polthier, Schmies 1998); vertices on a border, those whose faces are no fan and edges of three faces or
/// more count as borders. A line along a border that does not slide ends where the border bends. A vector of
/// length 0 gives the point itself. \throw Cancelled. Complexity: O(faces crossed).
TracedEnd trace(const TangentFrame& frame, const Tangent& vector, AtBorder at_border = AtBorder::end);

struct LineStart {
  const TangentFrame* frame;
  Tangent vector;
};
/// The same for many lines on one mesh.
void trace(std::span<const LineStart> starts, AtBorder at_border, const FaceSteps& steps,
           std::span<TracedEnd> ends);

}  // namespace vorogeo
