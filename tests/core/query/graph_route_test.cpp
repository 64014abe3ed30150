// Bidirectional A*: equal to plain Dijkstra on the same graph; routes are connected and as long as stated.
#include "query/graph_route.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/heavy.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Soup;

void expect_sound(const IndexData& data, const GraphRoute& route, const RouteEnd& from, const RouteEnd& to) {
  if (route.length == unreachable) {
    EXPECT_TRUE(route.nodes.empty());
    return;
  }
  ASSERT_FALSE(route.nodes.empty());
  ASSERT_EQ(route.legs.size() + 1, route.nodes.size());
  auto start_distance = [](const RouteEnd& end, Index node) {
    double least = unreachable;
    for (const auto& seed : end.seeds) {
      if (seed.node == node) least = std::min(least, seed.distance);
    }
    return least;
  };
  double length = start_distance(from, route.nodes.front()) + start_distance(to, route.nodes.back());
  for (std::size_t i = 0; i < route.legs.size(); ++i) {
    double step = unreachable;
    for (const Arc& arc : data.graph.arcs(route.nodes[i])) {
      if (arc.target != route.nodes[i + 1] || arc.leg != route.legs[i]) continue;
      step = std::min(step, static_cast<double>(arc.length));
      const Index parent = arc.leg.in_first_layer() ? no_index : data.partition.parent[arc.leg.patch()];
      const bool open = std::find(from.parents.begin(), from.parents.end(), parent) != from.parents.end() ||
                        std::find(to.parents.begin(), to.parents.end(), parent) != to.parents.end();
      EXPECT_TRUE(arc.leg.in_first_layer() || open) << "a second-layer arc far from both ends";
    }
    length += step;
  }
  EXPECT_NEAR(length, route.length, 1e-12 * route.length);
}

/// Compares `sources` x `targets` random pairs.
void expect_shortest(const GeodesicIndex& index, int sources, int targets) {
  const IndexData& data = index.data();
  GraphRouter router(data);
  test::ReferenceRouter reference(data);
  const Index n = data.work.mesh->vertex_count();
  for (Index source : test::random_vertices(n, sources, 17)) {
    const RouteEnd from = test::route_end(data, source);
    for (Index target : test::random_vertices(n, targets, 1000 + source)) {
      const RouteEnd to = test::route_end(data, target);
      const GraphRoute route = test::graph_route(router, from, to);
      const double expected = reference.length(source, target);
      if (expected == unreachable) {
        ASSERT_EQ(route.length, unreachable) << source << " to " << target;
      } else {
        ASSERT_NEAR(route.length, expected, 1e-12 * expected) << source << " to " << target;
      }
      expect_sound(data, route, from, to);
    }
  }
}

TEST(GraphRouter, TenThousandPairsAsByDijkstra) {
  VOROGEO_HEAVY_TEST();
  expect_shortest(*test::make_graph_index(test::random_sphere(2500, 5), 6, 5), 100, 100);
}
TEST(GraphRouter, PrunedGraphsAsByDijkstra) {
  expect_shortest(*test::make_graph_index(test::hills(36, 0.2), 5, 4, 0.005), 20, 40);
  expect_shortest(*test::make_graph_index(test::torus(40, 20, 2.0, 0.7), 4, 4, 0.05), 20, 40);
}
TEST(GraphRouter, SeveralComponentsAsByDijkstra) {
  Soup soup = test::two_components(test::icosphere(2), test::torus(24, 10, 2.0, 0.7));
  soup = test::two_components(soup, test::icosphere(1));
  expect_shortest(*test::make_graph_index(soup, 4, 4), 30, 60);
}
TEST(GraphRouter, NonManifoldMeshesAsByDijkstra) {
  expect_shortest(*test::make_graph_index(test::book_of_three_pages(12, 2.0, 1.0).soup, 4, 4), 20, 40);
  expect_shortest(*test::make_graph_index(test::bow_tie(12).soup, 3, 4), 20, 40);
}

/// Nodes that plain Dijkstra from one end settles until it takes the target: those nearer than the length.
std::size_t settled_without_guidance(const IndexData& data, const RouteEnd& from, const RouteEnd& to,
                                     double length) {
  const auto usable = [&](const Arc& arc) {
    const auto open = [&](const RouteEnd& end) {
      return std::ranges::find(end.parents, data.partition.parent[arc.leg.patch()]) != end.parents.end();
    };
    return arc.leg.in_first_layer() || open(from) || open(to);
  };
  const auto distances = test::dijkstra(data.graph, from.seeds, usable);
  return std::ranges::count_if(distances, [&](double distance) { return distance < length; });
}

TEST(GraphRouter, GuidanceSavesWork) {
  const auto index = test::make_graph_index(test::hills(60, 0.1), 8, 5);
  const IndexData& data = index->data();
  GraphRouter router(data);
  std::size_t settled = 0;
  std::size_t unguided = 0;
  for (Index source : test::random_vertices(3721, 15, 1)) {
    const RouteEnd from = test::route_end(data, source);
    for (Index target : test::random_vertices(3721, 15, 2)) {
      const RouteEnd to = test::route_end(data, target);
      const GraphRoute route = test::graph_route(router, from, to);
      settled += router.settled();
      unguided += settled_without_guidance(data, from, to, route.length);
    }
  }
  // Two searches without guidance meet after two half discs, half of one disc; guided ones stay between the
  // ends.
  EXPECT_LT(4 * settled, unguided) << "settled " << settled << ", by a search from one end " << unguided;
}

}  // namespace
}  // namespace vorogeo
