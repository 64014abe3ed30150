// Which edge lengths the core can compute with, and the factor for the coordinates of meshes outside this
// range.
#pragma once

#include <string>

namespace vorogeo {

/// Range of edge lengths of a mesh: the least mean, and the greatest length of a single edge.
struct LengthLimits {
  double least_mean;
  double greatest;

  /// A mesh whose edges are all of length 0 passes.
  bool allow(double mean, double longest) const {
    return longest == 0.0 || (longest <= greatest && mean >= least_mean);
  }
};

/// Areas are products of four lengths: beyond these they leave the range of doubles.
inline constexpr LengthLimits exact_lengths{1e-60, 1e60};
/// Tables hold single precision: distances across the mesh must stay well inside its range.
inline constexpr LengthLimits index_lengths{1e-28, 1e28};

/// Refuses edge lengths outside the range of the arithmetic. `what` begins the sentence that states the
/// accepted lengths: "exact distances take". \throw InvalidInput.
void require_lengths(double mean, double longest, const std::string& what, const LengthLimits& limits);

/// The power of ten that brings mean and longest edge closest to 1 when coordinates are multiplied by it.
double factor_to_unit(double mean, double longest);

}  // namespace vorogeo
