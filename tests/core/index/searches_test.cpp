// Searches along a corridor: as close to exact distances as full searches, and equal to these nearly
// everywhere.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "exact/exact_solver.h"
#include "index/boundary_dijkstra.h"
#include "index/scans.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

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
  // Sources far from each other and on both components: the batch saves nothing, but finds all distances.
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

}  // namespace
}  // namespace vorogeo
