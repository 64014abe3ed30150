// Routes between far points, read from the tables: border, first-layer border, the same at the other end.
#pragma once

#include <cstdint>
#include <vector>

#include "route/access_distances.h"
#include "route/graph_route.h"

namespace vorogeo {

/// Reads routes of an index that has a transit table. One object belongs to one thread.
class TableRouter {
 public:
  explicit TableRouter(const IndexData& data) : data_(data), from_(data), to_(data) {}

  /// Writes the shortest route that leaves a first-layer patch of the source and enters one of the target to
  /// `result` if it is shorter than `below`, else leaves that as it was. Whether there is one. For ends in
  /// different first-layer patches it is the shortest of all. Lower bounds for each two groups of border
  /// nodes come first; of the tables of the ends and of the cells of the transit table only those are looked
  /// into that could make a shorter route than the best so far. Complexity: O(k + (b / 8)^2) for k seeds and
  /// b border nodes of such a patch, and 64 for each cell looked into.
  bool route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result, double below = unreachable);
  /// Cells looked into in the last call, for measurements.
  std::size_t cells() const { return cells_; }

 private:
  /// What joins two approaches best: groups and rows at the side of a first-layer patch and at that of one
  /// with the same or a greater number.
  struct Joint {
    float length;
    std::size_t group[2] = {0, 0};
    Index row[2] = {no_index, no_index};
  };
  struct Candidate {
    std::int16_t bound;
    std::int16_t group[2];
  };

  Joint join(AccessDistances& low, AccessDistances& high, float length);
  void look_into(AccessDistances& low, AccessDistances& high, const Candidate& candidate, Joint& best);
  void find_rows(const AccessDistances& low, const AccessDistances& high, Joint& best) const;
  std::int16_t in_bounds(float length) const;
  float rest(const AccessDistances& end, std::size_t group, std::int16_t least) const;

  const IndexData& data_;
  AccessDistances from_;
  AccessDistances to_;
  // Bounds between the borders: the least sum of each group of either side.
  std::vector<std::int16_t> low_least_;
  std::vector<std::int16_t> high_least_;
  std::vector<std::uint8_t> within_;
  std::vector<Candidate> candidates_;
  std::size_t cells_ = 0;
};

}  // namespace vorogeo
