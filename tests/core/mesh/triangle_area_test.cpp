// Areas of triangles against closed forms, also where Heron's formula has no digits left.
#include <gtest/gtest.h>

#include "mesh/vectors.h"

namespace vorogeo {
namespace {

TEST(TriangleArea, RightTrianglesInAnyOrderAndSize) {
  for (const double scale : {1e-60, 1.0, 1e60}) {
    const double twice = 12.0 * scale * scale;
    EXPECT_NEAR(twice_area({3 * scale, 4 * scale, 5 * scale}), twice, 1e-15 * twice);
    EXPECT_NEAR(twice_area({5 * scale, 3 * scale, 4 * scale}), twice, 1e-15 * twice);
  }
}

TEST(TriangleArea, NeedlesKeepTheirDigits) {
  // Legs of 1 + e over half a base of 1: the height is the root of 2 e + e e.
  const double e = 0x1p-50;
  const double height = 0x1p-25 * std::sqrt(2.0 + e);
  EXPECT_NEAR(twice_area({1 + e, 2, 1 + e}), 2 * height, 1e-15 * height);
}

TEST(TriangleArea, NoneWhereThreePointsLieOnALine) {
  EXPECT_EQ(twice_area({1, 3, 2}), 0.0);
  EXPECT_EQ(twice_area({1, 4, 2}), 0.0);
  EXPECT_EQ(twice_area({0, 0, 0}), 0.0);
}

}  // namespace
}  // namespace vorogeo
