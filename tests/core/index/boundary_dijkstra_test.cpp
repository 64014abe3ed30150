// Search over the border nodes of a layer: against straight lines in the plane and against plain Dijkstra.
#include "index/boundary_dijkstra.h"

#include <gtest/gtest.h>

#include <queue>

#include "exact/exact_solver.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// Least sums of table entries, without unfolding.
std::vector<double> plain_sums(const PatchLayer& layer, Index seed,
                               const std::vector<std::uint8_t>& allowed = {}) {
  std::vector<double> distance(layer.node_count(), unreachable);
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  distance[seed] = 0.0;
  queue.emplace(0.0, seed);
  while (!queue.empty()) {
    const auto [key, node] = queue.top();
    queue.pop();
    if (key > distance[node]) continue;
    for (const PatchRow& at : layer.patches_of(node)) {
      if (!allowed.empty() && !allowed[at.patch]) continue;
      for (Index i = 0; i < layer.border_size(at.patch); ++i) {
        const double through = key + layer.distance(at.patch, at.row, i);
        const Index other = layer.nodes(at.patch)[i];
        if (through >= distance[other]) continue;
        distance[other] = through;
        queue.emplace(through, other);
      }
    }
  }
  return distance;
}

/// Entries are rounded to 1 / 32766 of the greatest of their table, which in these patches is at most some
/// ten edges.
constexpr double rounding = 1e-3;

struct Comparison {
  test::ErrorStatistics with_unfolding;
  test::ErrorStatistics without;
};

/// Searches from some nodes to all others; every distance is at most the plain sum, up to `slack`: two arcs
/// in a row through one patch are not tried, which loses something where a table entry is too long because
/// its path leaves the halo.
Comparison compare(const GeodesicIndex& index, double slack) {
  const PatchLayer& layer = index.data().second;
  BoundaryDijkstra search(layer);
  ExactSolver solver(index.data().geometry->windows);
  test::ErrorCollector unfolded;
  test::ErrorCollector sums;
  for (Index seed : test::random_vertices(layer.node_count(), 8, 7)) {
    const auto plain = plain_sums(layer, seed);
    solver.run_from_vertices(std::array{layer.node_vertex[seed]});
    search.reset();
    search.add(seed, 0.0);
    search.run();
    for (Index node = 0; node < layer.node_count(); ++node) {
      EXPECT_LE(search.distance(node), plain[node] * (1.0 + slack)) << "node " << node;
      unfolded.add(search.distance(node), solver.distance(layer.node_vertex[node]));
      sums.add(plain[node], solver.distance(layer.node_vertex[node]));
    }
  }
  EXPECT_EQ(unfolded.contradictions, 0U);
  return {unfolded.statistics(), sums.statistics()};
}

TEST(BoundaryDijkstra, InThePlaneUnfoldingGivesStraightLines) {
  const auto index = test::make_index(test::plane_grid(50, 50, 1.0, 1.0, 0.2).soup, 4, 5);
  const Comparison found = compare(*index, rounding);
  EXPECT_GT(found.without.least, -rounding) << "sums of exact distances are upper bounds";
  EXPECT_LT(found.with_unfolding.mean, 0.5 * found.without.mean);
  EXPECT_LT(found.with_unfolding.mean, 5e-4);
  EXPECT_LT(found.with_unfolding.p99, 5e-3);
  EXPECT_GT(found.with_unfolding.least, -2e-3);
}

TEST(BoundaryDijkstra, WithinABoundAsWithoutOne) {
  const auto index = test::make_index(test::hills(40, 0.15), 4, 4);
  const PatchLayer& layer = index->data().second;
  BoundaryDijkstra whole(layer);
  whole.reset();
  whole.add(0, 0.0);
  whole.run();
  BoundaryDijkstra bounded(layer);
  bounded.reset();
  bounded.add(0, 0.0);
  bounded.run({}, 0.4);
  for (Index node = 0; node < layer.node_count(); ++node) {
    if (whole.distance(node) > 0.4 * 0.99) continue;
    EXPECT_EQ(bounded.distance(node), whole.distance(node));
  }
}

TEST(BoundaryDijkstra, WavesOfDifferentSourcesAreNotOne) {
  const Index first = BoundaryDijkstra::source_name(0);
  const Index second = BoundaryDijkstra::source_name(1);
  EXPECT_TRUE(BoundaryDijkstra::may_share_wave(first, first));
  EXPECT_FALSE(BoundaryDijkstra::may_share_wave(first, second));
  EXPECT_TRUE(BoundaryDijkstra::may_share_wave(first, 3));
  EXPECT_TRUE(BoundaryDijkstra::may_share_wave(3, 4));
}

TEST(BoundaryDijkstra, AcrossImprovesASum) {
  // In the plane: each inner vertex of a patch over the border of the patch, from an exact distance at its
  // nodes.
  const auto index = test::make_index(test::plane_grid(40, 40, 1.0, 1.0, 0.2).soup, 3, 4);
  const IndexData& data = index->data();
  const PatchLayer& layer = data.second;
  const Index source = data.work.work_vertex[0];
  ExactSolver solver(data.geometry->windows);
  solver.run_from_vertices(std::array{source});
  BoundaryDijkstra search(layer);
  search.reset();
  for (Index node = 0; node < layer.node_count(); ++node)
    search.add(node, solver.distance(layer.node_vertex[node]));
  test::ErrorCollector sums;
  test::ErrorCollector improved;
  for (Index p = 0; p < layer.patch_count; ++p) {
    if (p == data.home_patch[source]) continue;
    for (Index column = layer.border_size(p); column < layer.member_count(p); ++column) {
      Index best_row = 0;
      double best = unreachable;
      for (Index row = 0; row < layer.border_size(p); ++row) {
        const double sum = search.distance(layer.nodes(p)[row]) + layer.distance(p, row, column);
        if (sum >= best) continue;
        best = sum;
        best_row = row;
      }
      const double exact = solver.distance(layer.members(p)[column]);
      const double across = search.across(p, best_row, column, best);
      EXPECT_LE(across, best);
      sums.add(best, exact);
      improved.add(across, exact);
    }
  }
  EXPECT_GT(improved.statistics().least, -1e-3);
  EXPECT_LT(improved.statistics().mean, 0.1 * sums.statistics().mean);
}

}  // namespace
}  // namespace vorogeo
