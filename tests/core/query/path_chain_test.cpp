// Chains of border vertices: each step stays in a patch, and all together are about as long as the route.
#include "query/path_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "query/router.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(PathChain, StepsLieInPatchesAndSumToTheRoute) {
  const test::Shape plane = test::plane_grid(30, 30, 3.0, 3.0, 0.2);
  for (const IndexForm form : {IndexForm::tables, IndexForm::graph}) {
    const auto index = test::make_index(plane.soup, 3, 6, 0.0, 1, form);
    const IndexData& data = index->data();
    Router router(data);
    for (const Index target : {930, 31 * 31 - 1, 500}) {
      const Index s = data.work.work_vertex[0];
      const Index t = data.work.work_vertex[target];
      GraphRoute route;
      router.route(test::route_end(data, s), test::route_end(data, t), route);
      ASSERT_LT(route.length, unreachable);
      const PathChain chain = chain_of_route(data, route, s, t);
      ASSERT_FALSE(chain.steps.empty());
      EXPECT_EQ(chain.source, s);
      EXPECT_EQ(chain.steps.back().vertex, t);
      double length = 0.0;
      Index before = s;
      for (const ChainStep& step : chain.steps) {
        const Point& p = data.work.mesh->position(before);
        const Point& q = data.work.mesh->position(step.vertex);
        length += std::hypot(p[0] - q[0], p[1] - q[1]);
        if (step.patch != no_index) {
          const auto at_start = test::patches_at(*data.work.mesh, data.work.second_layer, before);
          const auto at_end = test::patches_at(*data.work.mesh, data.work.second_layer, step.vertex);
          EXPECT_TRUE(at_start.contains(step.patch) && at_end.contains(step.patch));
        }
        before = step.vertex;
      }
      // Straight from vertex to vertex in a plane: no longer than the tables say, up to their units.
      EXPECT_NEAR(length, route.length, 2e-3 * route.length);
      EXPECT_GE(length, plane.vertex_distance(0, target) * (1.0 - 1e-12));
    }
  }
}

}  // namespace
}  // namespace vorogeo
