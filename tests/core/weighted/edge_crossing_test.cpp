// Crossings of a piece of an edge against sources in a plane, and against the least of all ways.
#include "weighted/edge_crossing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/layers.h"

namespace vorogeo {
namespace {

constexpr double source_x = 0.7;
constexpr double source_y = 0.4;
constexpr double target_x = 0.1;
constexpr double target_y = 0.5;

/// Through the piece from 0 to `length` on the x axis before which a unit costs 1, and beyond `cost`.
EdgeCrossing crossing(double length, double cost) {
  const PlacedSource source(
      {cost * length, length, std::hypot(source_x, source_y), std::hypot(source_x - length, source_y)});
  EXPECT_TRUE(source.exists());
  const EdgeCrossing found = source.cross(cost * target_x, cost * target_y);
  EXPECT_GE(found.distance, source.least() + cost * target_y);
  return found;
}

TEST(EdgeCrossing, OneCostIsThePlane) {
  const EdgeCrossing found = crossing(1.0, 1.0);
  EXPECT_NEAR(found.distance, std::hypot(target_x - source_x, target_y + source_y), 1e-15);
  EXPECT_NEAR(found.share, source_x + (target_x - source_x) * source_y / (source_y + target_y), 1e-15);
}

TEST(EdgeCrossing, DearerFacesRefract) {
  for (const double cost : {1.5, 5.0, 1e3, 1e6}) {
    const EdgeCrossing found = crossing(1.0, cost);
    const auto length = [&](double x) {
      return std::hypot(x - source_x, source_y) + cost * std::hypot(x - target_x, target_y);
    };
    EXPECT_NEAR(found.distance, test::least_of(length, 0.0, 1.0), 1e-14 * found.distance);
    // Snell's law.
    EXPECT_NEAR((source_x - found.share) / std::hypot(source_x - found.share, source_y),
                cost * (found.share - target_x) / std::hypot(found.share - target_x, target_y), 1e-6);
    // Along the edge, distances do not fall below what running along it would cost.
    const PlacedSource wide({cost, 1.0, 2.0, 2.0});
    EXPECT_GE(wide.cross(0.5 * cost, 0.1 * cost).distance, 1.5);
  }
}

TEST(EdgeCrossing, WaysAroundThePieceAreNone) {
  EXPECT_EQ(crossing(0.3, 1.0).distance, unreachable);
  EXPECT_EQ(crossing(0.05, 3.0).distance, unreachable);
  EXPECT_FALSE(PlacedSource({1, 1, unreachable, 1}).exists());
  EXPECT_FALSE(PlacedSource({0, 0, 1, 1}).exists());
  EXPECT_FALSE(PlacedSource({2, 1, 1, 2.5}).exists());
}

}  // namespace
}  // namespace vorogeo
