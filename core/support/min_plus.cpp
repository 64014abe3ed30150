// The scans. Sums are formed in the same order on all instruction sets, so the results are the same to the
// last bit.
#include "support/min_plus.h"

#include <limits>

// One source, compiled for each instruction set; the loader picks the best that the machine has.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define VOROGEO_CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define VOROGEO_CLONES
#endif

namespace vorogeo {

VOROGEO_CLONES
float least_sum(const float* a, const float* b, Index count) {
  // Several minima side by side, as the order of minima may not be changed by the compiler.
  constexpr Index lanes = 32;
  float lane[lanes];
  for (float& value : lane) value = std::numeric_limits<float>::infinity();
  Index i = 0;
  for (; i + lanes <= count; i += lanes) {
    for (Index k = 0; k < lanes; ++k) {
      const float sum = a[i + k] + b[i + k];
      lane[k] = sum < lane[k] ? sum : lane[k];
    }
  }
  for (; i < count; ++i) {
    const float sum = a[i] + b[i];
    lane[0] = sum < lane[0] ? sum : lane[0];
  }
  for (Index half = lanes / 2; half > 0; half /= 2) {
    for (Index k = 0; k < half; ++k) lane[k] = lane[k + half] < lane[k] ? lane[k + half] : lane[k];
  }
  return lane[0];
}

Index first_within(const float* a, const float* b, Index count, float bound) {
  for (Index i = 0; i < count; ++i) {
    if (a[i] + b[i] <= bound) return i;
  }
  return no_index;
}

VOROGEO_CLONES
Index first_lower(const float* line, double base, const double* distance, Index begin, Index count) {
  // Most sums are not lower: a block is tested as a whole before it is looked at one by one.
  constexpr Index block = 16;
  Index i = begin;
  for (; i + block <= count; i += block) {
    int lower = 0;
    for (Index k = 0; k < block; ++k) lower |= base + line[i + k] < distance[i + k] ? 1 : 0;
    if (lower == 0) continue;
    for (Index k = 0; k < block; ++k) {
      if (base + line[i + k] < distance[i + k]) return i + k;
    }
  }
  for (; i < count; ++i) {
    if (base + line[i] < distance[i]) return i;
  }
  return count;
}

VOROGEO_CLONES
void lower_by_line(const float* line, float base, Index name, Index count, float* least, Index* best) {
  for (Index i = 0; i < count; ++i) {
    const float through = base + line[i];
    const bool lower = through < least[i];
    least[i] = lower ? through : least[i];
    best[i] = lower ? name : best[i];
  }
}

}  // namespace vorogeo
