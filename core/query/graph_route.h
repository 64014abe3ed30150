// Shortest routes in the two-layer graph: bidirectional A* with landmarks.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "index/index_data.h"

namespace vorogeo {

/// One end of a route: second-layer nodes with their distances from it, and the patch on whose border these
/// lie.
struct RouteEnd {
  struct Seed {
    Index node;
    double distance;
  };
  Index vertex = no_index;  ///< of the work mesh; no_index: not known
  std::vector<Seed> seeds;
  Index patch = no_index;      ///< second-layer patch of the seeds; no_index if the end is itself a node
  std::vector<Index> parents;  ///< first-layer patches whose second-layer arcs may be used
};

/// Makes `end` the end of a route at a work vertex.
void route_end(const IndexData& data, Index work_vertex, RouteEnd& end);

/// Prefetches what route_end will read.
void prefetch_end(const IndexData& data, Index work_vertex);

/// Distances from the landmarks of the index.
using LandmarkDistances = std::array<double, SearchGraph::landmark_count>;
LandmarkDistances landmark_distances(const IndexData& data, const RouteEnd& end);

/// A lower bound of the distance between an end and a second-layer node.
inline double landmark_bound(const IndexData& data, const LandmarkDistances& end, Index node) {
  const double* landmark = data.graph.landmarks(node);
  double bound = 0.0;
  for (std::size_t l = 0; l < end.size(); ++l) bound = std::max(bound, std::abs(landmark[l] - end[l]));
  return bound;
}

/// A shortest route: second-layer nodes in order, the leg between consecutive ones, and the whole length.
struct GraphRoute {
  double length = unreachable;
  std::vector<Index> nodes;
  std::vector<Leg> legs;  ///< one fewer than nodes
};

/// Searches the graph of one index. Second-layer arcs are used only near the ends (in their first-layer
/// patches), first-layer arcs everywhere. One object belongs to one thread; a search resets it in O(1).
///
/// The potential of a node is half the difference of the landmark bounds to the two ends, which is consistent
/// for both directions (Ikeda et al. 1994); the search stops when the two least keys sum to at least the
/// length of the best route found, which then is a shortest one (Goldberg, Harrelson 2005).
class GraphRouter {
 public:
  explicit GraphRouter(const IndexData& data);
  /// The shortest route, of length unreachable if there is none. Each first-layer arc is replaced by a path
  /// of second-layer arcs, as there are no first-layer tables. \return whether there is a route.
  bool route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result);
  /// The same with first-layer arcs left as they are.
  bool search(const RouteEnd& source, const RouteEnd& target, GraphRoute& result);

 private:
  struct NodeState {
    std::uint32_t stamp = 0;
    double distance[2];
    double potential;
    Index predecessor[2];
    Leg leg[2];
    bool done[2];
  };
  struct Entry {
    double key;
    Index node;
    bool operator<(const Entry& other) const { return key > other.key; }
  };

  NodeState& touch(Index node);
  void relax(int side, Index node, double distance, Index predecessor, Leg leg);
  void settle(int side);
  void append_path(Index from, Index to, GraphRoute& route);

  const IndexData& data_;
  std::vector<NodeState> state_;
  std::vector<std::uint32_t> parent_open_;
  std::uint32_t stamp_ = 0;
  std::vector<Entry> heap_[2];
  LandmarkDistances end_landmarks_[2];
  double best_ = unreachable;
  Index meeting_ = no_index;
  bool first_layer_ = true;  ///< whether first-layer arcs are used
};

}  // namespace vorogeo
