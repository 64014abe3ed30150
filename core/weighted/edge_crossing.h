// From between two points of an edge, whose distances are known, into a face.
#pragma once

#include "support/types.h"

namespace vorogeo {

/// Waves of a radius of more than this many times the distance count as this flat: the sources of flatter
/// ones would be placed so far away that rounding exceeds the least gain.
inline constexpr double flattest = 1e3;

/// A piece of an edge, from one of its points to the next.
struct EdgePiece {
  double length = 0.0;    ///< in the face that is entered
  double cheapest = 0.0;  ///< in the cheapest face of the edge
  double at_first = unreachable;
  double at_second = unreachable;  ///< distances of its ends from the source
  /// The wave is as flat as that of a source farther away by this: behind an edge to dearer faces it is
  /// flatter than its distance alone says.
  double farther = 0.0;
};

/// The cosine of the angle between a ray and an edge, in a face, and how many times as long the edge is there
/// as in its cheapest face.
struct RayAtEdge {
  double cosine = 0.0;
  double dearer = 1.0;
};

/// The radius of a wave after an edge into a dearer face, or (`into_face` false) as seen along the edge from
/// its cheapest face: on both sides distances along the edge have the same second derivative. `unreachable`
/// for the plane waves behind edges that are run along.
double refracted_radius(double radius, const RayAtEdge& ray, bool into_face);

/// How a point of a face is reached from inside a piece of one of its edges.
struct EdgeCrossing {
  double distance = unreachable;  ///< of the point; `unreachable` if no way leads straight through the piece
  double share = 0.0;             ///< where the piece is crossed, 0 to 1 from its first end
};

/// The source of the wave that has reached a piece, placed in the plane before it.
///
/// Before the piece, distances are those in the metric of its cheapest face: there they grow along the edge
/// no faster than the edge costs. Entering a dearer face, the way refracts.
class PlacedSource {
 public:
  /// None if no place in the plane has the two distances.
  PlacedSource() = default;
  explicit PlacedSource(const EdgePiece& piece);

  bool exists() const { return exists_; }
  /// Less the height of a point over the piece, a lower bound of its distance through the piece.
  double least() const { return least_; }
  double farther() const { return farther_; }
  /// The shortest way through the piece to a point at height `y` over the line of the piece in the face that
  /// is entered, `x` from the piece's first end. \pre exists()
  EdgeCrossing cross(double x, double y) const;

 private:
  double slope_at(double share, double x, double y, double& curvature) const;
  EdgeCrossing refract(double x, double y) const;

  bool exists_ = false;
  bool refracts_ = false;
  double length_ = 0.0;
  double cheapest_ = 0.0;
  double farther_ = 0.0;
  double least_ = 0.0;
  double x_ = 0.0;  ///< along the piece; in its units if the way refracts
  double y_ = 0.0;  ///< before it
  double slope_at_first_ = 0.0;
  double slope_at_second_ = 0.0;  ///< of the distance along the piece, if the way refracts
};

}  // namespace vorogeo
