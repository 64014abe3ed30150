// Threads: every item once, workers exclusive, progress from the caller, exceptions and cancelling.
#include "support/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <thread>
#include <vector>

namespace vorogeo {
namespace {

TEST(Parallel, ThreadCount) {
  EXPECT_EQ(resolve_thread_count(3), 3);
  EXPECT_GE(resolve_thread_count(0), 1);
  EXPECT_EQ(resolve_thread_count(-1), resolve_thread_count(0));
}

TEST(Parallel, AtMostFourThreadsPerCore) {
  const int most = 4 * resolve_thread_count(0);
  EXPECT_EQ(resolve_thread_count(most), most);
  EXPECT_EQ(resolve_thread_count(most + 1), most);
  EXPECT_EQ(resolve_thread_count(std::numeric_limits<int>::max()), most);
  std::atomic<int> largest = 0;
  parallel_for(1000, 1 << 30, {}, "work", [&](std::size_t, int worker) {
    for (int seen = largest; worker > seen && !largest.compare_exchange_weak(seen, worker);) {
    }
  });
  EXPECT_LT(largest, most);
}

TEST(Parallel, EveryItemOnce) {
  for (int threads : {1, 2, 7}) {
    for (std::size_t count : {0, 1, 5, 1000}) {
      std::vector<std::atomic<int>> calls(count);
      parallel_for(count, threads, {}, "count", [&](std::size_t item, int) { ++calls[item]; });
      for (const auto& n : calls) EXPECT_EQ(n, 1);
    }
  }
}

TEST(Parallel, RangesCoverEveryElementOnce) {
  for (const Index count : {0, 1, elements_per_range, elements_per_range + 1, 20 * elements_per_range - 1}) {
    std::vector<int> calls(count, 0);
    std::atomic<std::size_t> ranges = 0;
    parallel_ranges(count, [&](Index begin, Index end) {
      EXPECT_EQ(begin % elements_per_range, 0);
      EXPECT_EQ(range_of(begin), range_of(end - 1));
      ++ranges;
      for (Index i = begin; i < end; ++i) ++calls[i];
    });
    EXPECT_EQ(ranges, range_count(count));
    EXPECT_TRUE(std::ranges::all_of(calls, [](int n) { return n == 1; }));
  }
}

TEST(Parallel, RangesPassErrorsOn) {
  EXPECT_THROW(parallel_ranges(40 * elements_per_range,
                               [](Index begin, Index) {
                                 if (range_of(begin) == 7) throw std::runtime_error("range 7");
                               }),
               std::runtime_error);
}

TEST(Parallel, AWorkerRunsOneItemAtATime) {
  constexpr int threads = 4;
  std::vector<std::atomic<int>> busy(threads);
  parallel_for(2000, threads, {}, "work", [&](std::size_t, int worker) {
    ASSERT_GE(worker, 0);
    ASSERT_LT(worker, threads);
    EXPECT_EQ(++busy[worker], 1);
    --busy[worker];
  });
}

TEST(Parallel, ItemsGoOutInIncreasingOrder) {
  std::vector<std::vector<std::size_t>> items(3);
  parallel_for(500, 3, {}, "work", [&](std::size_t item, int worker) { items[worker].push_back(item); });
  for (const auto& own : items) EXPECT_TRUE(std::is_sorted(own.begin(), own.end()));
}

TEST(Parallel, ProgressGrowsOnTheCallingThreadAndEndsAtOne) {
  const auto caller = std::this_thread::get_id();
  std::vector<double> seen;
  const Progress progress([&](double fraction, const std::string& activity) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    EXPECT_EQ(activity, "sleeping");
    seen.push_back(fraction);
    return true;
  });
  parallel_for(20, 2, progress, "sleeping",
               [](std::size_t, int) { std::this_thread::sleep_for(std::chrono::milliseconds(15)); });
  ASSERT_GE(seen.size(), 2U);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 1.0);
}

TEST(Parallel, TheFirstExceptionComesOutAndStopsTheRest) {
  for (int threads : {1, 3}) {
    std::atomic<int> calls = 0;
    try {
      parallel_for(100000, threads, {}, "work", [&](std::size_t item, int) {
        ++calls;
        if (item == 10) throw std::runtime_error("item 10");
      });
      FAIL() << "nothing thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "item 10");
    }
    EXPECT_LE(calls, 100000);
  }
}

TEST(Parallel, CancellingStopsAllWorkers) {
  for (int threads : {1, 2}) {
    std::atomic<int> calls = 0;
    const Progress refusing([](double, const std::string&) { return false; });
    EXPECT_THROW(parallel_for(2000, threads, refusing, "work",
                              [&](std::size_t, int) {
                                ++calls;
                                std::this_thread::sleep_for(std::chrono::milliseconds(2));
                              }),
                 Cancelled);
    // The first report comes after about 50 ms: far from all items were taken.
    EXPECT_LT(calls, 1000);
  }
}

TEST(Parallel, CancellingWhileTheCallerOnlyWaits) {
  // One item sleeps on the helper's thread; the caller has nothing left to do and still notices the
  // cancelling.
  std::atomic<bool> finished = false;
  int reports = 0;  // the first comes before any item
  const Progress refusing([&](double, const std::string&) { return ++reports == 1; });
  EXPECT_THROW(parallel_for(2, 2, refusing, "work",
                            [&](std::size_t item, int) {
                              if (item == 0) std::this_thread::sleep_for(std::chrono::milliseconds(200));
                              if (item == 0) finished = true;
                            }),
               Cancelled);
  EXPECT_TRUE(finished);  // a running item is never abandoned
}

TEST(Parallel, RefusedAtItsStartRunsNothing) {
  int run = 0;
  const Progress refusing([](double, const std::string&) { return false; });
  EXPECT_THROW(parallel_for(2, 1, refusing, "work", [&](std::size_t, int) { ++run; }), Cancelled);
  EXPECT_EQ(run, 0);
}

}  // namespace
}  // namespace vorogeo
