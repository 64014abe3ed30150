// Runs whose edges drop their windows behind the front: the same distances in less memory.
#include <gtest/gtest.h>

#include "exact/exact_solver.h"
#include "support/near.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::expect_near;

TEST(Closing, DistancesOnlyGivesTheSameDistancesInLessMemory) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const auto mesh = test::make_mesh(test::random_sphere(1500, seed));
    ExactSolver all(mesh);
    ExactSolver only(mesh);
    const std::array<Index, 2> sources{3, static_cast<Index>(700 + seed)};
    const auto used = std::span(sources).first(1 + seed % 2);
    all.run_from_vertices(used);
    only.run_from_vertices(used, {.distances_only = true});
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      expect_near(only.distance(v), all.distance(v), *mesh, 1e-12, "vertex " + std::to_string(v));
      ASSERT_EQ(only.nearest_source(v), all.nearest_source(v)) << "vertex " << v;
    }
    EXPECT_LT(only.memory_bytes(), all.memory_bytes());
    EXPECT_THROW(only.path_to_source(SurfacePoint::at_vertex(0)), std::logic_error);
    EXPECT_THROW((void)only.distance(SurfacePoint::in_face(0, {0.2, 0.3, 0.5})), std::logic_error);
  }
}

}  // namespace
}  // namespace vorogeo
