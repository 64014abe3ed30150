// Routes inside first-layer patches: as by plain Dijkstra over all table entries.
#include "query/patch_route.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "query/router.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// Bellman-Ford over the second-layer tables of the first-layer patches of the two ends.
double least_length(const IndexData& data, const RouteEnd& source, const RouteEnd& target) {
  const PatchLayer& second = data.second;
  std::vector<double> distance(second.node_count(), unreachable);
  for (const auto& seed : source.seeds) distance[seed.node] = seed.distance;
  for (bool changed = true; changed;) {
    changed = false;
    for (Index p = 0; p < second.patch_count; ++p) {
      const Index parent = data.partition.parent[p];
      if (std::ranges::find(source.parents, parent) == source.parents.end() &&
          std::ranges::find(target.parents, parent) == target.parents.end()) {
        continue;
      }
      for (Index a = 0; a < second.border_size(p); ++a) {
        for (Index b = 0; b < second.border_size(p); ++b) {
          const double sum = distance[second.nodes(p)[a]] + second.distance(p, a, b);
          if (!(sum < distance[second.nodes(p)[b]] * (1.0 - 1e-12))) continue;
          distance[second.nodes(p)[b]] = sum;
          changed = true;
        }
      }
    }
  }
  double least = unreachable;
  for (const auto& seed : target.seeds) least = std::min(least, distance[seed.node] + seed.distance);
  return least;
}

/// How far the length of a route may be from the least one: the rounding of some steps.
double rounding(const IndexData& data) {
  return 8.0 * std::ranges::max(data.second.scale, {}, &TableScale::unit).unit();
}

void expect_shortest(const IndexData& data, PatchRouter& router, Index source, Index target) {
  const RouteEnd from = test::route_end(data, source);
  const RouteEnd to = test::route_end(data, target);
  const double expected = least_length(data, from, to);
  GraphRoute route;
  const bool found = router.route(from, to, route);
  ASSERT_EQ(found, expected < unreachable) << source << " to " << target;
  if (!found) {
    EXPECT_EQ(route.length, unreachable);
    return;
  }
  EXPECT_NEAR(route.length, expected, rounding(data)) << source << " to " << target;
  // As long as its parts.
  ASSERT_EQ(route.nodes.size(), route.legs.size() + 1);
  auto at_end = [](const RouteEnd& end, Index node) {
    const auto at = std::ranges::find(end.seeds, node, &RouteEnd::Seed::node);
    return at == end.seeds.end() ? unreachable : at->distance;
  };
  double length = at_end(from, route.nodes.front()) + at_end(to, route.nodes.back());
  for (std::size_t i = 0; i < route.legs.size(); ++i) {
    const auto nodes = data.second.nodes(route.legs[i].patch());
    const auto a = std::ranges::find(nodes, route.nodes[i]);
    const auto b = std::ranges::find(nodes, route.nodes[i + 1]);
    ASSERT_TRUE(a != nodes.end() && b != nodes.end());
    length += data.second.distance(route.legs[i].patch(), static_cast<Index>(a - nodes.begin()),
                                   static_cast<Index>(b - nodes.begin()));
  }
  EXPECT_NEAR(length, route.length, 1e-6 * route.length + 1e-12);
  // Nothing is shorter than that, and a route that is not shorter than a limit is not returned.
  GraphRoute kept = route;
  EXPECT_FALSE(router.route(from, to, kept, route.length * (1.0 - 1e-3) - rounding(data)));
  EXPECT_EQ(kept.nodes, route.nodes);
}

TEST(PatchRouter, AsPlainSearchOverTheTables) {
  const test::Soup two = test::two_components(test::icosphere(2), test::torus(24, 10, 2.0, 0.7));
  for (const test::Soup& soup : {test::icosphere(3), test::hills(28, 0.3), test::random_sphere(700, 5), two,
                                 test::book_of_three_pages(9, 2.0, 1.0).soup, test::bow_tie(9).soup}) {
    const auto index = test::make_index(soup, 3, 6);
    const IndexData& data = index->data();
    PatchRouter router(data);
    const Index n = data.work.mesh->vertex_count();
    for (Index source : test::random_vertices(n, 8, 1)) {
      for (Index target : test::random_vertices(n, 16, 2)) expect_shortest(data, router, source, target);
    }
  }
}

}  // namespace
}  // namespace vorogeo
