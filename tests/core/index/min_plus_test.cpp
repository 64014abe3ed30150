// Min-plus scans: against loops by their definitions, for all lengths around the size of their blocks.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "index/scans.h"

namespace vorogeo {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

/// Numbers of [0, 1), some of them infinite, at an address that is not aligned to a vector.
struct Numbers {
  Numbers(Index count, unsigned seed) : all(count + 1) {
    std::mt19937 random(seed);
    for (float& x : all) x = random() % 8 == 0 ? infinite : static_cast<float>(random() % 4096) / 4096.0F;
  }
  float* data() { return all.data() + 1; }
  float operator[](Index i) const { return all[i + 1]; }
  std::vector<float> all;
};

TEST(MinPlus, FirstLower) {
  for (Index count = 0; count < 100; ++count) {
    Numbers line(count, count);
    std::vector<double> distance(count);
    for (Index i = 0; i < count; ++i) distance[i] = 0.02 * (i % 17) * (i % 5);
    for (double base : {0.0, 0.25, 0.9, 5.0}) {
      for (Index begin = 0; begin <= count; begin += 1 + begin / 4) {
        Index first = begin;
        while (first < count && !(base + line[first] < distance[first])) ++first;
        EXPECT_EQ(first_lower(line.data(), base, distance.data(), begin, count), first)
            << count << ", " << begin;
      }
    }
  }
}

/// Entries of a table with some that stand for infinity, and bases with some that stand for none.
struct Entries {
  Entries(Index rows, Index columns, unsigned seed)
      : table(static_cast<std::size_t>(rows) * columns + 1), base(rows) {
    std::mt19937 random(seed);
    for (auto& entry : table) entry = random() % 16 == 0 ? 32767 : random() % 32767;
    for (auto& value : base)
      value = static_cast<std::int16_t>(random() % 8 == 0 ? 0 : -32768 + static_cast<int>(random() % 3000));
  }
  const std::uint16_t* data() const { return table.data() + 1; }
  std::vector<std::uint16_t> table;
  std::vector<std::int16_t> base;
};

TEST(MinPlus, EntriesAsDistances) {
  for (Index count = 0; count < 100; ++count) {
    const Entries entries(1, count, count);
    std::vector<float> scaled(count);
    scale_entries(entries.data(), count, {0.75F}, scaled.data());
    std::vector<float> least(count, 1e4F);
    std::vector<Index> best(count, no_index);
    relax_by_line(entries.data(), {0.75F}, 2.0F, 5, count, least.data(), best.data());
    for (Index i = 0; i < count; ++i) {
      const std::uint16_t entry = entries.data()[i];
      const float expected = entry == 32767 ? infinite : 0.75F * static_cast<float>(entry);
      EXPECT_EQ(scaled[i], expected);
      EXPECT_EQ(least[i], std::min(1e4F, 2.0F + expected));
      EXPECT_EQ(best[i], 2.0F + expected < 1e4F ? 5 : no_index);
    }
  }
}

TEST(MinPlus, LeastEntrySumAndWhereItIs) {
  for (Index count = 0; count < 200; ++count) {
    const Entries entries(count, 1, count);
    int least = 32767;
    Index first = no_index;
    for (Index i = 0; i < count; ++i) {
      const int sum = entries.base[i] + entries.data()[i];
      if (sum >= least) continue;
      least = sum;
      first = i;
    }
    const std::int16_t found = least_entry_sum(entries.base.data(), entries.data(), count);
    EXPECT_EQ(found, least) << count;
    EXPECT_EQ(first_entry_sum(entries.base.data(), entries.data(), count, found), first) << count;
  }
  const Entries none(70, 1, 3);
  EXPECT_EQ(first_entry_sum(none.base.data(), none.data(), 70, 32767), no_index);
}

TEST(MinPlus, LeastTileSums) {
  for (Index rows = 0; rows < 70; ++rows) {
    const Entries entries(rows, 32, 50 + rows);
    std::int16_t least[32];
    std::int16_t best[32];
    least_tile_sums(entries.base.data(), entries.data(), rows, least, best);
    for (Index column = 0; column < 32; ++column) {
      int expected = 32767;
      int expected_row = 0;
      for (Index row = 0; row < rows; ++row) {
        const int sum = entries.base[row] + entries.data()[32 * row + column];
        if (sum >= expected) continue;
        expected = sum;
        expected_row = row;
      }
      EXPECT_EQ(least[column], expected);
      EXPECT_EQ(best[column], expected_row);
    }
  }
}

TEST(MinPlus, TileSumsOfSomeRows) {
  for (Index rows = 0; rows < 70; ++rows) {
    const Entries entries(rows, 32, 90 + rows);
    std::vector<Index> some;
    std::vector<std::int16_t> base;
    for (Index row = rows - 1; row >= 0; row -= 1 + row % 3) {
      some.push_back(row);
      base.push_back(entries.base[row]);
    }
    std::int16_t least[32];
    std::int16_t best[32];
    least_tile_sums_of(base.data(), some.data(), static_cast<Index>(some.size()), entries.data(), least,
                       best);
    for (Index column = 0; column < 32; ++column) {
      int expected = 32767;
      int expected_place = 0;
      for (std::size_t i = 0; i < some.size(); ++i) {
        const int sum = base[i] + entries.data()[32 * some[i] + column];
        if (sum >= expected) continue;
        expected = sum;
        expected_place = static_cast<int>(i);
      }
      EXPECT_EQ(least[column], expected);
      EXPECT_EQ(best[column], expected_place);
    }
  }
}

TEST(MinPlus, CellsOfTheNodeTable) {
  std::mt19937 random(7);
  for (Index rows : {1, 3, 8}) {
    for (Index columns : {1, 5, 8}) {
      for (int round = 0; round < 40; ++round) {
        std::vector<std::uint16_t> cell(static_cast<std::size_t>(rows) * columns);
        for (auto& entry : cell) entry = random() % 8 == 0 ? 65535 : random() % 65535;
        std::vector<float> from(rows);
        std::vector<float> to(columns);
        for (float& x : from) x = random() % 8 == 0 ? infinite : static_cast<float>(random() % 4096);
        for (float& x : to) x = random() % 8 == 0 ? infinite : static_cast<float>(random() % 4096);
        // Products and sums that need no rounding, but for fourth powers.
        const TableScale scale = round % 2 == 0 ? TableScale{0.25F} : TableScale{-0x1p-13F};
        std::vector<float> least(columns, 3000.0F);
        std::vector<Index> best(columns, -7);
        const float worst = relax_by_cell(cell.data(), rows, columns, from.data(), 16.0F, scale, 40,
                                          least.data(), best.data());
        float expected = infinite;
        float greatest = 0.0F;
        for (Index column = 0; column < columns; ++column) {
          float lowest = 3000.0F;
          Index name = -7;
          for (Index row = 0; row < rows; ++row) {
            const std::uint16_t entry = cell[row * columns + column];
            if (entry == 65535) continue;
            const float through = from[row] + scale.distance(entry);
            expected = std::min(expected, through + to[column]);
            if (through + 16.0F >= lowest) continue;
            lowest = through + 16.0F;
            name = 40 + row;
          }
          EXPECT_FLOAT_EQ(least[column], lowest);
          EXPECT_EQ(best[column], name);
          greatest = std::max(greatest, lowest);
        }
        EXPECT_FLOAT_EQ(worst, greatest);
        EXPECT_FLOAT_EQ(least_in_cell(cell.data(), rows, columns, from.data(), to.data(), scale), expected);
      }
    }
  }
}

}  // namespace
}  // namespace vorogeo
