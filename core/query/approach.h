// Distances of one point from the border of its first-layer patch, as far as they are asked for.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "query/graph_route.h"

namespace vorogeo {

/// One end of a route and one of its first-layer patches: lower bounds for the groups of border nodes at
/// once, the distances of a group when it is asked for. One object belongs to one thread.
class Approach {
 public:
  explicit Approach(const IndexData& data) : data_(data) {}

  /// Bounds for all groups; nothing to do if the end is that of the last call. Complexity: O(starts x
  /// groups).
  void start(const RouteEnd& end, Index parent);

  Index parent() const { return parent_; }
  std::span<const GroupRows> groups() const { return data_.approach_bounds.groups[parent_]; }
  /// Groups of the patch whose numbers in the node table follow one another.
  struct Run {
    Index begin;
    Index end;
  };
  std::span<const Run> runs() const { return runs_; }
  /// By group: a lower bound of its least distance; after refine() that distance, or the limit if that is
  /// less.
  std::span<const float> least() const { return least_; }
  /// Fetches what refine() of a group will need first.
  void prefetch(std::size_t group) const;
  /// Finds the distances of the rows of a group, as far as they are below `limit`, unless that was done
  /// before.
  void refine(std::size_t group, float limit);
  /// After refine(): distances of the rows of a group.
  const float* distances(std::size_t group) const { return distance_.data() + groups()[group].row; }
  /// The start over which the distance of a row leads; the row's group must be refined.
  Index start_of(std::size_t group, Index row) const;

 private:
  int in_bounds(float distance, float greatest) const;
  /// A start to begin with: the best by the bounds, unless there are more than their numbers can tell apart.
  std::size_t best_start(std::size_t group) const {
    return static_cast<std::size_t>(std::max<std::int16_t>(0, best_start_[group]));
  }
  void add_start(Index column, double distance, std::size_t place);

  const IndexData& data_;
  Index vertex_ = no_index;  ///< of the end
  Index parent_ = no_index;
  float unit_ = 0.0f;
  float bound_unit_ = 0.0f;
  std::vector<Run> runs_;
  // By start: its lines of the first-layer table and of the bounds, its distance, also as a bound, and its
  // place among the starts of the end.
  std::vector<const std::uint16_t*> line_;
  std::vector<const std::uint8_t*> bounds_;
  std::vector<float> start_distance_;
  std::vector<std::uint8_t> start_bound_;
  std::vector<Index> place_;
  // By group.
  std::vector<std::uint8_t> least_bound_;
  std::vector<std::int16_t> best_start_;
  std::vector<float> least_;
  std::vector<float> refined_;   ///< up to where the distances are known
  std::vector<float> distance_;  ///< by row
  std::vector<const std::uint16_t*> piece_;
  std::vector<float> base_;
};

}  // namespace vorogeo
