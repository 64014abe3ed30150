// Walks to a border vertex of a patch: they arrive, over faces of the patch.
#include <gtest/gtest.h>

#include "query/path_chain.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(StepWalk, ArrivesFromEveryMemberOfAPatch) {
  const auto index = test::make_index(test::hills(16, 0.5), 2, 4);
  const IndexData& data = index->data();
  for (Index patch = 0; patch < data.second.patch_count; ++patch) {
    const Index goal = data.second.node_vertex[data.second.nodes(patch).front()];
    for (const Index start : data.second.members(patch)) {
      StepWalk walk(data, patch, start, goal);
      // A patch has fewer faces than the mesh; a walk stops a few times in each.
      for (Index stops = 0; walk.go_on(); ++stops) ASSERT_LT(stops, 10 * data.work.mesh->face_count());
      ASSERT_TRUE(walk.arrived());
      EXPECT_EQ(walk.passed().empty(), start == goal);
    }
  }
}

TEST(StepWalk, GoesAlongEdgesWhereThereIsNoPatch) {
  const auto index = test::make_index(test::plane_grid(6, 6, 6.0, 6.0).soup, 1, 2);
  const IndexData& data = index->data();
  const Index start = data.work.work_vertex[0];
  const Index goal = data.work.work_vertex[5];
  StepWalk walk(data, no_index, start, goal);
  while (walk.go_on()) {
  }
  EXPECT_TRUE(walk.arrived());
  EXPECT_EQ(walk.passed().size(), 5U);  // five edges along the side of the square
}

}  // namespace
}  // namespace vorogeo
