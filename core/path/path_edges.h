// The shortest path along edges.
#pragma once

#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

/// An edge on the path: the vertex it leaves, and an adjacent face.
struct EdgeStep {
  Index face;
  Index from;
};

/// Adds the shortest path along edges from one vertex to another (Hart, Nilsson, Raphael 1968); meant for
/// short paths. \return false if there is none. Complexity: O(n log n) for the n vertices visited.
bool path_along_edges(const Mesh& mesh, Index start, Index goal, std::vector<EdgeStep>& path);

}  // namespace vorogeo
