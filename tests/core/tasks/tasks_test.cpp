// Tasks: what they refuse, that they can be cancelled, how two fields differ, what answers, relaxed points.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "exact/exact_solver.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/memory.h"
#include "support/shapes.h"
#include "tasks/distance_matrix.h"
#include "tasks/extent.h"
#include "tasks/neighbors.h"
#include "tasks/spread_points.h"
#include "tasks/voronoi_regions.h"
#include "tasks/workers.h"

namespace vorogeo {
namespace {

// ---- What does not fit, and what is cancelled, in every task

TEST(Tasks, WhatDoesNotFitIsRefused) {
  Surface surface(test::make_mesh(test::plane_grid(14, 10, 4.0, 3.0, 0.2).soup), {.threads = 2});
  const std::vector<Index> points = test::random_vertices(165, 40, 7);
  std::vector<double> four(4);
  EXPECT_THROW(
      distance_matrix(surface, std::array<Index, 2>{0, 1}, MatrixMethod::automatic, std::span(four).first(3)),
      InvalidInput);
  EXPECT_THROW(distance_fields(surface, points, unreachable, std::span(four)), InvalidInput);
  EXPECT_THROW(pairs_within(surface, points, 100.0, 1000), NotEnoughMemory);
}

TEST(Tasks, CanBeCancelled) {
  const test::Soup soup = test::hills(20, 0.2);
  Surface surface(test::make_index(soup, 3, 4), 2);
  const std::vector<Index> points = test::random_vertices(static_cast<Index>(soup.positions.size()), 25, 3);
  std::vector<double> matrix(points.size() * points.size());
  std::vector<double> fields(points.size() * soup.positions.size());
  const Progress stop([](double, const std::string&) { return false; });
  for (const Answer by : {Answer::exact, Answer::index}) {
    const TaskOptions options{.by = by, .progress = stop};
    for (const auto& task : std::vector<std::function<void()>>{
             [&] { distance_matrix(surface, points, MatrixMethod::fields, std::span(matrix), options); },
             [&] { distance_fields(surface, points, unreachable, std::span(fields), options); },
             [&] { pairs_within(surface, points, 1.0, 0, options); },
             [&] { nearest_of_set(surface, points, points, 2, options); },
             [&] { voronoi_regions(surface, points, options); },
             [&] {
               sample_farthest(surface, {5, 0.0}, {}, 0, options);
             },
             [&] { sample_poisson_disk(surface, 0.1, 0, options); },
             [&] { relax_points(surface, points, 3, options); },
             [&] { geodesic_disk(surface, points, 1.0, options); },
             [&] { eccentricities(surface, points, options); },
             [&] { extent_of_component(surface, 0, 5, options); }}) {
      EXPECT_THROW(task(), Cancelled) << name_of(by);
    }
  }
}

// ---- What counts in the difference of two fields

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(FieldDifference, WhatOneFieldDoesNotReachIsCountedNotCompared) {
  const FieldDifference found =
      difference_of({infinite, infinite, 2.0, std::nan("")}, {infinite, 1.0, infinite, 3.0});
  EXPECT_EQ(found.one_only, 3);
  EXPECT_EQ(found.compared, 0);
  EXPECT_EQ(found.max, 0.0);
  for (const double value : found.relative) EXPECT_TRUE(std::isnan(value));
}

// ---- What answers the points of a task

const test::Shape plane = test::plane_grid(30, 30, 3.0, 3.0, 0.2);

TEST(Workers, RefuseTheQuickMethodAndSayWhatAnswered) {
  Surface surface(test::make_mesh(plane.soup), {.threads = 1});
  EXPECT_THROW(Workers(surface, {.by = Answer::quick}, 1.0), InvalidInput);
  Answered answered;
  { const Workers workers(surface, {.answered = &answered}, 1.0); }
  EXPECT_EQ(answered.by, Answer::exact);
}

TEST(Workers, FewOfALargeReachAreFromTheIndexAndManyOfASmallOneExact) {
  Surface surface(test::make_index(plane.soup, 3, 3), 1);
  EXPECT_FALSE(Workers(surface, {}, 10.0, 1.0).is_exact());
  EXPECT_TRUE(Workers(surface, {}, 1000.0, 0.01).is_exact());
}

TEST(Workers, FieldsOfASmallReachAreExactRunsWhereTheIndexWasNotAskedFor) {
  Surface surface(test::make_index(test::hills(40, 0.2), 3, 4), 1);
  constexpr double probe = 0.01;
  const double radius = 0.99 * probe * std::sqrt(surface.short_reach() / surface.reach_of(probe));
  Workers free(surface, {}, 10.0, 1.0);
  Workers exact(surface, {.by = Answer::exact}, 10.0, 1.0);
  Workers by_index(surface, {.by = Answer::index}, 10.0, 1.0);
  int from_index = 0;
  for (const Index source : test::random_vertices(surface.mesh()->vertex_count(), 40, 3)) {
    const auto expected = exact.field(source, radius, 0);
    EXPECT_EQ(free.field(source, radius, 0), expected) << source;
    from_index += by_index.field(source, radius, 0) != expected;
  }
  EXPECT_GT(from_index, 0);  // in the last digit
}

TEST(Workers, ManySamplesWithAnIndexAskItForTheFirstOnes) {
  Surface surface(test::make_index(plane.soup, 3, 3), 1);
  Answered answered;
  const FarthestSamples found = sample_farthest(surface, {400, 0.0}, {}, 1, {.answered = &answered});
  EXPECT_EQ(answered.by, Answer::index);
  ExactSolver solver(surface.mesh());
  std::vector<ExactSource> sources;
  for (const SurfacePoint& sample : found.points) sources.push_back({sample});
  solver.run(sources);
  for (Index v = 0; v < surface.mesh()->vertex_count(); ++v) {
    ASSERT_NEAR(found.distance[v], solver.distance(v), 0.01 * found.covering_radius) << v;
  }
}

// ---- Relaxation on a square and a rectangle, whose best points and their energy are known

const test::Shape square = test::plane_grid(10, 10, 1.0, 1.0);
const test::Shape rectangle = test::plane_grid(20, 10, 2.0, 1.0);

TEST(RelaxPoints, OnePointMovesToTheMiddleOfASquare) {
  Surface surface(test::make_mesh(square.soup), {.threads = 2});
  const RelaxedPoints found = relax_points(surface, std::array<Index, 1>{0}, 20, {.by = Answer::exact});
  ASSERT_EQ(found.points.size(), 1U);
  EXPECT_EQ(found.points[0], SurfacePoint::at_vertex(5 * 11 + 5));
  // The integral of the squared distance from a corner is 2/3, from the middle 1/6. It is summed over
  // vertices, with an error of the order of a squared cell.
  EXPECT_NEAR(found.energy.front(), 2.0 / 3.0, 0.01);
  EXPECT_NEAR(found.energy.back(), 1.0 / 6.0, 0.01);
  EXPECT_LT(found.energy.size(), 10U) << "it ends when nothing moves";
}

TEST(RelaxPoints, ARepeatedPointWaitsUntilTheOtherHasMoved) {
  Surface surface(test::make_mesh(rectangle.soup), {.threads = 1});
  const RelaxedPoints first = relax_points(surface, std::array<Index, 3>{0, 3, 3}, 1, {.by = Answer::exact});
  EXPECT_EQ(first.points[2].vertex, 3);
  EXPECT_NE(first.points[1].vertex, 3);
  const RelaxedPoints found = relax_points(surface, std::array<Index, 3>{0, 3, 3}, 30, {.by = Answer::exact});
  EXPECT_NE(found.points[2].vertex, 3);
  EXPECT_TRUE(std::ranges::is_sorted(found.energy, std::greater<>()));
}

}  // namespace
}  // namespace vorogeo
