// Samplings: each farthest point is the farthest, Poisson disks are full, relaxed points are better placed.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "contract/surfaces.h"

namespace vorogeo::contract {
namespace {

double from_nearest(const Case& one, const std::vector<SurfacePoint>& samples, std::size_t count, Index v) {
  double least = unreachable;
  for (std::size_t i = 0; i < count; ++i) least = std::min(least, one.distance(samples[i], vertex(v)));
  return least;
}

/// The greatest such distance over the vertices that have faces.
double covering_radius(const Case& one, const std::vector<SurfacePoint>& samples, std::size_t count) {
  double greatest = 0.0;
  for (Index v = 0; v < one.ask.vertex_count(); ++v) {
    if (!is_in_a_face(one.ask.soup(), vertex(v))) continue;
    greatest = std::max(greatest, from_nearest(one, samples, count, v));
  }
  return greatest;
}

TEST(SamplingsContract, EachFarthestPointIsTheFarthestFromThoseBefore) {
  ask_each(cases_in_turn(), [](const Case& one, By by) {
    const Samples found = one.ask.farthest_points(9, 0.0, {one.points()[4], vertex(5)}, by);
    ASSERT_EQ(found.points.size(), 9U);
    EXPECT_EQ(found.radius[0], unreachable);
    for (std::size_t i = 2; i < 9; ++i) {
      const double there = from_nearest(one, found.points, i, found.points[i].vertex);
      expect_close(found.radius[i], there, one.tolerance(by), one.ask, "sample " + std::to_string(i));
      expect_close(there, covering_radius(one, found.points, i), 2.0 * one.tolerance(by), one.ask,
                   "sample " + std::to_string(i));
    }
    expect_all_close(
        found.distance, [&](Index v) { return from_nearest(one, found.points, 9, v); }, one.tolerance(by),
        one.ask);
    expect_close(found.covering_radius, covering_radius(one, found.points, 9), one.tolerance(by), one.ask,
                 "all");
  });
}

TEST(SamplingsContract, ARadiusIsReachedWithPointsThatFarApart) {
  ask_each(cases_by_length(), [](const Case& one, By by) {
    const Samples found = one.ask.farthest_points(0, 0.8, {}, by, 3);
    EXPECT_LE(found.covering_radius, 0.8);
    EXPECT_LE(covering_radius(one, found.points, found.points.size()), 0.8 * (1.0 + one.tolerance(by)));
    for (std::size_t i = 1; i < found.points.size(); ++i) {
      EXPECT_GE(from_nearest(one, found.points, i, found.points[i].vertex), 0.8 * (1.0 - one.tolerance(by)));
    }
  });
}

TEST(SamplingsContract, EveryComponentGetsAFarthestPointAndNoVertexWithoutAFaceIsTaken) {
  const KnownSurface parts = several_components();
  const Ask ask(parts.soup, {.patches = 3, .patches_in_each = 2});
  for (const By by : {By::exact, By::index}) {
    const Samples two = ask.farthest_points(2, 0.0, {}, by);
    EXPECT_EQ(parts.distance(two.points[0], two.points[1]), unreachable);
    EXPECT_EQ(two.radius[1], unreachable);
    const Samples all = ask.farthest_points(1000, 0.0, {}, by);
    const std::set<SurfacePoint> taken(all.points.begin(), all.points.end());
    EXPECT_EQ(static_cast<Index>(taken.size()), ask.vertex_count() - 1);
    EXPECT_EQ(all.points.size(), taken.size());
    EXPECT_FALSE(taken.contains(vertex(ask.vertex_count() - 1)));
    EXPECT_EQ(all.covering_radius, 0.0);
  }
}

TEST(SamplingsContract, PoissonDisksAreApartAndLeaveNoRoom) {
  ask_each(cases_in_turn(), [](const Case& one, By by) {
    const double radius = 0.9 * one.scale;
    const auto samples = vertices(one.ask.poisson_disk(radius, by, 7));
    for (std::size_t i = 1; i < samples.size(); ++i) {
      EXPECT_GE(from_nearest(one, samples, i, samples[i].vertex), radius * (1.0 - one.tolerance(by)));
    }
    EXPECT_LE(covering_radius(one, samples, samples.size()), radius * (1.0 + one.tolerance(by)));
  });
}

TEST(SamplingsContract, AnotherSeedGivesOtherPoissonDisks) {
  const Ask ask(test::hills(24, 0.2));
  EXPECT_NE(ask.poisson_disk(0.2, By::exact, 5), ask.poisson_disk(0.2, By::exact, 6));
}

TEST(SamplingsContract, RelaxedPointsStayDistinctAndTheirEnergyNeverRises) {
  for (const test::Soup& soup : {test::icosphere(3), test::hills(16, 0.2)}) {
    const Ask ask(soup);
    const auto start = vertices({0, 1, 2, 3, 4, 5});
    for (const By by : {By::exact, By::index}) {
      const RelaxedPoints found = ask.relaxed(start, 10, by);
      ASSERT_EQ(found.points.size(), start.size());
      const std::set<SurfacePoint> distinct(found.points.begin(), found.points.end());
      EXPECT_EQ(distinct.size(), start.size());
      for (std::size_t i = 1; i < found.energy.size(); ++i) {
        EXPECT_LE(found.energy[i], found.energy[i - 1] * (by == By::exact ? 1.0 + 1e-12 : 1.001));
      }
      EXPECT_LT(found.energy.back(), 0.8 * found.energy.front());
    }
  }
}

}  // namespace
}  // namespace vorogeo::contract
