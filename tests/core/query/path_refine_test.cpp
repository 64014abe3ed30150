// Refined paths: points on the line pulled tight, and paths that pass edges of no length.
#include "query/path_refine.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/path_check.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(PathRefine, ALineAcrossAnEdgeOfNoLengthPassesItsPlace) {
  // Two triangles that meet tip to tip, joined by two faces without area: the only path leads through the
  // tip.
  test::Soup soup;
  soup.positions = {{-1.0, -1.0, 0.0}, {-1.0, 1.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {1.0, 0.5, 0.0}};
  soup.faces = {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}};
  const auto mesh = test::make_mesh(soup);
  const ExactGeometry geometry(mesh);
  FaceStrip strip;
  strip.source = SurfacePoint::at_vertex(0);
  strip.target = SurfacePoint::at_vertex(4);
  strip.faces.push_back(0);
  for (const Index face : {1, 2}) ASSERT_TRUE(turn_around(*mesh, strip, 2, face));
  PathRefiner refiner(geometry);
  EXPECT_NEAR(refiner.refine(strip), std::sqrt(2.0) + std::hypot(1.0, 0.5), 1e-12);
  EXPECT_EQ(test::path_fault(*mesh, refiner.path(), strip.source, strip.target), "");
}

}  // namespace
}  // namespace vorogeo
