// How finely border edges are split.
#pragma once

#include <vector>

#include "mesh/mesh.h"
#include "partition/partition.h"

namespace vorogeo {

/// Number of pieces of each edge of the mesh: 1 unless it is a border edge that is long for the patches
/// beside it. How long an edge may be follows from the mean angle defect of the mesh: the stronger paths bend
/// at its vertices, the less the distances at both ends of an edge tell of those between; near a saddle
/// vertex, pieces are shorter (near_saddles.h). Where tables would become too large, edges may be longer.
/// Complexity: O(edges).
std::vector<Index> pieces_of_edges(const Mesh& mesh, const Partition& partition);

/// About how many entries tables would have, as a multiple of the most they should have, if all border edges
/// were as short as the shape of the mesh asks for. Complexity: O(edges).
double wanted_entries(const Mesh& mesh, const Partition& partition);

/// The same with border edges as long as they may be.
double least_entries(const Mesh& mesh, const Partition& partition);

}  // namespace vorogeo
