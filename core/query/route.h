// A route between two points by the tables of an index, and the two ends that it joins.
#pragma once

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
  Index vertex = no_index;  ///< of the inner surface; no_index: not known
  std::vector<Seed> seeds;
  Index patch = no_index;      ///< second-layer patch of the seeds; no_index if the end is itself a node
  std::vector<Index> parents;  ///< first-layer patches that it lies in
};

/// Makes `end` the end of a route at a place.
void route_end(const IndexData& data, Index place, RouteEnd& end);

/// Prefetches what route_end will read.
void prefetch_end(const IndexData& data, Index place);

/// One leg of a route: by the table of a patch, or by the transit table.
struct Leg {
  enum class Table : std::uint8_t { second, first, transit };
  Table table = Table::transit;
  Index patch = no_index;  ///< in the layer of the table
  bool operator==(const Leg&) const = default;
};

/// A shortest route: second-layer nodes in order, the leg between consecutive ones, and the whole length.
struct GraphRoute {
  double length = unreachable;
  std::vector<Index> nodes;
  std::vector<Leg> legs;  ///< one fewer than nodes

  /// Goes on to a node, unless the route is there already.
  void go_on(Leg leg, Index node) {
    if (nodes.back() == node) return;
    legs.push_back(leg);
    nodes.push_back(node);
  }
};

/// Where a route between places begins or ends.
struct RoutedPlace {
  Index place;
  /// Second-layer patch that it shares with the first or last node, if it may lie on a border; no_index for
  /// the patch of a place inside one.
  Index patch = no_index;
};

/// A part of a route between places: the table of a leg, and where it ends. Two legs in a row through one
/// patch are one.
struct Stage {
  Leg leg;
  Index exit;  ///< place
};

/// Finds the stages of a whole route, with those through the patches of its ends; none if it has no node.
void find_stages(const IndexData& data, const GraphRoute& route, const RoutedPlace& source,
                 const RoutedPlace& target, std::vector<Stage>& stages);

}  // namespace vorogeo
