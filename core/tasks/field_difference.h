// How two distance fields of one mesh differ.
#pragma once

#include <vector>

namespace vorogeo {

/// Signed relative differences at the vertices that have a distance in both fields, and their statistics.
struct FieldDifference {
  std::vector<double> relative;  ///< NaN where there is nothing to compare
  int compared = 0;
  int one_only = 0;  ///< vertices with a distance in only one of the fields
  double bias = 0.0;
  double mean = 0.0;
  double rms = 0.0;
  double p99 = 0.0;
  double max = 0.0;
};

/// Complexity: O(n log n). \pre Both have the same size.
FieldDifference difference_of(const std::vector<double>& values, const std::vector<double>& reference);

}  // namespace vorogeo
