// Relative differences vertex by vertex, then their mean, RMS, percentile and maximum.
#include "tasks/field_difference.h"

#include <algorithm>
#include <cmath>

namespace vorogeo {

FieldDifference difference_of(const std::vector<double>& values, const std::vector<double>& reference) {
  FieldDifference result;
  std::vector<double> sizes;
  for (std::size_t v = 0; v < values.size(); ++v) {
    const bool both = std::isfinite(values[v]) && std::isfinite(reference[v]);
    if (std::isfinite(values[v]) != std::isfinite(reference[v])) ++result.one_only;
    if (!both || !(reference[v] > 0.0)) {
      result.relative.push_back(std::nan(""));
      continue;
    }
    const double error = (values[v] - reference[v]) / reference[v];
    result.relative.push_back(error);
    result.bias += error;
    result.mean += std::abs(error);
    result.rms += error * error;
    sizes.push_back(std::abs(error));
  }
  result.compared = static_cast<int>(sizes.size());
  if (sizes.empty()) return result;
  const auto count = static_cast<double>(sizes.size());
  result.bias /= count;
  result.mean /= count;
  result.rms = std::sqrt(result.rms / count);
  std::sort(sizes.begin(), sizes.end());
  result.p99 = sizes[static_cast<std::size_t>(std::ceil(0.99 * count)) - 1];
  result.max = sizes.back();
  return result;
}

}  // namespace vorogeo
