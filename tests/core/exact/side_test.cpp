// Windows on their way to a side: rays leave where straight lines do, whichever end positions count from.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "exact/solver_state.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// One face: its edge from (0, 0) to (length, 0), its apex below.
struct Crossed {
  Crossed(double length_of_edge, double apex_along, double depth)
      : length(length_of_edge), along(apex_along) {
    test::Soup soup;
    soup.positions = {{0.0, 0.0, 0.0}, {length, 0.0, 0.0}, {along, -depth, 0.0}};
    soup.faces = {{0, 1, 2}};
    mesh = test::make_mesh(soup);
    apex_depth = depth;
  }
  Side side(bool second, bool reversed) const {
    // Half-edge 1 runs from the second vertex to the apex, 2 from there to the first.
    return {*mesh, Index{second ? 1 : 2}, reversed, second ? length - along : along, apex_depth};
  }
  double length;
  double along;
  double apex_depth = 0.0;
  std::shared_ptr<const Mesh> mesh;
};

TEST(Side, WindowsArriveWhereStraightLinesDo) {
  // From (0.5, 1) through the whole of the edge to an apex at (0.5, -1): the ray to the apex halves it. The
  // source is sqrt(1.25) from each end, and 2 from the apex.
  const Crossed face(1.0, 0.5, 1.0);
  const Window window = Window::from_source(1.0, 0.5, 1.0, 3.0, 0, 7);
  for (const bool second : {false, true}) {
    const double begin = second ? 0.5 : 0.0;
    for (const bool reversed : {false, true}) {
      const Side side = face.side(second, reversed);
      Window arrived = side.arriving(window, begin, begin + 0.5, true, second, 1.0);
      EXPECT_EQ(arrived.offset, 3.0);
      EXPECT_EQ(arrived.source, 7);
      for (int direction = 0; direction < 2; ++direction) {
        EXPECT_NEAR(arrived.begin, 0.0, 1e-15);
        EXPECT_NEAR(arrived.end, std::sqrt(1.25), 1e-15);
        const double at_apex = reversed ? arrived.begin : arrived.end;
        const double at_shared = reversed ? arrived.end : arrived.begin;
        EXPECT_NEAR(arrived.distance(at_apex), 3.0 + 2.0, 1e-14);
        EXPECT_NEAR(arrived.distance(at_shared), 3.0 + std::sqrt(1.25), 1e-14);
        if (!reversed) break;
        arrived = side.arriving_from_apex(window, begin, begin + 0.5, true, second, 1.0, 0.5, 0.5);
      }
    }
  }
  // A part of it: the ray through (0.25, 0) meets the side from (0, 0) to (0.5, -1) at (1 / 6, -1 / 3).
  const Side side = face.side(false, true);
  const double from_apex = std::hypot(1.0 / 3.0, 2.0 / 3.0);
  EXPECT_NEAR(side.arriving(window, 0.0, 0.25, false, false, 1.0).begin, from_apex, 1e-15);
  EXPECT_NEAR(side.arriving_from_apex(window, 0.0, 0.25, false, false, 1.0, 0.5, 0.5).begin, from_apex,
              1e-15);
}

TEST(Side, PositionsBesideAnOutlierKeepTheirDigits) {
  // The second vertex of the crossed edge is the outlier; the side leads from it to an apex at (0.5, -1).
  const double far = 1e12;
  const Crossed face(far, 0.5, 1.0);
  const Window window = Window::from_source(far, 0.25, 1.0, 0.0, 0, 0);
  // The ray to the apex passes the edge at 0.375.
  const Window arrived =
      face.side(true, true).arriving_from_apex(window, 0.375, far, true, true, far, 0.5, 0.375);
  EXPECT_EQ(arrived.begin, 0.0);
  // At the apex, and one unit along the side, which is parallel to the edge there.
  EXPECT_NEAR(arrived.distance(0.0), std::hypot(0.25, 2.0), 1e-11);
  EXPECT_NEAR(arrived.distance(1.0), std::hypot(1.25, 2.0), 1e-11);
}

TEST(Side, AFaceWithoutWidthKeepsPositions) {
  const Crossed face(2.0, 1.0, 0.0);
  const Window window = Window::from_source(2.0, 0.75, 0.0, 0.0, 0, 0);
  const Window arrived = face.side(false, false).arriving(window, 0.25, 0.5, false, false, 2.0);
  EXPECT_NEAR(arrived.begin, 0.25, 1e-15);
  EXPECT_NEAR(arrived.end, 0.5, 1e-15);
  EXPECT_NEAR(arrived.source_x, 0.75, 1e-15);
}

}  // namespace
}  // namespace vorogeo
