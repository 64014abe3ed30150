// Matrices: equal to the distances and fields they are made of, symmetric, near the plane's straight lines.
#include "tasks/distance_matrix.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "query/geodesic_query.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Soup;

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

}  // namespace
}  // namespace vorogeo
