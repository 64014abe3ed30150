// Voronoi regions against closed forms: labels, borders where two distances are equal, areas.
#include "tasks/voronoi_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "support/error.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Shape;
using test::Soup;

double straight(const Point& p, const Point& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }

std::vector<int> degrees(const SurfaceLines& lines) {
  std::vector<int> degree(lines.points.size(), 0);
  for (const auto& [a, b] : lines.segments) {
    ++degree[a];
    ++degree[b];
  }
  return degree;
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

TEST(VoronoiRegions, ThreePointsMeetAtTheirCircumcentre) {
  const Shape plane = test::plane_grid(10, 10, 1.0, 1.0, 0.2);
  const Index sites[] = {2 * 11 + 2, 3 * 11 + 8, 8 * 11 + 4};
  Surface surface(test::make_mesh(plane.soup), {.threads = 1});
  const VoronoiRegions found = voronoi_regions(surface, sites, {.by = AnswerMethod::exact});
  const auto degree = degrees(found.borders);
  ASSERT_EQ(std::count(degree.begin(), degree.end(), 3), 1);
  const Point& centre = found.borders.points[std::find(degree.begin(), degree.end(), 3) - degree.begin()];
  const double radius = straight(centre, plane.soup.positions[sites[0]]);
  EXPECT_NEAR(straight(centre, plane.soup.positions[sites[1]]), radius, 1e-12);
  EXPECT_NEAR(straight(centre, plane.soup.positions[sites[2]]), radius, 1e-12);
}

TEST(VoronoiRegions, TiesAlongEdgesGiveOneLine) {
  const Shape plane = test::plane_grid(6, 4, 6.0, 4.0);
  const Index sites[] = {2 * 7 + 1, 2 * 7 + 5};  // the bisector x = 3 is a line of edges
  Surface surface(test::make_mesh(plane.soup), {.threads = 1});
  const VoronoiRegions found = voronoi_regions(surface, sites, {.by = AnswerMethod::exact});
  EXPECT_NEAR(found.borders.length(), 4.0, 1e-12);
  EXPECT_NEAR(found.area[0], 12.0, 1e-12);
  EXPECT_NEAR(found.area[1], 12.0, 1e-12);
}

TEST(VoronoiRegions, RoundAPrism) {
  const Shape prism = test::prism(6, 4, 10, 1.0, 4.0, 0.2);
  const Index sites[] = {5 * 24 + 2, 5 * 24 + 14};  // opposite each other in the middle row
  Surface surface(test::make_mesh(prism.soup), {.threads = 2});
  const VoronoiRegions found = voronoi_regions(surface, sites, {.by = AnswerMethod::exact});
  // Vertices know their distances from both; two borders run up the prism.
  for (Index v = 0; v < static_cast<Index>(prism.soup.positions.size()); ++v) {
    const double a = prism.vertex_distance(sites[0], v);
    const double b = prism.vertex_distance(sites[1], v);
    EXPECT_NEAR(found.distance[v], std::min(a, b), 1e-12);
    if (std::abs(a - b) > 1e-9) {
      EXPECT_EQ(found.vertex_region[v], a < b ? 0 : 1);
    }
  }
  const auto degree = degrees(found.borders);
  EXPECT_EQ(std::count(degree.begin(), degree.end(), 1), 4);
  EXPECT_NEAR(sum(found.area), 24.0, 1e-9);
}

TEST(VoronoiRegions, OppositeSidesOfABoxShareItEqually) {
  const Shape box = test::box({2.0, 1.0, 1.0}, 6);
  auto vertex_at = [&](const Point& p) {
    for (std::size_t v = 0; v < box.soup.positions.size(); ++v) {
      if (straight(box.soup.positions[v], p) < 1e-9) return static_cast<Index>(v);
    }
    return no_index;
  };
  const Index sites[] = {vertex_at({0.0, 0.5, 0.5}), vertex_at({2.0, 0.5, 0.5})};
  ASSERT_NE(sites[0], no_index);
  Surface surface(test::make_mesh(box.soup), {.threads = 2});
  const VoronoiRegions found = voronoi_regions(surface, sites, {.by = AnswerMethod::exact});
  EXPECT_NEAR(found.area[0], 5.0, 1e-9);
  EXPECT_NEAR(found.area[1], 5.0, 1e-9);
  EXPECT_NEAR(found.borders.length(), 4.0, 1e-9);
  for (const Point& x : found.borders.points) EXPECT_NEAR(x[0], 1.0, 1e-9);
}

}  // namespace
}  // namespace vorogeo
