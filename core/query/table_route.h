// Routes between far points, read from the tables: border, first-layer border, the same at the other end.
#pragma once

#include <vector>

#include "query/graph_route.h"

namespace vorogeo {

/// Reads routes of an index that has a node table. One object belongs to one thread.
class TableRouter {
 public:
  explicit TableRouter(const IndexData& data);

  /// The shortest route that leaves a first-layer patch of the source and enters one of the target: for ends
  /// in different first-layer patches, the shortest of all. Complexity: O(b^2) for b border nodes of such a
  /// patch.
  GraphRoute route(const RouteEnd& source, const RouteEnd& target);

 private:
  /// Distances of an end from the border nodes of one of its first-layer patches.
  struct Approach {
    Index parent = no_index;
    std::vector<float> distance;  ///< by row
    std::vector<Index> start;     ///< which start of the end, by row
  };

  void approach(const RouteEnd& end, Index parent, Approach& result) const;

  const IndexData& data_;
  std::vector<std::vector<NodeRange>> ranges_;  ///< by first-layer patch
  Approach from_;
  Approach to_;
};

}  // namespace vorogeo
