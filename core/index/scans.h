// Least sums over rows and tiles of tables, compiled for several instruction sets.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include "index/patch_layer.h"
#include "index/unfolding.h"
#include "support/types.h"

namespace vorogeo {

// ---- A min-plus scan for searches that are run side by side, compiled for several instruction sets

/// Searches that are run side by side, each in a *lane*: the numbers of all lanes for one node are
/// consecutive.
inline constexpr Index lane_count = 16;

/// For each lane: least = min(least, base[lane_count i + lane] + distance(entries[i])) over i in [0, count),
/// with best = first_name + i where that lowers it. distance() is that of the scale; an entry of 32767 stands
/// for an infinite distance.
void relax_lanes(const std::uint16_t* entries, TableScale scale, Index count, const float* base,
                 Index first_name, float* least, Index* best);

// ---- Min-plus scans: the inner loops of tables, compiled for several instruction sets and chosen at run
// time

/// Bases of 16-bit sums: the least distance has lowest_base; a least sum above greatest_least means none.
inline constexpr float lowest_base = -32768.0f;
inline constexpr std::int16_t greatest_least = -2;

/// First i in [begin, count) with base + line[i] < distance[i]; count for none.
Index first_lower(const float* line, double base, const double* distance, Index begin, Index count);

// distance() is that of the scale.

// Tables of 15 bits: an entry of 32767 stands for an infinite distance. A *base* is at most 0, so that sums
// fit int16_t; -32768 is the least distance, and a sum of -1 or more means none.

struct IndexRange {
  Index begin;
  Index end;
};

/// The smallest range that has all i in [0, count) with base[i] + distance(entries[i]) <= bound; here an
/// infinite entry counts as its number.
IndexRange range_within(const float* base, const std::uint16_t* entries, TableScale scale, float bound,
                        Index count);

/// distances[i] = distance(entries[i]), or infinity.
void scale_entries(const std::uint16_t* entries, Index count, TableScale scale, float* distances);

/// least[i] = min(least[i], base + line[i]).
void relax_by_sums(const float* line, float base, Index count, float* least);

/// least[i] = min(least[i], base + distance(entries[i])), with best[i] = name where that lowers it.
void relax_by_line(const std::uint16_t* entries, TableScale scale, float base, Index name, Index count,
                   float* least, Index* best);

/// Least base[i] + entries[i] for i in [0, count); 32767 for none.
std::int16_t least_entry_sum(const std::int16_t* base, const std::uint16_t* entries, Index count);

/// First i with base[i] + entries[i] == sum; no_index for none.
Index first_entry_sum(const std::int16_t* base, const std::uint16_t* entries, Index count, std::int16_t sum);

/// For each of 32 columns: the least base[row] + tile[32 row + column] for row in [0, rows), and the first
/// row that has it.
void least_tile_sums(const std::int16_t* base, const std::uint16_t* tile, Index rows, std::int16_t* least,
                     std::int16_t* best);

// Cells of the transit table: 16 bits, of which 65535 stands for an infinite distance; row by row.

/// For each column: least = min(least, base[row] + offset + distance(cell[columns row + column])) over the
/// rows, with best = first_name + row where that lowers it. Returns the greatest of `least`.
float relax_by_cell(const std::uint16_t* cell, Index rows, Index columns, const float* base, float offset,
                    TableScale scale, Index first_name, float* least, Index* best);

/// Least from[row] + distance(cell[columns row + column]) + to[column]; infinity for none.
float least_in_cell(const std::uint16_t* cell, Index rows, Index columns, const float* from, const float* to,
                    TableScale scale);

// ---- Scans over lower bounds in small integers: the inner loops that select the table entries that two
// points need

// Bounds of 8 bits, whose sums saturate at 255. `lanes` is a multiple of byte_lanes: so many are read, also
// beyond the end of a row of bounds; an unused lane has the base 255.
inline constexpr Index byte_lanes = 32;

/// The least base[lane] + bounds[row_size row + lane] over the lanes, by row; 255 for none.
void least_byte_sums(const std::uint8_t* bounds, Index rows, Index row_size, const std::uint8_t* base,
                     Index lanes, std::uint8_t* least);

/// Seeds of paths through a table of 15 bits, as lanes: for each, its distance, the same as a bound, and its
/// line in the table. Infinitely far seeds are not used.
struct SeedLanes {
  const float* distance;
  const std::uint8_t* bound;
  const Index* line;
  Index lanes;  ///< a multiple of byte_lanes, at most max_lanes
};
inline constexpr Index max_lanes = 512;

/// Relaxes least[0 .. columns) by paths over the lanes that can matter: the lane of the least bound comes
/// first, then those whose sum of bounds exceeds neither `limit` nor the greatest of least[first .. end).
/// `table` is the first of the entries in line 0, `line_size` the length of a line; a bound of 1 stands for
/// the distance bound_unit. \pre columns <= 8
void relax_within(const SeedLanes& seeds, const std::uint8_t* bounds, const std::uint16_t* table,
                  Index line_size, TableScale scale, float bound_unit, float limit, Index columns,
                  Index first, Index end, float* least);

/// Which lanes have base[lane] + bounds[lane] <= limit: 1 or 0, by lane.
void byte_sums_within(const std::uint8_t* bounds, const std::uint8_t* base, Index lanes, std::uint8_t limit,
                      std::uint8_t* within);

// Bounds of 15 bits, of which three must not sum up to more than 32767. `columns` is a multiple of
// short_lanes.
inline constexpr Index short_lanes = 16;

/// For the sums base[row] + between[columns row + column] + column_base[column]: the least of each row and of
/// each column. \pre rows > 0
void least_short_sums(const std::int16_t* base, const std::int16_t* between, const std::int16_t* column_base,
                      Index rows, Index columns, std::int16_t* row_least, std::int16_t* column_least);

/// Which columns have between[column] + column_base[column] <= limit: 1 or 0, by column.
void short_sums_within(const std::int16_t* between, const std::int16_t* column_base, Index columns,
                       std::int16_t limit, std::uint8_t* within);

/// Calls visit(lane) for each lane whose flag, 1 or 0 as written by the scans above, is set. `lanes` is a
/// multiple of eight.
template <class Visit>
void for_each_flag(const std::uint8_t* flags, Index lanes, Visit&& visit) {
  for (Index begin = 0; begin < lanes; begin += static_cast<Index>(sizeof(std::uint64_t))) {
    std::uint64_t word;
    std::memcpy(&word, flags + begin, sizeof(word));
    for (; word != 0; word &= word - 1) visit(begin + std::countr_zero(word) / 8);
  }
}

// ---- Many crossings at once, in single precision

/// Crossings, as a structure of arrays. Distances of the source are relative to `lowest`, so that those of a
/// far source keep their digits.
struct Crossings {
  static constexpr Index capacity = 32;
  float source[capacity];
  float target[capacity];
  struct Side {
    float source[capacity];
    float target[capacity];
    float length[capacity];
  } side[2];

  void set(Index k, const Crossing<float>& crossing) {
    source[k] = crossing.source;
    target[k] = crossing.target;
    for (int s : {0, 1}) {
      side[s].source[k] = crossing.side[s].source;
      side[s].target[k] = crossing.side[s].target;
      side[s].length[k] = crossing.side[s].length;
    }
  }
  BorderSample<float> beside(Index k, int s) const {
    return {side[s].source[k], side[s].target[k], side[s].length[k]};
  }
};

/// Finds crossing_gain() of each.
void crossing_gains(const Crossings& crossings, float lowest, float* gain);

}  // namespace vorogeo
