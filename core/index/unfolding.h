// Crossing a border between its vertices: edge unfolding, and the parabola through three border vertices.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/vectors.h"
#include "support/processor.h"
#include "support/types.h"

namespace vorogeo {

/// A border vertex near a crossing: distances of source and target from it, and the length of the border edge
/// that leads to it from the middle one; 0 for a vertex that may not be used.
template <class Number>
struct BorderSample {
  Number source;
  Number target;
  Number length;
};

/// Least offset of an outer vertex across the path, in lengths of its edge, for a parabola.
inline constexpr double least_offset = 0.1;

/// Greatest gain of a parabola, for border edges of length 1 with source and target at harmonic distance 1:
/// three times that of circles, 1/8.
inline constexpr double greatest_gain = 0.375;

/// Greatest curvature of the sum in a parabola, beyond that of circles around source and target, for border
/// edges of length 1.
inline constexpr double greatest_excess = 0.3;

// The formulas have no branches, so that compilers can apply them to many crossings at once (scans.h).
// Distances of the source are relative to `lowest`: those of a far source keep their digits in floats.

template <class Number>
VOROGEO_INLINE Number root(Number square) {
  return std::sqrt(square > Number{0} ? square : Number{0});
}

template <class Number>
VOROGEO_INLINE Number clamped(Number cosine) {
  const Number least = cosine < Number{-1} ? Number{-1} : cosine;
  return least > Number{1} ? Number{1} : least;
}

/// The angle between the directions to source and target at a border vertex, on one side of them.
template <class Number>
struct SideAngle {
  Number cosine;
  Number sine;
};

/// The angle on the side of one neighbour: the sum of both directions' angles with the border edge to it.
template <class Number>
VOROGEO_INLINE SideAngle<Number> side_angle(Number source, Number target,
                                            const BorderSample<Number>& neighbour, Number lowest) {
  constexpr Number half{0.5F};
  constexpr Number one{1};
  const Number length = neighbour.length;
  const Number away = lowest + source;
  const Number to_source =
      clamped(half * (length / away +
                      (source - neighbour.source) / length * ((away + (lowest + neighbour.source)) / away)));
  const Number to_target = clamped(half * (length / target + (target - neighbour.target) / length *
                                                                 ((target + neighbour.target) / target)));
  const Number source_sine = root(one - to_source * to_source);
  const Number target_sine = root(one - to_target * to_target);
  return {to_source * to_target - source_sine * target_sine,
          source_sine * to_target + to_source * target_sine};
}

/// Whether both neighbours may have been reached by one wave: a path passes a vertex on one side only, so
/// where one side has less than pi, the other has more. Together they are at least 1.5 pi: curvature does not
/// make them less.
template <class Number>
VOROGEO_INLINE bool may_be_one_path(const SideAngle<Number>& before, const SideAngle<Number>& after) {
  constexpr Number zero{0};
  const Number sine = before.sine * after.cosine + before.cosine * after.sine;
  const Number cosine = before.cosine * after.cosine - before.sine * after.sine;
  return ((sine < zero) & (cosine >= zero)) |
         ((sine >= zero) & ((before.sine <= zero) | (after.sine <= zero)));
}

/// The straight line from source to target across the edge to a neighbour.
template <class Number>
struct StraightCrossing {
  Number gain;  ///< by how much the sum over the vertex is longer; 0 if the line does not cross the edge
  Number part;  ///< of the edge between the vertex and the line, if they cross
};

// Let s and t be the distances of source and target from the vertex, and phi the sum of the angles of both
// straight lines with the edge. By the law of cosines the straight line r between them has (s + t)^2 - r^2 =
// 2 s t (1 + cos phi). The gain s + t - r is found from that with everything divided by s, which may be much
// longer than the rest; `excess` is t (1 + cos phi).
template <class Number>
VOROGEO_INLINE StraightCrossing<Number> straight_crossing(Number source, Number target,
                                                          const BorderSample<Number>& neighbour,
                                                          Number lowest) {
  constexpr Number half{0.5F};
  constexpr Number one{1};
  constexpr Number two{2};
  const Number length = neighbour.length;
  const Number away = lowest + source;
  const Number source_difference = source - neighbour.source;
  const Number target_difference = target - neighbour.target;
  const Number source_cosine =
      half * (length / away + source_difference / length * ((away + (lowest + neighbour.source)) / away));
  const Number target_along = half * (length + target_difference / length * (target + neighbour.target));
  const Number source_sine = root(one - source_cosine * source_cosine);
  const Number target_off = root((target - target_along) * (target + target_along));
  const Number excess = target + target_along * source_cosine - target_off * source_sine;
  const Number sum = one + target / away;
  const Number gain = two * excess / (sum + root(sum * sum - two * excess / away));
  // Where the straight line meets the edge, from the end at which the crossing is.
  const Number height = source_sine + target_off / away;
  const Number crossing = source_cosine * target_off + target_along * source_sine;
  const Number source_size = std::fabs(source_difference);
  const Number target_size = std::fabs(target_difference);
  const bool valid = (source_size <= length) & (target_size <= length) & (height > Number{0}) &
                     (crossing > Number{0}) & (crossing < length * height) & (gain > Number{0}) &
                     (gain <= two * target) & (gain <= two * away);
  return {valid ? gain : Number{0}, crossing / (length * height)};
}

template <class Number>
VOROGEO_INLINE Number unfolded_gain(Number source, Number target, const BorderSample<Number>& neighbour,
                                    Number lowest) {
  return straight_crossing(source, target, neighbour, lowest).gain;
}

/// By how much the sum over the middle one of three consecutive border vertices, the least of the three, is
/// longer than the path between them. Measured across the path, the sum grows with the square of the offset
/// from the true crossing, by the curvature of both waves; the three sums determine that parabola and so its
/// least value. Unlike unfolding, it does not assume the waves to be circles around source and target, which
/// would be too flat where paths bend at saddle vertices. 0 if the lowest point is not between the outer
/// vertices, if the sums do not curve upwards, or if the path runs so close along the border that the offsets
/// are mostly rounding. A path that bends at the middle vertex makes a kink there, through which three
/// samples of long edges fit a narrow parabola with a large gain. So the curvature is limited to a little
/// more than that of circles, where edges are not much shorter than the distances; the parabola then goes
/// through the middle sample and the one on the side where the sum falls. The gain is limited, too, to what
/// waves three times as curved as circles would give: a larger one comes from samples that belong to
/// different waves.
template <class Number>
VOROGEO_INLINE Number parabola_gain(Number source, Number target, const BorderSample<Number>& before,
                                    const BorderSample<Number>& after, Number lowest) {
  constexpr Number half{0.5F};
  constexpr Number least_edges{3};
  constexpr auto steepest = static_cast<Number>(greatest_gain);
  constexpr auto most_excess = static_cast<Number>(greatest_excess);
  constexpr auto narrowest = static_cast<Number>(least_offset);
  const Number away = lowest + source;
  auto offset =
      [](Number source_difference, Number target_difference, Number length) __attribute__((always_inline)) {
    // Cosine of the angle between path and border edge, as the mean of the values from both sides.
    const Number cosine = half * (source_difference - target_difference) / length;
    return length * root(Number{1} - cosine * cosine);
  };
  const Number source_before = before.source - source;
  const Number target_before = before.target - target;
  const Number source_after = after.source - source;
  const Number target_after = after.target - target;
  const Number left = -offset(source_before, target_before, before.length);
  const Number right = offset(source_after, target_after, after.length);
  const Number to_left = (source_before + target_before) / left;
  const Number to_right = (source_after + target_after) / right;
  const Number longest = before.length > after.length ? before.length : after.length;
  const Number of_circles = (away + target) / (away * target);
  const Number fitted = (to_right - to_left) / (right - left);
  const Number most = half * (of_circles + most_excess / longest);
  const Number curvature = fitted < most ? fitted : most;
  const bool falls_to_right = to_right < fitted * right;
  const Number slope = falls_to_right ? to_right - curvature * right : to_left - curvature * left;
  const Number lowest_point = -half * slope / curvature;
  const Number max_gain = steepest * longest * longest * of_circles;
  const Number free = -half * slope * lowest_point;
  const Number gain = free < max_gain ? free : max_gain;
  // By the triangle inequality no gain is more than twice the nearer distance; rounding of distances that are
  // much longer than their edges could make it more, and the distance negative.
  const Number nearer = away < target ? away : target;
  const bool valid = (nearer >= least_edges * before.length) & (nearer >= least_edges * after.length) &
                     (left < Number{0}) & (right > Number{0}) & (-left >= narrowest * before.length) &
                     (right >= narrowest * after.length) & (curvature > Number{0}) &
                     (falls_to_right == (slope < Number{0})) & (lowest_point > left) &
                     (lowest_point < right) & (gain <= nearer);
  return valid ? gain : Number{0};
}

/// A path crosses a border at the vertex where the sum source + target is least.
template <class Number>
struct Crossing {
  Number source{};
  Number target{};
  BorderSample<Number> side[2]{};  ///< neighbours along the border
  int neighbours = 0;              ///< that were added

