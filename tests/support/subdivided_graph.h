// A slow reference for geodesic distances: a graph over points on edges. Shares no code with the core.
#pragma once

#include <vector>

#include "support/hostile_parts.h"
#include "support/shapes.h"

namespace vorogeo::test {

/// Distances from one vertex in the graph of all vertices and of points on all edges, joined by straight
/// segments inside faces (Lanthier, Maheshwari, Sack 1997). Each is the length of a path over the surface, so
/// no geodesic distance is longer; with more points they converge.
///
/// Works on the soup alone, in space. Points lie evenly on an edge, and ever closer towards the ends of edges
/// that are long for the mesh.
class SubdividedGraph {
 public:
  /// Complexity: O(e k d log) for e edges with k points and d faces at each.
  SubdividedGraph(const Soup& soup, Index source, int points_per_edge);

  /// Infinite if no path leads there.
  double upper_bound(Index target) const { return free_.distance[target]; }
  /// A better bound: the path to the target pulled tight across the edges that it crosses.
  double tightened(Index target) const;

 private:
  /// A vertex (`to` is then the same), or the point at the fraction `t` between two vertices.
  struct Node {
    Index from;
    Index to;
    double t;
    double spacing;  ///< to the next points on its edge, as a fraction of the edge
  };
  Point at(const Node& node, double t) const;
  void add_nodes(const Soup& soup, int points_per_edge);
  struct Paths {
    std::vector<double> distance;
    std::vector<Index> predecessor;
  };
  Paths search(Index source, bool through_vertices) const;
  double tightened(const Paths& paths, Index target) const;

  std::vector<Point> positions_;  ///< relative to the source
  std::vector<Node> nodes_;       ///< vertices first
  std::vector<Point> places_;
  std::vector<std::vector<Index>> nodes_of_face_;
  std::vector<std::vector<Index>> faces_of_node_;
  Paths free_;      ///< shortest in the graph
  Paths crossing_;  ///< shortest of those that pass no vertex
};

}  // namespace vorogeo::test
