// The heat method on closed forms and on needles, where the literature says that it fails.
#include <gtest/gtest.h>

#include <numbers>

#include "support/methods.h"

namespace vorogeo {
namespace {

TEST(HeatMethod, ConvergesOnASphere) {
  const auto coarse = test::errors_against_exact("heat", test::make_mesh(test::icosphere(3)), 7);
  const auto fine = test::errors_against_exact("heat", test::make_mesh(test::icosphere(5)), 7);
  EXPECT_LT(fine.mean, 0.5 * coarse.mean);
  EXPECT_LT(fine.mean, 0.01);
}

TEST(HeatMethod, FollowsAPlaneWave) {
  // Heat from one end of a tube falls along the tube, but for the diagonals' unequal masses.
  const auto shape = test::prism(12, 1, 8, 0.5, 3.0);
  const auto mesh = test::make_mesh(shape.soup);
  std::vector<Index> end;
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    if (mesh->position(v)[2] < 1e-9) end.push_back(v);
  }
  ASSERT_EQ(end.size(), 12u);
  const auto field = test::method_field("heat", mesh, end);
  for (Index v = 0; v < mesh->vertex_count(); ++v) EXPECT_NEAR(field[v], mesh->position(v)[2], 0.05);
}

TEST(HeatMethod, NeedlesSpoilItAndTheIntrinsicTriangulationHelps) {
  const auto mesh = test::make_mesh(test::gear(24, 16, 0.4));
  const auto plain = test::errors_against_exact("heat", mesh, 5);
  const auto delaunay = test::errors_against_exact("heat", mesh, 5, {{"delaunay", 1.0}});
  EXPECT_GT(plain.mean, 0.05);
  EXPECT_LT(delaunay.mean, plain.mean);
}

}  // namespace
}  // namespace vorogeo
