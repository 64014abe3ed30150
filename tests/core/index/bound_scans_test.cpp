// Scans over lower bounds against plain loops.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "index/scans.h"

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
      const auto column_base = numbers(columns, 8192);
      auto sum = [&](Index row, Index column) {
        return base[row] + between[row * columns + column] + column_base[column];
      };
      std::vector<std::int16_t> row_least(rows);
      std::vector<std::int16_t> column_least(columns);
      least_short_sums(base.data(), between.data(), column_base.data(), rows, columns, row_least.data(),
                       column_least.data());
      std::vector<std::uint8_t> within(columns);
      for (Index row = 0; row < rows; ++row) {
        int expected = 32767;
        for (Index column = 0; column < columns; ++column) expected = std::min(expected, sum(row, column));
        EXPECT_EQ(row_least[row], expected);
        const int limit = 12000 - base[row];
        short_sums_within(between.data() + row * columns, column_base.data(), columns,
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

TEST(BoundScans, WaysOverTheLanesOfUse) {
  std::mt19937 random(9);
  constexpr float infinite = std::numeric_limits<float>::infinity();
  constexpr float greatest = 8191.5F;
  constexpr float bound_unit = greatest / 254.0F;
  for (const TableScale scale : {TableScale::even(greatest, 32766), TableScale::graded(greatest, 32766)}) {
    for (Index columns : {3, 8}) {
      for (Index seeds : {1, 30, 70}) {
        const Index lanes = (seeds + byte_lanes - 1) / byte_lanes * byte_lanes;
        std::vector<std::uint16_t> table(static_cast<std::size_t>(seeds) * columns);
        for (auto& entry : table)
          entry = static_cast<std::uint16_t>(random() % 5 == 0 ? 32767 : random() % 32767);
        std::vector<float> distance(lanes, infinite);
        std::vector<std::uint8_t> base(lanes, 255);
        std::vector<std::uint8_t> bounds(lanes, 0);
        std::vector<Index> line(lanes, 0);
        std::vector<float> expected(columns, infinite);
        for (Index lane = 0; lane < seeds; ++lane) {
          line[lane] = seeds - 1 - lane;
          if (random() % 6 != 0) distance[lane] = static_cast<float>(random() % 4000);
          base[lane] = static_cast<std::uint8_t>(std::min(distance[lane] / bound_unit, 255.0F));
          std::uint16_t least = 32767;
          for (Index k = 0; k < columns; ++k) {
            const std::uint16_t entry = table[line[lane] * columns + k];
            least = std::min(least, entry);
            if (entry < 32767) {
              expected[k] = std::min(expected[k], distance[lane] + scale.distance(entry));
            }
          }
          bounds[lane] = static_cast<std::uint8_t>(
              least == 32767 ? 255 : static_cast<int>(scale.distance(least) / bound_unit));
        }
        for (float limit : {infinite, 3000.0F, 0.0F}) {
          std::vector<float> found(columns, infinite);
          relax_within({distance.data(), base.data(), line.data(), lanes}, bounds.data(), table.data(),
                       columns, scale, bound_unit, limit, columns, 0, columns, found.data());
          for (Index k = 0; k < columns; ++k) {
            // Products may be rounded once or twice.
            EXPECT_GE(found[k], expected[k] * (1.0F - 1e-6F));
            if (expected[k] < limit) {
              EXPECT_FLOAT_EQ(found[k], expected[k]);
            }
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace vorogeo
