// Unfolded routes: closer to the exact distance than the sum over the nodes.
#include <gtest/gtest.h>

#include <algorithm>

#include "exact/exact_solver.h"
#include "query/router.h"
#include "support/heavy.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

struct Comparison {
  test::ErrorStatistics sums;
  test::ErrorStatistics unfolded;
};

Comparison compare(const test::Soup& soup) {
  const auto index = test::make_graph_index(soup, 4, 5);
  const IndexData& data = index->data();
  GraphRouter router(data);
  ExactSolver solver(data.geometry->windows);
  test::ErrorCollector sums;
  test::ErrorCollector unfolded;
  const Index n = data.work.mesh->vertex_count();
  for (Index source : test::random_vertices(n, 12, 3)) {
    solver.run_from_vertices(std::array{source});
    for (Index target : test::random_vertices(n, 120, 4)) {
      // Pairs in one patch are not answered by routes.
      const auto a = test::patches_at(*data.work.mesh, data.work.second_layer, source);
      const auto b = test::patches_at(*data.work.mesh, data.work.second_layer, target);
      if (std::ranges::any_of(a, [&](Index p) { return b.contains(p); })) continue;
      GraphRoute route;
      router.route(test::route_end(data, source), test::route_end(data, target), route);
      const double length = RouteUnfolder(data).length(route, source, target);
      sums.add(route.length, solver.distance(target));
      unfolded.add(std::min(route.length, length), solver.distance(target));
    }
  }
  EXPECT_EQ(unfolded.contradictions, 0U);
  return {sums.statistics(), unfolded.statistics()};
}

TEST(RouteUnfolding, InThePlaneNearlyTheStraightLine) {
  const Comparison found = compare(test::plane_grid(50, 50, 1.0, 1.0, 0.2).soup);
  EXPECT_GT(found.unfolded.count, 1000U);
  EXPECT_LT(found.unfolded.mean, 0.5 * found.sums.mean);
  EXPECT_LT(found.unfolded.mean, 5e-4);
  EXPECT_LT(found.unfolded.p99, 5e-3);
  EXPECT_GT(found.unfolded.least, -5e-3);
}

TEST(RouteUnfolding, OnCurvedSurfacesBetterThanSums) {
  for (const test::Soup& soup : test::one_under_sanitizers<test::Soup>(
           {test::hills(45, 0.12), test::icosphere(4), test::torus(60, 30, 2.0, 0.8)})) {
    const Comparison found = compare(soup);
    EXPECT_LT(found.unfolded.mean, 0.8 * found.sums.mean);
    EXPECT_LT(found.unfolded.mean, 1e-3);
    EXPECT_LT(found.unfolded.p99, 1e-2);
    EXPECT_GT(found.unfolded.least, -0.02);
  }
}

TEST(RouteUnfolding, BetweenTwoNodesOfOneArcTheTableEntry) {
  const auto index = test::make_graph_index(test::plane_grid(24, 24, 1.0, 1.0, 0.2).soup, 2, 3);
  const IndexData& data = index->data();
  for (Index node = 0; node < data.second.node_count(); ++node) {
    for (const Arc& arc : data.graph.arcs(node)) {
      if (arc.leg.in_first_layer()) continue;
      GraphRoute route;
      route.length = arc.length;
      route.nodes = {node, arc.target};
      route.legs = {arc.leg};
      const double length = RouteUnfolder(data).length(route, data.second.node_vertex[node],
                                                       data.second.node_vertex[arc.target]);
      EXPECT_NEAR(length, arc.length, 1e-6 * arc.length);
    }
  }
}

}  // namespace
}  // namespace vorogeo
