// Two points by unfolding: exact for nearly all far points of a plane, wrong for near ones on a rough
// surface.
#include <gtest/gtest.h>

#include <ctime>

#include "support/error.h"
#include "support/indexes.h"
#include "support/methods.h"

namespace vorogeo {
namespace {

TEST(GtuMethod, PointsOfAPlaneUnfoldExactly) {
  const auto shape = test::plane_grid(20, 20, 1.0, 1.0, 0.2);
  const auto method = prepare_method("gtu", test::make_mesh(shape.soup), {{"m", 40.0}}, {});
  int wrong = 0;
  int pairs = 0;
  for (Index a = 0; a < 441; a += 17) {
    for (Index b = 5; b < 441; b += 23) {
      const double expected = shape.vertex_distance(a, b);
      if (expected == 0.0) continue;
      ++pairs;
      wrong += std::abs(method->pair(a, b) / expected - 1.0) > 1e-6;
      EXPECT_EQ(method->pair(a, b), method->pair(b, a));
    }
  }
  EXPECT_GT(pairs, 400);
  EXPECT_LE(wrong, pairs / 10) << "only points outside all triangles, at the border, may be wrong";
}

TEST(GtuMethod, NearPointsFailOnARoughSurface) {
  // The weakness that the literature names: errors are as large as the bumps inside a triangle, which counts
  // for two points in it or in the one beside it.
  const auto mesh = test::make_mesh(test::hills(30, 0.4));
  const auto method = prepare_method("gtu", mesh, {{"m", 60.0}}, {});
  double error[2] = {0.0, 0.0};
  int count[2] = {0, 0};
  for (Index source = 50; source < mesh->vertex_count(); source += 211) {
    const auto exact = exact_distance_field(mesh, std::vector<Index>{source});
    const double farthest = std::ranges::max(exact);
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      if (v == source) continue;
      const int near = exact[v] < farthest / 8.0 ? 1 : 0;
      error[near] += std::abs(method->pair(source, v) / exact[v] - 1.0);
      ++count[near];
    }
  }
  EXPECT_LT(error[0] / count[0], 0.1);
  EXPECT_GT(error[1] / count[1], 2.0 * error[0] / count[0]);
}

TEST(GtuMethod, MoreSamplesErrLess) {
  const auto mesh = test::make_mesh(test::icosphere(3));
  const double few = test::errors_against_exact("gtu", mesh, 7, {{"m", 20.0}}).mean;
  const double many = test::errors_against_exact("gtu", mesh, 7, {{"m", 160.0}}).mean;
  EXPECT_LT(many, 0.5 * few);
  EXPECT_LT(many, 0.03);
}

TEST(GtuMethod, TheTimeOfAPairDoesNotGrowWithTheMesh) {
  const auto seconds_of = [](int subdivisions) {
    const auto mesh = test::make_mesh(test::icosphere(subdivisions));
    const auto method = prepare_method("gtu", mesh, {{"m", 12.0}}, {});
    double least = 1.0;
    double sum = 0.0;
    for (int round = 0; round < 5; ++round) {
      const std::clock_t start = std::clock();
      for (Index i = 0; i < 20000; ++i) {
        sum += method->pair(i % mesh->vertex_count(), (i * 31 + 7) % mesh->vertex_count());
      }
      least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    EXPECT_GT(sum, 0.0);
    return least;
  };
  EXPECT_LT(seconds_of(4), 4.0 * seconds_of(2));  // 16 times as many vertices
}

TEST(GtuMethod, RefusesMoreComponentsThanSamples) {
  const auto two = test::two_components(test::icosphere(1), test::icosphere(1));
  const auto mesh = test::make_mesh(test::two_components(two, two));
  EXPECT_THROW(prepare_method("gtu", mesh, {{"m", 3.0}}, {}), InvalidInput);
  EXPECT_EQ(prepare_method("gtu", mesh, {{"m", 4.0}}, {})->pair(0, 50), unreachable);
}

}  // namespace
}  // namespace vorogeo
