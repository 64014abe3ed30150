// Paths: between the points asked for, on the surface, as long as their steps, and shortest if said to be.
#include <gtest/gtest.h>

#include <random>

#include "contract/surfaces.h"
#include "support/layers.h"
#include "support/surface_walk.h"

namespace vorogeo::contract {
namespace {

/// How many times as long as the shortest path a refined one may be. Most are as long.
constexpr double longest_detour = 1.05;

TEST(PathContract, PathsJoinThePointsOverSharedFacesAndTheirStepsSumToTheLength) {
  for (const Case& one : cases_in_turn()) {
    const auto points = one.points();
    const test::SurfaceWalk walk(one.ask.soup(), one.ask.soup().faces);
    for (const By by : {By::exact, By::index}) {
      SCOPED_TRACE(one.name + ", " + to_string(by));
      for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < points.size(); j += 2) {
          if (one.distance(points[i], points[j]) == unreachable) continue;
          const Path path = one.ask.path(points[i], points[j], by);
          const std::string where = std::to_string(i) + " to " + std::to_string(j);
          ASSERT_EQ(walk.fault(path.line, points[i], points[j]), "") << where;
          EXPECT_NEAR(one.scale * walk.length(path.line), path.length(), 1e-9 * path.length()) << where;
        }
      }
    }
  }
}

TEST(PathContract, ExactPathsAreShortestAndCertifiedWithAndWithoutAnIndex) {
  for (const Case& one : cases()) {
    const auto points = one.points();
    for (const By by : {By::exact, By::index}) {
      SCOPED_TRACE(one.name + ", " + to_string(by));
      for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < points.size(); j += 2) {
          const double expected = one.distance(points[i], points[j]);
          const Path path = one.ask.exact_path(points[i], points[j], by);
          const std::string where = std::to_string(i) + " to " + std::to_string(j);
          expect_close(path.length(), expected, 1e-11, one.ask, where);
          EXPECT_TRUE(path.certified || expected == unreachable) << where;
        }
      }
    }
  }
}

TEST(PathContract, ExactPathsAreCertifiedOnBumpySurfacesAndHaveTheLengthOfTheExactDistance) {
  const unsigned seed = fresh_seed();
  SCOPED_TRACE("seed " + std::to_string(seed));
  for (const test::Soup& soup :
       {test::random_sphere(150, seed), test::hills(14, 0.3), test::drilled_plate(2, 2, 0.5, seed)}) {
    const Ask ask(soup, {.patches = 3, .patches_in_each = 3});
    const test::SurfaceWalk walk(soup, soup.faces);
    const auto points = test::spread_points(soup);
    for (const By by : {By::exact, By::index}) {
      for (const SurfacePoint& a : points) {
        const Field field = ask.field({{a}}, By::exact);
        for (const SurfacePoint& b : {points[1], points[2], points[3]}) {
          const Path path = ask.exact_path(a, b, by);
          EXPECT_TRUE(path.certified) << to_string(by);
          EXPECT_EQ(walk.fault(path.line, a, b), "");
          EXPECT_NEAR(walk.length(path.line), path.length(), 1e-9 * path.length());
          expect_close(path.length(), field.distance[b.vertex], 1e-10, ask, to_string(by));
        }
      }
    }
  }
}

TEST(PathContract, RefinedPathsAreNeverTooShortAndLongerByLittle) {
  for (const Case& one : cases_in_turn()) {
    const auto points = one.points();
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = 0; j < points.size(); j += 2) {
        const double expected = one.distance(points[i], points[j]);
        if (expected == unreachable) continue;
        const double length = one.ask.path(points[i], points[j], By::index).length();
        EXPECT_GE(length, expected * (1.0 - 1e-9)) << one.name << ", " << i << " to " << j;
        EXPECT_LE(length, expected * longest_detour + 1e-12) << one.name << ", " << i << " to " << j;
      }
    }
  }
}

TEST(PathContract, WithinOnePatchRefinedPathsAreShortest) {
  for (const KnownSurface& surface : known_surfaces()) {
    const Ask ask(surface.soup, {.patches = 1, .patches_in_each = 1});
    SCOPED_TRACE(surface.name);
    for_each_pair(test::spread_points(surface.soup), [&](const SurfacePoint& a, const SurfacePoint& b,
                                                         const std::string& where) {
      expect_close(ask.path(a, b, By::index).length(), surface.distance(a, b), 1e-10, ask, where);
    });
  }
}

