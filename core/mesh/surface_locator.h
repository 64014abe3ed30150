// The point of a surface nearest to a point in space.
#pragma once

#include <memory>
#include <vector>

#include "mesh/surface_point.h"

namespace vorogeo {

/// Weights of the corners a, b, c in the point of their triangle that is nearest to p.
std::array<double, 3> nearest_weights(const Point& p, const Point& a, const Point& b, const Point& c);

/// A surface point and how far it is from the point it was found for.
struct SnappedPoint {
  SurfacePoint point;
  double distance = 0.0;
};

/// A tree of boxes over the faces. Immutable; may be shared by threads. It is our own, as VCG's grids need a
/// VCG mesh, which the core and the Python package do not have.
class SurfaceLocator {
 public:
  /// \throw InvalidInput for a mesh without faces. Complexity: O(m log m).
  explicit SurfaceLocator(std::shared_ptr<const Mesh> mesh);

  /// The nearest point of the surface, which is not on a bridge over a gap, moved to a vertex or an edge if
  /// it differs from it only by rounding; for a distant point, one whose distance differs from the least only
  /// by rounding. Of several faces equally near, the one with the lowest number: where sheets coincide (the
  /// two sides of a slit, doubled vertices), all points there are moved to the same sheet, and the other can
  /// only be named by vertex or face numbers. \throw InvalidInput for a coordinate that is not finite or
  /// above 1e307; names the point. Complexity: O(log m) for points near the surface.
  SnappedPoint nearest(const Point& point) const;

 private:
  struct Box {
    Point low;
    Point high;
    Index begin;  ///< into order_
    Index end;
    Index second = no_index;  ///< box of the second half; the first half's follows this one; no_index: a leaf
  };
  Index build(Index begin, Index end);
  /// A point from which the same point of the surface is nearest, and whose squared distances do not
  /// overflow.
  Point drawn_near(const Point& point) const;

  std::shared_ptr<const Mesh> mesh_;
  std::vector<Index> order_;
  std::vector<Box> boxes_;
};

}  // namespace vorogeo
