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
  /// in different first-layer patches, the shortest of all. Of the cells of the node table between the two
  /// borders only those are looked into whose least distance could make a shorter route. Complexity: O(k b +
  /// (b / 8)^2) for k starts and b border nodes of such a patch, and 64 for each cell looked into.
  void route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result);

 private:
  /// A group of the node table, as rows of a first-layer patch.
  struct GroupRows {
    Index group;
    Index row;  ///< of its first node
  };
  /// Distances of an end from the border nodes of one of its first-layer patches.
  struct Approach {
    Index parent = no_index;
    std::vector<float> distance;  ///< by row
    std::vector<float> least;     ///< by group of the patch
  };
  /// What joins two approaches best.
  struct Joint {
    float length;
    Index source_row = no_index;
    Index target_row = no_index;
  };

  void approach(const RouteEnd& end, Index parent, Approach& result) const;
  Joint join(float length);
  void look_into(std::size_t from, std::size_t to, Joint& best) const;
  const RouteEnd::Start& start_of(const RouteEnd& end, Index parent, Index row) const;
  Index column_of(const RouteEnd::Start& start, Index parent) const;

  const IndexData& data_;
  std::vector<std::vector<GroupRows>> groups_;  ///< by first-layer patch
  Approach from_;
  Approach to_;
  std::vector<float> bounds_;
};

}  // namespace vorogeo
