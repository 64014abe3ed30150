// Routes between first-layer borders through the graph: the least of all sums.
#include "query/graph_route.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// Least distances of an end of a pair from the nodes of the first layer, by the tables.
std::vector<double> access_distances(const IndexData& data, const RouteEnd& end) {
  std::vector<double> least(data.first.node_count(), unreachable);
  for (Index parent : end.parents) {
    for (const auto& seed : end.seeds) {
      const Index column = data.column_in_parent(parent, seed.node);
      if (column == no_index) continue;
      for (Index row = 0; row < data.first.border_size(parent); ++row) {
        double& at = least[data.first.nodes(parent)[row]];
        at = std::min(at, seed.distance + data.first.distance(parent, row, column));
      }
    }
  }
  return least;
}

TEST(GraphRouter, FindsTheLeastOfAllSums) {
  const test::Soup two = test::two_components(test::icosphere(2), test::torus(24, 10, 2.0, 0.7));
  // An end of the limb is farther from the other end of its first-layer patch than any two members of that
  // patch are apart.
  const test::Soup limb = test::plane_grid(120, 8, 12.0, 0.8, 0.2).soup;
  for (const test::Soup& soup : {test::hills(28, 0.2), two, limb}) {
    const auto index = test::make_index(soup, 6, 3, test::lossless_delta);
    const IndexData& data = index->data();
    const auto all = test::graph_distances(data.graph);
    GraphRouter router(data);
    RouteEnd from, to;
    for (Index source : test::random_vertices(data.surface.vertex_count(), 14, 1)) {
      route_end(data, source, from);
      const auto here = access_distances(data, from);
      for (Index target : test::random_vertices(data.surface.vertex_count(), 14, 2)) {
        route_end(data, target, to);
        const auto there = access_distances(data, to);
        double expected = unreachable;
        for (std::size_t a = 0; a < here.size(); ++a) {
          for (std::size_t b = 0; b < there.size(); ++b) {
            expected = std::min(expected, here[a] + all[a][b] + there[b]);
          }
        }
        GraphRoute route;
        router.route(from, to, route);
        ASSERT_EQ(route.length < unreachable, expected < unreachable) << source << " to " << target;
        if (expected == unreachable) continue;
        ASSERT_NEAR(route.length, expected, 1e-6 * expected) << source << " to " << target;
        EXPECT_EQ(route.legs.size() + 1, route.nodes.size());
      }
    }
  }
}

}  // namespace
}  // namespace vorogeo
