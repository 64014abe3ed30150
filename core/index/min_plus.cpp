// The scans. Scans in integers and plain sums give the same result to the last bit on all instruction sets;
// where a product is added, some sets round once and others twice.
#include "index/min_plus.h"

#include <cstring>
#include <limits>

#include "support/clones.h"

namespace vorogeo {

namespace {

constexpr std::uint16_t infinite_entry_15 = 32767;
constexpr std::uint16_t infinite_entry_16 = 65535;
constexpr std::int16_t greatest_sum = 32767;

using Floats = float __attribute__((vector_size(32)));
using Masks = std::int32_t __attribute__((vector_size(32)));
using Entries = std::uint16_t __attribute__((vector_size(16)));

// The scans over distances, for each kind of scale; they are parts of the functions that choose between them.
#define VOROGEO_ON_SCALE    \
  template <bool is_graded> \
  inline __attribute__((always_inline))

VOROGEO_ON_SCALE IndexRange range_within_on(const float* base, const std::uint16_t* entries, float unit,
                                            float bound, Index count) {
  constexpr Index block = 16;
  auto within = [&](Index i) {
    return base[i] + distance_on_scale<is_graded>(unit, static_cast<float>(entries[i])) <= bound;
  };
  Index begin = 0;
  for (; begin + block <= count; begin += block) {
    int found = 0;
    for (Index k = 0; k < block; ++k) found |= within(begin + k) ? 1 : 0;
    if (found != 0) break;
  }
  while (begin < count && !within(begin)) ++begin;
  Index end = count;
  for (; end - block >= begin; end -= block) {
    int found = 0;
    for (Index k = 1; k <= block; ++k) found |= within(end - k) ? 1 : 0;
    if (found != 0) break;
  }
  while (end > begin && !within(end - 1)) --end;
  return {begin, end};
}

VOROGEO_ON_SCALE void relax_by_line_on(const std::uint16_t* entries, float unit, float base, Index name,
                                       Index count, float* least, Index* best) {
  for (Index i = 0; i < count; ++i) {
    const float through = base + distance_on_scale<is_graded>(unit, static_cast<float>(entries[i]));
    const bool is_less = (entries[i] != infinite_entry_15) & (through < least[i]);
    least[i] = is_less ? through : least[i];
    best[i] = is_less ? name : best[i];
  }
}

VOROGEO_ON_SCALE float relax_by_cell_on(const std::uint16_t* cell, Index rows, Index columns,
                                        const float* base, float offset, float unit, Index first_name,
                                        float* least, Index* best) {
  float worst = 0.0f;
  for (Index row = 0; row < rows; ++row) {
    const std::uint16_t* entries = cell + static_cast<std::size_t>(row) * columns;
    const float start = base[row] + offset;
    for (Index i = 0; i < columns; ++i) {
      const float through = start + distance_on_scale<is_graded>(unit, static_cast<float>(entries[i]));
      const bool is_less = (entries[i] != infinite_entry_16) & (through < least[i]);
      least[i] = is_less ? through : least[i];
      best[i] = is_less ? first_name + row : best[i];
    }
  }
  for (Index i = 0; i < columns; ++i) worst = least[i] > worst ? least[i] : worst;
  return worst;
}

VOROGEO_ON_SCALE float least_in_cell_on(const std::uint16_t* cell, Index rows, Index columns,
                                        const float* from, const float* to, float unit) {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  constexpr Index width = 8;
  float least = infinite;
  if (columns != width) {
    for (Index row = 0; row < rows; ++row) {
      const std::uint16_t* entries = cell + static_cast<std::size_t>(row) * columns;
      for (Index k = 0; k < columns; ++k) {
        const float between = distance_on_scale<is_graded>(unit, static_cast<float>(entries[k]));
        const float sum = (from[row] + between) + to[k];
        if (entries[k] != infinite_entry_16 && sum < least) least = sum;
      }
    }
    return least;
  }
  Floats lane = Floats{} + infinite;
  for (Index row = 0; row < rows; ++row) {
    Entries entry;
    std::memcpy(&entry, cell + static_cast<std::size_t>(row) * width, sizeof(entry));
    const Masks wide = __builtin_convertvector(entry, Masks);
    const Floats between = __builtin_convertvector(wide, Floats);
    const Floats root = unit * between;
    const Floats sum = from[row] + (is_graded ? (root * root) * (root * root) : root);
    lane = (wide != infinite_entry_16) & (sum < lane) ? sum : lane;
  }
  // The last part is the same for all rows.
  Floats last;
  std::memcpy(&last, to, sizeof(last));
  lane += last;
  for (Index k = 0; k < width; ++k) least = lane[k] < least ? lane[k] : least;
  return least;
}

VOROGEO_ON_SCALE void scale_entries_on(const std::uint16_t* entries, Index count, float unit,
                                       float* distances) {
  for (Index i = 0; i < count; ++i) {
    const float distance = distance_on_scale<is_graded>(unit, static_cast<float>(entries[i]));
    distances[i] = entries[i] == infinite_entry_15 ? std::numeric_limits<float>::infinity() : distance;
  }
}

}  // namespace

VOROGEO_CLONES
Index first_lower(const float* line, double base, const double* distance, Index begin, Index count) {
  // Most sums are not lower: a block is tested as a whole before its elements are tested one by one.
  constexpr Index block = 16;
  Index i = begin;
  for (; i + block <= count; i += block) {
    int found = 0;
    for (Index k = 0; k < block; ++k) found |= base + line[i + k] < distance[i + k] ? 1 : 0;
    if (found == 0) continue;
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
IndexRange range_within(const float* base, const std::uint16_t* entries, TableScale scale, float bound,
                        Index count) {
  return scale.is_graded() ? range_within_on<true>(base, entries, scale.unit(), bound, count)
                           : range_within_on<false>(base, entries, scale.unit(), bound, count);
}

VOROGEO_CLONES
void relax_by_line(const std::uint16_t* entries, TableScale scale, float base, Index name, Index count,
                   float* least, Index* best) {
  scale.is_graded() ? relax_by_line_on<true>(entries, scale.unit(), base, name, count, least, best)
                    : relax_by_line_on<false>(entries, scale.unit(), base, name, count, least, best);
}

VOROGEO_CLONES
void relax_by_sums(const float* line, float base, Index count, float* least) {
  for (Index i = 0; i < count; ++i) {
    const float through = base + line[i];
    least[i] = through < least[i] ? through : least[i];
  }
}

VOROGEO_CLONES
float relax_by_cell(const std::uint16_t* cell, Index rows, Index columns, const float* base, float offset,
                    TableScale scale, Index first_name, float* least, Index* best) {
  return scale.is_graded() ? relax_by_cell_on<true>(cell, rows, columns, base, offset, scale.unit(),
                                                    first_name, least, best)
                           : relax_by_cell_on<false>(cell, rows, columns, base, offset, scale.unit(),
                                                     first_name, least, best);
}

VOROGEO_CLONES
float least_in_cell(const std::uint16_t* cell, Index rows, Index columns, const float* from, const float* to,
                    TableScale scale) {
  return scale.is_graded() ? least_in_cell_on<true>(cell, rows, columns, from, to, scale.unit())
                           : least_in_cell_on<false>(cell, rows, columns, from, to, scale.unit());
}

VOROGEO_CLONES
void scale_entries(const std::uint16_t* entries, Index count, TableScale scale, float* distances) {
  scale.is_graded() ? scale_entries_on<true>(entries, count, scale.unit(), distances)
                    : scale_entries_on<false>(entries, count, scale.unit(), distances);
}

VOROGEO_CLONES
std::int16_t least_entry_sum(const std::int16_t* base, const std::uint16_t* entries, Index count) {
  constexpr Index lanes = 64;
  std::int16_t lane[lanes];
  for (std::int16_t& value : lane) value = greatest_sum;
  Index i = 0;
  for (; i + lanes <= count; i += lanes) {
    for (Index k = 0; k < lanes; ++k) {
      const auto sum = static_cast<std::int16_t>(base[i + k] + entries[i + k]);
      lane[k] = sum < lane[k] ? sum : lane[k];
    }
  }
  for (; i < count; ++i) {
    const auto sum = static_cast<std::int16_t>(base[i] + entries[i]);
    lane[0] = sum < lane[0] ? sum : lane[0];
  }
  for (Index half = lanes / 2; half > 0; half /= 2) {
    for (Index k = 0; k < half; ++k) lane[k] = lane[k + half] < lane[k] ? lane[k + half] : lane[k];
  }
  return lane[0];
}

VOROGEO_CLONES
Index first_entry_sum(const std::int16_t* base, const std::uint16_t* entries, Index count, std::int16_t sum) {
  constexpr Index block = 32;
  Index i = 0;
  for (; i + block <= count; i += block) {
    int found = 0;
    for (Index k = 0; k < block; ++k) found |= static_cast<std::int16_t>(base[i + k] + entries[i + k]) == sum;
    if (found != 0) break;
  }
  for (; i < count; ++i) {
    if (static_cast<std::int16_t>(base[i] + entries[i]) == sum) return i;
  }
  return no_index;
}

VOROGEO_CLONES
void least_tile_sums(const std::int16_t* base, const std::uint16_t* tile, Index rows, std::int16_t* least,
                     std::int16_t* best) {
  constexpr Index width = 32;
  std::int16_t lowest[width];
  std::int16_t at[width];
  for (Index k = 0; k < width; ++k) {
    lowest[k] = greatest_sum;
    at[k] = 0;
  }
  for (Index row = 0; row < rows; ++row) {
    const std::uint16_t* entries = tile + static_cast<std::size_t>(row) * width;
    for (Index k = 0; k < width; ++k) {
      const auto sum = static_cast<std::int16_t>(base[row] + entries[k]);
      const bool is_less = sum < lowest[k];
      lowest[k] = is_less ? sum : lowest[k];
      at[k] = is_less ? static_cast<std::int16_t>(row) : at[k];
    }
  }
  std::memcpy(least, lowest, sizeof(lowest));
  std::memcpy(best, at, sizeof(at));
}

VOROGEO_CLONES
void least_tile_sums_of(const std::int16_t* base, const Index* rows, Index count, const std::uint16_t* tile,
                        std::int16_t* least, std::int16_t* best) {
  constexpr Index width = 32;
  std::int16_t lowest[width];
  std::int16_t at[width];
  for (Index k = 0; k < width; ++k) {
    lowest[k] = greatest_sum;
    at[k] = 0;
  }
  for (Index i = 0; i < count; ++i) {
    const std::uint16_t* entries = tile + static_cast<std::size_t>(rows[i]) * width;
    for (Index k = 0; k < width; ++k) {
      const auto sum = static_cast<std::int16_t>(base[i] + entries[k]);
      const bool is_less = sum < lowest[k];
      lowest[k] = is_less ? sum : lowest[k];
      at[k] = is_less ? static_cast<std::int16_t>(i) : at[k];
    }
  }
  std::memcpy(least, lowest, sizeof(lowest));
  std::memcpy(best, at, sizeof(at));
}

}  // namespace vorogeo
