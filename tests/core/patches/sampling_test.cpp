// Sample vertices: how many, how far apart, one in each piece, the same for a seed.
#include "patches/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

std::vector<Index> all_vertices(const Mesh& mesh) {
  std::vector<Index> vertices;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!mesh.corners(v).empty()) vertices.push_back(v);
  }
  return vertices;
}

/// Edges from the nearest of some vertices, by breadth-first search; -1 where none reaches.
std::vector<int> edge_counts_from(const Mesh& mesh, const std::vector<Index>& starts) {
  std::vector<int> edge_count(mesh.vertex_count(), -1);
  std::deque<Index> queue;
  for (Index v : starts) {
    edge_count[v] = 0;
    queue.push_back(v);
  }
  for (; !queue.empty(); queue.pop_front()) {
    const Index v = queue.front();
    for (Index corner : mesh.corners(v)) {
      for (Index u : {mesh.head(corner), mesh.apex(corner)}) {
        if (edge_count[u] >= 0) continue;
        edge_count[u] = edge_count[v] + 1;
        queue.push_back(u);
      }
    }
  }
  return edge_count;
}

TEST(Sampling, TheSameForASeedAndAnotherForAnother) {
  const auto mesh = test::make_mesh(test::hills(30, 0.2));
  const auto vertices = all_vertices(*mesh);
  const auto first = Sampler(*mesh).spread({vertices, {}}, 12, 5);
  EXPECT_EQ(Sampler(*mesh).spread({vertices, {}}, 12, 5), first);
  EXPECT_NE(Sampler(*mesh).spread({vertices, {}}, 12, 6), first);
}

TEST(Sampling, WellSpread) {
  // On a grid of 41 x 41 vertices, 16 samples: a square of 10 x 10 cells for each. No vertex is farther from
  // the nearest sample than twice the side, no two samples nearer than a third of it.
  const auto mesh = test::make_mesh(test::plane_grid(40, 40, 1.0, 1.0).soup);
  const auto samples = Sampler(*mesh).spread({all_vertices(*mesh), {}}, 16, 0);
  const auto edge_count = edge_counts_from(*mesh, samples);
  EXPECT_LE(*std::max_element(edge_count.begin(), edge_count.end()), 20);
  for (Index a : samples) {
    const auto from_a = edge_counts_from(*mesh, {a});
    for (Index b : samples) EXPECT_TRUE(a == b || from_a[b] >= 3) << a << " and " << b;
  }
}

TEST(Sampling, EachPieceGetsASample) {
  test::Soup soup = test::icosphere(1);
  for (int i = 0; i < 9; ++i) soup = test::two_components(soup, test::icosphere(i % 2));
  const auto mesh = test::make_mesh(test::with_isolated_vertex(soup, {9, 9, 9}));
  const auto samples = Sampler(*mesh).spread({all_vertices(*mesh), {}}, 3, 1);
  EXPECT_EQ(samples.size(), 10U);
  const auto edge_count = edge_counts_from(*mesh, samples);
  for (Index v : all_vertices(*mesh)) EXPECT_GE(edge_count[v], 0) << "no sample reaches vertex " << v;
}

}  // namespace
}  // namespace vorogeo
