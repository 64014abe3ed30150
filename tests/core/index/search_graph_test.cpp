// The two-layer graph: pruning against the complete tables, growth of the error with delta, landmarks.
#include "index/search_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "index/local_tables.h"
#include "support/heavy.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Soup;
using Matrix = std::vector<std::vector<double>>;

SearchGraph graph_of(const IndexData& data, double delta, int threads = 0) {
  return make_search_graph(data.second, data.first, data.partition.parent, delta, threads, {});
}

Matrix distances(const SearchGraph& graph) {
  Matrix all;
  for (Index node = 0; node + 1 < static_cast<Index>(graph.arc_begin.size()); ++node) {
    all.push_back(test::dijkstra(graph, {{node, 0.0}}, [](const Arc&) { return true; }));
  }
  return all;
}

/// The same nodes with an arc for every table entry between two nodes, in both layers.
SearchGraph complete_graph(const IndexData& data) {
  std::vector<std::vector<Arc>> arcs(data.second.node_count());
  auto add = [&](const PatchLayer& layer, bool first_layer) {
    auto node = [&](Index p, Index row) { return data.second.vertex_node[layer.members(p)[row]]; };
    for (Index p = 0; p < layer.patch_count; ++p) {
      for (Index i = 0; i < layer.border_size(p); ++i) {
        for (Index j = 0; j < layer.border_size(p); ++j) {
          if (i == j) continue;
          arcs[node(p, i)].push_back({node(p, j), layer.distance(p, i, j),
                                      first_layer ? Leg::through_first(p) : Leg::through_second(p)});
        }
      }
    }
  };
  add(data.second, false);
  add(data.first, true);
  SearchGraph graph;
  graph.arc_begin.push_back(0);
  for (const auto& own : arcs) {
    graph.arc.insert(graph.arc.end(), own.begin(), own.end());
    graph.arc_begin.push_back(static_cast<std::int64_t>(graph.arc.size()));
  }
  return graph;
}

std::vector<std::shared_ptr<const GeodesicIndex>> small_indexes() {
  const Soup two = test::two_components(test::icosphere(2), test::torus(24, 10, 2.0, 0.7));
  return {test::make_index(test::icosphere(3), 3, 4), test::make_index(test::hills(22, 0.15), 4, 3),
          test::make_index(test::book_of_three_pages(9, 2.0, 1.0).soup, 3, 3), test::make_index(two, 2, 4)};
}

TEST(SearchGraph, WithDeltaZeroNoDistanceChanges) {
  for (const auto& index : small_indexes()) {
    const Matrix complete = distances(complete_graph(index->data()));
    const Matrix pruned = distances(graph_of(index->data(), 0.0));
    ASSERT_EQ(pruned.size(), complete.size());
    for (std::size_t a = 0; a < complete.size(); ++a) {
      for (std::size_t b = 0; b < complete.size(); ++b) {
        if (complete[a][b] == unreachable) {
          ASSERT_EQ(pruned[a][b], unreachable);
        } else {
          ASSERT_NEAR(pruned[a][b], complete[a][b], 1e-12 * complete[a][b]) << "nodes " << a << ", " << b;
        }
      }
    }
  }
}

TEST(SearchGraph, WithDeltaZeroNoDistanceChangesUnderTheRuleForArcsEither) {
  // With second-layer arcs of some parents only, as in a search between two points.
  for (const auto& index : small_indexes()) {
    const IndexData& data = index->data();
    const SearchGraph complete = complete_graph(data);
    const SearchGraph pruned = graph_of(data, 0.0);
    for (Index open = 0; open < data.first.patch_count; ++open) {
      auto usable = [&](const Arc& arc) {
        return arc.leg.in_first_layer() || data.partition.parent[arc.leg.patch()] == open;
      };
      for (Index start : test::random_vertices(data.second.node_count(), 20, 3)) {
        const auto expected = test::dijkstra(complete, {{start, 0.0}}, usable);
        const auto found = test::dijkstra(pruned, {{start, 0.0}}, usable);
        for (std::size_t node = 0; node < found.size(); ++node) {
          if (expected[node] == unreachable) {
            ASSERT_EQ(found[node], unreachable);
          } else {
            ASSERT_NEAR(found[node], expected[node], 1e-12 * expected[node]);
          }
        }
      }
    }
  }
}

