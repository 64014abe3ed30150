// The pruned graph of the first layer: against its complete tables, growth of the error with delta,
// landmarks.
#include "index/transit_graph.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "index/local_tables.h"
#include "support/heavy.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using Matrix = std::vector<std::vector<double>>;

/// Distances between all nodes by the entries of all tables (Floyd-Warshall).
Matrix complete_distances(const PatchLayer& first) {
  const auto nodes = static_cast<std::size_t>(first.node_count());
  Matrix all(nodes, std::vector<double>(nodes, unreachable));
  for (std::size_t a = 0; a < nodes; ++a) all[a][a] = 0.0;
  for (Index p = 0; p < first.patch_count; ++p) {
    for (Index i = 0; i < first.border_size(p); ++i) {
      for (Index j = 0; j < first.border_size(p); ++j) {
        double& entry = all[first.nodes(p)[i]][first.nodes(p)[j]];
        entry = std::min<double>(entry, first.distance(p, i, j));
      }
    }
  }
  for (std::size_t by = 0; by < nodes; ++by) {
    for (auto& from : all) {
      for (std::size_t b = 0; b < nodes; ++b) from[b] = std::min(from[b], from[by] + all[by][b]);
    }
  }
  return all;
}

std::vector<std::shared_ptr<const GeodesicIndex>> small_indexes() {
  const test::Soup two = test::two_components(test::icosphere(2), test::torus(24, 10, 2.0, 0.7));
  return {test::make_index(test::icosphere(3), 5, 4), test::make_index(test::hills(22, 0.15), 6, 3),
          test::make_index(test::book_of_three_pages(9, 2.0, 1.0).soup, 5, 3), test::make_index(two, 4, 4)};
}

TEST(TransitGraph, NoDistanceGrowsByMoreThanDeltaAndArcsGetFewer) {
  for (const auto& index : test::one_under_sanitizers(small_indexes())) {
    const PatchLayer& first = index->data().first;
    const Matrix complete = complete_distances(first);
    auto arcs_before = static_cast<std::size_t>(2 * pairs_of_nodes(first)) + 1;
    for (double delta : {0.0, 0.001, 0.005, 0.02, 0.1}) {
      const TransitGraph graph = make_transit_graph(first, delta, 0, {});
      EXPECT_LT(graph.arc.size(), arcs_before) << "delta " << delta;
      arcs_before = graph.arc.size();
      const Matrix pruned = test::graph_distances(graph);
      for (std::size_t a = 0; a < complete.size(); ++a) {
        for (std::size_t b = 0; b < complete.size(); ++b) {
          if (complete[a][b] == unreachable) {
            ASSERT_EQ(pruned[a][b], unreachable);
            continue;
          }
          ASSERT_GE(pruned[a][b], complete[a][b] * (1.0 - 1e-12));
          ASSERT_LE(pruned[a][b], complete[a][b] * (1.0 + delta + 1e-12)) << "nodes " << a << ", " << b;
        }
      }
    }
  }
}

TEST(TransitGraph, LandmarksAreLowerBounds) {
  for (const auto& index : small_indexes()) {
    const TransitGraph graph = make_transit_graph(index->data().first, 0.0, 0, {});
    const Matrix all = test::graph_distances(graph);
    double greatest = 0.0;
    for (std::size_t a = 0; a < all.size(); ++a) {
      for (std::size_t b = 0; b < all.size(); ++b) {
        const double bound = graph.landmarks.bound(static_cast<Index>(a), graph.landmarks.row[b]);
        ASSERT_LE(bound, all[a][b] * (1.0 + 1e-12));
        if (all[a][b] < unreachable && all[a][b] > 0.0) greatest = std::max(greatest, bound / all[a][b]);
      }
    }
    EXPECT_NEAR(greatest, 1.0, 1e-12) << "from a landmark the bound is the distance";
  }
}

/// A layer of one patch with the given table, square and symmetric.
TransitGraph graph_of_table(const std::vector<std::vector<float>>& table, double delta) {
  const auto k = static_cast<Index>(table.size());
  PatchLayer layer;
  layer.patch_count = 1;
  for (Index v = 0; v < k; ++v) {
    for (auto* list : {&layer.node_place, &layer.place_node, &layer.border.element, &layer.member.element})
      list->push_back(v);
  }
  layer.border.close();
  layer.member.close();
  layer.table_begin = {0, static_cast<std::size_t>(k) * k};
  TableDraft draft(layer, 0);
  for (Index v = 0; v < k; ++v) std::copy(table[v].begin(), table[v].end(), draft.line(v));
  std::vector<std::uint16_t> entries(layer.table_begin.back());
  layer.scale = {draft.write(layer.order, entries.data()).scale};
  layer.table = SharedArray(std::move(entries));
  return make_transit_graph(layer, delta, 1, {});
}

TEST(TransitGraph, AnArcIsDroppedOnlyIfTwoOthersAreAsShort) {
  const TransitGraph line = graph_of_table({{0, 1, 3}, {1, 0, 2}, {3, 2, 0}}, 0.0);
  EXPECT_EQ(line.arc.size(), 4U) << "1 + 2 = 3";
  const std::vector<std::vector<float>> triangle{{0, 1, 2.9F}, {1, 0, 2}, {2.9F, 2, 0}};
  EXPECT_EQ(graph_of_table(triangle, 0.0).arc.size(), 6U);
  EXPECT_EQ(graph_of_table(triangle, 0.05).arc.size(), 4U) << "3 <= 2.9 * 1.05";
  EXPECT_EQ(graph_of_table(triangle, 0.03).arc.size(), 6U);
}

TEST(TransitGraph, NodesAtNearlyTheSamePlaceStayConnected) {
  // Two nodes are 1e-20 or 0 apart: their arcs to a third must not both be dropped because of each other.
  for (float tiny : {1e-20F, 0.0F}) {
    for (double delta : {0.0, 0.01}) {
      const Matrix all =
          test::graph_distances(graph_of_table({{0, tiny, 1}, {tiny, 0, 1}, {1, 1, 0}}, delta));
      EXPECT_NEAR(all[0][2], 1.0, 1e-6);
      EXPECT_NEAR(all[1][2], 1.0, 1e-6);
      EXPECT_LE(all[0][1], tiny);
    }
  }
}

}  // namespace
}  // namespace vorogeo
