// Many distances at once: matrices, pairs within a radius, nearest of a set, and how two fields differ.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "query/geodesic_query.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/memory.h"
#include "support/shapes.h"
#include "tasks/distance_matrix.h"
#include "tasks/extent.h"
#include "tasks/neighbors.h"

namespace vorogeo {
namespace {

using test::Soup;

// ---- Matrices: equal to the distances and fields they are made of, symmetric, near the plane's straight
// lines

const TaskOptions by_index{.by = AnswerMethod::index};

struct Case {
  std::shared_ptr<const GeodesicIndex> index;
  std::vector<Index> points;
};

/// Two components, points on both, one of them twice.
Case two_sheets() {
  const Soup soup = test::two_components(test::hills(20, 0.2), test::icosphere(2));
  Case c{test::make_index(soup, 3, 4),
         test::random_vertices(static_cast<Index>(soup.positions.size()), 25, 3)};
  c.points.push_back(c.points[4]);
  return c;
}

TEST(DistanceMatrix, ByFieldsHoldsTheFieldOfTheSmallerVertex) {
  const Case c = two_sheets();
  Surface surface(c.index, 2);
  GeodesicQuery query(c.index, 1);
  const std::size_t k = c.points.size();
  std::vector<double> matrix(k * k, -1.0);
  distance_matrix(surface, c.points, MatrixMethod::fields, matrix, by_index);
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) {
      const Index low = std::min(c.points[i], c.points[j]);
      const Index high = std::max(c.points[i], c.points[j]);
      EXPECT_EQ(matrix[i * k + j], query.distance_field(std::span(&low, 1))[high]);
    }
  }
}

TEST(DistanceMatrix, TallAndWideMatricesAreFieldsOfTheShorterList) {
  const Case c = two_sheets();
  Surface surface(c.index, 2);
  const std::span<const Index> few(c.points.data(), 3);
  const std::size_t k = c.points.size();
  std::vector<double> wide(3 * k, -1.0);
  std::vector<double> tall(3 * k, -1.0);
  distance_matrix(surface, few, c.points, MatrixMethod::fields, wide, by_index);
  distance_matrix(surface, c.points, few, MatrixMethod::fields, tall, by_index);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto field = GeodesicQuery(c.index, 1).distance_field(few.subspan(i, 1));
    for (std::size_t j = 0; j < k; ++j) {
      EXPECT_EQ(wide[i * k + j], field[c.points[j]]);
      EXPECT_EQ(tall[j * 3 + i], wide[i * k + j]);
    }
  }
}

TEST(DistanceMatrix, FieldsAreThoseOfTheQueryAndRespectTheLimit) {
  const Case c = two_sheets();
  Surface surface(c.index, 2);
  GeodesicQuery query(c.index, 1);
  const auto n = static_cast<std::size_t>(c.index->mesh()->vertex_count());
  const std::span<const Index> sources(c.points.data(), 5);
  std::vector<double> rows(5 * n);
  distance_fields(surface, sources, 0.4, rows, by_index);
  for (std::size_t i = 0; i < 5; ++i) {
    const auto field = query.distance_field(sources.subspan(i, 1), 0.4);
    EXPECT_TRUE(std::equal(field.begin(), field.end(), rows.begin() + static_cast<std::ptrdiff_t>(i * n)));
  }
}

TEST(DistanceMatrix, SinglePrecisionIsTheRoundedDouble) {
  const Case c = two_sheets();
  Surface surface(c.index, 2);
  const std::size_t k = c.points.size();
  const auto n = static_cast<std::size_t>(c.index->mesh()->vertex_count());
  const std::span<const Index> few(c.points.data(), 3);
  auto expect_rounded = [](const std::vector<double>& wide, const std::vector<float>& narrow) {
    for (std::size_t i = 0; i < wide.size(); ++i) EXPECT_EQ(narrow[i], static_cast<float>(wide[i]));
  };
  for (MatrixMethod method : {MatrixMethod::pairs, MatrixMethod::fields}) {
    std::vector<double> wide(k * k, -1.0);
    std::vector<float> narrow(k * k, -1.0F);
    distance_matrix(surface, c.points, method, wide, by_index);
    distance_matrix(surface, c.points, method, narrow, by_index);
    expect_rounded(wide, narrow);
    wide.resize(3 * k);
    narrow.resize(3 * k);
    distance_matrix(surface, few, c.points, method, wide, by_index);
    distance_matrix(surface, few, c.points, method, narrow, by_index);
    expect_rounded(wide, narrow);
  }
  std::vector<double> wide(3 * n);
  std::vector<float> narrow(3 * n);
  distance_fields(surface, few, unreachable, wide, by_index);
  distance_fields(surface, few, unreachable, narrow, by_index);
  expect_rounded(wide, narrow);
}

TEST(DistanceMatrix, RefusesWhatDoesNotFit) {
  const Case c = two_sheets();
  Surface surface(c.index, 1);
  std::vector<double> four(4);
  const Index good[] = {0, 1};
  const Index bad[] = {0, 99999};
  EXPECT_THROW(distance_matrix(surface, bad, MatrixMethod::automatic, four), InvalidInput);
  EXPECT_THROW(distance_matrix(surface, good, MatrixMethod::automatic, std::span(four).first(3)),
               InvalidInput);
  EXPECT_THROW(distance_fields(surface, good, std::nan(""), four), InvalidInput);
}

TEST(DistanceMatrix, CanBeCancelled) {
  const Case c = two_sheets();
  Surface surface(c.index, 2);
  const std::size_t k = c.points.size();
  std::vector<double> matrix(k * k);
  const Progress stop([](double, const std::string&) { return false; });
  EXPECT_THROW(distance_matrix(surface, c.points, MatrixMethod::fields, matrix,
                               {.by = AnswerMethod::index, .progress = stop}),
               Cancelled);
}

// ---- Pairs within a radius and nearest of a set: equal to brute force over full fields

/// A plane, some of its vertices (one of them twice), and their straight-line distances.
struct Plane {
  test::Shape shape = test::plane_grid(14, 10, 4.0, 3.0, 0.2);
  Surface surface{test::make_mesh(shape.soup), {.threads = 2}};
  std::vector<Index> points = test::random_vertices(165, 40, 7);
  Plane() { points.push_back(points[3]); }
};

TEST(PairsWithin, RefusesBadRadiusAndTooManyPairs) {
  Plane plane;
  EXPECT_THROW(pairs_within(plane.surface, plane.points, -1.0), InvalidInput);
  EXPECT_THROW(pairs_within(plane.surface, plane.points, std::nan("")), InvalidInput);
  EXPECT_THROW(pairs_within(plane.surface, plane.points, 100.0, 1000), NotEnoughMemory);
  EXPECT_TRUE(pairs_within(plane.surface, std::span<const Index>(), 1.0).column.empty());
  EXPECT_EQ(pairs_within(plane.surface, plane.points, 0.0).column.size(), 2U);  // the repeated point
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
