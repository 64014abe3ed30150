// Extent: eccentricities, bounds that bracket diameter and radius and meet in the end, and disks.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "contract/surfaces.h"

namespace vorogeo::contract {
namespace {

/// The greatest finite distance of each vertex from another.
std::vector<double> true_eccentricities(const Case& one) {
  std::vector<double> greatest(one.ask.vertex_count(), 0.0);
  for (Index a = 0; a < one.ask.vertex_count(); ++a) {
    for (Index b = 0; b < a; ++b) {
      const double distance = one.distance(vertex(a), vertex(b));
      if (distance == unreachable) continue;
      greatest[a] = std::max(greatest[a], distance);
      greatest[b] = std::max(greatest[b], distance);
    }
  }
  return greatest;
}

TEST(ExtentContract, AnEccentricityIsTheDistanceOfTheFarthestVertex) {
  ask_each(cases_in_turn(), [](const Case& one, By by) {
    const auto points = one.points();
    const auto found = one.ask.eccentricities(points, by);
    for (std::size_t i = 0; i < points.size(); ++i) {
      double greatest = 0.0;
      for (Index v = 0; v < one.ask.vertex_count(); ++v) {
        const double distance = one.distance(points[i], vertex(v));
        if (distance != unreachable) greatest = std::max(greatest, distance);
      }
      expect_close(found[i].distance, greatest, one.tolerance(by), one.ask, std::to_string(i));
      expect_close(one.distance(points[i], vertex(found[i].farthest)), greatest, 2.0 * one.tolerance(by),
                   one.ask, std::to_string(i));
    }
  });
}

TEST(ExtentContract, BoundsOfDiameterAndRadiusBracketTheTruthAndMeet) {
  for (const Case& one : cases_by_length()) {
    const auto eccentricity = true_eccentricities(one);
    const Index start = 3;
    double diameter = 0.0;
    double radius = unreachable;
    for (Index v = 0; v < one.ask.vertex_count(); ++v) {
      if (one.distance(vertex(start), vertex(v)) == unreachable) continue;
      diameter = std::max(diameter, eccentricity[v]);
      radius = std::min(radius, eccentricity[v]);
    }
    for (const By by : {By::exact, By::index}) {
      for (const Index fields : {2, 6, 100000}) {
        SCOPED_TRACE(one.name + ", " + to_string(by) + ", " + std::to_string(fields));
        const Extent found = one.ask.extent(start, fields, by);
        const double more = 1.0 + one.tolerance(by);
        EXPECT_LE(found.fields, fields);
        EXPECT_LE(found.diameter.lower, diameter * more);
        EXPECT_GE(found.diameter.upper * more, diameter);
        EXPECT_LE(found.radius.lower, radius * more);
        EXPECT_GE(found.radius.upper * more, radius);
        expect_close(one.distance(vertex(found.ends[0]), vertex(found.ends[1])), found.diameter.lower,
                     one.tolerance(by), one.ask, "ends");
        expect_close(eccentricity[found.centre], found.radius.upper, one.tolerance(by), one.ask, "centre");
        if (fields < 100000) continue;
        EXPECT_NEAR(found.diameter.lower, found.diameter.upper, 1e-9 * diameter);
        EXPECT_NEAR(found.radius.lower, found.radius.upper, 1e-9 * diameter);
      }
    }
  }
}

TEST(ExtentContract, ADiskIsWhatLiesWithinTheRadius) {
  ask_each(cases_in_turn(), [](const Case& one, By by) {
    const SurfacePoint centre = one.points()[5];
    const double radius = 0.8 * one.scale;
    const Disk disk = one.ask.disk({centre}, radius, by);
    const std::set<Index> inside(disk.vertices.begin(), disk.vertices.end());
    ASSERT_TRUE(std::ranges::is_sorted(disk.vertices));
    for (Index v = 0; v < one.ask.vertex_count(); ++v) {
      const double distance = one.distance(centre, vertex(v));
      if (std::abs(distance - radius) <= one.tolerance(by) * radius) continue;
      EXPECT_EQ(inside.contains(v), distance < radius) << "vertex " << v;
    }
    for (std::size_t i = 0; i < disk.vertices.size(); ++i) {
      const SurfacePoint there = vertex(disk.vertices[i]);
      expect_close(disk.distance[i], one.distance(centre, there), one.tolerance(by), one.ask,
                   "vertex " + std::to_string(disk.vertices[i]));
    }
  });
}

TEST(ExtentContract, ADiskOfSeveralSourcesIsTheUnionOfTheirDisks) {
  for (const Case& one : cases_by_length()) {
    const auto points = one.points();
    std::set<Index> expected;
    for (const SurfacePoint& centre : {points[1], points[5]}) {
      const Disk disk = one.ask.disk({centre}, 0.8, By::exact);
      expected.insert(disk.vertices.begin(), disk.vertices.end());
    }
    const Disk both = one.ask.disk({points[1], points[5]}, 0.8, By::exact);
    EXPECT_EQ(std::set<Index>(both.vertices.begin(), both.vertices.end()), expected) << one.name;
  }
}

TEST(ExtentContract, ADiskHoldsTheFacesAllOfWhoseCornersLieInside) {
  const test::Soup soup = test::hills(20, 0.2);
  const Ask ask(soup, {.patches = 3, .patches_in_each = 3});
  for (const By by : {By::exact, By::index}) {
    const Disk disk = ask.disk(vertices({100}), 0.3, by);
    const std::set<Index> inside(disk.vertices.begin(), disk.vertices.end());
    std::vector<Index> faces;
    for (std::size_t f = 0; f < soup.faces.size(); ++f) {
      if (std::ranges::all_of(soup.faces[f], [&](Index v) { return inside.contains(v); })) {
        faces.push_back(static_cast<Index>(f));
      }
    }
    EXPECT_EQ(disk.faces, faces) << to_string(by);
    EXPECT_FALSE(faces.empty());
  }
}

}  // namespace
}  // namespace vorogeo::contract
