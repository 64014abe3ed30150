// Distance across an edge whose two faces are unfolded into one plane.
#pragma once

#include <cmath>

#include "support/types.h"

namespace vorogeo {

/// Distance across an edge of the given length from a source at distances (source_a, source_b) of its ends to
/// a target at (target_a, target_b): both placed in the plane, on opposite sides of the edge. `unreachable`
/// if the straight line misses the edge or no point in the plane has these distances.
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

}  // namespace vorogeo
