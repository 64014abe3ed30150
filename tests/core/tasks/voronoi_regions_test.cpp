// Voronoi regions against closed forms: labels, borders where two distances are equal, areas.
#include "tasks/voronoi_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "support/error.h"
#include "support/indexes.h"
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

TEST(VoronoiRegions, BorderOfTwoPointsOnAPlaneIsTheirBisector) {
  const Shape plane = test::plane_grid(16, 12, 4.0, 3.0, 0.2);
  const Index sites[] = {3 * 17 + 4, 8 * 17 + 11};
  const Point& p = plane.soup.positions[sites[0]];
  const Point& q = plane.soup.positions[sites[1]];
  Surface surface(test::make_mesh(plane.soup), {.threads = 2});
  const VoronoiRegions found = voronoi_regions(surface, sites, {.by = AnswerMethod::exact});
  ASSERT_GT(found.borders.points.size(), 10U);
  for (const Point& x : found.borders.points) EXPECT_NEAR(straight(x, p), straight(x, q), 1e-12);
  // One line from side to side of the rectangle: its length, and the area on its left, by the formula of the
  // line that leaves through y = 0 and y = 3.
  const double nx = q[0] - p[0];
  const double ny = q[1] - p[1];
  const double c = 0.5 * (q[0] * q[0] + q[1] * q[1] - p[0] * p[0] - p[1] * p[1]);
  const double low = c / nx;
  const double high = (c - 3.0 * ny) / nx;
  EXPECT_NEAR(found.borders.length(), std::hypot(high - low, 3.0), 1e-12);
  EXPECT_NEAR(found.area[0], 1.5 * (low + high), 1e-12);
  EXPECT_NEAR(sum(found.area), 12.0, 1e-12);
  const auto degree = degrees(found.borders);
  EXPECT_EQ(std::count(degree.begin(), degree.end(), 1), 2);
  EXPECT_EQ(std::count(degree.begin(), degree.end(), 2), static_cast<std::ptrdiff_t>(degree.size()) - 2);
}

TEST(VoronoiRegions, ManyPointsOnAPlane) {
  const Shape plane = test::plane_grid(30, 24, 4.0, 3.0, 0.25);
  // So many sites that regions have only some faces: in many faces three or more meet, or one only just
  // reaches into them.
  const auto sites = test::random_vertices(31 * 25, 120, 5);
  Surface surface(test::make_mesh(plane.soup), {.threads = 2});
  const VoronoiRegions found = voronoi_regions(surface, sites, {.by = AnswerMethod::exact});
  auto least = [&](const Point& x) {
    double distance = unreachable;
    for (Index site : sites) distance = std::min(distance, straight(x, plane.soup.positions[site]));
    return distance;
  };
  for (std::size_t v = 0; v < plane.soup.positions.size(); ++v) {
    EXPECT_NEAR(found.distance[v], least(plane.soup.positions[v]), 1e-12);
    EXPECT_NEAR(plane.vertex_distance(sites[found.vertex_region[v]], static_cast<Index>(v)),
                found.distance[v], 1e-12);
  }
  ASSERT_EQ(found.border_regions.size(), found.borders.segments.size());
  for (std::size_t i = 0; i < found.borders.segments.size(); ++i) {
    for (Index end : found.borders.segments[i]) {
      const Point& x = found.borders.points[end];
      for (Index region : found.border_regions[i]) {
        EXPECT_NEAR(straight(x, plane.soup.positions[sites[region]]), least(x), 1e-9);
      }
    }
  }
  EXPECT_NEAR(sum(found.area), 12.0, 1e-9);
  for (double area : found.area) EXPECT_GT(area, 0.0);
  // Borders end at the sides of the rectangle only; three meet inside.
  const auto degree = degrees(found.borders);
  int junctions = 0;
  for (std::size_t i = 0; i < degree.size(); ++i) {
    const Point& x = found.borders.points[i];
    const bool at_side = x[0] < 1e-12 || x[0] > 4.0 - 1e-12 || x[1] < 1e-12 || x[1] > 3.0 - 1e-12;
    if (degree[i] == 1) {
      EXPECT_TRUE(at_side) << x[0] << ", " << x[1];
    }
    if (degree[i] == 3) ++junctions;
  }
  EXPECT_GT(junctions, 100);
}

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

TEST(VoronoiRegions, FromAnIndexAreNearThoseOfExactFields) {
  const Soup soup = test::hills(24, 0.2);
  const auto index = test::make_index(soup, 3, 4);
  const auto sites = test::random_vertices(static_cast<Index>(soup.positions.size()), 8, 9);
  Surface surface(index, 2);
  const VoronoiRegions exact = voronoi_regions(surface, sites, {.by = AnswerMethod::exact});
  const VoronoiRegions found = voronoi_regions(surface, sites, {.by = AnswerMethod::index});
  EXPECT_NEAR(sum(found.area), sum(exact.area), 1e-9);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    EXPECT_NEAR(found.area[i], exact.area[i], 0.01 * exact.area[i]);
  }
  EXPECT_NEAR(found.borders.length(), exact.borders.length(), 0.02 * exact.borders.length());
}

TEST(VoronoiRegions, RepeatedPointsOtherComponentsAndIsolatedVertices) {
  const Soup soup =
      test::with_isolated_vertex(test::two_components(test::icosphere(2), test::icosphere(1)), {9, 9, 9});
  const auto n = static_cast<Index>(soup.positions.size());
  Surface surface(test::make_index(soup, 3, 3), 2);
  const Index sites[] = {5, 5, 80};
  const VoronoiRegions found = voronoi_regions(surface, sites, {.by = AnswerMethod::index});
  for (Index v = 0; v < n; ++v) {
    const bool reached = surface.mesh()->component(v) == surface.mesh()->component(5);
    EXPECT_EQ(found.vertex_region[v] != no_index, reached);
    EXPECT_EQ(found.distance[v] < unreachable, reached);
    EXPECT_NE(found.vertex_region[v], 1);
  }
  EXPECT_EQ(found.area[1], 0.0);
  for (Index f = 0; f < surface.mesh()->face_count(); ++f) {
    EXPECT_EQ(found.face_region[f] == no_index,
              surface.mesh()->component(surface.mesh()->face_vertices(f)[0]) != surface.mesh()->component(5));
  }
  EXPECT_THROW(voronoi_regions(surface, std::span<const Index>()), InvalidInput);
  const Index bad[] = {n};
  EXPECT_THROW(voronoi_regions(surface, bad), InvalidInput);
  const Progress stop([](double, const std::string&) { return false; });
  EXPECT_THROW(voronoi_regions(surface, sites, {.progress = stop}), Cancelled);
}

}  // namespace
}  // namespace vorogeo
