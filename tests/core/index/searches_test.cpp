// Searches over border nodes: against straight lines, plain Dijkstra and searches of their own.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <queue>

#include "exact/exact_solver.h"
#include "index/boundary_dijkstra.h"
#include "index/scans.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

// Search over the border nodes of a layer: against straight lines in the plane and against plain Dijkstra.

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
  test::PlaceSolver solver(index.data());
  test::ErrorCollector unfolded;
  test::ErrorCollector sums;
  for (Index seed : test::random_vertices(layer.node_count(), 8, 7)) {
    const auto plain = plain_sums(layer, seed);
    solver.run_from(layer.node_place[seed]);
    search.reset();
    search.add(seed, 0.0);
    search.run();
    for (Index node = 0; node < layer.node_count(); ++node) {
      EXPECT_LE(search.distance(node), plain[node] * (1.0 + slack)) << "node " << node;
      unfolded.add(search.distance(node), solver.distance(layer.node_place[node]));
      sums.add(plain[node], solver.distance(layer.node_place[node]));
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
  const Index source = data.surface.vertex[0];
  test::PlaceSolver solver(data);
  solver.run_from(source);
  BoundaryDijkstra search(layer);
  search.reset();
  for (Index node = 0; node < layer.node_count(); ++node)
    search.add(node, solver.distance(layer.node_place[node]));
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

// Searches along a corridor: as close to exact distances as full searches, and equal to these nearly
// everywhere.

std::vector<Index> consecutive(Index begin, Index end) {
  std::vector<Index> list(end - begin);
  std::iota(list.begin(), list.end(), begin);
  return list;
}

TEST(BatchDijkstra, AsFullSearchesFromEachSource) {
  struct Case {
    test::Soup soup;
    int first, second;
  };
  for (const Case& one : {Case{test::hills(40, 0.15), 5, 4}, Case{test::icosphere(4), 6, 4},
                          Case{test::torus(44, 20, 2.0, 0.8), 5, 4}}) {
    const auto index = test::make_index(one.soup, one.first, one.second);
    const IndexData& data = index->data();
    test::PlaceSolver solver(data);
    for (const PatchLayer* layer : {&data.first, &data.second}) {
      BatchDijkstra batch(*layer);
      BoundaryDijkstra full(*layer);
      test::ErrorCollector in_batch, in_full;
      double difference = 0.0;
      std::size_t compared = 0, apart = 0;
      const auto groups = group_by_patches(*layer, 16);
      for (std::size_t g = 0; g + 1 < groups.size(); g += 7) {
        const auto sources = consecutive(groups[g], groups[g + 1]);
        std::size_t calls = 0;
        batch.search_from_each(sources, {}, [&](std::size_t i) {
          ++calls;
          full.reset();
          full.add(sources[i], 0.0);
          full.run();
          for (Index node = 0; node < layer->node_count(); ++node) {
            if (node == sources[i]) {
              EXPECT_EQ(batch.distance(node), 0.0);
              continue;
            }
            const double relative = std::abs(batch.distance(node) / full.distance(node) - 1.0);
            difference += relative;
            ++compared;
            apart += relative > 0.01 ? 1 : 0;
          }
          if (i != 0) return;
          solver.run_from(layer->node_place[sources[i]]);
          for (Index node = 0; node < layer->node_count(); ++node) {
            const double exact = solver.distance(layer->node_place[node]);
            in_batch.add(batch.distance(node), exact);
            in_full.add(full.distance(node), exact);
          }
        });
        EXPECT_EQ(calls, sources.size());
      }
      EXPECT_EQ(in_batch.contradictions, 0U);
      EXPECT_LT(in_batch.statistics().mean, 1.05 * in_full.statistics().mean + 2e-5);
      EXPECT_LT(in_batch.statistics().p99, 1.02 * in_full.statistics().p99 + 1e-4);
      EXPECT_LT(difference / static_cast<double>(compared), 2e-5);
      EXPECT_LT(static_cast<double>(apart), 1e-3 * static_cast<double>(compared));
    }
  }
}

TEST(BatchDijkstra, StaysInTheAllowedPatches) {
  const auto index = test::make_index(test::icosphere(4), 4, 5);
  const PatchLayer& layer = index->data().second;
  std::vector<std::uint8_t> allowed(layer.patch_count, 0);
  for (Index p = 0; p < layer.patch_count; p += 2) allowed[p] = 1;
  BatchDijkstra batch(layer);
  BoundaryDijkstra full(layer);
  const auto groups = group_by_patches(layer, 8);
  for (std::size_t g = 0; g + 1 < groups.size(); g += 3) {
    const auto sources = consecutive(groups[g], groups[g + 1]);
    batch.search_from_each(sources, allowed, [&](std::size_t i) {
      full.reset();
      full.add(sources[i], 0.0);
      full.run(allowed);
      for (Index node = 0; node < layer.node_count(); ++node) {
        EXPECT_EQ(batch.distance(node) < unreachable, full.distance(node) < unreachable);
      }
    });
  }
}

TEST(BatchDijkstra, SourcesThatTheLeaderCannotReach) {
  const auto index = test::make_index(test::two_components(test::icosphere(3), test::icosphere(3)), 6, 2);
  const PatchLayer& layer = index->data().first;
  // Far from each other and on both components: nothing is saved, but everything is found.
  const auto sources = test::random_vertices(layer.node_count(), 10, 3);
  BatchDijkstra batch(layer);
  BoundaryDijkstra full(layer);
  batch.search_from_each(sources, {}, [&](std::size_t i) {
    full.reset();
    full.add(sources[i], 0.0);
    full.run();
    for (Index node = 0; node < layer.node_count(); ++node) {
      if (full.distance(node) == unreachable || node == sources[i]) {
        EXPECT_EQ(batch.distance(node), full.distance(node));
      } else {
        EXPECT_NEAR(batch.distance(node) / full.distance(node), 1.0, 0.01);
      }
    }
  });
}

TEST(MinPlus, RangeWithinIsTheSmallest) {
  const std::vector<std::uint16_t> entries = {9, 5, 7, 3, 8, 4, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 2, 9};
  const std::vector<float> base(entries.size(), 1.0F);
  const auto count = static_cast<Index>(entries.size());
  auto range = [&](float bound) { return range_within(base.data(), entries.data(), {0.5F}, bound, count); };
  EXPECT_EQ(range(3.5F).begin, 1);
  EXPECT_EQ(range(3.5F).end, 19);
  EXPECT_EQ(range(2.5F).begin, 3);
  EXPECT_EQ(range(2.0F).begin, 18);
  EXPECT_EQ(range(2.0F).end, 19);
  EXPECT_EQ(range(1.0F).begin, range(1.0F).end);
}

// The sweep alone: lanes against full searches, lanes that are empty, and lanes that are used again.

/// Nodes next to each other on a border of the first layer, the leader last, and their distances.
struct Group {
  explicit Group(const PatchLayer& of) : layer(of), leader(of), full(of), sweep(of) {
    const std::vector<Index> begin = group_by_patches(layer, 5);
    Index widest = 0;
    for (std::size_t g = 0; g + 1 < begin.size(); ++g) {
      if (begin[g + 1] - begin[g] > begin[widest + 1] - begin[widest]) widest = static_cast<Index>(g);
    }
    for (Index node = begin[widest]; node < begin[widest + 1]; ++node) sources.push_back(node);
    leader.add(sources.back(), 0.0);
    leader.run();
    for (Index source : sources) radius = std::max(radius, leader.distance(source));
    sweep.prepare(leader, {}, 2.1 * radius);
    sweep.clear();
  }
  void add(Index lane, Index source) {
    full.reset();
    full.add(source, 0.0);
    full.run({}, 3.0 * radius);
    sweep.add(lane, full, 3.0 * radius);
  }
  void expect_equal(Index lane, Index source) {
    full.reset();
    full.add(source, 0.0);
    full.run();
    double difference = 0.0;
    for (Index node = 0; node < layer.node_count(); ++node) {
      if (node == source) {
        EXPECT_EQ(sweep.distance(node, lane), 0.0);
        continue;
      }
      const double relative = std::abs(sweep.distance(node, lane) / full.distance(node) - 1.0);
      EXPECT_LT(relative, 1e-2) << node;
      difference += relative;
    }
    EXPECT_LT(difference / layer.node_count(), 2e-5) << lane;
  }

  const PatchLayer& layer;
  BoundaryDijkstra leader, full;
  FollowerSweep sweep;
  std::vector<Index> sources;
  double radius = 0.0;
};

TEST(FollowerSweep, LanesAreSearchesOfTheirOwn) {
  for (const test::Soup& soup : {test::hills(40, 0.15), test::torus(44, 20, 2.0, 0.8)}) {
    const auto index = test::make_index(soup, 5, 4);
    Group group(index->data().first);
    ASSERT_GE(group.sources.size(), 3U);
    // Lanes need not be consecutive; one source may have two.
    group.add(0, group.sources[0]);
    group.add(7, group.sources[1]);
    group.add(FollowerSweep::lanes - 1, group.sources[0]);
    EXPECT_EQ(group.sweep.run(), 0U);
    group.expect_equal(0, group.sources[0]);
    group.expect_equal(7, group.sources[1]);
    for (Index node = 0; node < index->data().first.node_count(); ++node) {
      EXPECT_TRUE(group.sweep.has(node));
      EXPECT_EQ(group.sweep.distance(node, FollowerSweep::lanes - 1), group.sweep.distance(node, 0));
      EXPECT_EQ(group.sweep.distance(node, 3), unreachable);
    }
    group.sweep.clear();
    group.add(7, group.sources[2]);
    EXPECT_EQ(group.sweep.run(), 0U);
    group.expect_equal(7, group.sources[2]);
    EXPECT_EQ(group.sweep.distance(group.sources[0], 0), unreachable);
  }
}

TEST(FollowerSweep, SourcesMuchCloserThanRoundingReachWhatTheLeaderReaches) {
  const auto index = test::make_index(test::hills(40, 0.15), 5, 4);
  const PatchLayer& layer = index->data().first;
  Group group(layer);
  // As if the sources were one place: nothing but rounding is left to find the way.
  group.sweep.prepare(group.leader, {}, 0.0);
  group.sweep.clear();
  group.full.reset();
  group.full.add(group.sources.back(), 0.0);
  group.full.run({}, 0.0);
  group.sweep.add(0, group.full, 0.0);
  EXPECT_EQ(group.sweep.run(), 0U);
  for (Index node = 0; node < layer.node_count(); ++node) {
    EXPECT_NEAR(group.sweep.distance(node, 0), group.leader.distance(node),
                1e-4 * group.leader.distance(node));
  }
}

TEST(FollowerSweep, NodesThatTheLeaderDidNotReachHaveNoDistance) {
  const auto index = test::make_index(test::two_components(test::icosphere(3), test::icosphere(3)), 6, 2);
  Group group(index->data().first);
  group.add(0, group.sources[0]);
  EXPECT_EQ(group.sweep.run(), 0U);
  Index reached = 0;
  for (Index node = 0; node < index->data().first.node_count(); ++node) {
    EXPECT_EQ(group.sweep.has(node), group.leader.distance(node) < unreachable);
    EXPECT_EQ(group.sweep.distance(node, 0) < unreachable, group.sweep.has(node));
    reached += group.sweep.has(node) ? 1 : 0;
  }
  EXPECT_GT(reached, 0);
  EXPECT_LT(reached, index->data().first.node_count());
}

}  // namespace
}  // namespace vorogeo
