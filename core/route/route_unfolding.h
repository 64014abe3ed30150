// A better length for a route: each patch border that it crosses is unfolded at the crossing.
#pragma once

#include <vector>

#include "route/graph_route.h"

namespace vorogeo {

/// Walks routes of one index. Holds scratch memory: one object belongs to one thread.
class RouteUnfolder {
 public:
  explicit RouteUnfolder(const IndexData& data) : data_(data) {}

  /// Length of the path along a route from source to target (work vertices) that crosses each border anywhere
  /// on the border edges at the route's node instead of at the node itself. At each crossing, distances are
  /// kept for the node and its border neighbours; they belong to the same wave, so no guard is needed.
  /// Complexity: O(nodes of the route). `source_patch`, `target_patch`: second-layer patches that the route's
  /// first and last node share with these vertices, for ends that may lie on a border; no_index for the
  /// patches of vertices inside one.
  double length(const GraphRoute& route, Index source, Index target, Index source_patch = no_index,
                Index target_patch = no_index);

  /// A border node near the route: the route's own node first, then its border neighbours.
  struct Near {
    Index vertex;
    double distance;  ///< from the source
    double length;    ///< of the border edge to the route's own node
  };
  /// A leg of the route and where it ends; two legs in a row through one patch are one.
  struct Stage {
    Leg leg;
    Index exit_vertex;  ///< where the route leaves it; the target at last
  };

 private:
  const IndexData& data_;
  std::vector<Stage> stages_;
  std::vector<Near> near_;
  std::vector<Near> next_;
};

}  // namespace vorogeo
