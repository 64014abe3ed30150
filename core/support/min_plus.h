// Min-plus scans: the inner loops of tables, compiled for several instruction sets and chosen at run time.
#pragma once

#include <cstdint>

#include "support/types.h"

namespace vorogeo {

/// Least a[i] + b[i] for i in [0, count); infinity for none.
float least_sum(const float* a, const float* b, Index count);

/// First i with a[i] + b[i] <= bound; no_index for none.
Index first_within(const float* a, const float* b, Index count, float bound);

/// First i in [begin, count) with base + line[i] < distance[i]; count for none.
Index first_lower(const float* line, double base, const double* distance, Index begin, Index count);

/// least[i] = min(least[i], base + line[i]); where that is lower, best[i] = name.
void lower_by_line(const float* line, float base, Index name, Index count, float* least, Index* best);

// Tables of 15 bits: an entry of 32767 stands for an infinite distance. A *base* is at most 0, so that sums
// are int16_t; -32768 is the least distance, and a sum of -1 or more stands for none.

/// distances[i] = unit * entries[i], or infinity.
void scale_entries(const std::uint16_t* entries, Index count, float unit, float* distances);

/// lower_by_line for the line unit * entries[i].
void lower_by_entries(const std::uint16_t* entries, float unit, float base, Index name, Index count,
                      float* least, Index* best);

/// Least base[i] + entries[i] for i in [0, count); 32767 for none.
std::int16_t least_entry_sum(const std::int16_t* base, const std::uint16_t* entries, Index count);

/// First i with base[i] + entries[i] == sum; no_index for none.
Index first_entry_sum(const std::int16_t* base, const std::uint16_t* entries, Index count, std::int16_t sum);

/// For each of 32 columns: the least base[row] + tile[32 row + column] for row in [0, rows), and the first
/// row that has it.
void least_tile_sums(const std::int16_t* base, const std::uint16_t* tile, Index rows, std::int16_t* least,
                     std::int16_t* best);

}  // namespace vorogeo
