// Shares and borders of regions in a single triangle of the plane, where bisectors are straight lines.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/shapes.h"
#include "tasks/voronoi_regions.h"

namespace vorogeo {
namespace {

/// The triangle (0, 0), (1, 0), (0, 1).
const test::Soup triangle{{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, {{0, 1, 2}}};

FaceSite site_at(Index number, double x, double y) {
  FaceSite site{number, {}};
  for (int c = 0; c < 3; ++c) {
    const Point& p = triangle.positions[c];
    site.square[c] = (p[0] - x) * (p[0] - x) + (p[1] - y) * (p[1] - y);
  }
  return site;
}

TEST(ShareOfFace, TwoSitesShareAlongTheirBisector) {
  // The bisector of (0, 0) and (1, 0) is x = 1/2: it cuts off a triangle of a quarter of the area.
  const std::vector<FaceSite> sites{site_at(0, 0.0, 0.0), site_at(1, 1.0, 0.0)};
  EXPECT_NEAR(share_of_face(sites, 0), 0.75, 1e-15);
  EXPECT_NEAR(share_of_face(sites, 1), 0.25, 1e-15);
}

TEST(ShareOfFace, SharesOfRandomSitesSumToOne) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(-1.0, 2.0);
  for (int repetition = 0; repetition < 200; ++repetition) {
    std::vector<FaceSite> sites;
    for (Index i = 0; i < 6; ++i) sites.push_back(site_at(i, anywhere(random), anywhere(random)));
    double sum = 0.0;
    for (std::size_t i = 0; i < sites.size(); ++i) sum += share_of_face(sites, i);
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
}

TEST(ShareOfFace, OfEqualSitesTheFirstOwnsTheFace) {
  const std::vector<FaceSite> sites{site_at(4, 0.3, 0.3), site_at(9, 0.3, 0.3)};
  EXPECT_EQ(share_of_face(sites, 0), 1.0);
  EXPECT_EQ(share_of_face(sites, 1), 0.0);
}

TEST(BorderTracer, TheBorderOfTwoSitesIsTheirBisector) {
  const auto mesh = test::make_mesh(triangle);
  std::vector<std::array<Index, 2>> regions;
  BorderTracer tracer(*mesh, regions);
  tracer.trace(0, {site_at(2, 0.0, 0.0), site_at(5, 1.0, 0.0)});
  const SurfaceLines lines = tracer.take();
  ASSERT_EQ(lines.segments.size(), 1U);
  EXPECT_EQ(regions, (std::vector<std::array<Index, 2>>{{2, 5}}));
  for (const Point& p : lines.points) EXPECT_NEAR(p[0], 0.5, 1e-15);
  EXPECT_NEAR(lines.length(), 0.5, 1e-15);
}

TEST(BorderTracer, ThreeRegionsMeetAtTheCircumcentreOfTheirSites) {
  const auto mesh = test::make_mesh(triangle);
  std::vector<std::array<Index, 2>> regions;
  BorderTracer tracer(*mesh, regions);
  // On a circle around (0.3, 0.3), so that this is the point at equal distance from all three.
  std::vector<FaceSite> sites;
  for (Index i = 0; i < 3; ++i) {
    const double angle = 0.4 + 2.1 * i;
    sites.push_back(site_at(i, 0.3 + 0.2 * std::cos(angle), 0.3 + 0.2 * std::sin(angle)));
  }
  tracer.trace(0, sites);
  const SurfaceLines lines = tracer.take();
  ASSERT_EQ(lines.segments.size(), 3U);
  ASSERT_EQ(lines.points.size(), 4U) << "three ends on edges and the point where all meet";
  int meeting = 0;
  for (const Point& p : lines.points) meeting += std::hypot(p[0] - 0.3, p[1] - 0.3) < 1e-12 ? 1 : 0;
  EXPECT_EQ(meeting, 1);
}

TEST(BorderTracer, NeighbouringFacesShareTheEndsOfTheirBorders) {
  const auto mesh = test::make_mesh(test::plane_grid(1, 1, 1.0, 1.0).soup);
  std::vector<std::array<Index, 2>> regions;
  BorderTracer tracer(*mesh, regions);
  for (Index face = 0; face < 2; ++face) {
    std::vector<FaceSite> sites;
    for (Index i = 0; i < 2; ++i) {
      FaceSite site{i, {}};
      for (int c = 0; c < 3; ++c) {
        const Point& p = mesh->position(mesh->face_vertices(face)[c]);
        const double x = p[0] - (i == 0 ? 0.2 : 0.9);
        const double y = p[1] - (i == 0 ? 0.5 : 0.4);
        site.square[c] = x * x + y * y;
      }
      sites.push_back(site);
    }
    tracer.trace(face, sites);
  }
  const SurfaceLines lines = tracer.take();
  EXPECT_EQ(lines.segments.size(), 2U);
  EXPECT_EQ(lines.points.size(), 3U);
}

}  // namespace
}  // namespace vorogeo
