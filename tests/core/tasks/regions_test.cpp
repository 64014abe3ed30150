// Voronoi regions: where borders meet, shares of a face, and borders inside a face of another cost.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "mesh/surface_locator.h"
#include "support/layers.h"
#include "support/shapes.h"
#include "tasks/voronoi_regions.h"

namespace vorogeo {
namespace {

using test::Shape;

// ---- Where three distances are equal

std::vector<int> degrees(const SurfaceLines& lines) {
  std::vector<int> degree(lines.points.size(), 0);
  for (const auto& [a, b] : lines.segments) {
    ++degree[a];
    ++degree[b];
  }
  return degree;
}

TEST(VoronoiRegions, ThreePointsMeetAtTheirCircumcentre) {
  const Shape plane = test::plane_grid(10, 10, 1.0, 1.0, 0.2);
  const Index sites[] = {2 * 11 + 2, 3 * 11 + 8, 8 * 11 + 4};
  Surface surface(test::make_mesh(plane.soup), {.threads = 1});
  const VoronoiRegions found = voronoi_regions(surface, sites, {.by = Answer::exact});
  const auto degree = degrees(found.borders);
  ASSERT_EQ(std::count(degree.begin(), degree.end(), 3), 1);
  const Point& centre = found.borders.points[std::find(degree.begin(), degree.end(), 3) - degree.begin()];
  const double radius = distance_between(centre, plane.soup.positions[sites[0]]);
  EXPECT_NEAR(distance_between(centre, plane.soup.positions[sites[1]]), radius, 1e-12);
  EXPECT_NEAR(distance_between(centre, plane.soup.positions[sites[2]]), radius, 1e-12);
}

// ---- Shares of regions in a single triangle of the plane, where bisectors are straight lines

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

// ---- Regions inside a dear face: borders where the distances of both sites are equal

/// A square of unit cells at cost 1, with cost 5 in the two faces of the middle cell.
struct DearCell {
  DearCell() {
    std::vector<double> cost;
    for (const auto& face : soup.faces) {
      Point centre{};
      for (Index v : face) {
        for (int k = 0; k < 3; ++k) centre[k] += soup.positions[v][k] / 3.0;
      }
      cost.push_back(std::abs(centre[0] - 2.5) < 0.5 && std::abs(centre[1] - 2.5) < 0.5 ? 5.0 : 1.0);
    }
    mesh = test::with_costs(soup, cost);
  }
  test::Soup soup = test::plane_grid(5, 5, 5.0, 5.0).soup;
  std::shared_ptr<const Mesh> mesh;
};

TEST(DividedFaces, ASiteInsideADearFaceOwnsWhatIsNearIt) {
  const DearCell cell;
  const SurfaceLocator locator(cell.mesh);
  const std::vector<SurfacePoint> sites{locator.nearest({2.6, 2.4, 0}).point,
                                        locator.nearest({0.2, 0.3, 0}).point};
  Surface surface(cell.mesh, {.threads = 1});
  const VoronoiRegions found = voronoi_regions(surface, sites, {.by = Answer::exact});
  EXPECT_GT(found.area[0], 25.0);  // a cell of cost 5 has area 25 in the metric
  ASSERT_GT(found.borders.points.size(), 5U);
  Query query(surface);
  for (const Point& place : found.borders.points) {
    const std::vector<SurfacePoint> at{locator.nearest(place).point};
    const double first =
        query.distances(std::array{ExactSource{sites[0]}}, at, unreachable, Answer::exact)[0];
    const double second =
        query.distances(std::array{ExactSource{sites[1]}}, at, unreachable, Answer::exact)[0];
    // Differences are interpolated over parts of a dear face, with sides of 1.25 and 1.8 in the metric.
    EXPECT_NEAR(first, second, 0.5) << place[0] << ' ' << place[1];
  }
}

TEST(DividedFaces, BordersInADearFaceAreWherePathsFromBothSidesMeet) {
  const DearCell cell;
  // Sites on both sides of the dear cell, equally far: by symmetry the border is the line x + y = 5.
  const std::vector<Index> sites{0, static_cast<Index>(cell.soup.positions.size()) - 1};
  Surface surface(cell.mesh, {.threads = 1});
  const VoronoiRegions found = voronoi_regions(surface, sites, {.by = Answer::exact});
  const Point& a = cell.soup.positions[sites[0]];
  const Point& b = cell.soup.positions[sites[1]];
  ASSERT_NEAR(a[0] + b[0], 5.0, 1e-12);
  ASSERT_NEAR(a[1] + b[1], 5.0, 1e-12);
  EXPECT_NEAR(found.area[0], found.area[1], 1e-2 * found.area[0]);
  for (const Point& p : found.borders.points) {
    EXPECT_NEAR(distance_between(p, a), distance_between(p, b), 0.08) << p[0] << ' ' << p[1];
  }
}

}  // namespace
}  // namespace vorogeo
