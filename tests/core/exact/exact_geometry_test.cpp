// Faces unfolded next to their edges, and the corners around vertices.
#include "exact/exact_geometry.h"

#include <gtest/gtest.h>

#include <numbers>

#include "support/shapes.h"

namespace vorogeo {
namespace {

using std::numbers::pi;

TEST(ExactGeometry, PathsBendAtSaddlesBordersAndNonManifoldVertices) {
  auto bends = [](const test::Soup& soup, Index vertex) {
    return ExactGeometry(test::make_mesh(soup)).can_bend[vertex] != 0;
  };
  EXPECT_FALSE(bends(test::cone(8, 2, 1.5 * pi, 1.0).soup, 0));
  EXPECT_TRUE(bends(test::cone(8, 2, 2.5 * pi, 1.0).soup, 0));
  EXPECT_FALSE(bends(test::icosphere(1), 3));
  EXPECT_TRUE(bends(test::plane_grid(4, 4, 1.0, 1.0).soup, 0));
  EXPECT_TRUE(bends(test::plane_grid(4, 4, 1.0, 1.0).soup, 12)) << "a flat vertex counts as a saddle";
  EXPECT_FALSE(bends(test::with_isolated_vertex(test::icosphere(0), {0, 0, 0}), 12));
  const test::Soup bow = test::bow_tie(2).soup;
  const auto mesh = test::make_mesh(bow);
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    if (mesh->fan(v) != Mesh::Fan::non_manifold) continue;
    EXPECT_TRUE(bends(bow, v));
  }
}

TEST(ExactGeometry, PositionsCountFromTheEndThatIsNoOutlier) {
  // Two outliers next to each other, whose common edge is shorter than those of all others.
  test::Soup soup = test::plane_grid(8, 8, 8.0, 8.0, 0.0).soup;
  for (const Index v : {40, 41}) soup.positions[v][2] = 1e12;
  soup.positions[40][0] = soup.positions[41][0] - 0.25;
  const auto mesh = test::make_mesh(soup);
  const ExactGeometry geometry(mesh);
  int long_edges = 0;
  for (Index e = 0; e < mesh->edge_count(); ++e) {
    if (!geometry.is_long(e)) continue;
    ++long_edges;
    EXPECT_TRUE(geometry.ends(e)[0] != 40 && geometry.ends(e)[0] != 41) << e;
    EXPECT_DOUBLE_EQ(geometry.fineness[e], 1.0);
  }
  EXPECT_EQ(long_edges, 10);
}

}  // namespace
}  // namespace vorogeo
