// One pass over the table of a patch: row by row, so that the inner loop runs over consecutive memory.
#include "query/field_sweep.h"

#include <algorithm>
#include <limits>

namespace vorogeo {

namespace {

/// least[i] = min(least[i], base + table[i]), noting the row that gave it.
void lower_by_row(const float* table, float base, Index row, std::size_t count, float* least,
                  Index* best_row) {
  for (std::size_t i = 0; i < count; ++i) {
    const float through = base + table[i];
    const bool lower = through < least[i];
    least[i] = lower ? through : least[i];
    best_row[i] = lower ? row : best_row[i];
  }
}

}  // namespace

std::span<const double> FieldSweep::sweep(const PatchLayer& layer, const BorderSearch& search, Index patch) {
  const auto nodes = layer.nodes(patch);
  const Index border = layer.border_size(patch);
  const Index inner = layer.member_count(patch) - border;
  result_.assign(layer.member_count(patch), unreachable);
  least_.assign(inner, std::numeric_limits<float>::infinity());
  row_.assign(inner, no_index);
  // Sums are formed above the least border distance, so that single precision loses nothing far from the
  // source.
  double lowest = unreachable;
  for (Index i = 0; i < border; ++i) {
    result_[i] = search.distance(nodes[i]);
    lowest = std::min(lowest, result_[i]);
  }
  if (lowest == unreachable) return result_;
  for (Index i = 0; i < border; ++i) {
    if (result_[i] == unreachable) continue;
    lower_by_row(layer.row(patch, i) + border, static_cast<float>(result_[i] - lowest), i, inner,
                 least_.data(), row_.data());
  }
  for (Index i = 0; i < inner; ++i) {
    if (row_[i] == no_index) continue;
    const double sum = result_[row_[i]] + layer.row(patch, row_[i])[border + i];
    result_[border + i] = search.across(patch, row_[i], border + i, sum);
  }
  return result_;
}

}  // namespace vorogeo
