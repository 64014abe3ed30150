// Routes between far points, read from the tables: through the patch border and the first-layer border at
// either end.
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
  /// `result` if it is shorter than `below`, otherwise leaves `result` unchanged. \return whether it is
  /// shorter. For ends in different first-layer patches it is the shortest of all. Lower bounds for all pairs
  /// of groups of border nodes come first; of the tables at the ends and the cells of the transit table, only
  /// those are examined that could give a shorter route than the best so far. Complexity: O(k + (b / 8)^2)
  /// for k seeds and b border nodes of such a patch, and 64 for each cell examined.
  bool route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result, double below = unreachable);
  /// Cells examined in the last call, for measurements.
  std::size_t cells() const { return cells_; }

 private:
  /// The best connection of two ends: group and row on the side of the first-layer patch with the smaller
  /// number, then on the other side.
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
  // Least sum of bounds, by group, on either side.
  std::vector<std::int16_t> low_least_;
  std::vector<std::int16_t> high_least_;
  std::vector<std::uint8_t> within_;
  std::vector<Candidate> candidates_;
  std::size_t cells_ = 0;
};

}  // namespace vorogeo
