// Matrices: equal to the distances and fields they are made of, symmetric, near the plane's straight lines.
#include "tasks/distance_matrix.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "query/geodesic_query.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Soup;

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

TEST(DistanceMatrix, ByPairsHoldsTheDistancesOfTheQuery) {
  const Case c = two_sheets();
  FieldTeam team(c.index, 2);
  GeodesicQuery query(c.index, 1);
  const std::size_t k = c.points.size();
  std::vector<double> square(k * k, -1.0);
  distance_matrix(team, c.points, MatrixMethod::pairs, square);
  const std::span<const Index> rows(c.points.data(), 7);
  std::vector<double> wide(7 * k, -1.0);
  distance_matrix(team, rows, c.points, MatrixMethod::pairs, wide);
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) {
      EXPECT_EQ(square[i * k + j], query.distance(c.points[i], c.points[j]));
      if (i < 7) {
        EXPECT_EQ(wide[i * k + j], square[i * k + j]);
      }
    }
  }
}

TEST(DistanceMatrix, ByFieldsHoldsTheFieldOfTheSmallerVertex) {
  const Case c = two_sheets();
  FieldTeam team(c.index, 2);
  GeodesicQuery query(c.index, 1);
  const std::size_t k = c.points.size();
  std::vector<double> matrix(k * k, -1.0);
  distance_matrix(team, c.points, MatrixMethod::fields, matrix);
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
  FieldTeam team(c.index, 2);
  const std::span<const Index> few(c.points.data(), 3);
  const std::size_t k = c.points.size();
  std::vector<double> wide(3 * k, -1.0);
  std::vector<double> tall(3 * k, -1.0);
  distance_matrix(team, few, c.points, MatrixMethod::fields, wide);
  distance_matrix(team, c.points, few, MatrixMethod::fields, tall);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto field = team.field(few[i], unreachable, 0);
    for (std::size_t j = 0; j < k; ++j) {
      EXPECT_EQ(wide[i * k + j], field[c.points[j]]);
      EXPECT_EQ(tall[j * 3 + i], wide[i * k + j]);
    }
  }
}

TEST(DistanceMatrix, ExactOnThePlane) {
  const test::Shape plane = test::plane_grid(12, 9, 4.0, 3.0, 0.2);
  FieldTeam team(test::make_mesh(plane.soup), 2);
  const auto points = test::random_vertices(130, 20, 2);
  std::vector<double> matrix(400);
  for (MatrixMethod method : {MatrixMethod::automatic, MatrixMethod::pairs, MatrixMethod::fields}) {
    distance_matrix(team, points, method, matrix);
    for (int i = 0; i < 20; ++i) {
      for (int j = 0; j < 20; ++j) {
        EXPECT_NEAR(matrix[20 * i + j], plane.vertex_distance(points[i], points[j]), 1e-12);
      }
    }
  }
}

TEST(DistanceMatrix, UnreachableIsInfinityAndEmptyListsAreEmptyMatrices) {
  const Case c = two_sheets();
  FieldTeam team(c.index, 1);
  const Index ends[] = {0, c.index->mesh()->vertex_count() - 1};
  std::vector<double> matrix(4);
  distance_matrix(team, ends, MatrixMethod::automatic, matrix);
  EXPECT_EQ(matrix, (std::vector<double>{0.0, unreachable, unreachable, 0.0}));
  EXPECT_NO_THROW(
      distance_matrix(team, std::span<const Index>(), MatrixMethod::automatic, std::span<double>()));
  EXPECT_NO_THROW(
      distance_matrix(team, ends, std::span<const Index>(), MatrixMethod::fields, std::span<double>()));
  EXPECT_NO_THROW(distance_fields(team, {}, unreachable, std::span<double>()));
}

TEST(DistanceMatrix, FieldsAreThoseOfTheQueryAndRespectTheLimit) {
  const Case c = two_sheets();
  FieldTeam team(c.index, 2);
  GeodesicQuery query(c.index, 1);
  const auto n = static_cast<std::size_t>(c.index->mesh()->vertex_count());
  const std::span<const Index> sources(c.points.data(), 5);
  std::vector<double> rows(5 * n);
  distance_fields(team, sources, 0.4, rows);
  for (std::size_t i = 0; i < 5; ++i) {
    const auto field = query.distance_field(sources.subspan(i, 1), 0.4);
    EXPECT_TRUE(std::equal(field.begin(), field.end(), rows.begin() + static_cast<std::ptrdiff_t>(i * n)));
  }
}

