// Routes between far points, read from the tables: border, first-layer border, the same at the other end.
#pragma once

#include <vector>

#include "query/approach.h"
#include "query/graph_route.h"

namespace vorogeo {

/// Reads routes of an index that has a node table. One object belongs to one thread.
class TableRouter {
 public:
  explicit TableRouter(const IndexData& data) : data_(data), from_(data), to_(data) {}

  /// Writes the shortest route that leaves a first-layer patch of the source and enters one of the target to
  /// `result` if it is shorter than `below`, else leaves that as it was. Whether there is one. For ends in
  /// different first-layer patches it is the shortest of all. Lower bounds for each two groups of border
  /// nodes come first; of the tables of the ends and of the cells of the node table only those are looked
  /// into that could make a shorter route than the best so far. Complexity: O(k + (b / 8)^2) for k starts and
  /// b border nodes of such a patch, and 64 for each cell looked into.
  bool route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result, double below = unreachable);
  /// Cells looked into in the last call, for measurements.
  std::size_t cells() const { return cells_; }

 private:
  /// What joins two approaches best.
  struct Joint {
    float length;
    std::size_t source_group = 0;
    std::size_t target_group = 0;
    Index source_row = no_index;
    Index target_row = no_index;
  };
  struct Candidate {
    float bound;
    Index source_group;
    Index target_group;
  };

  Joint join(float length);
  void look_into(const Candidate& candidate, Joint& best);

  const IndexData& data_;
  Approach from_;
  Approach to_;
  std::vector<float> sums_;
  std::vector<float> row_least_;  ///< least of the sums, by group of the source
  std::vector<float> rest_of_source_;
  std::vector<float> rest_of_target_;
  std::vector<Candidate> candidates_;
  std::size_t cells_ = 0;
};

}  // namespace vorogeo
