// Runs in which neighbouring windows are merged: how far they deviate, and what they save.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/exact_solver.h"
#include "support/indexes.h"
#include "support/small_copy.h"

namespace vorogeo {
namespace {

struct Merged {
  double least = 0.0;     ///< largest amount by which a distance is too short, in mean edges
  double greatest = 0.0;  ///< and too long
  double windows = 0.0;   ///< relative to those of the exact run
};

Merged merged(const test::Soup& soup, double tolerance) {
  const auto mesh = test::make_mesh(soup);
  ExactSolver exact(mesh);
  ExactSolver solver(mesh);
  Merged result;
  std::size_t made = 0;
  std::size_t made_exactly = 0;
  ExactLimits limits;
  limits.merge_tolerance = tolerance;
  for (Index source : test::random_vertices(mesh->vertex_count(), 5, 3)) {
    exact.run_from_vertices(std::array{source});
    solver.run_from_vertices(std::array{source}, limits);
    made += solver.window_count();
    made_exactly += exact.window_count();
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      const double difference = (solver.distance(v) - exact.distance(v)) / mesh->mean_edge_length();
      result.least = std::min(result.least, difference);
      result.greatest = std::max(result.greatest, difference);
    }
  }
  result.windows = static_cast<double>(made) / static_cast<double>(made_exactly);
  return result;
}

TEST(WindowMerging, InThePlaneItChangesNextToNothing) {
  const Merged found = merged(test::plane_grid(30, 30, 1.0, 1.0, 0.2).soup, 1e-3);
  EXPECT_GT(found.least, -1e-5);
  EXPECT_LT(found.greatest, 1e-5);
}

TEST(WindowMerging, SavesWindowsAndErrsByLittleMoreThanItsTolerance) {
  // A path crosses dozens of edges; what their windows deviate by adds up in part.
  constexpr double tolerance = 2e-4;
  for (const test::Soup& soup : {test::icosphere(4), test::hills(40, 0.12), test::random_sphere(2000, 4)}) {
    const Merged found = merged(soup, tolerance);
    EXPECT_GT(found.least, -20.0 * tolerance);
    EXPECT_LT(found.greatest, 20.0 * tolerance);
    EXPECT_LT(found.windows, 0.9);
  }
}

TEST(WindowMerging, DistancesInASmallPartAreAsRightAsOthers) {
  // The needles that join the parts have edges a million times as long as distances in the small part.
  constexpr double tolerance = 2e-4;
  const test::Soup soup = test::with_small_copy(test::plane_grid(12, 12, 1.0, 1.0, 0.2).soup, 1e-7);
  const auto mesh = test::make_mesh(soup);
  ExactSolver exact(mesh);
  ExactSolver solver(mesh);
  ExactLimits limits;
  limits.merge_tolerance = tolerance;
  for (Index source : test::random_vertices(mesh->vertex_count(), 20, 3)) {
    exact.run_from_vertices(std::array{source});
    solver.run_from_vertices(std::array{source}, limits);
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      EXPECT_NEAR(solver.distance(v), exact.distance(v), 20.0 * tolerance * exact.distance(v));
    }
  }
}

TEST(WindowMerging, DoesNotBringWindowsRoundAFarOutlierNearer) {
  // High up, each time round an outlier takes less than the rounding of distances there: the run had no end.
  test::Soup soup = test::hills(60, 2.0);
  const double height = 1e12 * test::make_mesh(soup)->typical_edge_length();
  for (const Index v : test::random_vertices(static_cast<Index>(soup.positions.size()), 100, 1)) {
    soup.positions[v][2] -= height;
  }
  ExactSolver solver(test::make_mesh(soup));
  solver.run_from_vertices(std::array<Index, 1>{912}, {.merge_tolerance = 2e-4});
  EXPECT_LT(solver.window_count(), 100000U);
}

}  // namespace
}  // namespace vorogeo
