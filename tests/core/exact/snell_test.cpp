// Refraction against Snell's law and a one-dimensional search.
#include <gtest/gtest.h>

#include <cmath>

#include "exact/refraction.h"

namespace vorogeo {
namespace {

/// Layers y = 0, 1, 2, ... of different costs between two points, crossed on lines x in [-10, 10].
std::vector<PathPiece> layers(const std::vector<double>& cost, double shift) {
  std::vector<PathPiece> pieces;
  for (std::size_t i = 0; i < cost.size(); ++i) {
    PathPiece piece;
    const bool first = i == 0;
    const bool last = i + 1 == cost.size();
    piece.begin_at = first ? PathPiece::Vector{0.0, 0.0} : PathPiece::Vector{-10.0 * cost[i], 0.0};
    if (!first) piece.begin_along = {20.0 * cost[i], 0.0};
    piece.end_at =
        last ? PathPiece::Vector{shift * cost[i], cost[i]} : PathPiece::Vector{-10.0 * cost[i], cost[i]};
    if (!last) piece.end_along = {20.0 * cost[i], 0.0};
    pieces.push_back(piece);
  }
  return pieces;
}

TEST(Snell, LayersKeepTheProductOfCostAndSine) {
  const std::vector<double> cost{1.0, 2.5, 1.2, 4.0, 1.0};
  const auto pieces = layers(cost, 6.0);
  std::vector<double> crossing{0.1, 0.9, 0.5, 0.6};
  const double length = refract(pieces, crossing);
  double sum = 0.0;
  double invariant = 0.0;
  for (std::size_t i = 0; i < cost.size(); ++i) {
    const double from = i == 0 ? 0.0 : -10.0 + 20.0 * crossing[i - 1];
    const double to = i + 1 == cost.size() ? 6.0 : -10.0 + 20.0 * crossing[i];
    sum += cost[i] * std::hypot(to - from, 1.0);
    const double sine = cost[i] * (to - from) / std::hypot(to - from, 1.0);
    if (i == 0) invariant = sine;
    EXPECT_NEAR(sine, invariant, 1e-7);
  }
  EXPECT_NEAR(sum, length, 1e-12 * length);
}

TEST(Snell, CrossingsStayOnTheirEdges) {
  const auto pieces = layers({1.0, 1.0}, 30.0);
  std::vector<double> crossing{0.3};
  EXPECT_NEAR(refract(pieces, crossing), std::hypot(10.0, 1.0) + std::hypot(20.0, 1.0), 1e-12);
  EXPECT_EQ(crossing[0], 1.0);
}

}  // namespace
}  // namespace vorogeo
