// Isolines at vertices and on edges, and points along curves.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "support/error.h"
#include "support/refusal.h"
#include "support/shapes.h"
#include "tasks/curve_sources.h"
#include "tasks/cut.h"
#include "tasks/surface_lines.h"

namespace vorogeo {
namespace {

// ---- Isolines: levels at vertices, and crossings of edges

TEST(Isolines, LevelsAtVerticesAndOutsideTheFieldMakeNoLooseEnds) {
  const test::Shape grid = test::plane_grid(4, 4, 4.0, 4.0);
  const auto mesh = test::make_mesh(grid.soup);
  std::vector<double> field;
  for (const Point& p : grid.soup.positions) field.push_back(p[0]);
  const Isolines found = isolines(*mesh, field, std::vector<double>{2.0, -1.0, 9.0}, Interpolation::linear);
  EXPECT_EQ(found.lines.points.size(), 5U);
  EXPECT_EQ(found.lines.segments.size(), 4U);
  EXPECT_NEAR(total_length(found.lines), 4.0, 1e-12);
}

TEST(Isolines, MoreThanThereIsMemoryForAreRefused) {
  // Every face from 0 to 1: each of the levels crosses each of the faces, 2e10 times in all.
  const test::Shape grid = test::plane_grid(100, 100, 1.0, 1.0);
  const auto mesh = test::make_mesh(grid.soup);
  std::vector<double> field(grid.soup.positions.size(), 0.0);
  for (std::size_t f = 0; f < grid.soup.faces.size(); ++f) {
    const auto& corners = grid.soup.faces[f];
    if (std::ranges::none_of(corners, [&](Index v) { return field[v] > 0.0; })) field[corners[0]] = 1.0;
  }
  std::vector<double> levels(1'000'000);
  for (std::size_t i = 0; i < levels.size(); ++i) levels[i] = (i + 0.5) / static_cast<double>(levels.size());
  const auto sentence = [&](auto&& lines) { return test::refusal<NotEnoughMemory>(lines); };
  for (const std::string& one :
       {sentence([&] { isolines(*mesh, field, levels, Interpolation::linear); }),
        sentence([&] { cut_at_levels(*mesh, field, levels, Interpolation::linear); })}) {
    EXPECT_TRUE(one.starts_with("Finding the lines of 1000000 levels takes ")) << one;
    EXPECT_TRUE(one.ends_with("Give fewer levels.")) << one;
  }
  levels.resize(2);
  EXPECT_FALSE(isolines(*mesh, field, levels, Interpolation::linear).lines.segments.empty());
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

// ---- Lines put in order

TEST(Lines, SegmentsInAnyOrderMakeOpenAndClosedLines) {
  std::vector<std::array<Index, 2>> segments{{7, 3}, {3, 9}, {9, 1}, {4, 5}, {5, 6}, {6, 8}, {8, 4}, {2, 2}};
  const auto seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::ranges::shuffle(segments, random);
  for (auto& [a, b] : segments) {
    if (random() % 2 == 0) std::swap(a, b);
  }
  const auto name = [](Index v) { return "point " + std::to_string(v); };
  const auto lines = lines_in_order(segments, name);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0], (std::vector<Index>{1, 9, 3, 7}));
  ASSERT_EQ(lines[1].size(), 5U);
  EXPECT_EQ(lines[1].front(), 4);
  EXPECT_EQ(lines[1].back(), 4);
  EXPECT_EQ(lines[1][2], 6);
  segments.push_back({9, 4});
  const std::string said = test::refusal([&] { lines_in_order(segments, name); });
  EXPECT_TRUE(said.starts_with("The curve branches: point 4 has 3 of its edges")) << said;
}

// ---- Points along curves

/// The edges along y = 0 of a grid of 4 x 2 unit cells.
std::vector<Index> bottom_edges(const Mesh& mesh) {
  std::vector<Index> edges;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const auto [a, b] = mesh.edge_vertices(e);
    if (mesh.position(a)[1] == 0.0 && mesh.position(b)[1] == 0.0) edges.push_back(e);
  }
  return edges;
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
  // No edge alone would have ten million points, but all together would have more.
  EXPECT_THROW(sources_along_edges(*mesh, edges, 3e-7), InvalidInput);
}

}  // namespace
}  // namespace vorogeo
