// Relaxation on a square and a rectangle, whose best points and their energy are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "support/shapes.h"
#include "tasks/spread_points.h"

namespace vorogeo {
namespace {

const test::Shape square = test::plane_grid(10, 10, 1.0, 1.0);
const test::Shape rectangle = test::plane_grid(20, 10, 2.0, 1.0);

TEST(RelaxPoints, OnePointMovesToTheMiddleOfASquare) {
  Surface surface(test::make_mesh(square.soup), {.threads = 2});
  const RelaxedPoints found = relax_points(surface, std::array<Index, 1>{0}, 20, {.by = AnswerMethod::exact});
  EXPECT_EQ(found.vertices, std::vector<Index>{5 * 11 + 5});
  // The integral of the squared distance from a corner is 2/3, from the middle 1/6; vertices stand for their
  // faces, which makes an error of the order of a squared cell.
  EXPECT_NEAR(found.energy.front(), 2.0 / 3.0, 0.01);
  EXPECT_NEAR(found.energy.back(), 1.0 / 6.0, 0.01);
  EXPECT_LT(found.energy.size(), 10U) << "it ends when nothing moves";
}

TEST(RelaxPoints, WithoutRoundsOnlyTheEnergyIsMeasured) {
  Surface surface(test::make_mesh(square.soup), {.threads = 1});
  const std::array points{SurfacePoint::in_face(99, {0.2, 0.3, 0.5})};
  const RelaxedPoints found = relax_points(surface, points, 0, {.by = AnswerMethod::exact});
  EXPECT_EQ(found.energy.size(), 1U);
  EXPECT_EQ(found.vertices, std::vector<Index>{no_index});
  EXPECT_TRUE(found.points[0] == points[0]);
}

TEST(RelaxPoints, ARepeatedPointWaitsUntilTheOtherHasMoved) {
  Surface surface(test::make_mesh(rectangle.soup), {.threads = 1});
  const RelaxedPoints first =
      relax_points(surface, std::array<Index, 3>{0, 3, 3}, 1, {.by = AnswerMethod::exact});
  EXPECT_EQ(first.vertices[2], 3);
  EXPECT_NE(first.vertices[1], 3);
  const RelaxedPoints found =
      relax_points(surface, std::array<Index, 3>{0, 3, 3}, 30, {.by = AnswerMethod::exact});
  EXPECT_NE(found.vertices[2], 3);
  EXPECT_TRUE(std::ranges::is_sorted(found.energy, std::greater<>()));
}

}  // namespace
}  // namespace vorogeo
