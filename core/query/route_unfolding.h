// A better length for a route of the graph: each border it crosses is unfolded around the crossing.
#pragma once

#include "query/graph_route.h"

namespace vorogeo {

/// Length of the way along a route from source to target (work vertices), crossing each border anywhere on
/// the border edges at the route's node instead of at the node. Near a node, distances are kept for the node
/// and its border neighbours; they come from the same wave, so no guard is needed. Complexity: O(nodes of the
/// route).
double unfolded_length(const IndexData& data, const GraphRoute& route, Index source, Index target);

}  // namespace vorogeo
