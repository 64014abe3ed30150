// Distances over an unfolded edge against points of the plane.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mesh/vectors.h"

namespace vorogeo {
namespace {

TEST(UnfoldedDistance, IsTheStraightLineBetweenPointsOnTwoSidesOfTheEdge) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> along(-2.0, 3.0);
  std::uniform_real_distribution<double> across(0.01, 2.0);
  const double length = 1.5;
  int crossed = 0;
  for (int i = 0; i < 2000; ++i) {
    const double sx = along(random);
    const double sy = across(random);
    const double tx = along(random);
    const double ty = -across(random);
    const double at = sx + (tx - sx) * sy / (sy - ty);
    if (std::abs(at) < 1e-6 || std::abs(at - length) < 1e-6) continue;  // either answer is right
    const double found = unfolded_distance(length, std::hypot(sx, sy), std::hypot(sx - length, sy),
                                           std::hypot(tx, ty), std::hypot(tx - length, ty));
    if (at > 0.0 && at < length) {
      ++crossed;
      EXPECT_NEAR(found, std::hypot(tx - sx, ty - sy), 1e-12);
    } else {
      EXPECT_EQ(found, unreachable) << "the line misses the edge at " << at;
    }
  }
  EXPECT_GT(crossed, 300);
}

TEST(UnfoldedDistance, DistancesOfNoCommonWaveAreRefused) {
  EXPECT_EQ(unfolded_distance(1.0, 0.2, 1.3, 0.7, 0.7), unreachable);  // the source's ends differ by 1.1
  EXPECT_EQ(unfolded_distance(1.0, 0.7, 0.7, 2.0, 0.9), unreachable);  // the target's too
}

TEST(UnfoldedDistance, SourceAndTargetBothOnTheLineOfTheEdgeHaveNoCrossing) {
  EXPECT_EQ(unfolded_distance(1.0, 0.25, 0.75, 0.5, 0.5), unreachable);
}

TEST(UnfoldedDistance, ASourceOnTheEdgeSeesTheTargetDirectly) {
  // From (0.25, 0) to (0.5, -1).
  EXPECT_NEAR(unfolded_distance(1.0, 0.25, 0.75, std::hypot(0.5, 1.0), std::hypot(0.5, 1.0)),
              std::hypot(0.25, 1.0), 1e-12);
}

}  // namespace
}  // namespace vorogeo
