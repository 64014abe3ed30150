// Surfaces with gaps: shapes cut apart, and where their vertices came from.
#pragma once

#include <vector>

#include "support/shapes.h"

namespace vorogeo::test {

/// A soup whose vertices are copies of another's.
struct Cut {
  Soup soup;
  std::vector<Index> origin;  ///< by vertex, that of the whole surface
};

/// Every face with three vertices of its own, each moved by up to `jitter` along every axis.
Cut exploded(const Soup& whole, double jitter = 0.0, unsigned seed = 1);

/// Cut open where the plane through the origin across `normal` passes: along edges, the vertices on both
/// sides pulled back so that the crack is `width` wide there; faces nearer to the plane than half of
/// `removed` are left out. Vertices of no face are kept.
Cut cracked(const Cut& whole, const Point& normal, double width, double removed);

/// Two rectangles side by side in the plane z = 0, from x = 0 to 1 and from 1 + gap to 2, y from 0 to 1, with
/// `left` and `right` rows of cells. The distance is that in the plane.
Shape two_plates(int left, int right, double gap);

/// A strip of `turns` turns around the z axis, its layers `apart`, 1 high.
Soup rolled_sheet(int turns, int cells_per_turn, double apart);

/// A palm with fingers: boxes of 1 x 1 x `length` on one box, `apart` from each other; `open`: without their
/// tips.
Soup hand(int fingers, int cells, double length, double apart, bool open);

}  // namespace vorogeo::test
