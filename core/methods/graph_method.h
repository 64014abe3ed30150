// Methods that search a graph over the vertices.
#pragma once

#include "methods/distance_graph.h"
#include "methods/method.h"
#include "methods/window_tree.h"

namespace vorogeo {

/// Dijkstra's search over a graph that was made once.
class GraphMethod final : public GeodesicMethod {
 public:
  GraphMethod(DistanceGraph graph, Index vertices) : graph_(std::move(graph)), vertices_(vertices) {}
  std::vector<double> field(std::span<const Index> sources, const Progress& progress) override;
  double pair(Index source, Index target) override { return graph_.field({&source, 1}, target)[target]; }
  std::size_t bytes() const override {
    return graph_.bytes() + static_cast<std::size_t>(vertices_) * sizeof(double);
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
