// Edge unfolding and parabola (unfolding.h) for many crossings at once, in single precision.
#pragma once

#include "support/types.h"

namespace vorogeo {

/// Crossings, as a structure of arrays. Distances of the source are relative to `lowest`, so
/// that those of a far source keep their digits. A neighbour that may not be used has a length of 0.
struct Crossings {
  static constexpr Index capacity = 32;
  float source[capacity];
  float target[capacity];
  struct Side {
    float source[capacity];
    float target[capacity];
    float length[capacity];
  } side[2];
};

/// By how much each crossing's sum source + target is too long; 0 where nothing is known. The same as by
/// unfolded_distance over both edges and by parabola_distance, up to rounding of the target's distances: the
/// difference is computed without subtracting two long distances.
void crossing_gains(const Crossings& crossings, float lowest, float* gain);

}  // namespace vorogeo
