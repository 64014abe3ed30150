// Isolines: circles on the plane, closed lines, levels at vertices, borders of what was reached.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/error.h"
#include "support/shapes.h"
#include "tasks/surface_lines.h"

namespace vorogeo {
namespace {

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

double from_source(const Point& p) {
  const Point& s = plane.soup.positions[source];
  return std::hypot(p[0] - s[0], p[1] - s[1]);
}

/// How many segments meet at each point.
std::vector<int> degrees(const SurfaceLines& lines) {
  std::vector<int> degree(lines.points.size(), 0);
  for (const auto& [a, b] : lines.segments) {
    ++degree[a];
    ++degree[b];
  }
  return degree;
}

TEST(Isolines, OfADistanceOnThePlaneAreCircles) {
  const auto mesh = test::make_mesh(plane.soup);
  const std::vector<double> levels{1.4, 0.5, 1.0};
  const Isolines found = isolines(*mesh, distances(), levels, Interpolation::distance);
  ASSERT_EQ(found.level_of_point.size(), found.lines.points.size());
  ASSERT_EQ(found.level_of_segment.size(), found.lines.segments.size());
  for (std::size_t i = 0; i < found.lines.points.size(); ++i) {
    EXPECT_NEAR(from_source(found.lines.points[i]), levels[found.level_of_point[i]], 1e-12);
  }
  for (int degree : degrees(found.lines)) EXPECT_EQ(degree, 2);
  for (std::size_t i = 0; i < found.lines.segments.size(); ++i) {
    for (Index end : found.lines.segments[i]) {
      EXPECT_EQ(found.level_of_point[end], found.level_of_segment[i]);
    }
  }
  // A polygon in a circle with chords of at most h is shorter by at most h^2 / (24 r^2) of its length.
  const double circles = 2.0 * std::numbers::pi * (1.4 + 0.5 + 1.0);
  EXPECT_LE(found.lines.length(), circles);
  EXPECT_GE(found.lines.length(), circles * (1.0 - 0.3 * 0.3 / (24 * 0.25)));
}

TEST(Isolines, LinearInterpolationIsExactForALinearField) {
  const auto mesh = test::make_mesh(plane.soup);
  std::vector<double> field;
  for (const Point& p : plane.soup.positions) field.push_back(100.0 * p[0] - 40.0 * p[1]);
  const Isolines found = isolines(*mesh, field, std::vector<double>{63.0}, Interpolation::linear);
  EXPECT_GT(found.lines.points.size(), 20U);
  for (const Point& p : found.lines.points) EXPECT_NEAR(100.0 * p[0] - 40.0 * p[1], 63.0, 1e-10);
  // From (0.63, 0) to (2.23, 4).
  EXPECT_NEAR(found.lines.length(), std::hypot(1.6, 4.0), 1e-10);
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

TEST(Isolines, FacesWithUnreachableCornersHoldNone) {
  const auto mesh = test::make_mesh(plane.soup);
  auto field = distances();
  for (double& value : field) {
    if (value > 1.2) value = unreachable;
  }
  const Isolines found = isolines(*mesh, field, std::vector<double>{0.8, 3.0}, Interpolation::distance);
  for (Index level : found.level_of_segment) EXPECT_EQ(level, 0);
  for (int degree : degrees(found.lines)) EXPECT_EQ(degree, 2);
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

}  // namespace
}  // namespace vorogeo
