// The small form of the transit table, a pruned graph over the border nodes of the first layer; and
// landmarks.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "index/patch_layer.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Lower bounds of distances by the triangle inequality

inline constexpr int landmark_count = 8;

/// Distances of all nodes from a few of them, which lie far from one another.
struct Landmarks {
  using Row = std::array<double, landmark_count>;
  std::vector<Row> row;  ///< by node; 0 for a landmark that does not reach it

  /// The distances of a place from the landmarks, if all paths from it lead through these seeds.
  template <class Seeds>
  Row through(const Seeds& seeds) const {
    Row least;
    least.fill(unreachable);
    for (const auto& seed : seeds) {
      for (int l = 0; l < landmark_count; ++l)
        least[l] = std::min(least[l], row[seed.node][l] + seed.distance);
    }
    return least;
  }
  /// Lower bound of the distance of a node from a place with these distances.
  double bound(Index node, const Row& place) const {
    double greatest = 0.0;
    for (int l = 0; l < landmark_count; ++l) greatest = std::max(greatest, std::abs(row[node][l] - place[l]));
    return greatest;
  }
  std::size_t memory_bytes() const { return row.size() * sizeof(Row); }
};

/// Chooses landmarks by farthest points. `distances_from(node)`: the distances of all nodes from it.
Landmarks place_landmarks(Index nodes, const std::function<std::vector<double>(Index node)>& distances_from,
                          const Progress& progress);

/// Landmarks among the nodes of the second layer, whose distances are searched over its tables.
Landmarks make_landmarks(const PatchLayer& second, const Progress& progress);

// ---- Distances between first-layer nodes: sums of few entries of the first-layer tables

/// An arc of the graph: an entry of a first-layer table.
struct Arc {
  Index target;  ///< first-layer node
  float length;
  Index patch;  ///< the first-layer patch that it leads through
};

/// Undirected graph over the nodes of the first layer: each arc is stored at both ends. Empty in an index in
/// the form of tables.
struct TransitGraph {
  std::vector<std::int64_t> arc_begin;  ///< by node
  std::vector<Arc> arc;
  Landmarks landmarks;  ///< of the graph; they follow from the arcs

  std::span<const Arc> arcs(Index node) const {
    return {arc.data() + arc_begin[node], arc.data() + arc_begin[node + 1]};
  }
  std::size_t memory_bytes() const {
    return arc_begin.size() * sizeof(arc_begin[0]) + arc.size() * sizeof(Arc) + landmarks.memory_bytes();
  }
};

/// Makes the graph from the tables of the first layer. An arc is dropped if shorter arcs of its patch form a
/// path at most (1 + delta) times as long. With delta = 0 all distances stay as they are.
TransitGraph make_transit_graph(const PatchLayer& first, double delta, int threads, const Progress& progress);

/// Fills in the landmarks of a graph.
void place_landmarks(TransitGraph& graph, const Progress& progress);

}  // namespace vorogeo
