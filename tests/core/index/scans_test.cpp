// Scans, the kernels of the index: against loops by their definitions; batches of crossings against single
// ones. scalar_scans_test.cpp asks the same of the kernels without vector instructions.
#include "index/scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace vorogeo {
namespace {

// Min-plus scans: against loops by their definitions, for all lengths around the size of their blocks.

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

TEST(MinPlus, SumsWithALine) {
  for (Index count = 0; count < 100; ++count) {
    Numbers line(count, count);
    Numbers least(count, 1000 + count);
    const Numbers before = least;
    relax_by_sums(line.data(), 0.25F, count, least.data());
    for (Index i = 0; i < count; ++i) EXPECT_EQ(least[i], std::min(before[i], 0.25F + line[i])) << count;
  }
}

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

/// Entries of a table, some of which stand for infinity, and bases, some of which are missing.
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
        // Products and sums are exact in single precision, except for fourth powers.
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

// Scans over lower bounds against plain loops.

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

// Lanes side by side: against a loop by the definition, for all lengths around the size of a block.

TEST(LaneSums, LeastSumsAndWhereTheyComeFrom) {
  for (const TableScale scale : {TableScale{0.75F}, TableScale{-0.01F}}) {
    for (Index count = 0; count < 40; ++count) {
      std::mt19937 random(7 + count);
      std::vector<std::uint16_t> entries(count);
      for (auto& entry : entries) entry = random() % 16 == 0 ? 32767 : random() % 32767;
      std::vector<float> base(static_cast<std::size_t>(count) * lane_count);
      for (float& x : base) x = random() % 8 == 0 ? unreachable_float : static_cast<float>(random() % 4096);
      std::vector<float> least(lane_count, 9000.0F);
      least[3] = 0.0F;
      std::vector<Index> best(lane_count, no_index);
      std::vector<float> expected = least;
      std::vector<Index> expected_best = best;
      for (Index i = 0; i < count; ++i) {
        const std::uint16_t entry = entries[i];
        for (Index lane = 0; lane < lane_count; ++lane) {
          const float sum = base[i * lane_count + lane] + scale.distance(entry);
          if (entry == 32767 || !(sum < expected[lane])) continue;
          expected[lane] = sum;
          expected_best[lane] = 100 + i;
        }
      }
      relax_lanes(entries.data(), scale, count, base.data(), 100, least.data(), best.data());
      for (Index lane = 0; lane < lane_count; ++lane) {
        EXPECT_FLOAT_EQ(least[lane], expected[lane]);
        EXPECT_EQ(best[lane], expected_best[lane]);
      }
    }
  }
}

// Many crossings at once: against the formulas for one.

struct Point2 {
  double x, y;
};
double between(Point2 a, Point2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// A border of three vertices, a source below it and a target above it; the middle one is the crossing.
struct Scene {
  Scene(std::mt19937& random, double far) {
    auto uniform = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    border = {{{uniform(-1.2, -0.5), uniform(-0.2, 0.2)}, {0, 0}, {uniform(0.5, 1.2), uniform(-0.2, 0.2)}}};
    source = {uniform(-far, far), -uniform(0.1, far)};
    target = {uniform(-6, 6), uniform(0.05, 9)};
    for (int i : {0, 1, 2}) {
      from[i] = between(source, border[i]);
      to[i] = between(target, border[i]);
    }
    lengths = {between(border[0], border[1]), between(border[2], border[1])};
  }
  std::array<Point2, 3> border;
  Point2 source, target;
  std::array<double, 3> from, to;
  std::array<double, 2> lengths;
};

TEST(CrossingGains, AsUnfoldingAndParabola) {
  std::mt19937 random(4);
  for (double far : {2.0, 20.0, 500.0, 1e7}) {
    for (int round = 0; round < 50; ++round) {
      Crossings crossings{};
      std::array<double, Crossings::capacity> expected{};
      double lowest = 1e300;
      std::vector<Scene> scenes;
      for (Index k = 0; k < Crossings::capacity; ++k) {
        scenes.emplace_back(random, far);
        // The sources of one batch are at about the same distance.
        if (k > 0 && std::abs(scenes[k].from[1] - scenes[0].from[1]) > 30.0) scenes[k] = scenes[0];
        for (double distance : scenes[k].from) lowest = std::min(lowest, distance);
      }
      for (Index k = 0; k < Crossings::capacity; ++k) {
        const Scene& scene = scenes[k];
        crossings.source[k] = static_cast<float>(scene.from[1] - lowest);
        crossings.target[k] = static_cast<float>(scene.to[1]);
        Crossing<double> known{scene.from[1], scene.to[1]};
        for (int s : {0, 1}) {
          // Every fifth crossing lacks a neighbour.
          const bool used = k % 5 != 0 || s == k % 2;
          crossings.side[s].source[k] = static_cast<float>(scene.from[2 * s] - lowest);
          crossings.side[s].target[k] = static_cast<float>(scene.to[2 * s]);
          crossings.side[s].length[k] = used ? static_cast<float>(scene.lengths[s]) : 0.0F;
          if (used) known.add({scene.from[2 * s], scene.to[2 * s], scene.lengths[s]});
        }
        expected[k] = scene.from[1] + scene.to[1] - crossing_distance(known);
      }
      float gain[Crossings::capacity];
      crossing_gains(crossings, static_cast<float>(lowest), gain);
      for (Index k = 0; k < Crossings::capacity; ++k) {
        EXPECT_NEAR(gain[k], expected[k], 2e-4 * (1.0 + scenes[k].to[1])) << far << ", " << k;
        EXPECT_GE(gain[k], 0.0F);
      }
    }
  }
}

TEST(CrossingGains, NothingWhereThePathWouldPassOnBothSides) {
  // The wave runs along the border, from the neighbour before to the vertex; the distance of the neighbour
  // behind is of another path.
  Crossings crossings{};
  for (Index k = 0; k < Crossings::capacity; ++k) {
    crossings.source[k] = 0.5F;
    crossings.target[k] = 0.25F;
    crossings.side[0].source[k] = 0.3F;
    crossings.side[0].target[k] = 0.45F;
    crossings.side[0].length[k] = 0.2F;
    crossings.side[1].source[k] = 0.0F;
    crossings.side[1].target[k] = 0.77F;
    crossings.side[1].length[k] = 1.0F;
  }
  float gain[Crossings::capacity];
  crossing_gains(crossings, 6.7F, gain);
  for (float value : gain) EXPECT_EQ(value, 0.0F);
  for (Index k = 0; k < Crossings::capacity; ++k) crossings.side[0].length[k] = 0.0F;
  crossing_gains(crossings, 6.7F, gain);
  for (float value : gain) EXPECT_GT(value, 0.1F);
}

TEST(CrossingGains, NothingWithoutNeighboursOrWithoutDistances) {
  Crossings crossings{};
  float gain[Crossings::capacity];
  crossing_gains(crossings, 0.0F, gain);
  for (float value : gain) EXPECT_EQ(value, 0.0F);
  for (Index k = 0; k < Crossings::capacity; ++k) {
    crossings.source[k] = 1.0F;
    crossings.target[k] = 1.0F;
  }
  crossing_gains(crossings, 5.0F, gain);
  for (float value : gain) EXPECT_EQ(value, 0.0F);
}

}  // namespace
}  // namespace vorogeo
