// Virtual sources: exact on a plane up to bends, good on curved surfaces.
#include "methods/virtual_sources.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/error.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

test::ErrorStatistics errors_of(VirtualSources& runs, Index source) {
  runs.run({&source, 1});
  ExactSolver exact(std::make_shared<const Mesh>(runs.mesh()));
  exact.run_from_vertices({&source, 1});
  test::ErrorCollector collector;
  for (Index v = 0; v < runs.mesh().vertex_count(); ++v) collector.add(runs.distance(v), exact.distance(v));
  EXPECT_EQ(collector.contradictions, 0U);
  return collector.statistics();
}

TEST(VirtualSources, AreExactOnAPlane) {
  // Seen past a vertex without angle defect, the virtual source is at the source.
  const test::Shape shape = test::plane_grid(20, 16, 1.0, 0.8, 0.2, 3);
  VirtualSources runs(test::make_mesh(shape.soup));
  const Index source = 175;
  runs.run({&source, 1});
  int exact = 0;
  for (Index v = 0; v < runs.mesh().vertex_count(); ++v) {
    const double straight = shape.vertex_distance(175, v);
    EXPECT_GE(runs.distance(v), straight - 1e-12);
    EXPECT_LE(runs.distance(v), 1.01 * straight);
    exact += runs.distance(v) <= straight * (1.0 + 1e-12) ? 1 : 0;
  }
  EXPECT_GT(exact, 250);  // of 357
}

TEST(VirtualSources, GoRoundTheEndsOfASlit) {
  VirtualSources runs(test::make_mesh(test::plane_with_slit(8).soup));
  EXPECT_LT(errors_of(runs, 3).mean, 0.003);
}

TEST(VirtualSources, PassAnEdgeOfNoLengthThatAloneLeadsOn) {
  // Two faces, one on each side of an edge that is too short to have a direction: 1 to the edge, 2 behind it.
  for (int turn = 0; turn < 3; ++turn) {
    test::Soup soup;
    soup.positions = {{0.0, 0.0, 0.0}, {1e-15, 0.0, 0.0}, {0.6, 0.8, 0.0}, {-1.2, -1.6, 0.0}};
    soup.faces = {{0, 1, 2}, {1, 0, 3}};
    for (auto& face : soup.faces) std::ranges::rotate(face, face.begin() + turn);
    VirtualSources runs(test::make_mesh(soup));
    const Index source = 2;
    runs.run({&source, 1});
    EXPECT_NEAR(runs.distance(0), 1.0, 1e-14);
    EXPECT_NEAR(runs.distance(1), 1.0, 1e-14);
    EXPECT_NEAR(runs.distance(3), 3.0, 1e-14);
    const Index end = 0;
    runs.run({&end, 1});
    EXPECT_NEAR(runs.distance(2), 1.0, 1e-14);
    EXPECT_NEAR(runs.distance(3), 2.0, 1e-14);
  }
}

TEST(VirtualSources, AreWithinThreeTenthsOfAPercentOnSmoothSurfaces) {
  VirtualSources sphere(test::make_mesh(test::icosphere(5)));
  EXPECT_LT(errors_of(sphere, 7).mean, 0.003);
  VirtualSources hills(test::make_mesh(test::hills(40, 0.4)));
  EXPECT_LT(errors_of(hills, 7).mean, 0.005);
}

TEST(VirtualSources, RefuseLengthsWhoseProductsOverflow) {
  EXPECT_THROW(VirtualSources(test::make_mesh(test::plane_grid(2, 2, 1e150, 1e150).soup)), InvalidInput);
}

}  // namespace
}  // namespace vorogeo
