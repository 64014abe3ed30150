// The shortest path along edges.
#pragma once

#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

/// An edge on the path, as the half-edge of an adjacent face, and the vertex it leaves: its tail or its head.
struct EdgeStep {
  Index halfedge;
  Index from;
};

/// Adds the shortest path along edges from one vertex to another (Hart, Nilsson, Raphael 1968); meant for
/// short paths. \return false if there is none. Complexity: O(n log n) for the n vertices visited.
bool path_along_edges(const Mesh& mesh, Index start, Index goal, std::vector<EdgeStep>& path);

}  // namespace vorogeo
