// A min-plus scan for searches that are run side by side, compiled for several instruction sets.
#pragma once

#include <cstdint>

#include "index/table_scale.h"
#include "support/types.h"

namespace vorogeo {

/// Searches that are run side by side, each in a *lane*: numbers of one place for all of them are
/// consecutive.
inline constexpr Index lane_count = 16;

/// For each lane: least = min(least, base[lane_count i + lane] + distance(entries[i])) over i in [0, count),
/// with best = first_name + i where that lowers it. distance() is that of the scale; an entry of 32767 stands
/// for an infinite distance.
void relax_lanes(const std::uint16_t* entries, TableScale scale, Index count, const float* base,
                 Index first_name, float* least, Index* best);

}  // namespace vorogeo
