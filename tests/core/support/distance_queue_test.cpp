// Items in the order of their distances, which decrease while they wait.
#include "support/distance_queue.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vorogeo {
namespace {

TEST(DistanceQueue, TakesWhatASortedSetTakes) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  constexpr Index count = 50;
  DistanceQueue queue(count);
  std::vector<double> distance(count, unreachable);
  std::set<std::pair<double, Index>> expected;
  for (int step = 0; step < 20'000; ++step) {
    const Index item = std::uniform_int_distribution<Index>(0, count - 1)(random);
    // Whole numbers, so that many are equal.
    const auto at = static_cast<double>(random() % 100);
    if (random() % 3 != 0 && (!expected.contains({distance[item], item}) || at < distance[item])) {
      expected.erase({distance[item], item});
      distance[item] = at;
      expected.insert({at, item});
      queue.push(item, at);
    } else if (!queue.empty()) {
      ASSERT_EQ(std::pair(queue.first().distance, queue.first().number), *expected.begin());
      expected.erase(expected.begin());
      queue.pop();
    }
    if (step % 5000 == 4999) {
      queue.clear();
      expected.clear();
    }
    ASSERT_EQ(queue.empty(), expected.empty());
  }
}

}  // namespace
}  // namespace vorogeo
