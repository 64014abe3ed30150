// A corridor leaves out what cannot be on a path to its target, and nothing that can.
#include <gtest/gtest.h>

#include <array>

#include "exact/exact_solver.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(Corridor, FollowsFewerWindowsToTheSameDistance) {
  const test::Shape plane = test::plane_grid(20, 20, 1.0, 1.0, 0.2);
  const auto mesh = test::make_mesh(plane.soup);
  ExactSolver solver(mesh);
  const std::array<Index, 1> source{40};
  for (const Index target : {44, 200, 399}) {
    solver.run_from_vertices(source);
    const std::size_t all = solver.window_count();
    ExactLimits limits;
    limits.max_distance = plane.vertex_distance(40, target) * (1.0 + 1e-9);
    limits.corridor_target = target;
    solver.run_from_vertices(source, limits);
    EXPECT_NEAR(solver.distance(target), plane.vertex_distance(40, target), 1e-12);
    EXPECT_LT(solver.window_count(), all / 2);
  }
}

}  // namespace
}  // namespace vorogeo
