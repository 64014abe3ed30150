// From a route to a chain of second-layer border vertices, each in a patch of the previous one.
#pragma once

#include <vector>

#include "route/graph_route.h"

namespace vorogeo {

/// A step of a chain: to `vertex` (work mesh) through the second-layer patch `patch`. A step that begins or
/// ends at a border vertex of the patch can be followed by that vertex's distances in the patch.
struct ChainStep {
  Index vertex;
  Index patch;
};

/// A shortest path through the tables: the source, then a step for each second-layer patch passed.
struct PathChain {
  Index source = no_index;
  std::vector<ChainStep> steps;
};

/// Resolves a route between two work vertices into second-layer steps: a leg by the transit table into steps
/// between first-layer nodes of one first-layer patch, each of these into steps between second-layer nodes of
/// one second-layer patch. In each layer the predecessor is a node with the least sum. Complexity: O(b) for
/// each step, with b border nodes of the patches at its end. `source_patch`, `target_patch`: second-layer
/// patches that the route's first and last node share with the ends, for ends that may lie on a border;
/// no_index for the patches of vertices inside one.
PathChain chain_of_route(const IndexData& data, const GraphRoute& route, Index source, Index target,
                         Index source_patch = no_index, Index target_patch = no_index);

}  // namespace vorogeo
