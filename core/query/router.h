// Shortest routes of an index in either form.
#pragma once

#include "query/graph_route.h"
#include "query/patch_route.h"
#include "query/table_route.h"

namespace vorogeo {

/// One object belongs to one thread.
class Router {
 public:
  explicit Router(const IndexData& data) : data_(data), graph_(data), patches_(data), tables_(data) {}

  /// The shortest route between two ends; of length unreachable if there is none. In the form of a graph it
  /// is searched there. In the form of tables it is read from them; for ends with a first-layer patch in
  /// common those that stay in it are searched as well.
  void route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result);

 private:
  const IndexData& data_;
  GraphRouter graph_;
  PatchRouter patches_;
  TableRouter tables_;
};

}  // namespace vorogeo
