// The kernels chosen at run time for this machine against the same kernels without vector instructions.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "index/scans.h"

namespace vorogeo_scalar {
using Index = vorogeo::Index;
struct Crossings;
struct TableScale {
  float signed_unit;
};
Index first_lower(const float*, double, const double*, Index, Index);
void scale_entries(const std::uint16_t*, Index, TableScale, float*);
void relax_by_sums(const float*, float, Index, float*);
void relax_by_line(const std::uint16_t*, TableScale, float, Index, Index, float*, Index*);
void relax_lanes(const std::uint16_t*, TableScale, Index, const float*, Index, float*, Index*);
std::int16_t least_entry_sum(const std::int16_t*, const std::uint16_t*, Index);
Index first_entry_sum(const std::int16_t*, const std::uint16_t*, Index, std::int16_t);
void least_tile_sums(const std::int16_t*, const std::uint16_t*, Index, std::int16_t*, std::int16_t*);
float relax_by_cell(const std::uint16_t*, Index, Index, const float*, float, TableScale, Index, float*,
                    Index*);
float least_in_cell(const std::uint16_t*, Index, Index, const float*, const float*, TableScale);
void crossing_gains(const Crossings&, float, float*);
void least_byte_sums(const std::uint8_t*, Index, Index, const std::uint8_t*, Index, std::uint8_t*);
void byte_sums_within(const std::uint8_t*, const std::uint8_t*, Index, std::uint8_t, std::uint8_t*);
void least_short_sums(const std::int16_t*, const std::int16_t*, const std::int16_t*, Index, Index,
                      std::int16_t*, std::int16_t*);
void short_sums_within(const std::int16_t*, const std::int16_t*, Index, std::int16_t, std::uint8_t*);
}  // namespace vorogeo_scalar

