// Ends of paths: patches around a point, and distances to the border of its patch.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "query/path_chain.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(PathEnds, APointInAFaceIsBesideItsNearestCorner) {
  const auto index = test::make_index(test::plane_grid(12, 12, 12.0, 12.0).soup, 2, 4);
  const IndexData& data = index->data();
  for (Index face = 0; face < data.mesh->face_count(); face += 17) {
    const auto point = SurfacePoint::in_face(face, {0.1, 0.7, 0.2});
    const PathEnd end = path_end(data, point);
    const Point at = position_of(*data.mesh, point);
    const Point corner = data.work.mesh->position(end.vertex);
    EXPECT_NEAR(end.to_vertex, std::hypot(at[0] - corner[0], at[1] - corner[1]), 1e-12);
    EXPECT_EQ(end.patches.size(), 1U);
    EXPECT_TRUE(are_near(data, end, end));
    // In a plane the distance to a border vertex is the straight line: that of the tables errs by a unit.
    for (const auto& seed : route_end_of(data, end).seeds) {
      const Point border = data.work.mesh->position(data.second.node_vertex[seed.node]);
      EXPECT_NEAR(seed.distance, std::hypot(at[0] - border[0], at[1] - border[1]), 0.02);
    }
  }
}

TEST(PathEnds, AVertexOnABorderIsInAllItsPatches) {
  const auto index = test::make_index(test::plane_grid(12, 12, 12.0, 12.0).soup, 2, 4);
  const IndexData& data = index->data();
  int on_border = 0;
  for (Index v = 0; v < data.mesh->vertex_count(); ++v) {
    const PathEnd end = path_end(data, SurfacePoint::at_vertex(v));
    EXPECT_EQ(end.to_vertex, 0.0);
    const bool is_node = data.second.vertex_node[end.vertex] != no_index;
    EXPECT_EQ(end.patches.size() > 1, is_node);
    on_border += is_node ? 1 : 0;
  }
  EXPECT_GT(on_border, 0);
}

}  // namespace
}  // namespace vorogeo
