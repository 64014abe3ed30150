// Points along curves: how many, where, and how far the nearest of them may be.
#include "tasks/curve_sources.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "support/error.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Shape;

/// The edges along y = 0 of a grid of 4 x 2 unit cells.
std::vector<Index> bottom_edges(const Mesh& mesh) {
  std::vector<Index> edges;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const auto [a, b] = mesh.edge_vertices(e);
    if (mesh.position(a)[1] == 0.0 && mesh.position(b)[1] == 0.0) edges.push_back(e);
  }
  return edges;
}

TEST(CurveSources, PointsOfAStraightCurveAreEvenlySpaced) {
  const auto mesh = test::make_mesh(test::plane_grid(4, 2, 4.0, 2.0).soup);
  const auto edges = bottom_edges(*mesh);
  ASSERT_EQ(edges.size(), 4U);
  const auto sources = sources_along_edges(*mesh, edges, 0.3);  // four pieces of 0.25 an edge
  std::set<double> found;
  for (const ExactSource& one : sources) {
    EXPECT_EQ(one.offset, 0.0);
    const Point p = position_of(*mesh, validated(*mesh, one.point));
    EXPECT_EQ(p[1], 0.0);
    found.insert(p[0]);
  }
  ASSERT_EQ(sources.size(), 17U);
  ASSERT_EQ(found.size(), 17U) << "each vertex once";
  double expected = 0.0;
  for (const double x : found) {
    EXPECT_NEAR(x, expected, 1e-15);
    expected += 0.25;
  }
}

TEST(CurveSources, TheFieldIsNeverShorterAndAtMostHalfTheSpacingLonger) {
  const Shape plane = test::plane_grid(4, 2, 4.0, 2.0);
  const auto mesh = test::make_mesh(plane.soup);
  const double spacing = 0.5;
  const auto sources = sources_along_edges(*mesh, bottom_edges(*mesh), spacing);
  for (int i = 0; i <= 80; ++i) {
    for (int j = 0; j <= 40; ++j) {
      const double x = 0.05 * i;
      const double y = 0.05 * j;
      double nearest = unreachable;
      for (const ExactSource& one : sources) {
        const Point p = position_of(*mesh, one.point);
        nearest = std::min(nearest, std::hypot(p[0] - x, p[1] - y));
      }
      EXPECT_GE(nearest, y - 1e-15);
      const double error = y >= 1.0 ? 1.01 * spacing * spacing / (8.0 * y) : 0.5 * spacing;
      EXPECT_LE(nearest, y + error);
    }
  }
}

TEST(CurveSources, ALineInSpaceHasItsInnerPoints) {
  const auto points = points_between({0.0, 0.0, 0.0}, {1.0, 2.0, 2.0}, 1.0);  // of length 3
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(points[0][0], 1.0 / 3.0, 1e-15);
  EXPECT_NEAR(points[1][2], 4.0 / 3.0, 1e-15);
  EXPECT_TRUE(points_between({1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}, 0.1).empty());
  EXPECT_TRUE(points_between({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, unreachable).empty());
}

TEST(CurveSources, BadSpacingsAreRefused) {
  const auto mesh = test::make_mesh(test::plane_grid(4, 2, 4.0, 2.0).soup);
  const auto edges = bottom_edges(*mesh);
  for (const double spacing : {0.0, -1.0, std::nan(""), 1e-9}) {
    EXPECT_THROW(sources_along_edges(*mesh, edges, spacing), InvalidInput) << spacing;
    EXPECT_THROW(points_between({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, spacing), InvalidInput) << spacing;
  }
  // Each edge alone would have fewer than ten million points, all together have more.
  EXPECT_THROW(sources_along_edges(*mesh, edges, 3e-7), InvalidInput);
}

}  // namespace
}  // namespace vorogeo
