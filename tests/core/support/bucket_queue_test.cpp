// Queue in buckets: against a sorted list, with keys far ahead, lowered and late ones, limits, and reuse.
#include "support/bucket_queue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>

namespace vorogeo {
namespace {

TEST(BucketQueue, EmptyGivesNothing) {
  BucketQueue queue;
  queue.resize(5);
  queue.reset(1.0);
  EXPECT_EQ(queue.pop(), no_index);
  EXPECT_EQ(queue.pop(), no_index);
}

TEST(BucketQueue, ItemsLeaveInTheOrderOfTheirBucketsEachOnce) {
  BucketQueue queue;
  queue.resize(3000);
  std::mt19937 random(4);
  // Keys over up to eighty times as many buckets as a wheel has.
  std::uniform_real_distribution<double> key(0.0, 10240.0);
  queue.reset(0.5);
  std::vector<double> key_of(3000);
  for (Index item = 0; item < 3000; ++item) queue.push(item, key_of[item] = key(random));
  std::vector<int> taken(3000, 0);
  double last = 0.0;
  for (Index item = queue.pop(); item != no_index; item = queue.pop()) {
    ++taken[item];
    const double bucket = std::floor(key_of[item] / 0.5);
    EXPECT_GE(bucket, last);
    EXPECT_LE(queue.lower_bound(), key_of[item]);
    last = bucket;
  }
  for (int count : taken) EXPECT_EQ(count, 1);
}

TEST(BucketQueue, ALimitKeepsItemsOfLaterBuckets) {
  // Items are taken in steps: each in the step in which its bucket begins, and late ones first.
  BucketQueue queue;
  queue.resize(3001);
  queue.reset(0.5);
  EXPECT_EQ(queue.least_key(), unreachable);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> key(1.0, 10240.0);
  std::vector<double> key_of(3000);
  for (Index item = 0; item < 3000; ++item) queue.push(item, key_of[item] = key(random));
  std::size_t left = key_of.size();
  for (double limit = 0.0; left > 0; limit += 64.0) {
    const double least = *std::min_element(key_of.begin(), key_of.end());
    EXPECT_LE(queue.least_key(), least);
    for (Index item = queue.pop(limit); item != no_index; item = queue.pop(limit), --left) {
      EXPECT_LT(0.5 * std::floor(key_of[item] / 0.5), limit);
      key_of[item] = unreachable;
    }
    for (double k : key_of) EXPECT_GE(k, limit);
    queue.push(3000, 0.25);
    EXPECT_EQ(queue.pop(limit + 64.0), 3000);
  }
  EXPECT_EQ(queue.pop(), no_index);
  EXPECT_EQ(queue.least_key(), unreachable);
  // Far away, with nothing before it.
  queue.push(7, 1e6);
  EXPECT_NEAR(queue.least_key(), 1e6, 1e-6);
}

TEST(BucketQueue, ABucketThatIsNeverDoneGetsToItsOldestItem) {
  // Each item taken adds another to the same bucket: last in, first out alone would never return to item 0.
  BucketQueue queue;
  queue.resize(3);
  queue.reset(1.0);
  queue.push(0, 0.5);
  Index next = 1;
  queue.push(next, 0.1);
  bool seen = false;
  for (int i = 0; i < 100000 && !seen; ++i) {
    const Index item = queue.pop();
    ASSERT_NE(item, no_index);
    seen = item == 0;
    next = 3 - next;
    queue.push(next, 0.1);
  }
  EXPECT_TRUE(seen);
  // Items after such a bucket are found as usual.
  for (int i = 0; i < 3 && queue.pop() != no_index; ++i) {
  }
  EXPECT_EQ(queue.pop(), no_index);
  queue.push(0, 5000.5);
  queue.push(1, 7.5);
  EXPECT_EQ(queue.pop(), 1);
  EXPECT_EQ(queue.pop(), 0);
  EXPECT_EQ(queue.pop(), no_index);
}

TEST(BucketQueue, OnceAnItemHasComeBackToItsBucketOthersThereAreTakenInTheOrderOfTheirKeys) {
  BucketQueue queue;
  queue.resize(5);
  queue.reset(1.0);
  // The order is the same in every run, whatever earlier runs have taken.
  for (int run = 0; run < 3; ++run) {
    queue.push(0, 3.5);
    EXPECT_EQ(queue.pop(), 0);
    queue.push(1, 3.1);
    queue.push(2, 3.9);
    EXPECT_EQ(queue.pop(), 2);  // last in, first out
    EXPECT_EQ(queue.pop(), 1);
    queue.push(0, 3.4);
    EXPECT_EQ(queue.pop(), 0);
    queue.push(0, 3.3);  // for the third time
    queue.push(3, 3.8);
    queue.push(4, 3.2);
    queue.push(1, 3.7);
    for (const Index item : {4, 0, 1, 3}) EXPECT_EQ(queue.pop(), item);
    // In the next bucket, it is last in, first out again.
    queue.push(0, 4.5);
    EXPECT_EQ(queue.pop(), 0);
    queue.push(1, 4.1);
    queue.push(2, 4.9);
    EXPECT_EQ(queue.pop(), 2);
    EXPECT_EQ(queue.pop(), 1);
    EXPECT_EQ(queue.pop(), no_index);
    queue.reset(1.0);
  }
}

TEST(BucketQueue, ASortedItemIsNotTakenByAKeyThatItHadBefore) {
  BucketQueue queue;
  queue.resize(4);
  queue.reset(1.0);
  queue.push(1, 3.0);
  queue.push(0, 3.9);
  EXPECT_EQ(queue.pop(), 0);
  queue.push(0, 3.9);
  EXPECT_EQ(queue.pop(), 0);
  EXPECT_EQ(queue.pop(), 1);
  queue.push(0, 3.3);  // from here on, in the order of the keys
  queue.push(0, 3.2);
  EXPECT_EQ(queue.pop(), 0);
  queue.push(0, 3.6);
  queue.push(2, 3.5);
  EXPECT_EQ(queue.pop(), 2);
  EXPECT_EQ(queue.pop(), 0);
  EXPECT_EQ(queue.pop(), no_index);
}

TEST(BucketQueue, KeysOfAllScalesCostAConstantEach) {
  // 1e5 keys over 21 orders of magnitude: stepping from bucket to bucket, or examining all later items for
  // each of them, would take hours.
  constexpr Index count = 100000;
  BucketQueue queue;
  queue.resize(count);
  queue.reset(0.25);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> exponent(-9.0, 12.0);
  std::vector<double> key_of(count);
  for (Index item = 0; item < count; ++item)
    queue.push(item, key_of[item] = std::pow(10.0, exponent(random)));
  std::vector<int> taken(count, 0);
  for (Index item = queue.pop(); item != no_index; item = queue.pop()) {
    ++taken[item];
    ASSERT_LE(queue.lower_bound(), key_of[item]);
  }
  for (int times : taken) ASSERT_EQ(times, 1);
}

TEST(BucketQueue, MemoryStaysThatOfTheEntriesHoweverOftenItIsUsed) {
  // Keys over several turns of the first wheel, so that entries lie together on the second before each gets a
  // bucket of its own there. An entry takes 16 bytes, and lists have up to twice the room that they need.
  constexpr Index count = 20000;
  BucketQueue queue;
  queue.resize(count);
  const std::size_t empty = queue.memory_bytes();
  const auto seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> key(0.0, 1000.0);
  for (int use = 0; use < 20; ++use) {
    queue.reset(1.0);
    for (Index item = 0; item < count; ++item) queue.push(item, key(random));
    for (Index item = 0; item < count; ++item) ASSERT_NE(queue.pop(), no_index);
  }
  EXPECT_LT(queue.memory_bytes() - empty, 6u * 16u * count);
}

TEST(BucketQueue, GivesWhatASortedListGivesWhateverTheWidthsLimitsAndLateKeys) {
  // The pattern of solvers that share a run: items up to a limit are taken, and each adds others at distances
  // of all scales; then others come from elsewhere, also with keys below those taken, and the limit moves on.
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int taken_before = 0;  // items of crowded buckets that were taken before their turn
  for (int round = 0; round < 200; ++round) {
    BucketQueue queue;
    queue.resize(150);
    const double width = std::exp(uniform(-30.0, 30.0));
    queue.reset(width);
    const double spread = uniform(0.0, 30.0);  // scales of the steps, as powers of e
    std::map<Index, double> expected;          // the least key by item
    auto push = [&](double from) {
      const auto item = static_cast<Index>(random() % 150);
      const double key = from + width * std::exp(uniform(-5.0, spread));
      queue.push(item, key);
      const auto [at, added] = expected.try_emplace(item, key);
      if (!added) at->second = std::min(at->second, key);
    };
    auto least = [&] {
      double key = unreachable;
      for (const auto& [item, at] : expected) key = std::min(key, at);
      return key;
    };
    for (int i = 0; i < 20; ++i) push(0.0);
    double limit = 0.0;
    double late_from = 0.0;
    std::set<Index> put_off;
    for (int pushes = 0; !expected.empty() || pushes < 1000;) {
      ASSERT_LE(queue.least_key(), least());
      late_from = limit;
      limit = std::max(limit, queue.least_key() < unreachable ? queue.least_key() : 0.0) +
              width * std::exp(uniform(-3.0, spread));
      for (Index item = queue.pop(limit); item != no_index; item = queue.pop(limit)) {
        // An item that was put off and then taken before its turn comes once more.
        if (const bool was_put_off = put_off.erase(item) > 0; !expected.contains(item)) {
          ASSERT_TRUE(was_put_off);
          continue;
        }
        if (queue.is_crowded()) {
          const auto due = std::ranges::find_if(
              expected, [&](const auto& other) { return other.first != item && queue.is_due(other.first); });
          if (due != expected.end() && random() % 2 == 0) {
            queue.take_before(due->first, item);
            put_off.insert(item);
            item = due->first;
            ++taken_before;
          }
        }
        const double key = expected[item];
        ASSERT_LE(key, std::max(limit, least()) + width * (1.0 + 1e-9) + 1e-12 * limit);
        if (put_off.empty()) {
          ASSERT_LE(key, least() + width * (1.0 + 1e-9) + 1e-12 * key) << "overtaken by more than a bucket";
        }
        ASSERT_LE(queue.lower_bound(), least());
        expected.erase(item);
        for (int i = 0; i < 3 && pushes < 1000; ++i, ++pushes) push(key);
      }
      ASSERT_GE(least(), limit * (1.0 - 1e-12)) << "an item below the limit was not given";
      for (int i = 0; i < 4 && pushes < 1000; ++i, ++pushes) push(uniform(0.5 * late_from, limit));
    }
    EXPECT_EQ(queue.pop(), no_index);
    EXPECT_EQ(queue.least_key(), unreachable);
  }
  EXPECT_GT(taken_before, 0);
}

TEST(BucketQueue, AStartForgetsWhatWasLeft) {
  BucketQueue queue;
  queue.resize(10);
  queue.reset(1.0);
  queue.push(1, 3.0);
  queue.push(2, 1e6);
  queue.push(3, 1e7);
  EXPECT_EQ(queue.pop(), 1);
  queue.reset(0.25);
  EXPECT_EQ(queue.pop(), no_index);
  queue.push(3, 7.0);
  queue.push(2, 2.0);
  EXPECT_EQ(queue.pop(), 2);
  EXPECT_EQ(queue.pop(), 3);
  EXPECT_EQ(queue.pop(), no_index);
}

TEST(BucketQueue, AWidthOfZeroAndHugeKeysDoNoHarm) {
  BucketQueue queue;
  queue.resize(4);
  queue.reset(0.0);
  queue.push(0, 0.0);
  queue.push(1, 1e300);
  queue.push(2, 1e305);
  EXPECT_EQ(queue.pop(), 0);
  const Index next = queue.pop();
  EXPECT_TRUE(next == 1 || next == 2);
  EXPECT_NE(queue.pop(), no_index);
  EXPECT_EQ(queue.pop(), no_index);
}

TEST(BucketQueue, ItemsThatAreDueMayBeTakenBeforeOneThatWasTaken) {
  BucketQueue queue;
  queue.resize(10);
  queue.reset(1.0);
  queue.push(0, 0.5);
  queue.push(1, 0.7);
  queue.push(2, 0.8);
  queue.push(3, 1.5);
  ASSERT_EQ(queue.pop(), 2);
  EXPECT_TRUE(queue.is_due(0));
  EXPECT_FALSE(queue.is_due(3));
  queue.take_before(0, 2);
  queue.take_before(1, 0);
  EXPECT_FALSE(queue.is_due(0));
  EXPECT_FALSE(queue.is_due(1));
  EXPECT_LE(queue.least_key(), 0.5);
  // An item that was put off and is pushed again comes back only once.
  queue.push(0, 0.6);
  EXPECT_EQ(queue.pop(), 0);
  EXPECT_EQ(queue.pop(0.0), 2);
  EXPECT_EQ(queue.pop(), 3);
  EXPECT_EQ(queue.pop(), no_index);
}

}  // namespace
}  // namespace vorogeo
