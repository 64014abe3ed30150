// Polygons of shortest paths and convex hulls: area, perimeter and angles against formulas, and the curvature
// that they enclose by Gauss-Bonnet.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "contract/surfaces.h"
#include "mesh/surface_locator.h"

namespace vorogeo::contract {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<SurfacePoint> places_on(const test::Soup& soup, const std::vector<Point>& places) {
  const SurfaceLocator locator(test::make_mesh(soup));
  std::vector<SurfacePoint> points;
  for (const Point& place : places) points.push_back(locator.nearest(place).point);
  return points;
}

double sum_of(const std::vector<double>& angles) {
  return std::accumulate(angles.begin(), angles.end(), 0.0);
}

TEST(PolygonContract, InAPlaneItIsTheFlatOne) {
  const test::Soup soup = test::plane_grid(11, 9, 4.0, 3.0, 0.24, 7).soup;
  // An L, of six corners.
  const std::vector<Point> places{{0.5, 0.4, 0}, {3.3, 0.4, 0}, {3.3, 1.3, 0},
                                  {1.7, 1.3, 0}, {1.7, 2.6, 0}, {0.5, 2.6, 0}};
  const Ask ask(soup, {.patches = 3, .patches_in_each = 3});
  for (const By by : {By::exact, By::index}) {
    const GeodesicPolygon found = ask.polygon(places_on(soup, places), by);
    EXPECT_NEAR(found.area, 2.8 * 0.9 + 1.2 * 1.3, 1e-9);
    EXPECT_NEAR(found.perimeter, 2.0 * (2.8 + 2.2), 1e-9);
    ASSERT_EQ(found.angles.size(), 6U);
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(found.angles[i], i == 3 ? 1.5 * pi : 0.5 * pi, 1e-9);
    EXPECT_NEAR(found.curvature, 0.0, 1e-9);
    EXPECT_NEAR(found.gauss_bonnet, 0.0, 1e-9);
    const auto is_inside = [](const Point& p) {
      return p[0] > 0.5 && p[1] > 0.4 && p[0] < 3.3 && p[1] < 2.6 && (p[0] < 1.7 || p[1] < 1.3);
    };
    std::vector<Index> vertices;
    for (Index v = 0; v < ask.vertex_count(); ++v) {
      if (is_inside(soup.positions[v])) vertices.push_back(v);
    }
    EXPECT_EQ(found.vertices, vertices);
    ASSERT_FALSE(found.faces.empty());
    for (const Index f : found.faces) {
      for (const Index v : soup.faces[f]) EXPECT_TRUE(is_inside(soup.positions[v])) << f;
    }
  }
}

TEST(PolygonContract, AroundAHoleThatItsBorderTouchesNothingIsLost) {
  test::Soup soup = test::plane_grid(12, 12, 12.0, 12.0).soup;
  std::erase_if(soup.faces, [&](const auto& face) {
    return std::ranges::all_of(face, [&](Index v) {
      const Point& p = soup.positions[v];
      return p[0] > 3.9 && p[0] < 6.1 && p[1] > 3.9 && p[1] < 6.1;
    });
  });
  const Ask ask(soup);
  // A corner of the hole is a corner of the polygon, or lies on a leg.
  for (const Point& touching : {Point{4, 6, 0}, Point{2, 8, 0}}) {
    const GeodesicPolygon found = ask.polygon(
        places_on(soup, {{2, 2, 0}, {10, 2, 0}, {8, 2 + 6 * touching[0] / 4, 0}, touching}), By::exact);
    EXPECT_NEAR(found.gauss_bonnet, 0.0, 1e-9);
  }
}

TEST(PolygonContract, AroundACornerOfABoxAngleSumsHaveAQuarterTurnMore) {
  const test::Soup soup = test::box({1.0, 1.7, 3.1}, 4).soup;
  const Ask ask(soup);
  const GeodesicPolygon found =
      ask.polygon(places_on(soup, {{0.6, 0, 0}, {0, 0.6, 0}, {0, 0, 0.6}}), By::exact);
  EXPECT_NEAR(found.area, 3.0 * 0.18, 1e-9);
  EXPECT_NEAR(found.perimeter, 3.0 * 0.6 * std::numbers::sqrt2, 1e-9);
  for (const double angle : found.angles) EXPECT_NEAR(angle, 0.5 * pi, 1e-9);
  EXPECT_NEAR(found.curvature, 0.5 * pi, 1e-9);
  EXPECT_NEAR(found.gauss_bonnet, 0.0, 1e-9);
}

TEST(PolygonContract, AroundAnApexAnglesSumToItsDefectMore) {
  for (const double total : {1.4 * pi, 1.9 * pi, 2.3 * pi}) {
    const Ask ask(test::cone(12, 4, total, 2.0).soup);
    std::vector<Index> ring;  // of the outermost ring but one, every third vertex
    for (const Index sector : {0, 3, 6, 9}) ring.push_back(1 + 2 * 12 + sector);
    const GeodesicPolygon found = ask.polygon(vertices(ring), By::exact);
    EXPECT_NEAR(sum_of(found.angles), 2.0 * pi + (2.0 * pi - total), 1e-9) << total;
    const double radius = distance_between(ask.soup().positions[0], ask.soup().positions[ring[0]]);
    EXPECT_NEAR(found.area, 2.0 * radius * radius * std::sin(0.25 * total), 1e-9) << total;
    EXPECT_NEAR(found.gauss_bonnet, 0.0, 1e-9) << total;
  }
}

TEST(PolygonContract, LegsThatRunTogetherToASaddleEncloseNothingThere) {
  // The points lie more than pi apart around the apex: every leg passes through it.
  const Ask ask(test::cone(12, 3, 3.6 * pi, 2.0).soup);
  const std::vector<SurfacePoint> points = vertices({1 + 12, 1 + 12 + 4, 1 + 12 + 8});
  const std::string sentence = refusal([&] { ask.polygon(points, By::exact); });
  EXPECT_NE(sentence.find("same side left and right"), std::string::npos) << sentence;
}

TEST(PolygonContract, OnASphereAnOctantIsApproached) {
  double before = 0.0;
  for (const int subdivisions : {2, 3, 4}) {
    const test::Soup soup = test::icosphere(subdivisions);
    const Ask ask(soup);
    const auto points = places_on(soup, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    const GeodesicPolygon found = ask.polygon(points, By::exact);
    const double error = std::abs(found.area - 0.5 * pi);
    EXPECT_NEAR(found.gauss_bonnet, 0.0, 1e-8);
    EXPECT_NEAR(found.curvature, 0.5 * pi, 4.0 / std::pow(2.0, subdivisions));
    if (before > 0.0) {
      EXPECT_LT(error, before / 1.8) << subdivisions;
    }
    before = error;
  }
}

TEST(PolygonContract, MetricsMultiplyLengthsAndKeepAngles) {
  for (const Case& one : cases()) {
    if (one.surface->name != "box by length" && one.surface->name != "box") continue;
    const GeodesicPolygon found =
        one.ask.polygon(places_on(one.surface->soup, {{0.6, 0, 0}, {0, 0.6, 0}, {0, 0, 0.6}}), By::exact);
    EXPECT_NEAR(found.area, 0.54 * one.scale * one.scale, 1e-9) << one.name;
    EXPECT_NEAR(found.perimeter, 1.8 * std::numbers::sqrt2 * one.scale, 1e-9) << one.name;
    EXPECT_NEAR(sum_of(found.angles), 1.5 * pi, 1e-9) << one.name;
  }
}

TEST(PolygonContract, WhatIsNoPolygonIsRefused) {
  const test::Soup plane = test::plane_grid(6, 6, 2.0, 2.0, 0.2).soup;
  const auto corners = places_on(plane, {{0.4, 0.4, 0}, {1.6, 0.4, 0}, {1.6, 1.6, 0}, {0.4, 1.6, 0}});
  const auto torus = test::torus(24, 12, 2.0, 0.8);
  const auto refused = [](const test::Soup& soup, const std::vector<SurfacePoint>& points) {
    return refusal([&] { Ask(soup).polygon(points, By::exact); });
  };
  const auto has = [](const std::string& sentence, const std::string& words) {
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
  };
  has(refused(plane, {corners[0], corners[2], corners[1], corners[3]}), "Legs 0 and 2");
  has(refused(plane, {corners[0], corners[1]}), "there are 2");
  has(refused(plane, {corners[0], corners[1], corners[1], corners[2]}),
      "Points 1 and 2 of the polygon are the same");
  has(refused(torus, places_on(torus, {{2.8, 0, 0}, {1.6, 0, 0.69}, {1.6, 0, -0.69}})),
      "same side left and right");
  const test::Soup two = test::two_components(plane, test::icosphere(1));
  has(refused(two, {corners[0], corners[1], vertex(static_cast<Index>(plane.positions.size()) + 5)}),
      "from point 1 (face");
}

TEST(HullContract, AroundACornerOfABoxItHasAQuarterTurnMore) {
  for (const bool is_mixed : {false, true}) {
    const test::Soup box = test::box({1.0, 1.7, 3.1}, 4).soup;
    const Ask ask(is_mixed ? test::with_flipped_faces(box, 3) : box, {.patches = 3, .patches_in_each = 3});
    const auto points = places_on(
        ask.soup(),
        {{0.1, 0.2, 0}, {0.6, 0, 0}, {0, 0, 0}, {0, 0.6, 0}, {0.3, 0, 0.29}, {0, 0, 0.6}, {0.6, 0, 0}});
    for (const By by : {By::exact, By::index}) {
      const GeodesicPolygon hull = ask.convex_hull(points, by);
      std::vector<Index> corners = hull.corners;
      std::ranges::sort(corners);
      EXPECT_EQ(corners, (std::vector<Index>{1, 3, 5}));
      EXPECT_NEAR(hull.area, 3.0 * 0.18, 1e-9);
      for (const double angle : hull.angles) EXPECT_NEAR(angle, 0.5 * pi, 1e-9);
      EXPECT_NEAR(hull.gauss_bonnet, 0.0, 1e-9);
    }
  }
}

TEST(HullContract, AroundAnApexAllPointsOfARingAreCorners) {
  // On the second and third cone, points behind the apex are seen in one direction.
  for (const double total : {1.4 * pi, 2.3 * pi, 3.1 * pi}) {
    const Ask ask(test::cone(12, 4, total, 2.0).soup);
    std::vector<Index> points{0};
    for (int sector = 0; sector < 12; ++sector) points.push_back(1 + 2 * 12 + sector);
    for (int sector = 0; sector < 12; sector += 5) points.push_back(1 + 12 + sector);
    const GeodesicPolygon hull = ask.convex_hull(vertices(points), By::exact);
    ASSERT_EQ(hull.corners.size(), 12U) << total;
    const double radius = distance_between(ask.soup().positions[0], ask.soup().positions[points[1]]);
    EXPECT_NEAR(hull.perimeter, 24.0 * radius * std::sin(total / 24.0), 1e-9) << total;
    EXPECT_NEAR(hull.area, 6.0 * radius * radius * std::sin(total / 12.0), 1e-9) << total;
    for (const double angle : hull.angles) EXPECT_NEAR(angle, pi - total / 12.0, 1e-9) << total;
    EXPECT_NEAR(hull.gauss_bonnet, 0.0, 1e-9) << total;
  }
}

TEST(HullContract, ItTurnsAtASaddleWhereItsPathsDo) {
  // Sectors are a quarter turn wide: seen from the first of four corners, the last two are behind the apex.
  const Ask ask(test::cone(12, 4, 6.0 * pi, 2.0).soup);
  const Index ring = 1 + 2 * 12;
  const GeodesicPolygon hull =
      ask.convex_hull(vertices({0, ring + 2, ring, 1 + 12 + 1, ring + 1, 1 + 12 + 3, ring + 3}), By::exact);
  const double radius = distance_between(ask.soup().positions[0], ask.soup().positions[ring]);
  std::vector<Index> corners = hull.corners;
  std::ranges::sort(corners);
  EXPECT_EQ(corners, (std::vector<Index>{1, 2, 4, 6}));
  EXPECT_NEAR(hull.perimeter, (2.0 + 3.0 * std::numbers::sqrt2) * radius, 1e-9);
  EXPECT_NEAR(hull.area, 1.5 * radius * radius, 1e-9);
}

TEST(HullContract, WhatHasNoHullIsRefused) {
  const test::Soup plane = test::plane_grid(6, 6, 2.0, 2.0, 0.2).soup;
  const auto refused = [](const test::Soup& soup, const std::vector<SurfacePoint>& points) {
    return refusal([&] { Ask(soup).convex_hull(points, By::exact); });
  };
  const auto has = [](const std::string& sentence, const std::string& words) {
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
  };
  has(refused(plane, vertices({3, 4, 3})), "three different points or more; there are 2");
  has(refused(plane, places_on(plane, {{0.3, 0.7, 0}, {1.1, 0.7, 0}, {0.6, 0.7, 0}})),
      "lie on one line, from point ");
  has(refused(plane, {vertex(0), vertex(99)}), "Point 1");
  const test::Soup two = test::two_components(plane, test::icosphere(1));
  has(refused(two, vertices({0, 3, 55})), "from point 0 (vertex 0) to point 2 (vertex 55)");
  const test::Soup tube = test::prism(6, 2, 8, 1.0, 6.0).soup;
  has(refused(tube, vertices({48, 51, 54, 57, 38})), "no convex hull");
  const test::Soup sphere = test::icosphere(3);
  has(refused(sphere,
              places_on(sphere, {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}})),
      "no convex hull");
  const test::Soup torus = test::torus(24, 12, 2.0, 0.8);
  has(refused(torus, vertices({0, 72, 144, 216})), "no convex hull");
}

}  // namespace
}  // namespace vorogeo::contract
