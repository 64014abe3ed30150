// Scans by vectors of fixed width, which the compiler maps to one or more registers of the chosen instruction
// set.
#include "index/bound_scans.h"

#include <bit>
#include <cstring>
#include <limits>

#include "support/clones.h"

namespace vorogeo {

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

constexpr std::uint16_t infinite_entry_15 = 32767;
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

}  // namespace vorogeo
