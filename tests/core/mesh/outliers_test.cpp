// Which vertices are outliers, and the typical edge length, which they do not change.
#include "mesh/outliers.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace vorogeo {
namespace {

/// A flat grid of unit cells; vertex (i, j) is 21 j + i.
test::Soup grid() { return test::plane_grid(20, 20, 20.0, 20.0).soup; }

TEST(Outliers, AnOrdinaryMeshHasNone) {
  const Outliers found = find_outliers(*test::make_mesh(grid()));
  EXPECT_EQ(found.count, 0);
  EXPECT_EQ(found.first, no_index);
  EXPECT_FALSE(found.is_outlier(0));
}

TEST(Outliers, AreCountedAndGroupedByTheirEdges) {
  test::Soup soup = grid();
  for (Index v : {100, 101, 300}) soup.positions[v][2] = 1e4;
  const auto mesh = test::make_mesh(soup);
  const Outliers found = find_outliers(*mesh);
  EXPECT_EQ(found.count, 3);
  EXPECT_EQ(found.first, 100);
  EXPECT_EQ(found.group_of(100), found.group_of(101));
  EXPECT_NE(found.group_of(100), found.group_of(300));
  EXPECT_EQ(found.group_size[found.group_of(101)], 2);
  EXPECT_EQ(found.group_size[found.group_of(300)], 1);
  EXPECT_FALSE(found.is_outlier(99));
  EXPECT_NEAR(found.least_ratio * mesh->typical_edge_length(), 1e4, 1.0);
}

TEST(Outliers, TwoHalvesJoinedByLongEdgesAreNone) {
  test::Soup soup = test::box({1.0, 1.0, 1.0}, 1).soup;
  for (Point& p : soup.positions) p[2] *= 1e4;
  EXPECT_EQ(find_outliers(*test::make_mesh(soup)).count, 0);
}

TEST(Outliers, EachComponentHasItsOwn) {
  test::Soup far = grid();
  for (Point& p : far.positions) p[0] += 1e6;
  test::Soup soup = test::two_components(grid(), far);
  EXPECT_EQ(find_outliers(*test::make_mesh(soup)).count, 0);
  soup.positions.back()[0] += 1e6;
  const Outliers found = find_outliers(*test::make_mesh(soup));
  EXPECT_EQ(found.count, 1);
  EXPECT_EQ(found.first, static_cast<Index>(soup.positions.size()) - 1);
}

TEST(Outliers, LeaveTheTypicalEdgeAsItIs) {
  test::Soup soup = grid();
  const double before = test::make_mesh(soup)->typical_edge_length();
  EXPECT_DOUBLE_EQ(before, test::make_mesh(soup)->mean_edge_length());
  soup.positions[200][2] = 1e12;
  EXPECT_NEAR(test::make_mesh(soup)->typical_edge_length(), before, 0.01 * before);
  // Half of the vertices in one point: the edges that have a length are the scale.
  test::Soup collapsed = grid();
  for (std::size_t v = 0; v < collapsed.positions.size() / 2; ++v) collapsed.positions[v] = {};
  EXPECT_GT(test::make_mesh(collapsed)->typical_edge_length(), 0.1);
}

}  // namespace
}  // namespace vorogeo
