// The index type, and the values for "none" and "unreachable", of every module of the core.
#pragma once

#include <cstdint>
#include <limits>

namespace vorogeo {

/// Index of a vertex, edge, half-edge, face or patch; negative means "none".
using Index = std::int32_t;

inline constexpr Index no_index = -1;

/// Distance of a point that no path reaches.
inline constexpr double unreachable = std::numeric_limits<double>::infinity();
/// The same in the precision of searches and tables.
inline constexpr float unreachable_float = std::numeric_limits<float>::infinity();

}  // namespace vorogeo