TEST(PathContract, PathsAcrossFacesOfNoWidthAreAsLongAsTheFieldWhereFacesHaveCosts) {
  const unsigned seed = fresh_seed();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> between(1.0, 5.0);
  const KnownSurface plane = flat("closed T-junctions", test::plane_with_closed_t_junctions());
  const std::vector<double> even(plane.soup.faces.size(), 2.5);
  std::vector<double> uneven;
  for (std::size_t f = 0; f < even.size(); ++f) uneven.push_back(between(random));
  const test::SurfaceWalk walk(plane.soup, plane.soup.faces);
  for (const auto& cost : {even, uneven}) {
    const Ask ask({plane.soup, FaceCost{cost}}, {.patches = 3, .patches_in_each = 3});
    const Field field = ask.field({{vertex(8)}}, By::exact);
    for (Index v = 0; v < ask.vertex_count(); v += 2) {
      if (!is_in_a_face(plane.soup, vertex(v))) continue;
      for (const By by : {By::exact, By::index}) {
        const std::string where = std::string(to_string(by)) + ", vertex " + std::to_string(v);
        const Path path = ask.exact_path(vertex(8), vertex(v), by);
        ASSERT_EQ(walk.fault(path.line, vertex(8), vertex(v)), "") << where;
        expect_close(path.length(), field.distance[v], 0.02, ask, where);
        if (cost != even) continue;
        expect_close(path.length(), 2.5 * plane.distance_of(8, v), 4e-3, ask, where);
        EXPECT_NEAR(path.length(), 2.5 * walk.length(path.line), 1e-8 * path.length()) << where;
      }
    }
  }
}

TEST(PathContract, ARefinedPathIsTheSameOnTheWayBack) {
  auto is_same = [](const SurfacePoint& p, const SurfacePoint& q) { return (p <=> q) == 0; };
  for (const Case& one : cases_in_turn()) {
    const auto points = one.points();
    for (std::size_t i = 0; i < points.size(); i += 2) {
      for (std::size_t j = 1; j < points.size(); j += 2) {
        const Path there = one.ask.path(points[i], points[j], By::index);
        const Path back = one.ask.path(points[j], points[i], By::index);
        EXPECT_EQ(there.length(), back.length()) << one.name << ", " << i << " to " << j;
        EXPECT_TRUE(std::equal(there.line.points.begin(), there.line.points.end(), back.line.points.rbegin(),
                               back.line.points.rend(), is_same))
            << one.name << ", " << i << " to " << j;
      }
    }
  }
}

TEST(PathContract, WithoutAWayThereIsNoPathAndItsLengthIsInfinite) {
  const KnownSurface parts = several_components();
  const Ask ask(parts.soup, {.patches = 3, .patches_in_each = 2});
  const Index last = ask.vertex_count() - 1;
  for (const By by : {By::exact, By::index}) {
    for (const auto& [a, b] : {std::pair{vertex(0), vertex(60)}, std::pair{vertex(3), vertex(last)},
                               std::pair{SurfacePoint::in_face(2, {0.5, 0.25, 0.25}), vertex(70)}}) {
      const Path path = ask.path(a, b, by);
      EXPECT_TRUE(path.line.points.empty()) << to_string(by);
      EXPECT_EQ(path.length(), unreachable) << to_string(by);
    }
  }
}

TEST(PathContract, APathFromAPointToItselfIsThatPoint) {
  for (const Case& one : cases_by_length()) {
    for (const SurfacePoint& p : one.points()) {
      if (!is_in_a_face(one.ask.soup(), p)) continue;
      for (const By by : {By::exact, By::index}) {
        const Path path = one.ask.path(p, p, by);
        EXPECT_EQ(path.length(), 0.0) << one.name << ", " << to_string(by);
        EXPECT_FALSE(path.line.points.empty()) << one.name << ", " << to_string(by);
      }
    }
  }
}

}  // namespace
}  // namespace vorogeo::contract