TEST(SearchGraph, TheErrorStaysBelowDeltaAndArcsGetFewer) {
  for (const auto& index : test::one_under_sanitizers(small_indexes())) {
    const Matrix complete = distances(complete_graph(index->data()));
    const SearchGraph lossless = graph_of(index->data(), 0.0);
    std::size_t arcs_before = lossless.arc.size();
    EXPECT_LE(static_cast<std::int64_t>(arcs_before / 2), lossless.arcs_before_pruning);
    for (double delta : {0.001, 0.005, 0.02, 0.1}) {
      const SearchGraph graph = graph_of(index->data(), delta);
      EXPECT_EQ(graph.arcs_before_pruning, lossless.arcs_before_pruning);
      EXPECT_LT(graph.arc.size(), arcs_before) << "delta " << delta;
      arcs_before = graph.arc.size();
      const Matrix pruned = distances(graph);
      double sum = 0.0;
      double count = 0.0;
      for (std::size_t a = 0; a < complete.size(); ++a) {
        for (std::size_t b = 0; b < complete.size(); ++b) {
          if (a == b || complete[a][b] == unreachable) continue;
          const double added = pruned[a][b] / complete[a][b] - 1.0;
          ASSERT_GE(added, -1e-12);
          ASSERT_LE(added, delta + 1e-6) << "no single distance grows by more than delta";
          sum += added;
          count += 1.0;
        }
      }
      EXPECT_LT(sum / count, delta);
    }
  }
}

TEST(SearchGraph, ArcsAreTableEntriesStoredAtBothEndsOnce) {
  for (const auto& index : small_indexes()) {
    const IndexData& data = index->data();
    const SearchGraph graph = graph_of(data, 0.0);
    std::map<std::array<Index, 4>, float> found;
    for (Index node = 0; node < data.second.node_count(); ++node) {
      for (const Arc& arc : graph.arcs(node)) {
        ASSERT_TRUE(
            found
                .emplace(std::array{node, arc.target, static_cast<Index>(arc.leg.table()), arc.leg.patch()},
                         arc.length)
                .second)
            << "stored twice";
        const PatchLayer& layer = arc.leg.in_first_layer() ? data.first : data.second;
        auto row_of = [&](Index end) {
          for (const PatchRow& at : layer.patches_of(layer.vertex_node[data.second.node_vertex[end]])) {
            if (at.patch == arc.leg.patch()) return at.row;
          }
          return no_index;
        };
        ASSERT_NE(row_of(node), no_index);
        ASSERT_NE(row_of(arc.target), no_index);
        EXPECT_EQ(arc.length, layer.distance(arc.leg.patch(), row_of(arc.target), row_of(node)));
      }
    }
    for (const auto& [arc, length] : found) {
      const auto back = found.find({arc[1], arc[0], arc[2], arc[3]});
      ASSERT_NE(back, found.end());
      EXPECT_EQ(back->second, length);
    }
  }
}

TEST(SearchGraph, LandmarksHoldGraphDistances) {
  for (const auto& index : small_indexes()) {
    const SearchGraph graph = graph_of(index->data(), 0.0);
    const Matrix all = distances(graph);
    for (int l = 0; l < SearchGraph::landmark_count; ++l) {
      // The landmark is a node with this very column; nodes that it does not reach hold 0.
      bool explained = false;
      for (std::size_t mark = 0; mark < all.size() && !explained; ++mark) {
        explained = true;
        for (std::size_t node = 0; node < all.size() && explained; ++node) {
          const double expected = all[mark][node] == unreachable ? 0.0 : all[mark][node];
          explained = std::abs(graph.landmarks(static_cast<Index>(node))[l] - expected) <= 1e-12 * expected;
        }
      }
      EXPECT_TRUE(explained) << "landmark " << l;
    }
    // So the difference is a lower bound, whatever the pair.
    for (std::size_t a = 0; a < all.size(); ++a) {
      for (std::size_t b = 0; b < all.size(); ++b) {
        for (int l = 0; l < SearchGraph::landmark_count; ++l) {
          const double bound =
              std::abs(graph.landmarks(static_cast<Index>(a))[l] - graph.landmarks(static_cast<Index>(b))[l]);
          ASSERT_LE(bound, all[a][b] * (1.0 + 1e-12));
        }
      }
    }
  }
}

