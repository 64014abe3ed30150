// Least sums over rows and tiles of tables, compiled for several instruction sets.
#include "index/scans.h"

#include <bit>
#include <cstring>

#include "index/transit_table.h"
#include "support/processor.h"

namespace vorogeo {

// ---- Vectors of fixed width, which the compiler maps to one or more registers of the chosen instruction
// set, and the distances of entries on both kinds of scales

namespace {

constexpr std::int16_t greatest_sum = 32767;

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
VOROGEO_INLINE void load(Vector& to, const void* from) {
  std::memcpy(&to, from, sizeof(to));
}

/// The distances of entries that are not infinite.
template <bool is_graded>
struct Decoder {
  float unit;

  VOROGEO_INLINE float operator()(std::uint16_t entry) const {
    const float root = unit * static_cast<float>(entry);
    return is_graded ? (root * root) * (root * root) : root;
  }
  VOROGEO_INLINE void operator()(const Masks& entries, Floats& distances) const {
    const Floats root = unit * __builtin_convertvector(entries, Floats);
    distances = is_graded ? (root * root) * (root * root) : root;
  }
};

/// Calls scan(decoder): a scan is compiled for each kind of scale.
template <class Scan>
VOROGEO_INLINE auto on_scale(TableScale scale, const Scan& scan) {
  return scale.is_graded() ? scan(Decoder<true>{scale.unit()}) : scan(Decoder<false>{scale.unit()});
}

}  // namespace

// ---- Scans in integers and plain sums give the same result to the last bit on all instruction sets; where a
// product is added, some sets round once and others twice

namespace {

/// The least sums so far, and where they come from, in registers.
struct Lanes {
  static constexpr Index half = lane_count / 2;
  Floats least[2];
  Masks best[2];

  VOROGEO_INLINE void relax(const float* base, float distance, Index name) {
    for (int k = 0; k < 2; ++k) {
      Floats sum;
      load(sum, base + k * half);
      sum += distance;
      const Masks is_less = sum < least[k];
      least[k] = is_less ? sum : least[k];
      best[k] = is_less ? Masks{} + name : best[k];
    }
  }
};

}  // namespace

VOROGEO_CLONES
void relax_lanes(const std::uint16_t* entries, TableScale scale, Index count, const float* base,
                 Index first_name, float* least, Index* best) {
  constexpr Index block = 8;
  Lanes lanes;
  load(lanes.least, least);
  load(lanes.best, best);
  on_scale(
      scale, [&](auto decode) __attribute__((always_inline)) {
        if (count < block) {
          for (Index i = 0; i < count; ++i) {
            lanes.relax(base + i * lane_count,
                        entries[i] == PatchLayer::infinite_entry ? unreachable_float : decode(entries[i]),
                        first_name + i);
          }
          return;
        }
        for (Index done = 0; done < count; done += block) {
          // The last block begins early enough to be whole: what is done twice does no harm.
          const Index begin = done < count - block ? done : count - block;
          Entries entry;
          load(entry, entries + begin);
          const Masks wide = __builtin_convertvector(entry, Masks);
          Floats distance;
          decode(wide, distance);
          distance = wide == PatchLayer::infinite_entry ? Floats{} + unreachable_float : distance;
          const float* from = base + static_cast<std::size_t>(begin) * lane_count;
          for (Index i = 0; i < block; ++i) {
            lanes.relax(from + i * lane_count, distance[i], first_name + begin + i);
          }
        }
      });
  std::memcpy(least, lanes.least, sizeof(lanes.least));
  std::memcpy(best, lanes.best, sizeof(lanes.best));
}

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
  constexpr Index block = 8;
  IndexRange range{0, count};
  on_scale(
      scale, [&](auto decode) __attribute__((always_inline)) {
        const auto is_within = [&](Index i) { return base[i] + decode(entries[i]) <= bound; };
        const auto is_any_within = [&](Index i) __attribute__((always_inline)) {
          Entries entry;
          Floats from;
          Floats sum;
          load(entry, entries + i);
          load(from, base + i);
          decode(__builtin_convertvector(entry, Masks), sum);
          const Masks within = from + sum <= bound;
          std::uint64_t words[4];
          load(words, &within);
          return (words[0] | words[1] | words[2] | words[3]) != 0;
        };
        auto& [begin, end] = range;
        while (begin + block <= count && !is_any_within(begin)) begin += block;
        while (begin < count && !is_within(begin)) ++begin;
        while (end - block >= begin && !is_any_within(end - block)) end -= block;
        while (end > begin && !is_within(end - 1)) --end;
      });
  return range;
}

VOROGEO_CLONES
void relax_by_line(const std::uint16_t* entries, TableScale scale, float base, Index name, Index count,
                   float* least, Index* best) {
  on_scale(
      scale, [&](auto decode) __attribute__((always_inline)) {
        for (Index i = 0; i < count; ++i) {
          const float through = base + decode(entries[i]);
          const bool is_less = (entries[i] != PatchLayer::infinite_entry) & (through < least[i]);
          least[i] = is_less ? through : least[i];
          best[i] = is_less ? name : best[i];
        }
      });
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
  on_scale(
      scale, [&](auto decode) __attribute__((always_inline)) {
        for (Index row = 0; row < rows; ++row) {
          const std::uint16_t* entries = cell + static_cast<std::size_t>(row) * columns;
          const float start = base[row] + offset;
          for (Index i = 0; i < columns; ++i) {
            const float through = start + decode(entries[i]);
            const bool is_less = (entries[i] != TransitTable::infinite_entry) & (through < least[i]);
            least[i] = is_less ? through : least[i];
            best[i] = is_less ? first_name + row : best[i];
          }
        }
      });
  float worst = 0.0f;
  for (Index i = 0; i < columns; ++i) worst = least[i] > worst ? least[i] : worst;
  return worst;
}

