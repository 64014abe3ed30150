// Paths over faces of different costs find the shorter side of a vertex.
#include "exact/crossing_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/layers.h"

namespace vorogeo {
namespace {

/// A square with a vertex below its middle. The diagonal passes above that vertex.
const test::Soup square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.3, 0}},
                        {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};

/// From corner to corner over the vertex, along two edges.
CrossingPath over_vertex(const FaceNorms& norms) {
  CrossingPath path(norms, SurfacePoint::at_vertex(0));
  path.go_to({SurfacePoint::at_vertex(4)}, no_index, norms.mesh().edge_between(0, 4));
  path.go_to({SurfacePoint::at_vertex(2)}, no_index, norms.mesh().edge_between(4, 2));
  return path;
}

TEST(CrossingPath, PassesAVertexOnTheShorterSide) {
  const FaceNorms norms(test::with_costs(square, {2.0, 1.0, 1.0, 1.0}, 1), 1);
  CrossingPath path = over_vertex(norms);
  EXPECT_NEAR(path.straighten(), std::sqrt(2.0), 1e-14);
  ASSERT_EQ(path.points().size(), 3u);
  EXPECT_FALSE(path.points()[1].is_vertex());
}

TEST(CrossingPath, StaysAtAVertexWhereTheOtherSideIsDear) {
  const FaceNorms norms(test::with_costs(square, {1.0, 1.0, 10.0, 10.0}, 1), 1);
  CrossingPath path = over_vertex(norms);
  EXPECT_NEAR(path.straighten(), std::hypot(0.5, 0.3) + std::hypot(0.5, 0.7), 1e-14);
  ASSERT_EQ(path.points().size(), 3u);
  EXPECT_EQ(path.points()[1].vertex, 4);
}

}  // namespace
}  // namespace vorogeo
