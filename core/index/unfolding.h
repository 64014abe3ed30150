// Crossing a border between its vertices: edge unfolding, and the parabola through three border vertices.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "mesh/vectors.h"
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

/// Greatest curvature of the sum in a parabola, beyond that of circles around source and target, for border
/// edges of length 1.
inline constexpr double greatest_excess = 0.3;

/// The angle between the directions to source and target at a border vertex, on one side of them.
struct SideAngle {
  double cosine;
  double sine;
};

/// On the side of one neighbour: the angles of both directions with the border edge that leads to it.
inline SideAngle side_angle(double source, double target, const BorderSample& neighbour) {
  auto cosine = [&](double own, double other) {
    const double exact =
        0.5 * (neighbour.length / own + (own - other) / neighbour.length * ((own + other) / own));
    return std::clamp(exact, -1.0, 1.0);
  };
  const double to_source = cosine(source, neighbour.source);
  const double to_target = cosine(target, neighbour.target);
  const double source_sine = std::sqrt(1.0 - to_source * to_source);
  const double target_sine = std::sqrt(1.0 - to_target * to_target);
  return {to_source * to_target - source_sine * target_sine,
          source_sine * to_target + to_source * target_sine};
}

/// Whether both neighbours may have been reached by one wave: a path passes a vertex on one side only, so
/// where one side has less than pi, the other has more. Together they are at least 1.5 pi: curvature does not
/// make them less.
inline bool may_be_one_path(const SideAngle& before, const SideAngle& after) {
  const double sine = before.sine * after.cosine + before.cosine * after.sine;
  if (sine < 0.0) return before.cosine * after.cosine - before.sine * after.sine >= 0.0;
  return before.sine <= 0.0 || after.sine <= 0.0;
}

/// Distance across a border from three consecutive border vertices, of which the middle one (`source`,
/// `target`) has the least sum. Measured across the path, the sum grows with the square of the offset from
/// the true crossing, by the curvature of both waves; the three sums determine that parabola and so its least
/// value. Unlike unfolding, it does not assume the waves to be circles around source and target, which would
/// be too flat where paths bend at saddle vertices. `unreachable` if the lowest point is not between the
/// outer vertices, if the sums do not curve upwards, or if the path runs so close along the border that the
/// offsets are mostly rounding. A path that bends at the middle vertex makes a kink there, through which
/// three samples of long edges fit a narrow parabola with a large gain. So the curvature is limited to a
/// little more than that of circles, where edges are not much shorter than the distances; the parabola then
/// goes through the middle sample and the one on the side where the sum falls. The gain is limited, too, to
/// what waves three times as curved as circles would give: a larger one comes from samples that belong to
/// different waves.
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
  const double longest = std::fmax(before.length, after.length);
  const double of_circles = 1.0 / source + 1.0 / target;
  const double fitted = (to_right - to_left) / (right - left);
  const double curvature = std::fmin(fitted, 0.5 * (of_circles + greatest_excess / longest));
  if (!(curvature > 0.0)) return unreachable;
  const bool falls_to_right = to_right < fitted * right;
  const double slope = falls_to_right ? to_right - curvature * right : to_left - curvature * left;
  if (falls_to_right != (slope < 0.0)) return unreachable;
  const double lowest = -0.5 * slope / curvature;
  if (!(lowest > left && lowest < right)) return unreachable;
  const double max_gain = greatest_gain * longest * longest * of_circles;
  return sum - std::fmin(-0.5 * slope * lowest, max_gain);
}

/// Distance across a border at the vertex with the least sum source + target, improved by the neighbours
/// along the border; at most that sum.
inline double crossing_distance(double source, double target, std::span<const BorderSample> neighbours) {
  double best = source + target;
  for (const BorderSample& sample : neighbours) {
    best = std::min(best, unfolded_distance(sample.length, source, sample.source, target, sample.target));
  }
  if (neighbours.size() != 2) return best;
  if (!may_be_one_path(side_angle(source, target, neighbours[0]),
                       side_angle(source, target, neighbours[1]))) {
    return source + target;
  }
  return std::min(best, parabola_distance(source, target, neighbours[0], neighbours[1]));
}

}  // namespace vorogeo
