// The shortest way over edges.
#pragma once

#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

/// An edge on the way: the vertex it leaves, and a face beside it.
struct EdgeStep {
  Index face;
  Index from;
};

/// Adds the shortest way over edges from one vertex to another (Hart, Nilsson, Raphael 1968); meant for short
/// ones. \return false if there is none. Complexity: O(n log n) for the n vertices looked at.
bool path_along_edges(const Mesh& mesh, Index start, Index goal, std::vector<EdgeStep>& way);

}  // namespace vorogeo
