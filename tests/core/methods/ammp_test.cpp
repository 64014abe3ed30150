// Merged windows: the error that the method promises, and what the tolerance buys.
#include <gtest/gtest.h>

#include <numbers>

#include "methods/window_methods.h"
#include "support/indexes.h"
#include "support/methods.h"
#include "support/ply.h"

namespace vorogeo {
namespace {

/// Distances are off by no more than eps typical edges for each edge that the shortest path crosses.
void expect_promise(const test::Soup& soup, double eps) {
  const auto mesh = test::make_mesh(soup);
  const auto field = test::method_field("ammp", mesh, {1}, {{"eps", eps}});
  ExactSolver solver(mesh);
  solver.run_from_vertices(std::vector<Index>{1});
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    const auto path = solver.path_to_source(SurfacePoint::at_vertex(v));
    const double promised = eps * mesh->typical_edge_length() * static_cast<double>(path.points.size());
    ASSERT_NEAR(field[v], solver.distance(v), promised + 1e-9) << v;
  }
}

TEST(AmmpMethod, KeepsItsPromise) {
  for (double eps : {1e-4, 1e-3, 1e-2}) {
    expect_promise(test::icosphere(4), eps);
    expect_promise(test::hills(40, 0.4), eps);
    expect_promise(test::torus(40, 20, 2.0, 0.7), eps);
    expect_promise(test::random_sphere(600, 3), eps);
    expect_promise(test::drilled_plate(3, 2, 0.4, 5), eps);
    expect_promise(test::gear(16, 10, 0.5), eps);
  }
}

TEST(AmmpMethod, WithoutToleranceIsExact) {
  const auto errors =
      test::errors_against_exact("ammp", test::make_mesh(test::hills(30, 0.4)), 7, {{"eps", 0.0}});
  EXPECT_EQ(errors.greatest, 0.0);
}

TEST(AmmpMethod, ReusesNothingForTheNextSource) {
  // The weakness that the literature names: what a source costs is paid for every source.
  WindowRuns runs(test::make_mesh(test::icosphere(4)), 3e-4);
  runs.field(std::vector<Index>{7}, {});
  const std::size_t windows = runs.window_count();
  for (const Index source : {8, 100, 7}) {
    runs.field(std::vector<Index>{source}, {});
    EXPECT_GT(runs.window_count(), windows / 2) << source;
  }
  EXPECT_EQ(runs.window_count(), windows);
}

TEST(AmmpMethod, OnTheBunnyIsOffByHundredThousandthsInTheMean) {
  VOROGEO_READ_OR_SKIP(soup, "bunny");
  const auto errors = test::errors_against_exact("ammp", test::make_mesh(soup), 5);
  EXPECT_LT(errors.mean, 6e-5);
  EXPECT_LT(errors.greatest, 3e-4);
}

}  // namespace
}  // namespace vorogeo
