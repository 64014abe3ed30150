// Methods on graphs of geodesics: Dijkstra, SVG, DGG and short-term vectors.
#pragma once

#include <span>
#include <vector>

#include "methods/chen_han.h"
#include "methods/method.h"
#include "methods/vertex_search.h"
#include "support/types.h"

namespace vorogeo {

// ---- Shortest paths in a graph over the vertices of a mesh

/// An arc to a vertex, with its length.
struct GraphArc {
  Index target;
  double length;
};

/// An undirected graph over vertices 0..n-1 with lengths, as lists of neighbours.
class DistanceGraph {
 public:
  /// Takes arcs by their tails; those of one pair of vertices become one, the shortest, in both directions.
  explicit DistanceGraph(std::vector<std::vector<GraphArc>> arcs_of);

  std::span<const GraphArc> arcs(Index vertex) const {
    return {arcs_.data() + begin_[vertex], arcs_.data() + begin_[vertex + 1]};
  }
  std::size_t arc_count() const { return arcs_.size(); }
  std::size_t bytes() const {
    return arcs_.capacity() * sizeof(GraphArc) + begin_.capacity() * sizeof(std::size_t);
  }

  /// Lengths of shortest paths from the nearest source (Dijkstra 1959). With a target: it ends when that
  /// one's is final; the others are then upper bounds. Shape (n).
  std::vector<double> field(std::span<const Index> sources, Index target = no_index) const;

 private:
  std::vector<std::size_t> begin_;
  std::vector<GraphArc> arcs_;
};

// ---- Methods that search a graph over the vertices

/// Dijkstra's search over a graph that was made once.
class GraphMethod final : public GeodesicMethod {
 public:
  GraphMethod(DistanceGraph graph, Index vertices) : graph_(std::move(graph)), vertices_(vertices) {}
  std::vector<double> field(std::span<const Index> sources, const Progress& progress) override;
  double pair(Index source, Index target) override { return graph_.field({&source, 1}, target)[target]; }
  std::size_t bytes() const override {
    return graph_.bytes() + static_cast<std::size_t>(vertices_) * VertexSearch::bytes_per_vertex;
  }
  std::size_t arc_count() const { return graph_.arc_count(); }

 private:
  DistanceGraph graph_;
  Index vertices_;
};

/// Arcs from each vertex to those that a run of a WindowTree with these rules takes up (with an epsilon: and
/// needs), on all threads.
std::unique_ptr<GraphMethod> direct_geodesics(const std::shared_ptr<const Mesh>& mesh, const TreeRules& rules,
                                              const Progress& progress);

}  // namespace vorogeo