TEST(DistanceMatrix, SinglePrecisionIsTheRoundedDouble) {
  const Case c = two_sheets();
  FieldTeam team(c.index, 2);
  const std::size_t k = c.points.size();
  const auto n = static_cast<std::size_t>(c.index->mesh()->vertex_count());
  const std::span<const Index> few(c.points.data(), 3);
  auto expect_rounded = [](const std::vector<double>& wide, const std::vector<float>& narrow) {
    for (std::size_t i = 0; i < wide.size(); ++i) EXPECT_EQ(narrow[i], static_cast<float>(wide[i]));
  };
  for (MatrixMethod method : {MatrixMethod::pairs, MatrixMethod::fields}) {
    std::vector<double> wide(k * k, -1.0);
    std::vector<float> narrow(k * k, -1.0F);
    distance_matrix(team, c.points, method, wide);
    distance_matrix(team, c.points, method, narrow);
    expect_rounded(wide, narrow);
    wide.resize(3 * k);
    narrow.resize(3 * k);
    distance_matrix(team, few, c.points, method, wide);
    distance_matrix(team, few, c.points, method, narrow);
    expect_rounded(wide, narrow);
  }
  std::vector<double> wide(3 * n);
  std::vector<float> narrow(3 * n);
  distance_fields(team, few, unreachable, wide);
  distance_fields(team, few, unreachable, narrow);
  expect_rounded(wide, narrow);
}

TEST(DistanceMatrix, RefusesWhatDoesNotFit) {
  const Case c = two_sheets();
  FieldTeam team(c.index, 1);
  std::vector<double> four(4);
  const Index good[] = {0, 1};
  const Index bad[] = {0, 99999};
  EXPECT_THROW(distance_matrix(team, bad, MatrixMethod::automatic, four), InvalidInput);
  EXPECT_THROW(distance_matrix(team, good, MatrixMethod::automatic, std::span(four).first(3)), InvalidInput);
  EXPECT_THROW(pair_distances(team, good, std::span(good, 1), four), InvalidInput);
  EXPECT_THROW(distance_fields(team, good, std::nan(""), four), InvalidInput);
}

TEST(DistanceMatrix, CanBeCancelled) {
  const Case c = two_sheets();
  FieldTeam team(c.index, 2);
  const std::size_t k = c.points.size();
  std::vector<double> matrix(k * k);
  const Progress stop([](double, const std::string&) { return false; });
  EXPECT_THROW(distance_matrix(team, c.points, MatrixMethod::fields, matrix, stop), Cancelled);
}

TEST(PairDistances, InAnyOrderAsOneByOne) {
  const test::Soup two = test::two_components(test::hills(24, 0.2), test::icosphere(2));
  const auto index = test::make_index(test::with_isolated_vertex(two, {7, 7, 7}), 5, 3);
  const Index n = index->mesh()->vertex_count();
  FieldTeam team(index, 2);
  std::vector<Index> sources;
  std::vector<Index> targets;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    // Repeated ends, equal ends, and the vertex without a face.
    for (Index v : test::random_vertices(n, 60, seed)) {
      sources.push_back(seed % 2 == 0 ? sources[seed] : v);
      targets.push_back(v % 7 == 0 ? n - 1 : (v * 31) % n);
    }
  }
  const PointList from(sources);
  const PointList to(targets);
  const auto order = team.order_of_pairs(from, to);
  ASSERT_EQ(order.size(), sources.size());
  std::vector<std::size_t> sorted = order;
  std::ranges::sort(sorted);
  for (std::size_t i = 0; i < sorted.size(); ++i) EXPECT_EQ(sorted[i], i);
  std::vector<double> found(sources.size());
  pair_distances(team, from, to, found);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i], GeodesicQuery(index, 1).distance(sources[i], targets[i])) << i;
  }
}

}  // namespace
}  // namespace vorogeo
