// Statistics of the difference of two fields, counted by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tasks/extent.h"

namespace vorogeo {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(FieldDifference, StatisticsOfFourVertices) {
  const FieldDifference found = difference_of({0.0, 1.1, 1.8, 4.0, 5.0}, {0.0, 1.0, 2.0, 4.0, 5.0});
  ASSERT_EQ(found.relative.size(), 5U);
  EXPECT_TRUE(std::isnan(found.relative[0])) << "a source has no relative error";
  EXPECT_NEAR(found.relative[1], 0.1, 1e-15);
  EXPECT_NEAR(found.relative[2], -0.1, 1e-15);
  EXPECT_EQ(found.compared, 4);
  EXPECT_EQ(found.one_only, 0);
  EXPECT_NEAR(found.bias, 0.0, 1e-15);
  EXPECT_NEAR(found.mean, 0.05, 1e-15);
  EXPECT_NEAR(found.rms, std::sqrt(0.005), 1e-15);
  EXPECT_NEAR(found.p99, 0.1, 1e-15);
  EXPECT_NEAR(found.max, 0.1, 1e-15);
}

TEST(FieldDifference, ThePercentileLeavesOutOneInAHundred) {
  std::vector<double> values(200, 1.0);
  values[7] = 1.5;
  values[50] = 1.25;
  values[120] = 0.875;
  const FieldDifference found = difference_of(values, std::vector<double>(200, 1.0));
  EXPECT_EQ(found.p99, 0.125);  // the 198th of 200 sorted errors
  EXPECT_EQ(found.max, 0.5);
}

TEST(FieldDifference, WhatOneFieldDoesNotReachIsCountedNotCompared) {
  const FieldDifference found =
      difference_of({infinite, infinite, 2.0, std::nan("")}, {infinite, 1.0, infinite, 3.0});
  EXPECT_EQ(found.one_only, 3);
  EXPECT_EQ(found.compared, 0);
  EXPECT_EQ(found.max, 0.0);
  for (const double value : found.relative) EXPECT_TRUE(std::isnan(value));
}

TEST(FieldDifference, EmptyFieldsDifferInNothing) {
  const FieldDifference found = difference_of({}, {});
  EXPECT_EQ(found.compared, 0);
  EXPECT_TRUE(found.relative.empty());
}

}  // namespace
}  // namespace vorogeo
