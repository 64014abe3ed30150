// The formulas of unfolding.h without branches, rearranged so that all terms are of the order of the target's
// distance.
#include "index/crossing_gains.h"

#include <cmath>
#include <cstring>

#include "index/unfolding.h"
#include "support/clones.h"

namespace vorogeo {

namespace {

inline __attribute__((always_inline)) float root(float square) {
  return std::sqrt(square > 0.0f ? square : 0.0f);
}

/// Let s and t be the distances of source and target from the end of the edge where the crossing is, and phi
/// the sum of the angles of both straight lines with the edge. By the law of cosines the straight line r
/// between them has (s + t)^2 - r^2 = 2 s t (1 + cos phi). The gain s + t - r is found from that with
/// everything divided by s, which may be much longer than the rest; `excess` is t (1 + cos phi).
inline __attribute__((always_inline)) float unfolded_gain(float source, float other_source, float target,
                                                          float other_target, float length, float lowest) {
  const float away = lowest + source;
  const float source_difference = source - other_source;
  const float target_difference = target - other_target;
  const float source_cosine =
      0.5f * (length / away + source_difference / length * ((away + (lowest + other_source)) / away));
  const float target_along = 0.5f * (length + target_difference / length * (target + other_target));
  const float source_sine = root(1.0f - source_cosine * source_cosine);
  const float target_off = root((target - target_along) * (target + target_along));
  const float excess = target + target_along * source_cosine - target_off * source_sine;
  const float sum = 1.0f + target / away;
  const float gain = 2.0f * excess / (sum + root(sum * sum - 2.0f * excess / away));
  // Where the straight line meets the edge, from the end at which the crossing is.
  const float height = source_sine + target_off / away;
  const float crossing = source_cosine * target_off + target_along * source_sine;
  const bool valid = (std::fabs(source_difference) <= length) & (std::fabs(target_difference) <= length) &
                     (height > 0.0f) & (crossing > 0.0f) & (crossing < length * height) & (gain > 0.0f) &
                     (gain <= 2.0f * target) & (gain <= 2.0f * away);
  return valid ? gain : 0.0f;
}

inline __attribute__((always_inline)) float offset(float source_difference, float target_difference,
                                                   float length) {
  const float cosine = 0.5f * (source_difference - target_difference) / length;
  return length * root(1.0f - cosine * cosine);
}

inline __attribute__((always_inline)) float bounded(float cosine) {
  const float least = cosine < -1.0f ? -1.0f : cosine;
  return least > 1.0f ? 1.0f : least;
}

struct FloatSideAngle {
  float cosine;
  float sine;
};

/// side_angle().
inline __attribute__((always_inline)) FloatSideAngle float_side_angle(float source, float other_source,
                                                                      float target, float other_target,
                                                                      float length, float lowest) {
  const float away = lowest + source;
  const float to_source = bounded(
      0.5f * (length / away + (source - other_source) / length * ((away + (lowest + other_source)) / away)));
  const float to_target = bounded(
      0.5f * (length / target + (target - other_target) / length * ((target + other_target) / target)));
  const float source_sine = root(1.0f - to_source * to_source);
  const float target_sine = root(1.0f - to_target * to_target);
  return {to_source * to_target - source_sine * target_sine,
          source_sine * to_target + to_source * target_sine};
}

/// may_be_one_path().
inline __attribute__((always_inline)) bool one_path(const FloatSideAngle& before,
                                                    const FloatSideAngle& after) {
  const float sine = before.sine * after.cosine + before.cosine * after.sine;
  const float cosine = before.cosine * after.cosine - before.sine * after.sine;
  return ((sine < 0.0f) & (cosine >= 0.0f)) |
         ((sine >= 0.0f) & ((before.sine <= 0.0f) | (after.sine <= 0.0f)));
}

}  // namespace

VOROGEO_CLONES
void crossing_gains(const Crossings& crossings, float lowest, float* gain) {
  constexpr float least_edges = 3.0f;
  constexpr auto steepest = static_cast<float>(greatest_gain);
  constexpr auto excess = static_cast<float>(greatest_excess);
  constexpr auto narrowest = static_cast<float>(least_offset);
  const float* sources = crossings.source;
  const float* targets = crossings.target;
  const float* sources_before = crossings.side[0].source;
  const float* targets_before = crossings.side[0].target;
  const float* lengths_before = crossings.side[0].length;
  const float* sources_after = crossings.side[1].source;
  const float* targets_after = crossings.side[1].target;
  const float* lengths_after = crossings.side[1].length;
  float best[Crossings::capacity];
  for (Index k = 0; k < Crossings::capacity; ++k) {
    const float source = sources[k];
    const float target = targets[k];
    const float before = lengths_before[k];
    const float after = lengths_after[k];
    const float first = unfolded_gain(source, sources_before[k], target, targets_before[k], before, lowest);
    const float second = unfolded_gain(source, sources_after[k], target, targets_after[k], after, lowest);
    const bool consistent =
        !(before > 0.0f) | !(after > 0.0f) |
        one_path(float_side_angle(source, sources_before[k], target, targets_before[k], before, lowest),
                 float_side_angle(source, sources_after[k], target, targets_after[k], after, lowest));
    const float unfolded = consistent ? (first > second ? first : second) : 0.0f;
    const float source_before = sources_before[k] - source;
    const float target_before = targets_before[k] - target;
    const float source_after = sources_after[k] - source;
    const float target_after = targets_after[k] - target;
    const float left = -offset(source_before, target_before, before);
    const float right = offset(source_after, target_after, after);
    const float to_left = (source_before + target_before) / left;
    const float to_right = (source_after + target_after) / right;
    const float away = lowest + source;
    const float longest = before > after ? before : after;
    const float of_circles = (away + target) / (away * target);
    const float fitted = (to_right - to_left) / (right - left);
    const float most = 0.5f * (of_circles + excess / longest);
    const float curvature = fitted < most ? fitted : most;
    const bool falls_to_right = to_right < fitted * right;
    const float slope = falls_to_right ? to_right - curvature * right : to_left - curvature * left;
    const float lowest_point = -0.5f * slope / curvature;
    const float max_gain = steepest * longest * longest * of_circles;
    const float free = -0.5f * slope * lowest_point;
    const float parabola = free < max_gain ? free : max_gain;
    // By the triangle inequality no gain is more than twice the nearer distance; rounding of distances that
    // are much longer than their edges could make it more, and the distance negative.
    const float nearer = away < target ? away : target;
    const bool valid = consistent & (nearer >= least_edges * before) & (nearer >= least_edges * after) &
                       (left < 0.0f) & (right > 0.0f) & (-left >= narrowest * before) &
                       (right >= narrowest * after) & (curvature > 0.0f) &
                       (falls_to_right == (slope < 0.0f)) & (lowest_point > left) & (lowest_point < right) &
                       (parabola > unfolded) & (parabola <= nearer);
    best[k] = valid ? parabola : unfolded;
  }
  std::memcpy(gain, best, sizeof(best));
}

}  // namespace vorogeo
