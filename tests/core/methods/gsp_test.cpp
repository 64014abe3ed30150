// Virtual sources: exact where one source sees all, good on smooth surfaces, without a bound round corners.
#include <gtest/gtest.h>

#include <numbers>

#include "support/indexes.h"
#include "support/methods.h"

namespace vorogeo {
namespace {

TEST(GspMethod, OnAPlaneIsExactExceptWhereAFaceIsTakenToBeOutOfSight) {
  const test::Shape shape = test::plane_grid(20, 16, 1.0, 0.8, 0.2, 3);
  const auto field = test::method_field("gsp", test::make_mesh(shape.soup), {175});
  int exact = 0;
  for (Index v = 0; v < static_cast<Index>(field.size()); ++v) {
    const double straight = shape.vertex_distance(175, v);
    EXPECT_NEAR(field[v], straight, 0.02 * straight);
    EXPECT_GE(field[v], straight - 1e-9);
    exact += field[v] < straight + 1e-9 ? 1 : 0;
  }
  EXPECT_GT(exact, 250);  // of 357
}

TEST(GspMethod, GoesRoundAnEndOfASlit) {
  const test::Shape shape = test::plane_with_slit(8);
  const auto mesh = test::make_mesh(shape.soup);
  const auto errors = test::errors_against_exact("gsp", mesh, 3);
  EXPECT_LT(errors.mean, 0.01);
}

TEST(GspMethod, IsAccurateOnSmoothSurfacesButNotEverywhere) {
  const auto errors = test::errors_against_exact("gsp", test::make_mesh(test::icosphere(5)), 7);
  EXPECT_LT(errors.mean, 0.004);
  // One virtual source a face is too few behind a ridge: distances are too short, too.
  const auto hills = test::errors_against_exact("gsp", test::make_mesh(test::hills(40, 0.4)), 7);
  EXPECT_LT(hills.mean, 0.01);
  EXPECT_LT(hills.least, -1e-4);
}

}  // namespace
}  // namespace vorogeo