VOROGEO_CLONES
float least_in_cell(const std::uint16_t* cell, Index rows, Index columns, const float* from, const float* to,
                    TableScale scale) {
  return on_scale(
      scale, [&](auto decode) __attribute__((always_inline)) {
        constexpr Index width = 8;
        float least = unreachable_float;
        if (columns != width) {
          for (Index row = 0; row < rows; ++row) {
            const std::uint16_t* entries = cell + static_cast<std::size_t>(row) * columns;
            for (Index k = 0; k < columns; ++k) {
              const float sum = (from[row] + decode(entries[k])) + to[k];
              if (entries[k] != TransitTable::infinite_entry && sum < least) least = sum;
            }
          }
          return least;
        }
        Floats lane = Floats{} + unreachable_float;
        for (Index row = 0; row < rows; ++row) {
          Entries entry;
          load(entry, cell + static_cast<std::size_t>(row) * width);
          const Masks wide = __builtin_convertvector(entry, Masks);
          Floats sum;
          decode(wide, sum);
          sum += from[row];
          lane = ((wide != TransitTable::infinite_entry) & (sum < lane)) ? sum : lane;
        }
        // The last part is the same for all rows.
        Floats last;
        load(last, to);
        lane += last;
        for (Index k = 0; k < width; ++k) least = lane[k] < least ? lane[k] : least;
        return least;
      });
}

VOROGEO_CLONES
void scale_entries(const std::uint16_t* entries, Index count, TableScale scale, float* distances) {
  on_scale(
      scale, [&](auto decode) __attribute__((always_inline)) {
        for (Index i = 0; i < count; ++i) {
          const float distance = decode(entries[i]);
          distances[i] = entries[i] == PatchLayer::infinite_entry ? unreachable_float : distance;
        }
      });
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

// ---- Scans over lower bounds

namespace {

/// base + bounds of all lanes at once; sums saturate at 255.
VOROGEO_INLINE void add_bytes(const std::uint8_t* base, const std::uint8_t* bounds, Bytes& sum) {
  Bytes from;
  Bytes bound;
  load(from, base);
  load(bound, bounds);
  const Bytes room = ~from;
  sum = from + (bound < room ? bound : room);
}

/// The least of the lanes, by taking the minimum of two halves until one is left.
template <class Half, class Quarter, class Vector>
VOROGEO_INLINE auto least_lane(const Vector& lanes) {
  Half half[2];
  load(half, &lanes);
  half[0] = half[0] < half[1] ? half[0] : half[1];
  Quarter quarter[2];
  load(quarter, &half[0]);
  Quarter least = quarter[0] < quarter[1] ? quarter[0] : quarter[1];
  // Lanes that a shift leaves empty are never compared with the first one.
  for (unsigned bits = 32; bits >= 8 * sizeof(least[0]); bits /= 2) {
    std::uint64_t word;
    load(word, &least);
    word >>= bits;
    Quarter shifted;
    load(shifted, &word);
    least = least < shifted ? least : shifted;
  }
  return least[0];
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
  constexpr Index width = 8;
  std::uint8_t sums[max_lanes];
  Bytes lowest = ~Bytes{};
  for (Index lane = 0; lane < seeds.lanes; lane += byte_lanes) {
    Bytes sum;
    add_bytes(seeds.bound + lane, bounds + lane, sum);
    lowest = sum < lowest ? sum : lowest;
    std::memcpy(sums + lane, &sum, sizeof(sum));
  }
  const auto of_best = least_lane<HalfOfBytes, FewBytes>(lowest);
  Floats found = Floats{} + unreachable_float;
  const std::size_t size = columns == width ? sizeof(found) : columns * sizeof(float);
  std::memcpy(&found, least, size);
  on_scale(
      scale, [&](auto decode) __attribute__((always_inline)) {
        const auto take = [&](Index lane) __attribute__((always_inline)) {
          const std::uint16_t* line = table + static_cast<std::size_t>(seeds.line[lane]) * line_size;
          Entries entry = Entries{} + PatchLayer::infinite_entry;
          if (columns == width) {
            load(entry, line);
          } else {
            std::memcpy(&entry, line, columns * sizeof(*line));
          }
          const Masks wide = __builtin_convertvector(entry, Masks);
          Floats sum;
          decode(wide, sum);
          sum += seeds.distance[lane];
          found = ((wide != PatchLayer::infinite_entry) & (sum < found)) ? sum : found;
        };
        // The best seed first: it rules out most of the others.
        Index best = 0;
        while (sums[best] != of_best) ++best;
        if (seeds.distance[best] < unreachable_float) take(best);
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
          load(words, &within);
          Index lane = begin;
          for (std::uint64_t flags : words) {
            flags &= 0x0101010101010101U;
            for (; flags != 0; flags &= flags - 1) {
              const Index at = lane + static_cast<Index>(static_cast<unsigned>(std::countr_zero(flags)) / 8);
              if (seeds.distance[at] < unreachable_float) take(at);
            }
            lane += sizeof(flags);
          }
        }
      });
  std::memcpy(least, &found, size);
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

// ---- Crossings

VOROGEO_CLONES
void crossing_gains(const Crossings& crossings, float lowest, float* gain) {
  float found[Crossings::capacity];
  const auto& [before, after] = crossings.side;
  for (Index k = 0; k < Crossings::capacity; ++k) {
    found[k] = crossing_gain<float>({crossings.source[k],
                                     crossings.target[k],
                                     {{before.source[k], before.target[k], before.length[k]},
                                      {after.source[k], after.target[k], after.length[k]}}},
                                    lowest);
  }
  std::memcpy(gain, found, sizeof(found));
}

}  // namespace vorogeo
