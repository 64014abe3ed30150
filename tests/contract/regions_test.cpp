// Voronoi regions: every vertex belongs to its nearest site, areas tile the surface, borders lie between.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

#include "contract/surfaces.h"

namespace vorogeo::contract {
namespace {

double area_of(const test::Soup& soup, const std::array<Index, 3>& face) {
  const Point& a = soup.positions[face[0]];
  Point u{};
  Point v{};
  for (int k = 0; k < 3; ++k) {
    u[k] = soup.positions[face[1]][k] - a[k];
    v[k] = soup.positions[face[2]][k] - a[k];
  }
  return 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}

TEST(RegionsContract, EveryVertexBelongsToItsNearestSite) {
  ask_each(cases_in_turn(), [](const Case& one, By by) {
    const auto sites = one.points();
    const Regions found = one.ask.regions(sites, by);
    for (Index v = 0; v < one.ask.vertex_count(); ++v) {
      double least = unreachable;
      for (const SurfacePoint& site : sites) least = std::min(least, one.distance(site, vertex(v)));
      const std::string where = "vertex " + std::to_string(v);
      expect_close(found.distance[v], least, one.tolerance(by), one.ask, where);
      ASSERT_EQ(found.vertex_region[v] == no_index, least == unreachable) << where;
      if (least == unreachable) continue;
      expect_close(one.distance(sites[found.vertex_region[v]], vertex(v)), least, 2.0 * one.tolerance(by),
                   one.ask, where);
    }
  });
}

TEST(RegionsContract, RegionsTileTheSurfaceThatCanBeReached) {
  for (const Case& one : cases_in_turn()) {
    // The first three points: the last may be an isolated vertex.
    auto sites = one.points();
    sites.erase(sites.begin() + 3);
    const test::Soup& soup = one.ask.soup();
    double area = 0.0;
    std::set<std::set<Index>> counted;  // a repeated face counts once
    for (const auto& face : soup.faces) {
      if (counted.insert({face.begin(), face.end()}).second) area += area_of(soup, face);
    }
    for (const By by : {By::exact, By::index}) {
      const Regions found = one.ask.regions(sites, by);
      ASSERT_EQ(found.area.size(), sites.size());
      for (const double share : found.area) EXPECT_GE(share, 0.0);
      EXPECT_NEAR(std::accumulate(found.area.begin(), found.area.end(), 0.0), one.scale * one.scale * area,
                  1e-9 * one.scale * one.scale * area)
          << one.name << ", " << to_string(by);
    }
  }
}

TEST(RegionsContract, TwoSitesHalveAPlaneAlongTheLineBetweenThem) {
  // Both sites are equally far from the line x = 1, which is the border.
  const test::Shape plane = test::plane_grid(8, 7, 2.0, 1.0);
  const Ask ask(plane.soup);
  const std::vector<SurfacePoint> sites{vertex(9 * 3 + 2), vertex(9 * 3 + 6)};
  for (const By by : {By::exact, By::index}) {
    const Regions found = ask.regions(sites, by);
    EXPECT_NEAR(found.area[0], 1.0, 1e-9);
    EXPECT_NEAR(found.area[1], 1.0, 1e-9);
    EXPECT_NEAR(total_length(found.borders), 1.0, 1e-9);
    for (const Point& p : found.borders.points) EXPECT_NEAR(p[0], 1.0, 1e-9);
    for (const auto& pair : found.border_regions) EXPECT_EQ(pair, (std::array<Index, 2>{0, 1}));
    for (std::size_t f = 0; f < plane.soup.faces.size(); ++f) {
      double x = 0.0;
      for (const Index v : plane.soup.faces[f]) x += plane.soup.positions[v][0] / 3.0;
      EXPECT_EQ(found.face_region[f], x < 1.0 ? 0 : 1) << "face " << f;
    }
  }
}

TEST(RegionsContract, ASiteThatRepeatsAnotherOwnsNothing) {
  const Ask ask(test::icosphere(2));
  for (const By by : {By::exact, By::index}) {
    const Regions found = ask.regions(vertices({3, 40, 3}), by);
    EXPECT_EQ(found.area[2], 0.0);
    EXPECT_EQ(std::ranges::count(found.vertex_region, 2), 0);
  }
}

TEST(RegionsContract, WhereNoSiteLeadsThereIsNoRegion) {
  const KnownSurface parts = several_components();
  const Ask ask(parts.soup);
  for (const By by : {By::exact, By::index}) {
    const Regions found = ask.regions(vertices({0, 20}), by);
    EXPECT_NEAR(found.area[0] + found.area[1], 6.0, 1e-9);
    EXPECT_EQ(found.vertex_region.back(), no_index);
    EXPECT_EQ(found.face_region.back(), no_index);
  }
}

}  // namespace
}  // namespace vorogeo::contract
