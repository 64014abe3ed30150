// Shortest paths along the edges of the mesh.
#include "methods/graph_method.h"
#include "methods/method_table.h"

namespace vorogeo {

namespace {

DistanceGraph edge_graph(const Mesh& mesh) {
  std::vector<std::vector<GraphArc>> arcs(mesh.vertex_count());
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const auto [a, b] = mesh.edge_vertices(e);
    arcs[a].push_back({b, mesh.edge_length(e)});
  }
  return DistanceGraph(std::move(arcs));
}

}  // namespace

MethodEntry dijkstra_entry() {
  return {{"dijkstra",
           "Shortest edge path (Dijkstra)",
           "E. W. Dijkstra: A note on two problems in connexion with graphs. Numerische Mathematik 1, 1959",
           {},
           {"MSAD, SSSD", "none", "never too short; no refinement helps", "any on edges", "field n log n"},
           false,
           true},
          [](const std::shared_ptr<const Mesh>& mesh, const MethodOptions&, const Progress&) {
            return std::make_unique<GraphMethod>(edge_graph(*mesh), mesh->vertex_count());
          },
          {}};
}

}  // namespace vorogeo
