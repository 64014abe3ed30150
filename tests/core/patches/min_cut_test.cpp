// Minimum cuts: against all cuts of small graphs, and by the maximum flow through a grid.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "patches/border_cut.h"

namespace vorogeo {
namespace {

struct Edge {
  Index a;
  Index b;
  std::int64_t capacity;
};

template <class BesideSource>
std::int64_t capacity_of_cut(const std::vector<Edge>& edges, BesideSource&& beside_source) {
  std::int64_t sum = 0;
  for (const Edge& edge : edges) {
    if (beside_source(edge.a) != beside_source(edge.b)) sum += edge.capacity;
  }
  return sum;
}

TEST(MinCut, NoOtherCutOfARandomGraphIsCheaper) {
  MinCut cut;
  for (unsigned seed = 0; seed < 50; ++seed) {
    std::mt19937 random(seed);
    constexpr unsigned nodes = 8;
    std::vector<Edge> edges;
    for (int i = 0; i < 16; ++i) {
      const auto a = static_cast<Index>(random() % nodes);
      const auto b = static_cast<Index>(random() % nodes);
      if (a != b) edges.push_back({a, b, static_cast<std::int64_t>(random() % 10)});
    }
    cut.reset(nodes);
    for (const Edge& edge : edges) cut.join(edge.a, edge.b, edge.capacity);
    const std::int64_t found = cut.run();
    EXPECT_TRUE(cut.beside_source(MinCut::source));
    EXPECT_FALSE(cut.beside_source(MinCut::sink));
    EXPECT_EQ(found, capacity_of_cut(edges, [&](Index node) { return cut.beside_source(node); }));
    for (unsigned set = 0; set < 1U << nodes; ++set) {
      if ((set & 1U) == 0 || (set & 2U) != 0) continue;
      const auto other = capacity_of_cut(edges, [&](Index node) { return (set >> node & 1U) != 0; });
      ASSERT_LE(found, other) << "seed " << seed;
    }
  }
}

TEST(MinCut, NothingPassesBetweenPartsThatAreNotJoined) {
  MinCut cut;
  cut.reset(4);
  cut.join(MinCut::source, 2, 5);
  cut.join(3, MinCut::sink, 5);
  EXPECT_EQ(cut.run(), 0);
  EXPECT_TRUE(cut.beside_source(2));
  EXPECT_FALSE(cut.beside_source(3));
}

TEST(MinCut, AStripBreaksAtItsNarrowestPlace) {
  // Node 2 + 10 i + j of a strip 40 long and 10 wide; in column 17 each arc is the cheapest by one.
  constexpr Index length = 40;
  constexpr Index width = 10;
  MinCut cut;
  cut.reset(2 + length * width);
  auto node = [&](Index i, Index j) { return 2 + width * i + j; };
  for (Index j = 0; j < width; ++j) {
    cut.join(MinCut::source, node(0, j), 100);
    cut.join(node(length - 1, j), MinCut::sink, 100);
    for (Index i = 0; i + 1 < length; ++i) cut.join(node(i, j), node(i + 1, j), i == 17 ? 6 : 7);
    for (Index i = 0; i < length && j + 1 < width; ++i) cut.join(node(i, j), node(i, j + 1), 9);
  }
  EXPECT_EQ(cut.run(), 6 * width);
  for (Index i = 0; i < length; ++i) EXPECT_EQ(cut.beside_source(node(i, 3)), i <= 17);
}

}  // namespace
}  // namespace vorogeo
