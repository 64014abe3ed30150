// Routes read from the tables: equal to the least of all sums, and as long as their parts.
#include "query/table_route.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// Distance of a seed of an end from a row of a first-layer patch that holds it, by the table.
double through_patch(const IndexData& data, Index parent, Index row, Index node) {
  const auto members = data.first.members(parent);
  const auto at = std::find(members.begin(), members.end(), data.second.node_vertex[node]);
  if (at == members.end()) return unreachable;
  return data.first.distance(parent, row, static_cast<Index>(at - members.begin()));
}

/// All sums: seed, first-layer border, first-layer border, seed.
double least_sum(const IndexData& data, const RouteEnd& from, const RouteEnd& to) {
  auto access_distances = [&](const RouteEnd& end, Index parent) {
    std::vector<double> least(data.first.border_size(parent), unreachable);
    for (const auto& seed : end.seeds) {
      for (std::size_t row = 0; row < least.size(); ++row) {
        least[row] = std::min(
            least[row], seed.distance + through_patch(data, parent, static_cast<Index>(row), seed.node));
      }
    }
    return least;
  };
  double least = unreachable;
  for (Index p : from.parents) {
    const auto here = access_distances(from, p);
    for (Index q : to.parents) {
      const auto there = access_distances(to, q);
      for (std::size_t a = 0; a < here.size(); ++a) {
        const Index row = data.first.nodes(p)[a];
        for (std::size_t b = 0; b < there.size(); ++b) {
          least =
              std::min(least, here[a] + data.transit_table.distance(row, data.first.nodes(q)[b]) + there[b]);
        }
      }
    }
  }
  return least;
}

/// Routes between random vertices are as long as the least of all sums.
void expect_least_sums(const IndexData& data, Index sources, Index targets) {
  TableRouter router(data);
  const Index n = data.work.mesh->vertex_count();
  for (Index source : test::random_vertices(n, sources, 1)) {
    for (Index target : test::random_vertices(n, targets, 2)) {
      const RouteEnd from = test::route_end(data, source);
      const RouteEnd to = test::route_end(data, target);
      const double expected = least_sum(data, from, to);
      GraphRoute route;
      router.route(from, to, route);
      if (expected == unreachable) {
        EXPECT_EQ(route.length, unreachable);
        EXPECT_TRUE(route.nodes.empty());
      } else {
        EXPECT_NEAR(route.length, expected, 1e-6 * expected) << source << " to " << target;
      }
    }
  }
}

TEST(TableRouter, TheLeastOfAllSums) {
  const test::Soup two = test::two_components(test::icosphere(2), test::torus(24, 10, 2.0, 0.7));
  for (const test::Soup& soup : {test::icosphere(3), test::hills(28, 0.2), two}) {
    expect_least_sums(test::make_index(soup, 6, 3)->data(), 14, 14);
  }
}

TEST(TableRouter, FromTheTipOfALimb) {
  // Farther from the other end of its first-layer patch than any two members of that patch are.
  expect_least_sums(test::make_index(test::plane_grid(120, 8, 12.0, 0.8, 0.2).soup, 3, 3)->data(), 40, 20);
}

}  // namespace
}  // namespace vorogeo
