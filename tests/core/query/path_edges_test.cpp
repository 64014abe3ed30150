// Paths along edges against the Bellman-Ford algorithm.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "query/path_chain.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// Distances along edges from a vertex: every edge is relaxed until nothing becomes shorter.
std::vector<double> over_edges(const Mesh& mesh, Index start) {
  std::vector<double> distance(mesh.vertex_count(), unreachable);
  distance[start] = 0.0;
  for (bool relaxed = true; relaxed;) {
    relaxed = false;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      for (Index side = 3 * f; side < 3 * f + 3; ++side) {
        const Index a = mesh.tail(side), b = mesh.head(side);
        const double length = mesh.edge_length(mesh.edge_of(side));
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
          if (!(distance[from] + length < distance[to])) continue;
          distance[to] = distance[from] + length;
          relaxed = true;
        }
      }
    }
  }
  return distance;
}

void expect_shortest_paths(const Mesh& mesh, Index start) {
  const std::vector<double> expected = over_edges(mesh, start);
  for (Index goal = 0; goal < mesh.vertex_count(); ++goal) {
    std::vector<EdgeStep> steps{{7, 7}};
    ASSERT_EQ(path_along_edges(mesh, start, goal, steps), expected[goal] < unreachable) << goal;
    EXPECT_EQ(steps.front().from, 7) << "what was there stays";
    if (!(expected[goal] < unreachable)) continue;
    double length = 0.0;
    for (std::size_t i = 1; i < steps.size(); ++i) {
      const Index next = i + 1 < steps.size() ? steps[i + 1].from : goal;
      const std::set<Index> ends{mesh.tail(steps[i].halfedge), mesh.head(steps[i].halfedge)};
      EXPECT_EQ(ends, (std::set<Index>{steps[i].from, next}));
      const Point& a = mesh.position(steps[i].from);
      const Point& b = mesh.position(next);
      length += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
    EXPECT_EQ(steps.size() > 1 ? steps[1].from : start, start);
    EXPECT_NEAR(length, expected[goal], 1e-12);
  }
}

TEST(PathEdges, ShortestOverAnUnevenPlaneWithASlit) {
  expect_shortest_paths(*test::make_mesh(test::plane_grid(9, 7, 3.0, 2.0, 0.25).soup), 5);
  expect_shortest_paths(*test::make_mesh(test::plane_with_slit(3).soup), 0);
}

TEST(PathEdges, NoneToAnotherComponent) {
  expect_shortest_paths(*test::make_mesh(test::two_components(test::icosphere(1), test::icosphere(1))), 3);
}

}  // namespace
}  // namespace vorogeo
