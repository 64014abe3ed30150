// Ranks among positive numbers, against sorting.
#include "support/positive_rank.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace vorogeo {
namespace {

TEST(PositiveRank, EveryRankIsThatOfTheSortedNumbers) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-300.0, 300.0);
  std::vector<double> values{0.0, -1.0, -0.0, 1.5, 1.5, 1.5, 5e-324, 1.7e308};
  for (int i = 0; i < 60; ++i) values.push_back(std::pow(10.0, exponent(random)));
  std::vector<double> sorted;
  for (double value : values) {
    if (value > 0.0) sorted.push_back(value);
  }
  std::ranges::sort(sorted);
  for (std::size_t rank = 0; rank < sorted.size(); ++rank) {
    EXPECT_EQ(positive_of_rank(values, rank), sorted[rank]);
  }
}

}  // namespace
}  // namespace vorogeo
