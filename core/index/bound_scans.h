// Scans over lower bounds in small integers: the inner loops that select the table entries that two points
// need.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include "index/table_scale.h"
#include "support/types.h"

namespace vorogeo {

// Bounds of 8 bits, whose sums saturate at 255. `lanes` is a multiple of byte_lanes: that many are read, in
// rows of bounds also beyond their end; a lane that is not used has the base 255.
inline constexpr Index byte_lanes = 32;

/// The least base[lane] + bounds[row_size row + lane] over the lanes, by row; 255 for none.
void least_byte_sums(const std::uint8_t* bounds, Index rows, Index row_size, const std::uint8_t* base,
                     Index lanes, std::uint8_t* least);

/// Seeds of paths through a table of 15 bits (min_plus.h), as lanes: for each, its distance, the same as a
/// bound, and its line in the table. Infinitely far ones are not used.
struct SeedLanes {
  const float* distance;
  const std::uint8_t* bound;
  const Index* line;
  Index lanes;  ///< a multiple of byte_lanes, at most max_lanes
};
inline constexpr Index max_lanes = 512;

/// Relaxes least[0 .. columns) by paths over the lanes that can matter: the lane of the least bound comes
/// first, then those whose bounds[lane] allows less than `limit` and less than the greatest of least[first ..
/// end). `table` is the first of the entries in line 0, `line_size` the length of a line; a bound of 1 stands
/// for the distance bound_unit. \pre columns <= 8
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

}  // namespace vorogeo
