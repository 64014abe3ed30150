// Both forms of an index have routes of about the same length, never shorter than the straight line.
#include "query/router.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(Router, NotBelowTheStraightLineAndAlikeInBothForms) {
  const test::Soup soup = test::plane_grid(30, 30, 1.0, 1.0, 0.2).soup;
  const auto tables = test::make_index(soup, 6, 3);
  const auto graph = test::make_graph_index(soup, 6, 3);
  ASSERT_EQ(tables->data().form(), IndexForm::tables);
  ASSERT_EQ(graph->data().form(), IndexForm::graph);
  Router by_tables(tables->data());
  Router by_graph(graph->data());
  const Mesh& mesh = *tables->data().work.mesh;
  GraphRoute route;
  GraphRoute other;
  for (Index a : test::random_vertices(mesh.vertex_count(), 12, 3)) {
    for (Index b : test::random_vertices(mesh.vertex_count(), 12, 4)) {
      by_tables.route(test::route_end(tables->data(), a), test::route_end(tables->data(), b), route);
      by_graph.route(test::route_end(graph->data(), a), test::route_end(graph->data(), b), other);
      const Point& p = mesh.position(a);
      const Point& q = mesh.position(b);
      const double straight = std::hypot(p[0] - q[0], p[1] - q[1]);
      // Entries are rounded, and a route passes borders at vertices only. Two points in one patch have no
      // route inside it, so theirs leads to the border and back.
      EXPECT_GE(route.length, straight * (1.0 - 1e-3) - 1e-3);
      EXPECT_NEAR(route.length, other.length, 0.02 * straight + 1e-3) << a << ", " << b;
      EXPECT_FALSE(route.nodes.empty());
    }
  }
}

TEST(Router, NoneBetweenComponents) {
  const test::Soup soup = test::two_components(test::icosphere(2), test::icosphere(2));
  for (const auto& index : {test::make_index(soup, 4, 3), test::make_graph_index(soup, 4, 3)}) {
    const IndexData& data = index->data();
    Router router(data);
    GraphRoute route;
    const Index a = data.work.work_vertex[0];
    const Index b = data.work.work_vertex[static_cast<Index>(soup.positions.size()) - 1];
    router.route(test::route_end(data, a), test::route_end(data, b), route);
    EXPECT_EQ(route.length, unreachable);
  }
}

}  // namespace
}  // namespace vorogeo
