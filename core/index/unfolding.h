// Crossing a border between its vertices: edge unfolding, and the parabola through three border vertices.
#pragma once

#include <cmath>

#include "mesh/unfolded_distance.h"
#include "support/types.h"

namespace vorogeo {

/// A border vertex near a crossing: distances of source and target from it, and the length of the border edge
/// that leads to it from the middle one.
struct BorderSample {
  double source;
  double target;
  double length;
};

/// Least offset of an outer vertex across the path, in lengths of its edge, for a parabola.
inline constexpr double least_offset = 0.1;

/// Greatest gain of a parabola, for border edges of length 1 with source and target at harmonic distance 1:
/// three times that of circles, 1/8.
inline constexpr double greatest_gain = 0.375;

/// Distance across a border from three consecutive border vertices, of which the middle one (`source`,
/// `target`) has the least sum. Measured across the path, the sum grows with the square of the offset from
/// the true crossing, by the curvature of both waves; the three sums determine that parabola and so its least
/// value. Unlike unfolding, it does not assume the waves to be circles around source and target, which would
/// be too flat where paths bend at saddle vertices. `unreachable` if the lowest point is not between the
/// outer vertices, if the sums do not curve upwards, or if the path runs so close along the border that the
/// offsets are mostly rounding. The gain is limited to what waves three times as curved as circles around
/// source and target would give: a larger one comes from samples that belong to different waves.
inline double parabola_distance(double source, double target, const BorderSample& before,
                                const BorderSample& after) {
  constexpr double least_edges = 3.0;
  if (std::fmin(source, target) < least_edges * std::fmax(before.length, after.length)) return unreachable;
  const double sum = source + target;
  auto offset = [&](const BorderSample& sample) {
    // Cosine of the angle between path and border edge, as the mean of the values from both sides.
    const double cosine = 0.5 * ((sample.source - source) - (sample.target - target)) / sample.length;
    return sample.length * std::sqrt(std::fmax(0.0, 1.0 - cosine * cosine));
  };
  const double left = -offset(before);
  const double right = offset(after);
  if (!(-left >= least_offset * before.length && right >= least_offset * after.length)) return unreachable;
  const double to_left = (before.source + before.target - sum) / left;
  const double to_right = (after.source + after.target - sum) / right;
  const double curvature = (to_right - to_left) / (right - left);
  const double slope = to_right - curvature * right;
  if (!(curvature > 0.0)) return unreachable;
  const double lowest = -0.5 * slope / curvature;
  if (!(lowest > left && lowest < right)) return unreachable;
  const double longest = std::fmax(before.length, after.length);
  const double most = greatest_gain * longest * longest * (1.0 / source + 1.0 / target);
  return sum - std::fmin(-0.5 * slope * lowest, most);
}

}  // namespace vorogeo
