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

/// The piece from 0 to `length` on the x axis before which a unit costs 1, and beyond `cost`.
EdgeCrossing crossing(double length, double cost, double below = unreachable) {
  const EdgePiece piece{cost * length, length, std::hypot(source_x, source_y),
                        std::hypot(source_x - length, source_y)};
  return cross_piece(piece, cost * std::hypot(target_x, target_y),
                     cost * std::hypot(target_x - length, target_y), below);
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
    const EdgePiece wide{cost, 1.0, 2.0, 2.0};
    EXPECT_GE(cross_piece(wide, 0.6 * cost, 0.6 * cost, unreachable).distance, 1.5);
  }
}

TEST(EdgeCrossing, WaysAroundThePieceAreNone) {
  EXPECT_EQ(crossing(0.3, 1.0).distance, unreachable);
  EXPECT_EQ(crossing(0.05, 3.0).distance, unreachable);
  const double distance = crossing(1.0, 3.0).distance;
  EXPECT_EQ(crossing(1.0, 3.0, 0.2 * distance).distance, unreachable);
  EXPECT_EQ(crossing(1.0, 3.0, 1.01 * distance).distance, distance);
  EXPECT_EQ(cross_piece({1, 1, unreachable, 1}, 1, 1, unreachable).distance, unreachable);
  EXPECT_EQ(cross_piece({0, 0, 1, 1}, 1, 1, unreachable).distance, unreachable);
  EXPECT_EQ(cross_piece({2, 1, 1, 2.5}, 1, 2, unreachable).distance, unreachable);
}

}  // namespace
}  // namespace vorogeo
