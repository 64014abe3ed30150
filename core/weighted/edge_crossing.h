// From between two points of an edge, whose distances are known, into a face.
#pragma once

#include "support/types.h"

namespace vorogeo {

/// A piece of an edge, from one of its points to the next.
struct EdgePiece {
  double length = 0.0;    ///< in the face that is entered
  double cheapest = 0.0;  ///< in the cheapest face of the edge
  double at_first = unreachable;
  double at_second = unreachable;  ///< distances of its ends from the source
};

/// How a point of a face is reached from inside a piece of one of its edges.
struct EdgeCrossing {
  double distance = unreachable;  ///< of the point; `unreachable` if no way leads straight through the piece
  double share = 0.0;             ///< where the piece is crossed, 0 to 1 from its first end
};

/// The shortest way through a piece to a point of the face at distances `to_first` and `to_second` of the
/// piece's ends.
///
/// Before the piece, distances are those from a source in the plane, in the metric of the cheapest face:
/// there they grow along the edge no faster than the edge costs. Entering a dearer face, the way refracts.
/// Ways that are not shorter than `below` may count as none.
EdgeCrossing cross_piece(const EdgePiece& piece, double to_first, double to_second, double below);

}  // namespace vorogeo
