// Crossings of a piece of an edge against sources in a plane, and against the least of all ways.
#include <gtest/gtest.h>

#include <cmath>

#include "exact/refraction.h"
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
  EXPECT_FALSE(PlacedSource({2, 1, 0.3, 0.4, 5}).exists()) << "there are two waves";
}

TEST(EdgeCrossing, WavesOfSourcesFartherAway) {
  // Seen from the piece, distances are less by what the source is farther away.
  const double farther = 3.0;
  const PlacedSource source({1.0, 1.0, std::hypot(source_x, source_y + 5.0) - farther,
                             std::hypot(source_x - 1.0, source_y + 5.0) - farther, farther});
  ASSERT_TRUE(source.exists());
  EXPECT_NEAR(source.cross(target_x, target_y).distance,
              std::hypot(target_x - source_x, target_y + source_y + 5.0) - farther, 1e-14);
}

TEST(EdgeCrossing, WavesBecomeFlatterInDearerFaces) {
  // Around a source at height 1 over an edge beyond which a unit costs 5: the second derivative of the least
  // sum along a line parallel to the edge is that of a wave of this radius.
  constexpr double cost = 5.0;
  constexpr double depth = 0.3;
  const auto distance = [&](double x) {
    return test::least_of([&](double t) { return std::hypot(t, 1.0) + cost * std::hypot(x - t, depth); },
                          -1.0, x);
  };
  const double x = 0.8;
  const double step = 1e-3;
  const double second = (distance(x + step) - 2.0 * distance(x) + distance(x - step)) / (step * step);
  const double slope = (distance(x + step) - distance(x - step)) / (2.0 * step);
  const double cosine = slope / cost;  // of the ray behind the edge
  const double after = depth / std::sqrt(1.0 - cosine * cosine);
  const double before = distance(x) - cost * after;
  const double radius = refracted_radius(before, {cosine, cost}, true) + cost * after;
  EXPECT_NEAR(cost * cost * (1.0 - cosine * cosine) / radius, second, 1e-4 * second);
  EXPECT_NEAR(refracted_radius(refracted_radius(2.0, {cosine, cost}, true), {cosine, cost}, false), 2.0,
              1e-12);
  EXPECT_EQ(refracted_radius(2.0, {cosine, 1.0}, true), 2.0);
}

}  // namespace
}  // namespace vorogeo