  /// Takes a neighbour into account, if the target is not infinitely far from it. Where more borders meet, no
  /// two of three belong to one path for sure: only the one across whose edge the path is shortest is used.
  void add(const BorderSample<Number>& neighbour) {
    if (!(neighbour.target < std::numeric_limits<Number>::infinity())) return;
    if (++neighbours <= 2) {
      side[neighbours - 1] = neighbour;
      return;
    }
    for (const BorderSample<Number>& other : {side[1], neighbour}) {
      if (unfolded_gain(source, target, other, Number{0}) >
          unfolded_gain(source, target, side[0], Number{0})) {
        side[0] = other;
      }
    }
    side[1] = {};
  }
};

/// By how much the sum is too long; 0 where nothing is known.
template <class Number>
VOROGEO_INLINE Number crossing_gain(const Crossing<Number>& at, Number lowest) {
  const auto& [before, after] = at.side;
  const Number by_before = unfolded_gain(at.source, at.target, before, lowest);
  const Number by_after = unfolded_gain(at.source, at.target, after, lowest);
  const bool is_one_path = !(before.length > Number{0}) | !(after.length > Number{0}) |
                           may_be_one_path(side_angle(at.source, at.target, before, lowest),
                                           side_angle(at.source, at.target, after, lowest));
  const Number longer = by_before > by_after ? by_before : by_after;
  const Number unfolded = is_one_path ? longer : Number{0};
  const Number parabola = parabola_gain(at.source, at.target, before, after, lowest);
  return (is_one_path & (parabola > unfolded)) ? parabola : unfolded;
}

/// Distance across the border by the same formulas, without those that the result does not need; at most the
/// sum.
inline double crossing_distance(const Crossing<double>& at) {
  const auto& [before, after] = at.side;
  const double sum = at.source + at.target;
  double best = sum;
  for (const BorderSample<double>& side : at.side) {
    best = std::min(best, unfolded_distance(side.length, at.source, side.source, at.target, side.target));
  }
  if (at.neighbours != 2) return best;
  if (!may_be_one_path(side_angle(at.source, at.target, before, 0.0),
                       side_angle(at.source, at.target, after, 0.0))) {
    return sum;
  }
  return std::min(best, sum - parabola_gain(at.source, at.target, before, after, 0.0));
}

}  // namespace vorogeo
