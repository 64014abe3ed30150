// Runs that several solvers share, and the solvers' territories.
#include "exact/shared_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "exact/exact_solver.h"
#include "exact/territories.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/near.h"
#include "support/parallel.h"
#include "support/progress.h"

namespace vorogeo {
namespace {

// Runs that several solvers share: the same answers as of one solver, and cancelling.

using test::expect_near;

/// Compares fields from three sources up to a limit by one thread and by several, all in one solver.
void expect_equal(const test::Soup& soup, double max_distance) {
  const auto last = static_cast<Index>(soup.faces.size()) - 1;
  const std::vector<ExactSource> sources{{SurfacePoint::at_vertex(0), 0.1},
                                         {SurfacePoint::in_face(last / 2, {0.2, 0.3, 0.5})},
                                         {SurfacePoint::in_face(last / 3, {0.4, 0.6, 0.0}), 0.02}};
  const auto mesh = test::make_mesh(soup);
  ExactSolver alone(mesh);
  alone.run(sources, {.max_distance = max_distance, .distances_only = true});
  ExactSolver several(mesh);
  for (int threads : {2, 5, 1, 1000}) {
    several.run(sources, {.max_distance = max_distance, .distances_only = true, .threads = threads});
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      expect_near(several.distance(v), alone.distance(v), *mesh, 1e-12, "vertex " + std::to_string(v));
      ASSERT_EQ(several.nearest_source(v) == no_index, alone.distance(v) == unreachable);
    }
  }
}

/// A rough ridge of `points` between two far vertices: needles on both sides.
test::Soup ridge(int points) {
  test::Soup soup{{{0.5, -1.0, 0.0}, {0.5, 1.0, 0.0}}, {}};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> offset(-0.5, 0.5);
  for (int i = 0; i < points; ++i) {
    soup.positions.push_back({1.0 * i / points, offset(random) / points, offset(random) / points});
    if (i == 0) continue;
    soup.faces.push_back({0, i + 2, i + 1});
    soup.faces.push_back({1, i + 1, i + 2});
  }
  return soup;
}

TEST(SharedRun, OnNeedlesAndSmallPartsItMakesAsManyWindowsAsOneSolver) {
  for (const test::Soup& soup :
       {ridge(400), test::with_small_copy(test::plane_grid(24, 24, 1.0, 1.0, 0.2).soup, 1e-3)}) {
    const auto mesh = test::make_mesh(soup);
    ExactSolver alone(mesh);
    alone.run_from_vertices(std::array<Index, 1>{300}, {.distances_only = true});
    ExactSolver several(mesh);
    several.run_from_vertices(std::array<Index, 1>{300}, {.distances_only = true, .threads = 3});
    EXPECT_LT(several.window_count(), 1.5 * alone.window_count());
  }
}

TEST(SharedRun, EqualsOneSolverFromSeveralSourcesAndUpToALimit) {
  expect_equal(test::drilled_plate(4, 3, 0.3, 2), unreachable);
  expect_equal(test::hills(30, 3.0), 9.0);
  // Lengths whose ratio exceeds the number of buckets of a queue.
  test::Soup outliers = test::icosphere(3);
  for (Index v : {11, 222}) {
    for (double& coordinate : outliers.positions[v]) coordinate *= 1e5;
  }
  expect_equal(outliers, unreachable);
}

TEST(SharedRun, EndsWhereAllEdgesHaveNoLength) {
  const auto mesh = test::make_mesh({{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 1, 2}, {1, 3, 2}}});
  ExactSolver several(mesh);
  several.run_from_vertices(std::array{Index{0}}, {.distances_only = true, .threads = 2});
  for (Index v = 0; v < 4; ++v) EXPECT_EQ(several.distance(v), 0.0);
}

TEST(SharedRun, IsCancelledAndReportsProgress) {
  // Large enough for several reports.
  const auto mesh = test::make_mesh(test::icosphere(6));
  ExactSolver solver(mesh);
  double reached = 0.0;
  const Progress watching([&](double fraction, const std::string&) {
    EXPECT_LE(fraction, 1.0);
    reached = std::max(reached, fraction);
    return true;
  });
  ExactLimits limits{.distances_only = true, .threads = 2, .progress = &watching};
  solver.run_from_vertices(std::array<Index, 1>{0}, limits);
  const double farthest = solver.distance(1);
  const Progress stop([](double, const std::string&) { return false; });
  limits.progress = &stop;
  EXPECT_THROW(solver.run_from_vertices(std::array<Index, 1>{0}, limits), Cancelled);
  limits.progress = nullptr;
  {
    const Watch watch([] { throw Cancelled(); });
    EXPECT_THROW(solver.run_from_vertices(std::array<Index, 1>{0}, limits), Cancelled);
  }
  // A run that was cancelled leaves nothing behind.
  solver.run_from_vertices(std::array<Index, 1>{0}, limits);
  EXPECT_EQ(solver.distance(1), farthest);
}

// Territories: books of thousands of pages take no longer than other meshes.

TEST(Territories, OfABookOfThousandsOfPagesAreFoundAtOnce) {
  const auto mesh = test::make_mesh(test::book_of_pages(20'000));
  const double start = thread_seconds();
  const Territories territories(*mesh, 2);
  // Work quadratic in the pages would take seconds.
  EXPECT_LT(thread_seconds() - start, 0.5);
  const auto owned = std::count(territories.of_edge.begin(), territories.of_edge.end(), 0);
  EXPECT_NEAR(static_cast<double>(owned), 20'000.0, 4'000.0);
}

}  // namespace
}  // namespace vorogeo
