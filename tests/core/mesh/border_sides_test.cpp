// Directions, neighbours and distances of border edges, by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "mesh/gaps.h"
#include "support/gaps.h"

namespace vorogeo {
namespace {

TEST(BorderSides, PointAwayFromTheirFaces) {
  const auto mesh = test::make_mesh(test::plane_grid(2, 1, 2.0, 1.0).soup);
  const BorderSides sides(*mesh);
  ASSERT_EQ(sides.count(), 6);
  const BorderSide& below = sides[sides.between(0, 1)];
  EXPECT_NEAR(below.out[1], -1.0, 1e-15);
  EXPECT_NEAR(below.depth, 1.0, 1e-15);
  EXPECT_EQ(sides.between(0, 4), no_index);
  // All round the plate and back.
  Index side = sides.between(0, 1);
  Index vertex = 1;
  for (int i = 0; i < 6; ++i) {
    side = sides.next(side, vertex);
    vertex = sides.other_end(side, vertex);
  }
  EXPECT_EQ(side, sides.between(0, 1));
  EXPECT_EQ(vertex, 1);
}

TEST(BorderSides, RunBesideEachOther) {
  const auto mesh = test::make_mesh(test::two_plates(1, 2, 0.25).soup);
  const BorderSides sides(*mesh);
  const Index left = sides.between(1, 3);   // x = 1, y from 0 to 1
  const Index right = sides.between(4, 7);  // x = 1.25, y from 0 to 0.5
  const SidePair pair = sides.beside(left, right);
  EXPECT_NEAR(pair.overlap, 0.5, 1e-15);
  EXPECT_NEAR(pair.apart, 0.25, 1e-15);
  EXPECT_NEAR(pair.across[0], 0.25, 1e-15);
  EXPECT_TRUE(sides.continues(left, right, pair.across, false));
  // Over the plate to its own other border.
  const Index outer = sides.between(0, 2);
  EXPECT_FALSE(sides.continues(left, outer, sides.beside(left, outer).across, true));
}

TEST(BorderSides, RimsSideBySideAreAFold) {
  const auto mesh = test::make_mesh(test::rolled_sheet(2, 12, 0.1));
  const BorderSides sides(*mesh);
  const Index inner = sides.between(3, 4);
  const Index outer = sides.between(15, 16);  // one turn farther out
  const Point across = sides.beside(inner, outer).across;
  EXPECT_FALSE(sides.continues(inner, outer, across, false));
  EXPECT_TRUE(sides.continues(inner, outer, across, true));
}

}  // namespace
}  // namespace vorogeo
