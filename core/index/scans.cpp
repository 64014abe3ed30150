// Least sums over rows and tiles of tables, compiled for several instruction sets.
#include "index/scans.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "index/unfolding.h"
#include "support/processor.h"

namespace vorogeo {

// ---- The scan, with the least sums of all lanes in registers

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

// ---- The scans. Scans in integers and plain sums give the same result to the last bit on all instruction
// sets; where a product is added, some sets round once and others twice

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

// ---- Scans by vectors of fixed width, which the compiler maps to one or more registers of the chosen
// instruction set

namespace {

using Bytes = std::uint8_t __attribute__((vector_size(32)));
using HalfOfBytes = std::uint8_t __attribute__((vector_size(16)));
using FewBytes = std::uint8_t __attribute__((vector_size(8)));
using Shorts = std::int16_t __attribute__((vector_size(32)));
using HalfOfShorts = std::int16_t __attribute__((vector_size(16)));
using FewShorts = std::int16_t __attribute__((vector_size(8)));
using Floats = float __attribute__((vector_size(32)));
using Masks = std::int32_t __attribute__((vector_size(32)));
using Entries = std::uint16_t __attribute__((vector_size(16)));

static_assert(sizeof(Bytes) == byte_lanes && sizeof(Shorts) == 2 * short_lanes);

template <class Vector>
inline __attribute__((always_inline)) void load(Vector& to, const void* from) {
  std::memcpy(&to, from, sizeof(to));
}

/// base + bounds of all lanes at once; sums saturate at 255.
inline __attribute__((always_inline)) void add_bytes(const std::uint8_t* base, const std::uint8_t* bounds,
                                                     Bytes& sum) {
  Bytes from;
  Bytes bound;
  load(from, base);
  load(bound, bounds);
  const Bytes room = ~from;
  sum = from + (bound < room ? bound : room);
}

/// The least of the lanes, by taking the minimum of two halves until one is left.
template <class Half, class Quarter, class Vector>
inline __attribute__((always_inline)) auto least_lane(const Vector& lanes) {
  Half half[2];
  std::memcpy(half, &lanes, sizeof(half));
  half[0] = half[0] < half[1] ? half[0] : half[1];
  Quarter quarter[2];
  std::memcpy(quarter, &half[0], sizeof(quarter));
  Quarter least = quarter[0] < quarter[1] ? quarter[0] : quarter[1];
  // Lanes that a shift leaves empty are never compared with the first one.
  for (unsigned bits = 32; bits >= 8 * sizeof(least[0]); bits /= 2) {
    std::uint64_t word;
    std::memcpy(&word, &least, sizeof(word));
    word >>= bits;
    Quarter shifted;
    load(shifted, &word);
    least = least < shifted ? least : shifted;
  }
  return least[0];
}

/// relax_within() for one kind of scale; a part of that function.
template <bool is_graded>
inline __attribute__((always_inline)) void relax_within_on(const SeedLanes& seeds, const std::uint8_t* bounds,
                                                           const std::uint16_t* table, Index line_size,
                                                           float unit, float bound_unit, float limit,
                                                           Index columns, Index first, Index end,
                                                           float* least) {
  constexpr Index width = 8;
  constexpr float infinite = std::numeric_limits<float>::infinity();
  std::uint8_t sums[max_lanes];
  Bytes lowest = ~Bytes{};
  for (Index lane = 0; lane < seeds.lanes; lane += byte_lanes) {
    Bytes sum;
    add_bytes(seeds.bound + lane, bounds + lane, sum);
    lowest = sum < lowest ? sum : lowest;
    std::memcpy(sums + lane, &sum, sizeof(sum));
  }
  const auto of_best = least_lane<HalfOfBytes, FewBytes>(lowest);
  Floats found = Floats{} + infinite;
  const std::size_t size = columns == width ? sizeof(found) : columns * sizeof(float);
  std::memcpy(&found, least, size);
  const auto take = [&](Index lane) __attribute__((always_inline)) {
    const std::uint16_t* line = table + static_cast<std::size_t>(seeds.line[lane]) * line_size;
    Entries entry = Entries{} + infinite_entry_15;
    if (columns == width) {
      load(entry, line);
    } else {
      std::memcpy(&entry, line, columns * sizeof(*line));
    }
    const Masks wide = __builtin_convertvector(entry, Masks);
    const Floats root = unit * __builtin_convertvector(wide, Floats);
    const Floats sum = seeds.distance[lane] + (is_graded ? (root * root) * (root * root) : root);
    found = (wide != infinite_entry_15) & (sum < found) ? sum : found;
  };
  // The best seed first: it rules out most of the others.
  Index best = 0;
  while (sums[best] != of_best) ++best;
  if (seeds.distance[best] < infinite) take(best);
  float farthest = 0.0f;
  for (Index k = first; k < end; ++k) farthest = found[k] > farthest ? found[k] : farthest;
  const float max_sum = limit < farthest ? limit : farthest;
  const float in_units = bound_unit > 0.0f ? max_sum / bound_unit : 255.0f;
  const auto max_bound = static_cast<std::uint8_t>(in_units < 255.0f ? in_units : 255.0f);
  for (Index begin = 0; begin < seeds.lanes; begin += byte_lanes) {
    Bytes sum;
    load(sum, sums + begin);
    const Bytes within = reinterpret_cast<Bytes>(sum <= max_bound);
    std::uint64_t words[byte_lanes / sizeof(std::uint64_t)];
    std::memcpy(words, &within, sizeof(words));
    Index lane = begin;
    for (std::uint64_t flags : words) {
      flags &= 0x0101010101010101U;
      for (; flags != 0; flags &= flags - 1) {
        const Index at = lane + static_cast<Index>(static_cast<unsigned>(std::countr_zero(flags)) / 8);
        if (seeds.distance[at] < infinite) take(at);
      }
      lane += sizeof(flags);
    }
  }
  std::memcpy(least, &found, size);
}

}  // namespace

VOROGEO_CLONES
void least_byte_sums(const std::uint8_t* bounds, Index rows, Index row_size, const std::uint8_t* base,
                     Index lanes, std::uint8_t* least) {
  for (Index row = 0; row < rows; ++row) {
    const std::uint8_t* of_row = bounds + static_cast<std::size_t>(row) * row_size;
    Bytes lowest = ~Bytes{};
    for (Index lane = 0; lane < lanes; lane += byte_lanes) {
      Bytes sum;
      add_bytes(base + lane, of_row + lane, sum);
      lowest = sum < lowest ? sum : lowest;
    }
    least[row] = least_lane<HalfOfBytes, FewBytes>(lowest);
  }
}

VOROGEO_CLONES
void relax_within(const SeedLanes& seeds, const std::uint8_t* bounds, const std::uint16_t* table,
                  Index line_size, TableScale scale, float bound_unit, float limit, Index columns,
                  Index first, Index end, float* least) {
  scale.is_graded() ? relax_within_on<true>(seeds, bounds, table, line_size, scale.unit(), bound_unit, limit,
                                            columns, first, end, least)
                    : relax_within_on<false>(seeds, bounds, table, line_size, scale.unit(), bound_unit, limit,
                                             columns, first, end, least);
}

VOROGEO_CLONES
void byte_sums_within(const std::uint8_t* bounds, const std::uint8_t* base, Index lanes, std::uint8_t limit,
                      std::uint8_t* within) {
  for (Index lane = 0; lane < lanes; lane += byte_lanes) {
    Bytes sum;
    add_bytes(base + lane, bounds + lane, sum);
    const Bytes found = reinterpret_cast<Bytes>(sum <= limit) & static_cast<std::uint8_t>(1);
    std::memcpy(within + lane, &found, sizeof(found));
  }
}

VOROGEO_CLONES
void least_short_sums(const std::int16_t* base, const std::int16_t* between, const std::int16_t* column_base,
                      Index rows, Index columns, std::int16_t* row_least, std::int16_t* column_least) {
  const auto width = static_cast<std::size_t>(columns);
  for (Index column = 0; column < columns; column += short_lanes) {
    Shorts last;
    load(last, column_base + column);
    Shorts lowest = Shorts{} + std::int16_t{32767};
    for (Index row = 0; row < rows; ++row) {
      Shorts sum;
      load(sum, between + row * width + column);
      sum += base[row];
      lowest = sum < lowest ? sum : lowest;
    }
    lowest += last;
    std::memcpy(column_least + column, &lowest, sizeof(lowest));
  }
  for (Index row = 0; row < rows; ++row) {
    Shorts lowest = Shorts{} + std::int16_t{32767};
    for (Index column = 0; column < columns; column += short_lanes) {
      Shorts sum;
      Shorts last;
      load(sum, between + row * width + column);
      load(last, column_base + column);
      sum += last;
      lowest = sum < lowest ? sum : lowest;
    }
    row_least[row] = static_cast<std::int16_t>(base[row] + least_lane<HalfOfShorts, FewShorts>(lowest));
  }
}

VOROGEO_CLONES
void short_sums_within(const std::int16_t* between, const std::int16_t* column_base, Index columns,
                       std::int16_t limit, std::uint8_t* within) {
  for (Index column = 0; column < columns; column += short_lanes) {
    Shorts sum;
    Shorts last;
    load(sum, between + column);
    load(last, column_base + column);
    const Shorts found = (sum + last) <= limit;
    const HalfOfBytes flags = __builtin_convertvector(found, HalfOfBytes) & static_cast<std::uint8_t>(1);
    std::memcpy(within + column, &flags, sizeof(flags));
  }
}

// ---- The formulas of unfolding.h without branches

namespace {

inline __attribute__((always_inline)) float root(float square) {
  return std::sqrt(square > 0.0f ? square : 0.0f);
}

/// Let s and t be the distances of source and target from the end of the edge where the crossing is, and phi
/// the sum of the angles of both straight lines with the edge. By the law of cosines the straight line r
/// between them has (s + t)^2 - r^2 = 2 s t (1 + cos phi). The gain s + t - r is found from that with
/// everything divided by s, which may be much longer than the rest; `excess` is t (1 + cos phi).
inline __attribute__((always_inline)) float unfolded_gain(float source, float other_source, float target,
                                                          float other_target, float length, float lowest) {
  const float away = lowest + source;
  const float source_difference = source - other_source;
  const float target_difference = target - other_target;
  const float source_cosine =
      0.5f * (length / away + source_difference / length * ((away + (lowest + other_source)) / away));
  const float target_along = 0.5f * (length + target_difference / length * (target + other_target));
  const float source_sine = root(1.0f - source_cosine * source_cosine);
  const float target_off = root((target - target_along) * (target + target_along));
  const float excess = target + target_along * source_cosine - target_off * source_sine;
  const float sum = 1.0f + target / away;
  const float gain = 2.0f * excess / (sum + root(sum * sum - 2.0f * excess / away));
  // Where the straight line meets the edge, from the end at which the crossing is.
  const float height = source_sine + target_off / away;
  const float crossing = source_cosine * target_off + target_along * source_sine;
  const bool valid = (std::fabs(source_difference) <= length) & (std::fabs(target_difference) <= length) &
                     (height > 0.0f) & (crossing > 0.0f) & (crossing < length * height) & (gain > 0.0f) &
                     (gain <= 2.0f * target) & (gain <= 2.0f * away);
  return valid ? gain : 0.0f;
}

inline __attribute__((always_inline)) float offset(float source_difference, float target_difference,
                                                   float length) {
  const float cosine = 0.5f * (source_difference - target_difference) / length;
  return length * root(1.0f - cosine * cosine);
}

inline __attribute__((always_inline)) float bounded(float cosine) {
  const float least = cosine < -1.0f ? -1.0f : cosine;
  return least > 1.0f ? 1.0f : least;
}

struct FloatSideAngle {
  float cosine;
  float sine;
};

/// side_angle().
inline __attribute__((always_inline)) FloatSideAngle float_side_angle(float source, float other_source,
                                                                      float target, float other_target,
                                                                      float length, float lowest) {
  const float away = lowest + source;
  const float to_source = bounded(
      0.5f * (length / away + (source - other_source) / length * ((away + (lowest + other_source)) / away)));
  const float to_target = bounded(
      0.5f * (length / target + (target - other_target) / length * ((target + other_target) / target)));
  const float source_sine = root(1.0f - to_source * to_source);
  const float target_sine = root(1.0f - to_target * to_target);
  return {to_source * to_target - source_sine * target_sine,
          source_sine * to_target + to_source * target_sine};
}

/// may_be_one_path().
inline __attribute__((always_inline)) bool one_path(const FloatSideAngle& before,
                                                    const FloatSideAngle& after) {
  const float sine = before.sine * after.cosine + before.cosine * after.sine;
  const float cosine = before.cosine * after.cosine - before.sine * after.sine;
  return ((sine < 0.0f) & (cosine >= 0.0f)) |
         ((sine >= 0.0f) & ((before.sine <= 0.0f) | (after.sine <= 0.0f)));
}

}  // namespace

VOROGEO_CLONES
void crossing_gains(const Crossings& crossings, float lowest, float* gain) {
  constexpr float least_edges = 3.0f;
  constexpr auto steepest = static_cast<float>(greatest_gain);
  constexpr auto excess = static_cast<float>(greatest_excess);
  constexpr auto narrowest = static_cast<float>(least_offset);
  const float* sources = crossings.source;
  const float* targets = crossings.target;
  const float* sources_before = crossings.side[0].source;
  const float* targets_before = crossings.side[0].target;
  const float* lengths_before = crossings.side[0].length;
  const float* sources_after = crossings.side[1].source;
  const float* targets_after = crossings.side[1].target;
  const float* lengths_after = crossings.side[1].length;
  float best[Crossings::capacity];
  for (Index k = 0; k < Crossings::capacity; ++k) {
    const float source = sources[k];
    const float target = targets[k];
    const float before = lengths_before[k];
    const float after = lengths_after[k];
    const float first = unfolded_gain(source, sources_before[k], target, targets_before[k], before, lowest);
    const float second = unfolded_gain(source, sources_after[k], target, targets_after[k], after, lowest);
    const bool consistent =
        !(before > 0.0f) | !(after > 0.0f) |
        one_path(float_side_angle(source, sources_before[k], target, targets_before[k], before, lowest),
                 float_side_angle(source, sources_after[k], target, targets_after[k], after, lowest));
    const float unfolded = consistent ? (first > second ? first : second) : 0.0f;
    const float source_before = sources_before[k] - source;
    const float target_before = targets_before[k] - target;
    const float source_after = sources_after[k] - source;
    const float target_after = targets_after[k] - target;
    const float left = -offset(source_before, target_before, before);
    const float right = offset(source_after, target_after, after);
    const float to_left = (source_before + target_before) / left;
    const float to_right = (source_after + target_after) / right;
    const float away = lowest + source;
    const float longest = before > after ? before : after;
    const float of_circles = (away + target) / (away * target);
    const float fitted = (to_right - to_left) / (right - left);
    const float most = 0.5f * (of_circles + excess / longest);
    const float curvature = fitted < most ? fitted : most;
    const bool falls_to_right = to_right < fitted * right;
    const float slope = falls_to_right ? to_right - curvature * right : to_left - curvature * left;
    const float lowest_point = -0.5f * slope / curvature;
    const float max_gain = steepest * longest * longest * of_circles;
    const float free = -0.5f * slope * lowest_point;
    const float parabola = free < max_gain ? free : max_gain;
    // By the triangle inequality no gain is more than twice the nearer distance; rounding of distances that
    // are much longer than their edges could make it more, and the distance negative.
    const float nearer = away < target ? away : target;
    const bool valid = consistent & (nearer >= least_edges * before) & (nearer >= least_edges * after) &
                       (left < 0.0f) & (right > 0.0f) & (-left >= narrowest * before) &
                       (right >= narrowest * after) & (curvature > 0.0f) &
                       (falls_to_right == (slope < 0.0f)) & (lowest_point > left) & (lowest_point < right) &
                       (parabola > unfolded) & (parabola <= nearer);
    best[k] = valid ? parabola : unfolded;
  }
  std::memcpy(gain, best, sizeof(best));
}

}  // namespace vorogeo
