// The plugin's cache of indexes: found by the whole mesh; bounded in number and in memory.
#include "layers/index_cache.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo::plugin {
namespace {

struct Cached {
  VcgMeshArrays arrays;
  std::shared_ptr<const GeodesicIndex> index;
};

/// Indexes of meshes that differ in position only, so that all take the same memory.
std::vector<Cached> indexes(int count) {
  std::vector<Cached> all;
  for (int i = 0; i < count; ++i) {
    test::Soup soup = test::icosphere(1);
    for (Point& p : soup.positions) p[0] += i;
    VcgMeshArrays arrays;
    arrays.positions = soup.positions;
    arrays.faces = soup.faces;
    all.push_back({arrays, test::make_index(soup, 2, 2)});
  }
  return all;
}

/// Which of the indexes a cache holds, looked up in their order.
std::vector<bool> kept(IndexCache& cache, const std::vector<Cached>& all) {
  std::vector<bool> found;
  for (const Cached& c : all) {
    const auto index = cache.find(c.arrays, {});
    EXPECT_TRUE(!index || index == c.index);
    found.push_back(index != nullptr);
  }
  return found;
}

TEST(IndexCache, KnowsTheMetric) {
  const auto all = indexes(1);
  VcgMeshArrays costly = all[0].arrays;
  costly.sides.assign(costly.faces.size(), {1.0, 1.0, 1.0});
  IndexCache cache;
  cache.put(all[0].arrays, {}, all[0].index);
  EXPECT_EQ(cache.find(costly, {}), nullptr);
  cache.put(costly, {}, all[0].index);
  EXPECT_EQ(cache.find(costly, {}), all[0].index);
  EXPECT_EQ(cache.find(all[0].arrays, {}), all[0].index);
  VcgMeshArrays split = costly;  // sides of whole faces do not tell
  split.splits.sides = costly.sides;
  EXPECT_EQ(cache.find(split, {}), nullptr);
  costly.sides.back()[2] = 1.5;
  EXPECT_EQ(cache.find(costly, {}), nullptr);
}

TEST(IndexCache, KeepsTheFourUsedLast) {
  const auto all = indexes(6);
  IndexCache cache;
  for (int i = 0; i < 4; ++i) cache.put(all[i].arrays, {}, all[i].index);
  EXPECT_EQ(cache.find(all[0].arrays, {}), all[0].index);  // now 1 is the one used longest ago
  cache.put(all[4].arrays, {}, all[4].index);
  EXPECT_EQ(kept(cache, all), (std::vector<bool>{true, false, true, true, true, false}));
}

TEST(IndexCache, RemembersWhatExactAnswersTookOnAMesh) {
  IndexCache cache;
  auto number = [](std::uint64_t i) { return Fingerprint{{i, 0}}; };
  RentOrBuy spent = cache.spent(number(1), 10);
  EXPECT_EQ(spent.rent(), 0.0);
  spent.pay(3.0);
  cache.keep_spent(number(1), spent);
  EXPECT_EQ(cache.spent(number(1), 10).rent(), 3.0);
  EXPECT_EQ(cache.spent(number(2), 10).rent(), 0.0);
  for (std::uint64_t i = 2; i < 80; ++i) cache.keep_spent(number(i), spent);
  EXPECT_EQ(cache.spent(number(1), 10).rent(), 0.0);
  EXPECT_EQ(cache.spent(number(79), 10).rent(), 3.0);
}

TEST(IndexCache, DropsTheOldestWhileTheyTakeTooMuchMemory) {
  const auto all = indexes(4);
  const std::int64_t size = all[0].index->statistics().bytes;
  ASSERT_GT(size, 0);
  IndexCache cache(2 * size + size / 2);
  for (const Cached& c : all) cache.put(c.arrays, {}, c.index);
  EXPECT_EQ(kept(cache, all), (std::vector<bool>{false, false, true, true}));
}

TEST(IndexCache, KeepsTheNewestHoweverLarge) {
  const auto all = indexes(3);
  IndexCache cache(1);
  for (const Cached& c : all) {
    cache.put(c.arrays, {}, c.index);
    EXPECT_EQ(cache.find(c.arrays, {}), c.index);
  }
  EXPECT_EQ(kept(cache, all), (std::vector<bool>{false, false, true}));
}

TEST(IndexCache, AnotherIndexOfTheSameMeshTakesItsPlace) {
  const auto all = indexes(2);
  IndexCache cache;
  for (const Cached& c : all) cache.put(c.arrays, {}, c.index);
  const auto again = indexes(1)[0].index;
  cache.put(all[0].arrays, {}, again);
  EXPECT_EQ(cache.find(all[0].arrays, {}), again);
  EXPECT_EQ(cache.find(all[1].arrays, {}), all[1].index);
}

TEST(IndexCache, AnEditedMeshHasNone) {
  const auto all = indexes(1);
  IndexCache cache;
  cache.put(all[0].arrays, {}, all[0].index);
  VcgMeshArrays moved = all[0].arrays;
  moved.positions[3][2] += 1e-9;
  EXPECT_EQ(cache.find(moved, {}), nullptr);
  VcgMeshArrays smaller = all[0].arrays;
  smaller.faces.pop_back();
  EXPECT_EQ(cache.find(smaller, {}), nullptr);
  EXPECT_EQ(cache.find(all[0].arrays, {}), all[0].index);
}

}  // namespace
}  // namespace vorogeo::plugin
