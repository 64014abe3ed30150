// Pairs within a radius and nearest of a set: equal to brute force over full fields.
#include "tasks/neighbors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/error.h"
#include "support/indexes.h"
#include "support/memory.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Soup;

const TaskOptions exactly{.by = AnswerMethod::exact};
const TaskOptions by_index{.by = AnswerMethod::index};

/// A plane, some of its vertices (one of them twice), and their straight-line distances.
struct Plane {
  test::Shape shape = test::plane_grid(14, 10, 4.0, 3.0, 0.2);
  Surface surface{test::make_mesh(shape.soup), {.threads = 2}};
  std::vector<Index> points = test::random_vertices(165, 40, 7);
  Plane() { points.push_back(points[3]); }
};

TEST(PairsWithin, AreThoseOfBruteForceOnThePlane) {
  Plane plane;
  const double radius = 0.9;
  const SparseDistances found = pairs_within(plane.surface, plane.points, radius, 0, exactly);
  ASSERT_EQ(found.row_begin.size(), plane.points.size() + 1);
  std::size_t at = 0;
  for (std::size_t i = 0; i < plane.points.size(); ++i) {
    EXPECT_EQ(found.row_begin[i], static_cast<std::int64_t>(at));
    for (std::size_t j = 0; j < plane.points.size(); ++j) {
      const double distance = plane.shape.vertex_distance(plane.points[i], plane.points[j]);
      if (i == j || distance > radius) continue;
      ASSERT_LT(at, found.column.size());
      EXPECT_EQ(found.column[at], static_cast<Index>(j));
      EXPECT_NEAR(found.distance[at], distance, 1e-12);
      ++at;
    }
  }
  EXPECT_EQ(at, found.column.size());
}

TEST(PairsWithin, OtherColumns) {
  Plane plane;
  const std::span<const Index> rows(plane.points.data(), 6);
  const double radius = 1.3;
  const SparseDistances found = pairs_within(plane.surface, rows, plane.points, radius, 0, exactly);
  std::size_t at = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < plane.points.size(); ++j) {
      const double distance = plane.shape.vertex_distance(rows[i], plane.points[j]);
      if (distance > radius) continue;
      ASSERT_LT(at, found.column.size());
      EXPECT_EQ(found.column[at], static_cast<Index>(j));
      EXPECT_NEAR(found.distance[at++], distance, 1e-12);
    }
  }
  EXPECT_EQ(at, found.column.size());
}

TEST(PairsWithin, InfiniteRadiusJoinsComponentsOnlyWithin) {
  const Soup soup = test::two_components(test::icosphere(1), test::icosphere(1));
  Surface surface(test::make_index(soup, 2, 2), 2);
  const Index points[] = {0, 5, 42, 50};
  const SparseDistances found = pairs_within(surface, points, unreachable, 0, by_index);
  EXPECT_EQ(found.column, (std::vector<Index>{1, 0, 3, 2}));
  EXPECT_EQ(found.distance[0], found.distance[1]);
}

TEST(PairsWithin, RefusesBadRadiusAndTooManyPairs) {
  Plane plane;
  EXPECT_THROW(pairs_within(plane.surface, plane.points, -1.0), InvalidInput);
  EXPECT_THROW(pairs_within(plane.surface, plane.points, std::nan("")), InvalidInput);
  EXPECT_THROW(pairs_within(plane.surface, plane.points, 100.0, 1000), NotEnoughMemory);
  EXPECT_TRUE(pairs_within(plane.surface, std::span<const Index>(), 1.0).column.empty());
  EXPECT_EQ(pairs_within(plane.surface, plane.points, 0.0).column.size(), 2U);  // the repeated point
}

TEST(NearestOfSet, AreThoseOfBruteForceFromEitherSide) {
  Plane plane;
  const std::vector<Index> all = test::random_vertices(165, 90, 11);
  for (const auto& [set, queries] : {std::pair(plane.points, all), std::pair(all, plane.points)}) {
    const NearestOfSet found = nearest_of_set(plane.surface, set, queries, 4, exactly);
    for (std::size_t q = 0; q < queries.size(); ++q) {
      std::vector<double> distances;
      for (Index point : set) distances.push_back(plane.shape.vertex_distance(point, queries[q]));
      for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(found.distance[4 * q + i], distances[found.position[4 * q + i]], 1e-12);
      }
      std::sort(distances.begin(), distances.end());
      for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found.distance[4 * q + i], distances[i], 1e-12);
    }
  }
}

TEST(NearestOfSet, MoreThanCanBeReachedLeavesPlacesEmpty) {
  const Soup soup = test::two_components(test::icosphere(1), test::icosphere(1));
  Surface surface(test::make_index(soup, 2, 2), 1);
  const Index set[] = {0, 50, 3};
  const Index queries[] = {0};
  const NearestOfSet found = nearest_of_set(surface, set, queries, 5, by_index);
  EXPECT_EQ(found.position, (std::vector<Index>{0, 2, no_index, no_index, no_index}));
  EXPECT_EQ(found.distance[0], 0.0);
  EXPECT_EQ(found.distance[2], unreachable);
  EXPECT_EQ(nearest_of_set(surface, {}, queries, 1, by_index).position, (std::vector<Index>{no_index}));
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

}  // namespace
}  // namespace vorogeo
