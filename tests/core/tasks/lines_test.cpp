// Lines on a surface: how they are assembled, isolines, and points along curves.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "support/error.h"
#include "support/shapes.h"
#include "tasks/curve_sources.h"
#include "tasks/surface_lines.h"

namespace vorogeo {
namespace {

using test::Shape;

// ---- Points shared by neighbouring faces, and segments that are kept once

class SurfaceLinesTest : public testing::Test {
 protected:
  std::shared_ptr<const Mesh> mesh_ = test::make_mesh(test::plane_grid(1, 1, 3.0, 4.0).soup);
  LineBuilder builder_{*mesh_};
  /// The edge between the vertices (0, 0) and (3, 0).
  Index bottom() const {
    for (Index e = 0; e < mesh_->edge_count(); ++e) {
      if (mesh_->edge_vertices(e)[0] == 0 && mesh_->edge_vertices(e)[1] == 1) return e;
    }
    return no_index;
  }
};

TEST_F(SurfaceLinesTest, AnEdgeHasOnePointForEachLine) {
  const Index first = builder_.on_edge(bottom(), 0.5, 7);
  EXPECT_EQ(builder_.on_edge(bottom(), 0.5 + 1e-12, 7), first);
  EXPECT_NE(builder_.on_edge(bottom(), 0.5, 8), first);
  const SurfaceLines lines = builder_.take();
  ASSERT_EQ(lines.points.size(), 2U);
  EXPECT_EQ(lines.points[0], (Point{1.5, 0.0, 0.0}));
}

TEST_F(SurfaceLinesTest, AtTheEndOfAnEdgeItIsThePointOfTheVertex) {
  EXPECT_EQ(builder_.on_edge(bottom(), 0.0, 1), builder_.at_vertex(0, 1));
  EXPECT_EQ(builder_.on_edge(bottom(), 1.0, 1), builder_.at_vertex(1, 1));
  EXPECT_NE(builder_.at_vertex(0, 1), builder_.at_vertex(0, 2));
}

TEST_F(SurfaceLinesTest, SegmentsHaveALengthAndAreKeptOnce) {
  const Index a = builder_.at_vertex(0, 1);  // (0, 0)
  const Index b = builder_.at_vertex(3, 1);  // (3, 4)
  const Index middle = builder_.in_face(0, {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0}, 5);
  EXPECT_EQ(builder_.in_face(0, {1.0, 0.0, 0.0}, 5), middle) << "the name of a point decides, not its place";
  EXPECT_NE(builder_.in_face(0, {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0}, 6), middle);
  EXPECT_TRUE(builder_.add_segment(b, a));
  EXPECT_FALSE(builder_.add_segment(a, b));
  EXPECT_FALSE(builder_.add_segment(a, a));
  const SurfaceLines lines = builder_.take();
  ASSERT_EQ(lines.segments.size(), 1U);
  EXPECT_EQ(lines.segments[0], (std::array<Index, 2>{a, b}));
  EXPECT_DOUBLE_EQ(lines.length(), 5.0);
}

// ---- Isolines: circles on the plane, closed lines, levels at vertices, borders of what was reached

constexpr Index columns = 24;
const test::Shape plane = test::plane_grid(columns, columns, 4.0, 4.0, 0.2);
constexpr Index source = 12 * (columns + 1) + 12;

std::vector<double> distances() {
  std::vector<double> field;
  for (Index v = 0; v < static_cast<Index>(plane.soup.positions.size()); ++v) {
    field.push_back(plane.vertex_distance(source, v));
  }
  return field;
}

TEST(Isolines, LevelsAtVerticesAndOutsideTheFieldMakeNoLooseEnds) {
  const test::Shape grid = test::plane_grid(4, 4, 4.0, 4.0);
  const auto mesh = test::make_mesh(grid.soup);
  std::vector<double> field;
  for (const Point& p : grid.soup.positions) field.push_back(p[0]);
  const Isolines found = isolines(*mesh, field, std::vector<double>{2.0, -1.0, 9.0}, Interpolation::linear);
  EXPECT_EQ(found.lines.points.size(), 5U);
  EXPECT_EQ(found.lines.segments.size(), 4U);
  EXPECT_NEAR(found.lines.length(), 4.0, 1e-12);
}

TEST(Isolines, CrossingOfTheDistanceFromAPointBesideTheEdge) {
  for (double foot : {-3.0, 0.0, 0.4, 1.0, 7.0}) {
    for (double height : {0.0, 0.2, 5.0}) {
      auto at = [&](double x) { return std::hypot(x - foot, height); };
      for (double x : {0.3, 0.75}) {
        const double level = at(x);
        if ((at(0.0) - level) * (at(1.0) - level) >= 0.0) continue;
        EXPECT_NEAR(crossing(at(0.0), at(1.0), 1.0, level, Interpolation::distance), x, 1e-12)
            << foot << ", " << height;
      }
    }
  }
}

TEST(Isolines, RefusesWrongSizesAndLevels) {
  const auto mesh = test::make_mesh(plane.soup);
  EXPECT_THROW(isolines(*mesh, std::vector<double>{1.0}, std::vector<double>{1.0}, Interpolation::linear),
               InvalidInput);
  EXPECT_THROW(isolines(*mesh, distances(), std::vector<double>{std::nan("")}, Interpolation::linear),
               InvalidInput);
  EXPECT_TRUE(
      isolines(*mesh, distances(), std::vector<double>{}, Interpolation::linear).lines.points.empty());
}

// ---- Points along curves: how many, where, and how far the nearest of them may be

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
  const Shape grid = test::plane_grid(4, 2, 4.0, 2.0);
  const auto mesh = test::make_mesh(grid.soup);
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
