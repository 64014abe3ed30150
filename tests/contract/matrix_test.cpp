// Matrices: the distances of all pairs, zero on the diagonal, symmetric to the last bit, in any order.
#include <gtest/gtest.h>

#include "contract/surfaces.h"

namespace vorogeo::contract {
namespace {

TEST(MatrixContract, EntriesAreTheDistancesOfTheirPoints) {
  ask_each(cases_in_turn(), [](const Case& one, By by) {
    const auto rows = one.points();
    const std::vector<SurfacePoint> columns{rows[1], rows[5], rows[0], rows[1]};
    const auto matrix = one.ask.matrix(rows, columns, by);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t j = 0; j < columns.size(); ++j) {
        expect_close(matrix[i * columns.size() + j], one.distance(rows[i], columns[j]),
                     one.tolerance(by, rows[i], columns[j]), one.ask, std::to_string(i));
      }
    }
  });
}

TEST(MatrixContract, OfOneListItIsSymmetricToTheLastBitWithZerosForEqualPoints) {
  ask_each(cases_in_turn(), [](const Case& one, By by) {
    auto points = one.points();
    points.push_back(points[4]);
    const std::size_t n = points.size();
    const auto matrix = one.ask.matrix(points, by);
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_EQ(matrix[i * n + i], 0.0);
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_EQ(matrix[i * n + j], matrix[j * n + i]) << i << ", " << j;
        expect_close(matrix[i * n + j], one.distance(points[i], points[j]),
                     one.tolerance(by, points[i], points[j]), one.ask, std::to_string(i));
      }
    }
    EXPECT_EQ(matrix[4 * n + n - 1], 0.0);
  });
}

TEST(MatrixContract, TheOrderChangesNoEntry) {
  const Ask ask(test::hills(24, 0.2), {.patches = 3, .patches_in_each = 3});
  const auto points = test::spread_points(ask.soup());
  const std::vector<SurfacePoint> turned(points.rbegin(), points.rend());
  for (const By by : {By::exact, By::index}) {
    const auto matrix = ask.matrix(points, by);
    const auto other = ask.matrix(turned, by);
    EXPECT_TRUE(std::equal(matrix.begin(), matrix.end(), other.rbegin())) << to_string(by);
  }
}

TEST(MatrixContract, ListsMayBeEmpty) {
  const Ask ask(test::icosphere(1));
  for (const By by : {By::exact, By::index}) {
    EXPECT_TRUE(ask.matrix({}, {vertex(1)}, by).empty());
    EXPECT_TRUE(ask.matrix({vertex(1)}, {}, by).empty());
    EXPECT_TRUE(ask.matrix(std::vector<SurfacePoint>{}, by).empty());
  }
}

}  // namespace
}  // namespace vorogeo::contract
