// What tasks refuse, that they can be cancelled, and how two fields differ.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "support/error.h"
#include "support/indexes.h"
#include "support/memory.h"
#include "support/shapes.h"
#include "tasks/distance_matrix.h"
#include "tasks/extent.h"
#include "tasks/neighbors.h"
#include "tasks/spread_points.h"
#include "tasks/voronoi_regions.h"

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
  EXPECT_THROW(distance_fields(surface, points, unreachable, four), InvalidInput);
  EXPECT_THROW(pairs_within(surface, points, 100.0, 1000), NotEnoughMemory);
}

TEST(Tasks, CanBeCancelled) {
  const test::Soup soup = test::hills(20, 0.2);
  Surface surface(test::make_index(soup, 3, 4), 2);
  const std::vector<Index> points = test::random_vertices(static_cast<Index>(soup.positions.size()), 25, 3);
  std::vector<double> matrix(points.size() * points.size());
  std::vector<double> fields(points.size() * soup.positions.size());
  const Progress stop([](double, const std::string&) { return false; });
  for (const AnswerMethod by : {AnswerMethod::exact, AnswerMethod::index}) {
    const TaskOptions options{.by = by, .progress = stop};
    for (const auto& task : std::vector<std::function<void()>>{
             [&] { distance_matrix(surface, points, MatrixMethod::fields, matrix, options); },
             [&] { distance_fields(surface, points, unreachable, fields, options); },
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
      EXPECT_THROW(task(), Cancelled) << to_string(by);
    }
  }
}

TEST(Memory, SaysHowMuchIsMissing) {
  EXPECT_NO_THROW(require_memory(1000.0, 1000, "It", "Try less."));
  EXPECT_GT(available_memory_bytes(), 0);
  EXPECT_THROW(require_memory(1e30, 0, "It", "Try less."), NotEnoughMemory);
  try {
    require_memory(3.0 * (1 << 30), 1 << 20, "It", "Try less.");
    FAIL();
  } catch (const NotEnoughMemory& error) {
    EXPECT_STREQ(error.what(), "It takes 3 GiB, more than the 1 MiB allowed. Try less.");
  }
}

// ---- Statistics of the difference of two fields, counted by hand

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(FieldDifference, StatisticsOfFourVertices) {
  const FieldDifference found = difference_of({0.0, 1.1, 1.8, 4.0, 5.0}, {0.0, 1.0, 2.0, 4.0, 5.0});
  ASSERT_EQ(found.relative.size(), 5U);
  EXPECT_TRUE(std::isnan(found.relative[0])) << "a source has no relative error";
  EXPECT_NEAR(found.relative[1], 0.1, 1e-15);
  EXPECT_NEAR(found.relative[2], -0.1, 1e-15);
  EXPECT_EQ(found.compared, 4);
  EXPECT_EQ(found.one_only, 0);
  EXPECT_NEAR(found.bias, 0.0, 1e-15);
  EXPECT_NEAR(found.mean, 0.05, 1e-15);
  EXPECT_NEAR(found.rms, std::sqrt(0.005), 1e-15);
  EXPECT_NEAR(found.p99, 0.1, 1e-15);
  EXPECT_NEAR(found.max, 0.1, 1e-15);
}

TEST(FieldDifference, ThePercentileLeavesOutOneInAHundred) {
  std::vector<double> values(200, 1.0);
  values[7] = 1.5;
  values[50] = 1.25;
  values[120] = 0.875;
  const FieldDifference found = difference_of(values, std::vector<double>(200, 1.0));
  EXPECT_EQ(found.p99, 0.125);  // the 198th of 200 sorted errors
  EXPECT_EQ(found.max, 0.5);
}

TEST(FieldDifference, WhatOneFieldDoesNotReachIsCountedNotCompared) {
  const FieldDifference found =
      difference_of({infinite, infinite, 2.0, std::nan("")}, {infinite, 1.0, infinite, 3.0});
  EXPECT_EQ(found.one_only, 3);
  EXPECT_EQ(found.compared, 0);
  EXPECT_EQ(found.max, 0.0);
  for (const double value : found.relative) EXPECT_TRUE(std::isnan(value));
}

TEST(FieldDifference, EmptyFieldsDifferInNothing) {
  const FieldDifference found = difference_of({}, {});
  EXPECT_EQ(found.compared, 0);
  EXPECT_TRUE(found.relative.empty());
}

}  // namespace
}  // namespace vorogeo
