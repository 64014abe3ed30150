// The shortest route of two points by whatever tables there are, and its length with borders unfolded.
#pragma once

#include <optional>
#include <vector>

#include "query/graph_route.h"
#include "query/patch_route.h"
#include "query/table_route.h"

namespace vorogeo {

// ---- A better length for a route: each patch border that it crosses is unfolded at the crossing

/// Walks routes of one index. Holds scratch memory: one object belongs to one thread.
class RouteUnfolder {
 public:
  explicit RouteUnfolder(const IndexData& data) : data_(data) {}

  /// Length of the path along a route from source to target that crosses each border anywhere on the border
  /// edges at the route's node instead of at the node itself. At each crossing, distances are kept for the
  /// node and its border neighbours; they belong to the same wave, so their predecessors need no check.
  /// Complexity: O(nodes of the route).
  double length(const GraphRoute& route, const RoutedPlace& source, const RoutedPlace& target);

  /// A border node near the route: the route's own node first, then its border neighbours.
  struct Near {
    Index vertex;
    double distance;  ///< from the source
    double length;    ///< of the border edge to the route's own node
  };

 private:
  const IndexData& data_;
  std::vector<Stage> stages_;
  std::vector<Near> near_;
  std::vector<Near> next_;
};

// ---- Shortest routes of an index in either form

/// Each kind of search takes its memory when it is first needed. One object belongs to one thread.
class Router {
 public:
  explicit Router(const IndexData& data) : data_(data) {}

  /// The shortest route between two ends; of length unreachable if there is none. Between borders of the
  /// first layer it is read from the transit table, or searched in the graph that stands for it; if the ends
  /// share a first-layer patch, routes inside that patch are searched as well.
  void route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result);

 private:
  const IndexData& data_;
  std::optional<GraphRouter> graph_;
  std::optional<PatchRouter> patches_;
  std::optional<TableRouter> tables_;
};

}  // namespace vorogeo
