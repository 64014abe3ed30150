// A source placed before the piece, and the crossing by Snell's law: Newton's method within bounds.
#include "weighted/edge_crossing.h"

#include <algorithm>
#include <cmath>

namespace vorogeo {

namespace {

/// Relative: the cost of an edge is that of one of its faces up to rounding.
constexpr double same_cost = 1e-9;

/// Of the place in the piece; the length of the way is off by its square.
constexpr double crossing_rounding = 1e-8;
constexpr int most_newton_steps = 50;

/// A point beside a segment on the x axis that begins at 0.
struct Beside {
  double x = 0.0;
  double y = 0.0;  ///< at least 0
};

Beside beside(double length, double from_first, double from_second) {
  const double x = 0.5 * (length + (from_first - from_second) * (from_first + from_second) / length);
  return {x, std::sqrt(std::max(0.0, (from_first - x) * (from_first + x)))};
}

}  // namespace

EdgeCrossing cross_piece(const EdgePiece& piece, double to_first, double to_second, double below) {
  const auto& [length, cheapest, at_first, at_second] = piece;
  const bool placed = cheapest > 0.0 && at_first < unreachable && at_second < unreachable &&
                      std::abs(at_first - at_second) <= cheapest && std::abs(to_first - to_second) <= length;
  if (!placed) return {};
  const Beside target = beside(length, to_first, to_second);
  if (!(0.5 * (at_first + at_second - cheapest) + target.y < below)) return {};
  // In units of the piece, on both sides of it.
  const Beside source = beside(cheapest, at_first, at_second);
  const Beside before{source.x / cheapest, source.y / cheapest};
  const Beside after{target.x / length, target.y / length};
  const double height = before.y + after.y;
  if (!(height > 0.0)) return {};
  double at = before.x + (after.x - before.x) * (before.y / height);
  auto distance = [&](double share) {
    return cheapest * std::hypot(share - before.x, before.y) + length * std::hypot(share - after.x, after.y);
  };
  if (length <= cheapest * (1.0 + same_cost)) {
    return at > 0.0 && at < 1.0 ? EdgeCrossing{distance(at), at} : EdgeCrossing{};
  }
  auto slope = [&](double share, double& curvature) {
    const double first = std::max(std::hypot(share - before.x, before.y), 1e-300);
    const double second = std::max(std::hypot(share - after.x, after.y), 1e-300);
    curvature = cheapest * (before.y / first) * (before.y / first) / first +
                length * (after.y / second) * (after.y / second) / second;
    return cheapest * ((share - before.x) / first) + length * ((share - after.x) / second);
  };
  double low = 0.0;
  double high = 1.0;
  double curvature = 0.0;
  if (!(slope(low, curvature) < 0.0 && slope(high, curvature) > 0.0)) return {};
  at = std::clamp(at, low, high);
  for (int i = 0; i < most_newton_steps; ++i) {
    const double rise = slope(at, curvature);
    (rise > 0.0 ? high : low) = at;
    double next = at - rise / curvature;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const bool found = std::abs(next - at) <= crossing_rounding;
    at = next;
    if (found) break;
  }
  return {distance(at), at};
}

}  // namespace vorogeo
