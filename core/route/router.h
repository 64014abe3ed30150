// Shortest routes of an index in either form.
#pragma once

#include <optional>

#include "route/graph_route.h"
#include "route/patch_route.h"
#include "route/table_route.h"

namespace vorogeo {

/// Each kind of search takes its memory when it is first needed. One object belongs to one thread.
class Router {
 public:
  explicit Router(const IndexData& data) : data_(data) {}

  /// The shortest route between two ends; of length unreachable if there is none. In the form of a graph, it
  /// is searched in the graph. In the form of tables, it is read from the tables; if the ends share a
  /// first-layer patch, routes inside that patch are searched as well.
  void route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result);

 private:
  const IndexData& data_;
  std::optional<GraphRouter> graph_;
  std::optional<PatchRouter> patches_;
  std::optional<TableRouter> tables_;
};

}  // namespace vorogeo
