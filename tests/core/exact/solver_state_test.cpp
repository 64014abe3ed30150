// Lower bounds of a corridor, from straight lines in space.
#include "exact/solver_state.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(SolverState, LengthsToTheTargetAreNeverAboveThePath) {
  const auto mesh = test::make_mesh(test::plane_grid(6, 6, 1.0, 1.0).soup);
  ExactSolver::State state(std::make_shared<const ExactGeometry>(mesh));
  EXPECT_EQ(state.length_at_vertex(0.25, 3), 0.25) << "without a target";
  EXPECT_TRUE(state.in_corridor(1e9));
  state.has_corridor = true;
  state.corridor_at = {1.0, 1.0, 0.0};
  state.max_distance = 1.0;
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    // In the plane the straight line is the path.
    EXPECT_NEAR(state.length_at_vertex(0.25, v),
                0.25 + distance_between(mesh->position(v), state.corridor_at), 1e-15);
  }
  for (Index e = 0; e < mesh->edge_count(); ++e) {
    const auto [a, b] = mesh->edge_vertices(e);
    EXPECT_LE(state.length_at_edge(0.0, e) - 1e-12,
              std::min(state.length_at_vertex(0.0, a), state.length_at_vertex(0.0, b)));
  }
  EXPECT_TRUE(state.in_corridor(1.0));
  EXPECT_FALSE(state.in_corridor(1.0 + 1e-6));
}

}  // namespace
}  // namespace vorogeo
