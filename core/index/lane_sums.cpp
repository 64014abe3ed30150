// The scan, with the least sums of all lanes in registers.
#include "index/lane_sums.h"

#include <cstring>
#include <limits>

#include "support/clones.h"

namespace vorogeo {

namespace {

constexpr std::uint16_t infinite_entry = 32767;

using Floats = float __attribute__((vector_size(32)));
using Masks = std::int32_t __attribute__((vector_size(32)));
using Entries = std::uint16_t __attribute__((vector_size(16)));

/// The least sums so far, and where they come from, in registers.
struct Lanes {
  static constexpr Index half = lane_count / 2;
  Floats least[2];
  Masks best[2];

  inline __attribute__((always_inline)) void relax(const float* base, float distance, Index name) {
    for (int k = 0; k < 2; ++k) {
      Floats sum;
      std::memcpy(&sum, base + k * half, sizeof(sum));
      sum += distance;
      const Masks is_less = sum < least[k];
      least[k] = is_less ? sum : least[k];
      best[k] = is_less ? Masks{} + name : best[k];
    }
  }
};

template <bool is_graded>
inline __attribute__((always_inline)) void relax_lanes_on(const std::uint16_t* entries, float unit,
                                                          Index count, const float* base, Index first_name,
                                                          float* least, Index* best) {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  constexpr Index block = 8;
  Lanes lanes;
  std::memcpy(lanes.least, least, sizeof(lanes.least));
  std::memcpy(lanes.best, best, sizeof(lanes.best));
  if (count < block) {
    for (Index i = 0; i < count; ++i) {
      const float finite = distance_on_scale<is_graded>(unit, static_cast<float>(entries[i]));
      lanes.relax(base + i * lane_count, entries[i] == infinite_entry ? infinite : finite, first_name + i);
    }
  } else {
    for (Index done = 0; done < count; done += block) {
      // The last block begins early enough to be whole: what is done twice does no harm.
      const Index begin = done < count - block ? done : count - block;
      Entries entry;
      std::memcpy(&entry, entries + begin, sizeof(entry));
      const Masks wide = __builtin_convertvector(entry, Masks);
      const Floats root = unit * __builtin_convertvector(wide, Floats);
      const Floats finite = is_graded ? (root * root) * (root * root) : root;
      const Floats distance = wide == infinite_entry ? Floats{} + infinite : finite;
      const float* from = base + static_cast<std::size_t>(begin) * lane_count;
      for (Index i = 0; i < block; ++i) {
        lanes.relax(from + i * lane_count, distance[i], first_name + begin + i);
      }
    }
  }
  std::memcpy(least, lanes.least, sizeof(lanes.least));
  std::memcpy(best, lanes.best, sizeof(lanes.best));
}

}  // namespace

VOROGEO_CLONES
void relax_lanes(const std::uint16_t* entries, TableScale scale, Index count, const float* base,
                 Index first_name, float* least, Index* best) {
  scale.is_graded() ? relax_lanes_on<true>(entries, scale.unit(), count, base, first_name, least, best)
                    : relax_lanes_on<false>(entries, scale.unit(), count, base, first_name, least, best);
}

}  // namespace vorogeo
