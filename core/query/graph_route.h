// Routes between far points through the pruned graph: bidirectional A* with landmarks.
#pragma once

#include <cstdint>
#include <vector>

#include "query/route.h"

namespace vorogeo {

/// Searches the graph of one index, from the access distances of both ends. One object belongs to one thread;
/// a search resets it in O(1).
///
/// The potential of a node is half the difference of the landmark bounds to the two ends, which is consistent
/// for both directions (Ikeda et al. 1994); the search stops when the two least keys sum to at least the
/// length of the best route found, which then is a shortest one (Goldberg, Harrelson 2005).
class GraphRouter {
 public:
  explicit GraphRouter(const IndexData& data) : data_(data), state_(data.first.node_count()) {}

  /// Replaces a route by the shortest one that leaves a first-layer patch of the source and enters one of the
  /// target, if that is shorter. For ends in different first-layer patches it is the shortest of all.
  void route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result);

 private:
  /// A path from an end through one of its seeds to a node on the border of its first-layer patch.
  struct Access {
    Index node;
    double distance;
    Index seed;  ///< second-layer node
    Index parent;
  };
  struct NodeState {
    std::uint32_t stamp = 0;
    double distance[2];
    double potential;
    Index predecessor[2];
    Index by[2];  ///< patch of the arc from the predecessor; without one, index into access_
    bool done[2];
  };
  struct Entry {
    double key;
    Index node;
    bool operator<(const Entry& other) const { return key > other.key; }
  };

  void find_accesses(int side, const RouteEnd& end);
  NodeState& touch(Index node);
  void relax(int side, Index node, double distance, Index predecessor, Index by);
  void settle(int side);
  void write(GraphRoute& result) const;

  const IndexData& data_;
  std::vector<NodeState> state_;
  std::uint32_t stamp_ = 0;
  std::vector<Entry> heap_[2];
  std::vector<Access> access_[2];
  Landmarks::Row end_landmarks_[2];
  double best_ = unreachable;
  Index meeting_ = no_index;
  std::vector<float> least_;  ///< access distances, by row
  std::vector<Index> seed_;
};

}  // namespace vorogeo
