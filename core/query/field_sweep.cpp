// One pass over the table of a patch, member by member.
#include "query/field_sweep.h"

#include <algorithm>
#include <limits>

#include "support/min_plus.h"

namespace vorogeo {

std::span<const double> FieldSweep::sweep(const PatchLayer& layer, const BorderSearch& search, Index patch) {
  const auto nodes = layer.nodes(patch);
  const Index border = layer.border_size(patch);
  const Index inner = layer.member_count(patch) - border;
  result_.assign(layer.member_count(patch), unreachable);
  // Sums are formed above the least border distance, so that single precision loses nothing far from the
  // source.
  double lowest = unreachable;
  for (Index i = 0; i < border; ++i) {
    result_[i] = search.distance(nodes[i]);
    lowest = std::min(lowest, result_[i]);
  }
  if (lowest == unreachable) return result_;
  base_.resize(border);
  for (Index i = 0; i < border; ++i) base_[i] = static_cast<float>(result_[i] - lowest);
  for (Index i = border; i < border + inner; ++i) {
    const float* line = layer.line(patch, i);
    const float least = least_sum(base_.data(), line, border);
    if (least == std::numeric_limits<float>::infinity()) continue;
    const Index row = first_within(base_.data(), line, border, least);
    result_[i] = search.across(patch, row, i, result_[row] + line[row]);
  }
  return result_;
}

}  // namespace vorogeo
