// Graphs of direct geodesics: on a plane one arc is a distance.
#include <gtest/gtest.h>

#include "methods/graph_methods.h"
#include "support/methods.h"

namespace vorogeo {
namespace {

TEST(GraphMethod, ACompleteGraphOfAPlaneIsExact) {
  const test::Shape shape = test::plane_grid(8, 6, 2.0, 1.0, 0.2);
  TreeRules rules;
  rules.bends = false;
  const auto graph = direct_geodesics(test::make_mesh(shape.soup), rules, {});
  EXPECT_EQ(graph->arc_count(), 63u * 62u);
  const std::vector<Index> source{40};
  const auto field = graph->field(source, {});
  for (Index v = 0; v < 63; ++v) {
    EXPECT_NEAR(field[v], shape.vertex_distance(40, v), 1e-12);
    EXPECT_NEAR(graph->pair(v, 40), field[v], 1e-12);
  }
}

}  // namespace
}  // namespace vorogeo