TEST(SearchGraph, TheSameWhateverTheThreads) {
  const auto index = test::make_index(test::hills(24, 0.2), 4, 4);
  for (double delta : {0.0, 0.01}) {
    const SearchGraph one = graph_of(index->data(), delta, 1);
    const SearchGraph three = graph_of(index->data(), delta, 3);
    EXPECT_EQ(three.arc_begin, one.arc_begin);
    EXPECT_EQ(three.landmark_distance, one.landmark_distance);
    ASSERT_EQ(three.arc.size(), one.arc.size());
    for (std::size_t i = 0; i < one.arc.size(); ++i) {
      EXPECT_EQ(three.arc[i].target, one.arc[i].target);
      EXPECT_EQ(three.arc[i].length, one.arc[i].length);
      EXPECT_EQ(three.arc[i].leg, one.arc[i].leg);
    }
  }
}

/// One patch with the given table, square and symmetric, and a first layer without nodes.
SearchGraph graph_of_table(const std::vector<std::vector<float>>& table, double delta) {
  const auto k = static_cast<Index>(table.size());
  PatchLayer second;
  second.patch_count = 1;
  for (Index v = 0; v < k; ++v) {
    second.node_vertex.push_back(v);
    second.vertex_node.push_back(v);
    second.border_node.push_back(v);
    second.member.push_back(v);
  }
  second.border_begin = {0, k};
  second.member_begin = {0, k};
  second.table_begin = {0, static_cast<std::size_t>(k) * k};
  TableDraft draft(second, 0);
  for (Index v = 0; v < k; ++v) std::copy(table[v].begin(), table[v].end(), draft.line(v));
  std::vector<std::uint16_t> entries(second.table_begin.back());
  second.scale = {draft.write(second.order, entries.data()).scale};
  second.table = SharedArray(std::move(entries));
  PatchLayer first;
  first.patch_count = 1;
  first.border_begin = {0, 0};
  first.member_begin = {0, 0};
  first.table_begin = {0, 0};
  return make_search_graph(second, first, std::array<Index, 1>{0}, delta, 1, {});
}

TEST(SearchGraph, AnArcIsDroppedOnlyIfTwoOthersAreAsShort) {
  const SearchGraph line = graph_of_table({{0, 1, 3}, {1, 0, 2}, {3, 2, 0}}, 0.0);
  EXPECT_EQ(line.arc.size(), 4U) << "1 + 2 = 3";
  const SearchGraph triangle = graph_of_table({{0, 1, 2.9F}, {1, 0, 2}, {2.9F, 2, 0}}, 0.0);
  EXPECT_EQ(triangle.arc.size(), 6U);
  EXPECT_EQ(graph_of_table({{0, 1, 2.9F}, {1, 0, 2}, {2.9F, 2, 0}}, 0.05).arc.size(), 4U)
      << "3 <= 2.9 * 1.05";
  EXPECT_EQ(graph_of_table({{0, 1, 2.9F}, {1, 0, 2}, {2.9F, 2, 0}}, 0.03).arc.size(), 6U);
}

TEST(SearchGraph, NodesAtNearlyTheSamePlaceStayConnected) {
  // Two nodes 1e-20 apart or at distance 0: the arcs to a third must not drop each other.
  for (float tiny : {1e-20F, 0.0F}) {
    for (double delta : {0.0, 0.01}) {
      const SearchGraph graph = graph_of_table({{0, tiny, 1}, {tiny, 0, 1}, {1, 1, 0}}, delta);
      const Matrix all = distances(graph);
      EXPECT_NEAR(all[0][2], 1.0, 1e-6);
      EXPECT_NEAR(all[1][2], 1.0, 1e-6);
      EXPECT_LE(all[0][1], tiny);
    }
  }
}

}  // namespace
}  // namespace vorogeo