namespace vorogeo {
namespace {

/// Sums with a product may be rounded once or twice: a few units in the last place of the terms.
constexpr float rounding = 4e-7F;

struct Input {
  explicit Input(unsigned seed) : random(seed) {}
  std::vector<std::uint16_t> entries(Index count, std::uint16_t none) {
    std::vector<std::uint16_t> result(count);
    for (auto& entry : result) {
      entry = random() % 16 == 0 ? none : static_cast<std::uint16_t>(random() % 32767);
    }
    return result;
  }
  std::vector<float> floats(Index count, float low, float high) {
    std::vector<float> result(count);
    for (float& x : result) x = std::uniform_real_distribution<float>(low, high)(random);
    return result;
  }
  std::vector<std::int16_t> bases(Index count) {
    std::vector<std::int16_t> result(count);
    for (auto& base : result) base = static_cast<std::int16_t>(-32768 + static_cast<int>(random() % 32768));
    return result;
  }
  std::mt19937 random;
};

TEST(InstructionSets, IntegerScansAgreeToTheLastBit) {
  for (Index count = 0; count < 300; count += 1 + count / 9) {
    Input input(count);
    const auto entries = input.entries(count, 32767);
    const auto bases = input.bases(count);
    const std::int16_t least = least_entry_sum(bases.data(), entries.data(), count);
    ASSERT_EQ(least, vorogeo_scalar::least_entry_sum(bases.data(), entries.data(), count)) << count;
    ASSERT_EQ(first_entry_sum(bases.data(), entries.data(), count, least),
              vorogeo_scalar::first_entry_sum(bases.data(), entries.data(), count, least));
    const auto tile = input.entries(32 * count, 32767);
    std::vector<std::int16_t> vector_least(32), vector_best(32), scalar_least(32), scalar_best(32);
    least_tile_sums(bases.data(), tile.data(), count, vector_least.data(), vector_best.data());
    vorogeo_scalar::least_tile_sums(bases.data(), tile.data(), count, scalar_least.data(),
                                    scalar_best.data());
    ASSERT_EQ(vector_least, scalar_least) << count;
    ASSERT_EQ(vector_best, scalar_best) << count;
    const auto line = input.floats(count, 0.0F, 1.0F);
    std::vector<double> distance(count);
    for (double& d : distance) d = 0.5 + 0.001 * static_cast<double>(input.random() % 1000);
    ASSERT_EQ(first_lower(line.data(), 0.499, distance.data(), 0, count),
              vorogeo_scalar::first_lower(line.data(), 0.499, distance.data(), 0, count));
  }
}

class ScalesOfScans : public testing::TestWithParam<TableScale> {};

TEST_P(ScalesOfScans, ProductsAgreeWithinRounding) {
  const TableScale scale = GetParam();
  const vorogeo_scalar::TableScale scalar{scale.signed_unit};
  for (Index count = 1; count < 300; count += 1 + count / 9) {
    Input input(1000 + count);
    const auto entries = input.entries(count, 32767);
    std::vector<float> one = input.floats(count, 0.2F, 1.0F);
    const std::vector<float> line = input.floats(count, 0.2F, 1.0F);
    std::vector<float> two = one;
    relax_by_sums(line.data(), 0.1F, count, one.data());
    vorogeo_scalar::relax_by_sums(line.data(), 0.1F, count, two.data());
    ASSERT_EQ(one, two);
    std::vector<Index> vector_best(count, no_index), scalar_best(count, no_index);
    relax_by_line(entries.data(), scale, 0.2F, 5, count, one.data(), vector_best.data());
    vorogeo_scalar::relax_by_line(entries.data(), scalar, 0.2F, 5, count, two.data(), scalar_best.data());
    for (Index i = 0; i < count; ++i) {
      ASSERT_NEAR(one[i], two[i], rounding);
      // Where the two choose different ones, it is a tie.
      if (vector_best[i] != scalar_best[i]) {
        ASSERT_NEAR(one[i], 0.2F + scale.distance(entries[i]), rounding);
      }
    }
    const std::vector<float> bases = input.floats(count * lane_count, 0.2F, 1.0F);
    std::vector<float> lanes(lane_count, 2.0F), scalar_lanes(lane_count, 2.0F);
    std::vector<Index> best(lane_count, no_index), best_of_scalar(lane_count, no_index);
    relax_lanes(entries.data(), scale, count, bases.data(), 0, lanes.data(), best.data());
    vorogeo_scalar::relax_lanes(entries.data(), scalar, count, bases.data(), 0, scalar_lanes.data(),
                                best_of_scalar.data());
    for (Index lane = 0; lane < lane_count; ++lane) ASSERT_NEAR(lanes[lane], scalar_lanes[lane], rounding);
    scale_entries(entries.data(), count, scale, one.data());
    vorogeo_scalar::scale_entries(entries.data(), count, scalar, two.data());
    ASSERT_EQ(one, two);
  }
  for (Index rows = 1; rows <= 8; ++rows) {
    for (Index columns = 1; columns <= 8; ++columns) {
      Input input(10 * rows + columns);
      const auto cell = input.entries(rows * columns, 65535);
      const auto from = input.floats(rows, 0.0F, 1.0F);
      const auto to = input.floats(columns, 0.0F, 1.0F);
      const float one = least_in_cell(cell.data(), rows, columns, from.data(), to.data(), scale);
      const float two =
          vorogeo_scalar::least_in_cell(cell.data(), rows, columns, from.data(), to.data(), scalar);
      if (std::isinf(one) || std::isinf(two)) {
        ASSERT_EQ(one, two);
      } else {
        ASSERT_NEAR(one, two, rounding);
      }
      std::vector<float> vector_least(columns, 1.2F), scalar_least(columns, 1.2F);
      std::vector<Index> vector_best(columns, no_index), scalar_best(columns, no_index);
      relax_by_cell(cell.data(), rows, columns, from.data(), 0.1F, scale, 7, vector_least.data(),
                    vector_best.data());
      vorogeo_scalar::relax_by_cell(cell.data(), rows, columns, from.data(), 0.1F, scalar, 7,
                                    scalar_least.data(), scalar_best.data());
      for (Index i = 0; i < columns; ++i) ASSERT_NEAR(vector_least[i], scalar_least[i], rounding);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, ScalesOfScans,
                         testing::Values(TableScale{1.7e-5F}, TableScale{-2.3e-5F}));

TEST(InstructionSets, CrossingGainsAgreeWithinRounding) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    Input input(seed);
    Crossings crossings{};
    std::uniform_real_distribution<float> unit(0.0F, 1.0F);
    for (Index k = 0; k < Crossings::capacity; ++k) {
      crossings.source[k] = unit(input.random);
      crossings.target[k] = 0.3F + unit(input.random);
      for (auto& side : crossings.side) {
        side.length[k] = 0.05F + 0.2F * unit(input.random);
        side.source[k] = crossings.source[k] + side.length[k] * (2.0F * unit(input.random) - 1.0F);
        side.target[k] = crossings.target[k] + side.length[k] * (2.0F * unit(input.random) - 1.0F);
      }
    }
    std::vector<float> one(Crossings::capacity), two(Crossings::capacity);
    crossing_gains(crossings, 5.0F, one.data());
    vorogeo_scalar::crossing_gains(reinterpret_cast<const vorogeo_scalar::Crossings&>(crossings), 5.0F,
                                   two.data());
    // A crossing at the end of its edge may be accepted by one and not by the other; the gain there is that
    // of a path along the edge.
    int different = 0;
    for (Index k = 0; k < Crossings::capacity; ++k) different += std::abs(one[k] - two[k]) > 1e-4F ? 1 : 0;
    EXPECT_LE(different, 1) << "seed " << seed;
  }
}

TEST(InstructionSets, BoundScansAgreeToTheLastBit) {
  for (Index lanes : {32, 64, 128}) {
    for (Index rows : {1, 5, 60}) {
      Input input(lanes + rows);
      const auto bytes = [&](Index count) {
        std::vector<std::uint8_t> result(count);
        for (auto& byte : result) byte = static_cast<std::uint8_t>(input.random() % 256);
        return result;
      };
      const auto shorts = [&](Index count, unsigned most) {
        std::vector<std::int16_t> result(count);
        for (auto& value : result) value = static_cast<std::int16_t>(input.random() % most);
        return result;
      };
      const auto bounds = bytes(lanes * rows);
      const auto base = bytes(lanes);
      std::vector<std::uint8_t> least(rows), other_least(rows), within(lanes), other_within(lanes);
      least_byte_sums(bounds.data(), rows, lanes, base.data(), lanes, least.data());
      vorogeo_scalar::least_byte_sums(bounds.data(), rows, lanes, base.data(), lanes, other_least.data());
      EXPECT_EQ(least, other_least);
      byte_sums_within(bounds.data(), base.data(), lanes, 200, within.data());
      vorogeo_scalar::byte_sums_within(bounds.data(), base.data(), lanes, 200, other_within.data());
      EXPECT_EQ(within, other_within);

      const auto near = shorts(rows, 8192);
      const auto far = shorts(lanes, 8192);
      const auto between = shorts(lanes * rows, 16384);
      std::vector<std::int16_t> of_row(rows), other_of_row(rows), of_column(lanes), other_of_column(lanes);
      least_short_sums(near.data(), between.data(), far.data(), rows, lanes, of_row.data(), of_column.data());
      vorogeo_scalar::least_short_sums(near.data(), between.data(), far.data(), rows, lanes,
                                       other_of_row.data(), other_of_column.data());
      EXPECT_EQ(of_row, other_of_row);
      EXPECT_EQ(of_column, other_of_column);
      short_sums_within(between.data(), far.data(), lanes, 9000, within.data());
      vorogeo_scalar::short_sums_within(between.data(), far.data(), lanes, 9000, other_within.data());
      EXPECT_EQ(within, other_within);
    }
  }
}

}  // namespace
}  // namespace vorogeo
