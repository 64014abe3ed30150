// The sweep alone: lanes against full searches, lanes that are empty, and lanes that are used again.
#include <gtest/gtest.h>

#include <cmath>

#include "index/boundary_dijkstra.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

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
