// Scans over lower bounds against plain loops.
#include "support/bound_scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace vorogeo {
namespace {

TEST(BoundScans, BytesEndAt255) {
  std::mt19937 random(3);
  for (Index row_size : {1, 7, 31, 32, 33, 64, 90}) {
    const Index lanes = (row_size + byte_lanes - 1) / byte_lanes * byte_lanes;
    for (Index rows : {0, 1, 2, 40}) {
      std::vector<std::uint8_t> bounds(static_cast<std::size_t>(rows) * row_size + byte_lanes);
      for (auto& bound : bounds) bound = static_cast<std::uint8_t>(random() % 256);
      std::vector<std::uint8_t> base(lanes, 255);
      for (Index lane = 0; lane < row_size; ++lane) base[lane] = static_cast<std::uint8_t>(random() % 256);
      std::vector<std::uint8_t> least(rows);
      least_byte_sums(bounds.data(), rows, row_size, base.data(), lanes, least.data());
      for (Index row = 0; row < rows; ++row) {
        const std::uint8_t* of_row = bounds.data() + static_cast<std::size_t>(row) * row_size;
        int expected = 255;
        for (Index lane = 0; lane < row_size; ++lane)
          expected = std::min(expected, base[lane] + of_row[lane]);
        EXPECT_EQ(least[row], expected);
        for (int limit : {0, expected - 1, expected, 200, 254, 255}) {
          std::vector<std::uint8_t> within(lanes, 7);
          byte_sums_within(of_row, base.data(), lanes, static_cast<std::uint8_t>(std::max(0, limit)),
                           within.data());
          for (Index lane = 0; lane < row_size; ++lane) {
            const int sum = std::min(255, base[lane] + of_row[lane]);
            EXPECT_EQ(within[lane], sum <= std::max(0, limit) ? 1 : 0);
          }
        }
      }
    }
  }
}

TEST(BoundScans, SumsOfThree) {
  std::mt19937 random(5);
  for (Index columns : {16, 32, 64, 80}) {
    for (Index rows : {1, 2, 30}) {
      auto numbers = [&](Index count, unsigned most) {
        std::vector<std::int16_t> result(count);
        for (auto& number : result) number = static_cast<std::int16_t>(random() % most);
        return result;
      };
      const auto base = numbers(rows, 8192);
      const auto between = numbers(rows * columns, 16384);
      const auto beyond = numbers(columns, 8192);
      auto sum = [&](Index row, Index column) {
        return base[row] + between[row * columns + column] + beyond[column];
      };
      std::vector<std::int16_t> row_least(rows);
      std::vector<std::int16_t> column_least(columns);
      least_short_sums(base.data(), between.data(), beyond.data(), rows, columns, row_least.data(),
                       column_least.data());
      std::vector<std::uint8_t> within(columns);
      for (Index row = 0; row < rows; ++row) {
        int expected = 32767;
        for (Index column = 0; column < columns; ++column) expected = std::min(expected, sum(row, column));
        EXPECT_EQ(row_least[row], expected);
        const int limit = 12000 - base[row];
        short_sums_within(between.data() + row * columns, beyond.data(), columns,
                          static_cast<std::int16_t>(limit), within.data());
        for (Index column = 0; column < columns; ++column) {
          EXPECT_EQ(within[column], sum(row, column) <= 12000 ? 1 : 0);
        }
      }
      for (Index column = 0; column < columns; ++column) {
        int expected = 32767;
        for (Index row = 0; row < rows; ++row) expected = std::min(expected, sum(row, column));
        EXPECT_EQ(column_least[column], expected);
      }
    }
  }
}

}  // namespace
}  // namespace vorogeo
