// Shortest paths along the edges of the mesh.
#include "methods/distance_graph.h"
#include "methods/method_table.h"
#include "support/checkpoint.h"

namespace vorogeo {

namespace {

DistanceGraph edge_graph(const Mesh& mesh) {
  std::vector<std::vector<GraphArc>> arcs(mesh.vertex_count());
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const auto [a, b] = mesh.edge_vertices(e);
    arcs[a].push_back({b, mesh.edge_length(e)});
  }
  return DistanceGraph(arcs);
}

class EdgePaths final : public GeodesicMethod {
 public:
  explicit EdgePaths(const Mesh& mesh) : graph_(edge_graph(mesh)), vertices_(mesh.vertex_count()) {}
  std::vector<double> field(std::span<const Index> sources, const Progress& progress) override {
    const Watch watch(progress, "Shortest edge paths");
    return graph_.field(sources);
  }
  double pair(Index source, Index target) override { return graph_.field({&source, 1}, target)[target]; }
  std::size_t bytes() const override {
    return graph_.bytes() + static_cast<std::size_t>(vertices_) * sizeof(double);
  }

 private:
  DistanceGraph graph_;
  Index vertices_;
};

}  // namespace

MethodEntry dijkstra_entry() {
  return {
      {"dijkstra",
       "Shortest edge path (Dijkstra)",
       "E. W. Dijkstra: A note on two problems in connexion with graphs. Numerische Mathematik 1, 1959",
       {},
       {"MSAD, SSSD", "none", "never too short; grows with no refinement", "any on edges", "field n log n"},
       false,
       true},
      [](const std::shared_ptr<const Mesh>& mesh, const MethodOptions&, const Progress&) {
        return std::make_unique<EdgePaths>(*mesh);
      },
      {}};
}

}  // namespace vorogeo
