// Min-plus scans: the inner loops of tables, compiled for several instruction sets and chosen at run time.
#pragma once

#include <cstdint>

#include "index/table_scale.h"
#include "support/types.h"

namespace vorogeo {

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
/// infinite entry is treated as its number.
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

/// The same for the rows rows[0 .. count) only; base[i] is that of rows[i], and `best` holds positions in
/// `rows`.
void least_tile_sums_of(const std::int16_t* base, const Index* rows, Index count, const std::uint16_t* tile,
                        std::int16_t* least, std::int16_t* best);

// Cells of the transit table: 16 bits, of which 65535 stands for an infinite distance; row by row.

/// For each column: least = min(least, base[row] + offset + distance(cell[columns row + column])) over the
/// rows, with best = first_name + row where that lowers it. Returns the greatest of `least`.
float relax_by_cell(const std::uint16_t* cell, Index rows, Index columns, const float* base, float offset,
                    TableScale scale, Index first_name, float* least, Index* best);

/// Least from[row] + distance(cell[columns row + column]) + to[column]; infinity for none.
float least_in_cell(const std::uint16_t* cell, Index rows, Index columns, const float* from, const float* to,
                    TableScale scale);

}  // namespace vorogeo
