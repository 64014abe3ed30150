// Lanes side by side: against a loop by the definition, for all lengths around the size of a block.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "index/scans.h"

namespace vorogeo {
namespace {

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

}  // namespace
}  // namespace vorogeo
