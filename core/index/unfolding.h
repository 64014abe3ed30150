// Crossing a border between its vertices: edge unfolding, and the parabola through three border vertices.
#pragma once

#include <cmath>

#include "support/types.h"

namespace vorogeo {

/// Distance across an edge of the given length from a source at distances (source_a, source_b) of its ends to
/// a target at (target_a, target_b): both unfolded into the plane on either side of the edge. `unreachable`
/// if the straight line misses the edge or the distances belong to no common wave.
inline double unfolded_distance(double length, double source_a, double source_b, double target_a,
                                double target_b) {
  const double source_difference = source_a - source_b;
  const double target_difference = target_a - target_b;
  if (!(std::abs(source_difference) <= length && std::abs(target_difference) <= length)) return unreachable;
  const double source_x = 0.5 * (length + source_difference * (source_a + source_b) / length);
  const double target_x = 0.5 * (length + target_difference * (target_a + target_b) / length);
  const double source_y = std::sqrt(std::fmax(0.0, (source_a - source_x) * (source_a + source_x)));
  const double target_y = std::sqrt(std::fmax(0.0, (target_a - target_x) * (target_a + target_x)));
  const double height = source_y + target_y;
  if (!(height > 0.0)) return unreachable;
  const double shift = target_x - source_x;
  const double crossing = source_x + shift * (source_y / height);
  if (!(crossing > 0.0 && crossing < length)) return unreachable;
  return std::sqrt(shift * shift + height * height);
}

/// A border vertex near a crossing: distances of source and target from it, and the length of the border edge
/// that leads to it from the middle one.
struct BorderSample {
  double source;
  double target;
  double length;
};

/// Distance across a border from three consecutive border vertices, of which the middle one (`source`,
/// `target`) has the least sum. Measured across the path, the sum grows with the square of the offset from
/// the true crossing, by the curvature of both waves; the three sums give that parabola and so its lowest
/// value. Unlike unfolding it does not take the waves for circles around source and target, which bends at
/// saddle vertices make too flat. `unreachable` if the lowest point is not between the outer vertices or the
/// sums do not bend upwards.
inline double parabola_distance(double source, double target, const BorderSample& before,
                                const BorderSample& after) {
  constexpr double least_edges = 3.0;
  if (std::fmin(source, target) < least_edges * std::fmax(before.length, after.length)) return unreachable;
  const double sum = source + target;
  auto offset = [&](const BorderSample& sample) {
    // Cosine of the angle between path and border edge, as the mean of what both sides say.
    const double cosine = 0.5 * ((sample.source - source) - (sample.target - target)) / sample.length;
    return sample.length * std::sqrt(std::fmax(0.0, 1.0 - cosine * cosine));
  };
  const double left = -offset(before);
  const double right = offset(after);
  if (!(left < 0.0 && right > 0.0)) return unreachable;
  const double to_left = (before.source + before.target - sum) / left;
  const double to_right = (after.source + after.target - sum) / right;
  const double curvature = (to_right - to_left) / (right - left);
  const double slope = to_right - curvature * right;
  if (!(curvature > 0.0)) return unreachable;
  const double lowest = -0.5 * slope / curvature;
  if (!(lowest > left && lowest < right)) return unreachable;
  return sum + 0.5 * slope * lowest;
}

}  // namespace vorogeo
