// Dijkstra's search over a graph given by arcs.
#include <gtest/gtest.h>

#include "methods/graph_methods.h"

namespace vorogeo {
namespace {

TEST(DistanceGraph, KeepsTheShortestArcOfAPairInBothDirections) {
  const DistanceGraph graph({{{1, 5.0}, {1, 2.0}}, {{0, 3.0}, {2, 1.0}}, {}, {}});
  EXPECT_EQ(graph.arc_count(), 4u);
  EXPECT_EQ(graph.arcs(0)[0].length, 2.0);
  EXPECT_EQ(graph.arcs(2)[0].target, 1);
  const Index source = 2;
  EXPECT_EQ(graph.field({&source, 1}), (std::vector<double>{3.0, 1.0, 0.0, unreachable}));
}

TEST(DistanceGraph, TakesTheNearestSourceAndEndsAtATarget) {
  std::vector<std::vector<GraphArc>> chain(100);
  for (Index v = 0; v + 1 < 100; ++v) chain[v].push_back({v + 1, 1.0});
  const DistanceGraph graph(chain);
  const std::vector<Index> sources{0, 99, 99};
  const auto field = graph.field(sources);
  for (Index v = 0; v < 100; ++v) EXPECT_EQ(field[v], std::min(v, 99 - v));
  const Index source = 10;
  const auto until = graph.field({&source, 1}, 13);
  EXPECT_EQ(until[13], 3.0);
  EXPECT_EQ(until[50], unreachable);
}

}  // namespace
}  // namespace vorogeo
