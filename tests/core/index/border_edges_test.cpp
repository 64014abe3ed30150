// Border edges by node: against the edges of the mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "index/patch_layer.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(BorderEdges, AreTheMeshEdgesBetweenTwoPatches) {
  for (const test::Soup& soup :
       {test::icosphere(3), test::hills(24, 0.2), test::book_of_three_pages(9, 2.0, 1.0).soup}) {
    const auto index = test::make_index(soup, 3, 4);
    const IndexData& data = index->data();
    const Mesh& mesh = *data.work.mesh;
    const BorderEdges& edges = data.second.edges;
    std::vector<int> expected(data.second.node_count(), 0);
    for (Index e = 0; e < mesh.edge_count(); ++e) {
      const auto [a, b] = mesh.edge_vertices(e);
      const Index node_a = data.second.vertex_node[a];
      const Index node_b = data.second.vertex_node[b];
      if (node_a == no_index || node_b == no_index) continue;
      std::set<Index> beside;
      Index h = mesh.edge_halfedge(e);
      for (int i = 0; i < mesh.edge_face_count(e); ++i, h = mesh.next_around_edge(h)) {
        beside.insert(data.work.second_layer[Mesh::face_of(h)]);
      }
      const bool border = beside.size() >= 2;
      if (border) {
        ++expected[node_a];
        ++expected[node_b];
        const auto& list = edges.at(node_a);
        const auto found = std::ranges::find(list, node_b, &BorderEdges::Edge::node);
        if (expected[node_a] <= 4 && found != list.end()) {
          EXPECT_NEAR(found->length, mesh.edge_length(e), 1e-6 * mesh.edge_length(e));
        }
      }
    }
    for (Index node = 0; node < data.second.node_count(); ++node) {
      const auto& list = edges.at(node);
      const auto count = std::ranges::count_if(list, [](const auto& edge) { return edge.node != no_index; });
      EXPECT_EQ(count, std::min(4, expected[node]));
    }
  }
}

}  // namespace
}  // namespace vorogeo
