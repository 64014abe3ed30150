// T-junctions: vertices that lie inside a border edge of a face to which they do not belong.
#pragma once

#include <array>

#include "mesh/mesh.h"

namespace vorogeo {

/// A gap without width: one side of it is split at a vertex, the other is not, so no path crosses it.
struct TJunctions {
  Index count = 0;                                      ///< vertices inside a border edge
  Index first = no_index;                               ///< the first of them
  std::array<Index, 2> first_edge{no_index, no_index};  ///< ends of the edge it lies in
};

/// Vertices count as inside an edge if their distance from it is what rounding to single precision explains.
/// Edge lengths must be within exact_lengths. Complexity: O(b log b) for b border edges.
TJunctions find_t_junctions(const Mesh& mesh);

}  // namespace vorogeo
