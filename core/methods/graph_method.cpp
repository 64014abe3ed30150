// A graph of direct geodesics: a search around each vertex.
#include "methods/graph_method.h"

#include "support/checkpoint.h"
#include "support/per_worker.h"

namespace vorogeo {

namespace {

/// Vertices that one item of the work takes.
constexpr Index vertices_per_item = 64;

}  // namespace

std::vector<double> GraphMethod::field(std::span<const Index> sources, const Progress& progress) {
  const Watch watch(progress, "Shortest paths in a graph");
  return graph_.field(sources);
}

std::unique_ptr<GraphMethod> direct_geodesics(const std::shared_ptr<const Mesh>& mesh, const TreeRules& rules,
                                              const Progress& progress) {
  const auto geometry = std::make_shared<const ExactGeometry>(mesh);
  const Index count = mesh->vertex_count();
  std::vector<std::vector<GraphArc>> arcs(count);
  PerWorker<WindowTree> trees(0);
  const auto items = static_cast<std::size_t>((count + vertices_per_item - 1) / vertices_per_item);
  parallel_for(items, 0, progress, "Direct geodesics around each vertex", [&](std::size_t item, int worker) {
    WindowTree& tree = trees.of(worker, geometry);
    const Index begin = static_cast<Index>(item) * vertices_per_item;
    for (Index v = begin; v < std::min(count, begin + vertices_per_item); ++v) {
      tree.run({&v, 1}, rules);
      for (Index other : tree.settled()) {
        if (other == v || (rules.epsilon > 0.0 && !tree.is_needed(other))) continue;
        arcs[v].push_back({other, tree.distance(other)});
      }
    }
  });
  return std::make_unique<GraphMethod>(DistanceGraph(std::move(arcs)), count);
}

}  // namespace vorogeo
