// Queue in buckets: against a plain ordered search, with keys far ahead, relaxed keys, and reuse.
#include "support/bucket_queue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

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
  // Up to ten times round the ring, so that most items go through the overflow.
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
  // Keys up to twenty times round the ring, taken in steps: an item leaves in the step in which its bucket
  // begins, and what comes late leaves in the next one.
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
  // Beyond the ring, with nothing in it.
  queue.push(7, 1e6);
  EXPECT_EQ(queue.least_key(), 1e6);
}

TEST(BucketQueue, ABucketThatIsNeverDoneGetsToItsOldestItem) {
  // Each item taken adds another of the same bucket: last in, first out would never come back to item 0.
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

TEST(BucketQueue, WorksLikeAnOrderedMapWhileKeysAreAddedAndLowered) {
  // The pattern of a propagation: each item taken lowers or adds others, none below its own bucket.
  for (unsigned seed = 0; seed < 50; ++seed) {
    std::mt19937 random(seed);
    BucketQueue queue;
    queue.resize(200);
    const double width = std::exp(std::uniform_real_distribution<double>(-12.0, 12.0)(random));
    queue.reset(width);
    std::map<Index, std::int64_t> expected;  // bucket by item
    auto push = [&](Index item, double key) {
      queue.push(item, key);
      const auto bucket = static_cast<std::int64_t>(key / width);
      const auto [at, added] = expected.try_emplace(item, bucket);
      if (!added) at->second = std::min(at->second, bucket);
    };
    for (Index item = 0; item < 20; ++item) push(item, width * (random() % 3000));
    std::uniform_real_distribution<double> step(0.0, 5000.0);
    for (int pushes = 0;;) {
      const Index item = queue.pop();
      if (item == no_index) break;
      ASSERT_TRUE(expected.contains(item)) << "seed " << seed;
      const std::int64_t bucket = expected[item];
      for (const auto& [other, other_bucket] : expected)
        ASSERT_LE(bucket, other_bucket + 1) << "seed " << seed;
      expected.erase(item);
      for (int i = 0; i < 3 && pushes < 2000; ++i, ++pushes) {
        push(static_cast<Index>(random() % 200), (static_cast<double>(bucket) + 1.0 + step(random)) * width);
      }
    }
    EXPECT_TRUE(expected.empty()) << "seed " << seed;
  }
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

}  // namespace
}  // namespace vorogeo
