// Routes inside first-layer patches, from second-layer patch to second-layer patch.
#pragma once

#include <cstdint>
#include <vector>

#include "query/route.h"

namespace vorogeo {

/// Searches the second-layer tables of an index. A step scans a whole patch: it finds the least sums from the
/// border nodes that were relaxed since the patch's last scan to all others, 32 at a time. The straight line
/// to the target in space is the lower bound (A*): it excludes nodes and selects the patch to scan next. One
/// object belongs to one thread; a search resets it in O(1).
class PatchRouter {
 public:
  explicit PatchRouter(const IndexData& data);

  /// Replaces a route by the shortest one inside the first-layer patches of the ends, if that is shorter. Of
  /// routes whose lengths differ only by rounding of table entries, any may be found.
  void route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result);

 private:
  struct NodeState {
    std::uint32_t stamp = 0;
    float distance = 0.0f;     ///< from the source
    float to_target = 0.0f;    ///< for seeds of the target: distance from it
    float lower_bound = 0.0f;  ///< lower bound of the distance to the target
    Index predecessor = 0;     ///< node; no_index for a seed of the source
    Index patch = 0;           ///< second-layer patch through which it was reached
  };
  struct PatchState {
    bool waits = false;
    float key = 0.0f;         ///< least sum of distance and lower bound over the rows that wait
    std::vector<Index> rows;  ///< that wait for the next scan
  };
  void reset(const RouteEnd& source, const RouteEnd& target);
  NodeState& touch(Index node);
  void relax(Index node, float distance, Index predecessor, Index patch);
  void wait(Index patch, Index row, float key);
  void scan_patch(Index patch);
  void write(GraphRoute& result) const;

  const IndexData& data_;
  std::vector<NodeState> node_;
  std::vector<PatchState> patch_;
  std::vector<std::uint32_t> parent_open_;
  std::vector<std::uint8_t> row_waits_;  ///< by second.slot(patch, row)
  std::vector<Index> waiting_;           ///< patches
  std::uint32_t stamp_ = 0;
  Index target_vertex_ = no_index;
  /// Distances of the target from the landmarks: with a metric, straight lines in space are poor bounds.
  Landmarks::Row target_landmarks_{};
  float best_ = 0.0f;
  Index meeting_ = no_index;
  std::vector<Index> rows_;
};

}  // namespace vorogeo
