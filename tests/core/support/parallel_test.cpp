// Threads, checkpoints, progress, clocks and limits of memory.
#include "support/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "support/memory.h"
#include "support/progress.h"
#include "support/refusal.h"

namespace vorogeo {
namespace {

// Threads: every item once, workers exclusive, progress from the caller, exceptions and cancelling.

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

// Checkpoints: who is told, how often, and how workers leave.

using namespace std::chrono_literals;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(Checkpoint, NothingOutsideAWatch) { EXPECT_NO_THROW(checkpoint()); }

TEST(Checkpoint, ReportsAtOnceWhenDueAndAtEachFraction) {
  std::vector<double> seen;
  const Progress progress([&](double fraction, const std::string& activity) {
    EXPECT_EQ(activity, "Waiting");
    seen.push_back(fraction);
    return true;
  });
  Watch watch(progress.part(0.5, 1.0), "Waiting");
  checkpoint();
  EXPECT_EQ(seen, (std::vector<double>{0.5})) << "not due yet";
  std::this_thread::sleep_for(50ms);
  checkpoint();
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_GT(seen[1], 0.5) << "something was done";
  EXPECT_LT(seen[1], 0.51);
  watch.reach(0.5);
  ASSERT_EQ(seen.size(), 3U);
  EXPECT_EQ(seen[2], 0.75);
  for (int i = 0; i < 3000; ++i) watch.reach(0.5);
  EXPECT_EQ(seen.back(), 0.75) << "what is said to be reached decides";
}

TEST(Checkpoint, ASilentWatchLeavesItToTheOneAround) {
  int reports = 0;
  const Watch outer(Progress([&](double, const std::string&) { return ++reports < 2; }), "Outer");
  const Watch inner(Progress(), "Inner");
  std::this_thread::sleep_for(50ms);
  EXPECT_THROW(checkpoint(), Cancelled);
  EXPECT_EQ(reports, 2);
}

TEST(Checkpoint, LongItemsOfAllThreadsLeaveWhenCancelled) {
  // Each item would run forever without its checkpoints.
  for (int threads : {1, 3}) {
    int reports = 0;
    std::chrono::steady_clock::time_point refused;
    const Progress progress([&](double, const std::string&) {
      refused = std::chrono::steady_clock::now();
      return ++reports < 3;
    });
    auto run = [&] {
      parallel_for(8, threads, progress, "Waiting", [](std::size_t, int) {
        for (;;) {
          checkpoint();
          std::this_thread::sleep_for(1ms);
        }
      });
    };
    EXPECT_THROW(run(), Cancelled);
    EXPECT_LT(seconds_since(refused), 0.2);
  }
}

TEST(Checkpoint, AFailureOfOneThreadIsWhatTheOthersLeaveFor) {
  for (int round = 0; round < 20; ++round) {
    auto run = [] {
      parallel_for(4, 4, Progress([](double, const std::string&) { return true; }), "Waiting",
                   [](std::size_t item, int) {
                     if (item == 3) throw InvalidInput("item 3");
                     for (;;) checkpoint();
                   });
    };
    EXPECT_THROW(run(), InvalidInput);
  }
}

// Progress: spans within spans, cancelling.

TEST(Progress, WithoutFunctionNothingHappens) {
  const Progress none;
  EXPECT_NO_THROW(none.report(0.5, "work"));
  EXPECT_NO_THROW(none.part(0.0, 0.5).report(1.0, "work"));
}

TEST(Progress, PartsMapIntoTheWhole) {
  std::vector<double> seen;
  std::string activity;
  const Progress whole([&](double fraction, const std::string& what) {
    seen.push_back(fraction);
    activity = what;
    return true;
  });
  whole.report(0.125, "begin");
  EXPECT_EQ(activity, "begin");
  const Progress second_half = whole.part(0.5, 1.0);
  second_half.report(0.0, "middle");
  second_half.report(0.5, "middle");
  const Progress last_eighth = second_half.part(0.75, 1.0);
  last_eighth.report(0.0, "late");
  last_eighth.report(1.0, "end");
  EXPECT_EQ(seen, (std::vector<double>{0.125, 0.5, 0.75, 0.875, 1.0}));
  EXPECT_EQ(activity, "end");
}

TEST(Progress, FalseCancels) {
  const Progress refusing([](double fraction, const std::string&) { return fraction < 0.5; });
  EXPECT_NO_THROW(refusing.report(0.25, "work"));
  EXPECT_THROW(refusing.report(0.5, "work"), Cancelled);
  EXPECT_THROW(refusing.part(0.9, 1.0).report(0.0, "work"), Cancelled);
  EXPECT_EQ(test::refusal<Cancelled>([&] { refusing.report(1.0, "work"); }),
            "Cancelled: nothing was changed.");
}

TEST(Progress, WarningsPassThroughPartsAndMayCancel) {
  std::vector<std::string> seen;
  const Progress whole({}, [&](const std::string& sentence) {
    seen.push_back(sentence);
    return sentence != "stop";
  });
  whole.warn("first");
  whole.part(0.25, 0.5).part(0.0, 0.1).warn("second");
  EXPECT_THROW(whole.part(0.5, 1.0).warn("stop"), Cancelled);
  EXPECT_EQ(seen, (std::vector<std::string>{"first", "second", "stop"}));
  EXPECT_NO_THROW(Progress().warn("to nobody"));
}

// The clock of a thread goes on while it works, and neither while it sleeps nor while another one works.

/// Works until the clock of the calling thread has moved.
void work(double seconds) {
  const double start = thread_seconds();
  while (thread_seconds() - start < seconds) {
  }
}

TEST(ThreadClock, CountsOwnWorkOnly) {
  const double start = thread_seconds();
  const auto on_the_wall = std::chrono::steady_clock::now();
  work(0.02);
  EXPECT_GE(std::chrono::steady_clock::now() - on_the_wall, std::chrono::milliseconds(15));
  std::this_thread::sleep_for(std::chrono::milliseconds(40));
  std::thread([] { work(0.04); }).join();
  const double worked = thread_seconds() - start;
  EXPECT_GE(worked, 0.02);
  EXPECT_LT(worked, 0.04);
}

// Memory limits: what fits passes, what does not is refused with both sizes, and the system's own figure.

constexpr double mib = 1 << 20;

std::string refusal(double needed, std::int64_t max_bytes) {
  return test::refusal<NotEnoughMemory>(
      [&] { require_memory(needed, max_bytes, "The matrix of 5 x 5 distances", "Give fewer points."); });
}

TEST(Memory, WhatFitsPasses) {
  EXPECT_EQ(refusal(0.0, 1), "");
  EXPECT_EQ(refusal(200.0, 200), "");
  EXPECT_EQ(refusal(8.0 * 25, 0), "");
}

TEST(Memory, ARefusalNamesBothSizesAndWhatToDo) {
  EXPECT_EQ(refusal(3.5 * mib, 2 << 20),
            "The matrix of 5 x 5 distances takes 3.5 MiB, more than the 2 MiB allowed. Give fewer points.");
  EXPECT_EQ(refusal(1536.0 * mib, 1 << 30),
            "The matrix of 5 x 5 distances takes 1.5 GiB, more than the 1 GiB allowed. Give fewer points.");
}

TEST(Memory, WithoutALimitWhatIsAvailableCounts) {
  const std::string text = refusal(1e30, 0);
  EXPECT_NE(text.find("of memory available. Give fewer points."), std::string::npos) << text;
}

TEST(Memory, AvailableIsNoMoreThanTheMachineHas) {
  const std::int64_t available = available_memory_bytes();
  EXPECT_GT(available, 0);
  std::ifstream in("/proc/meminfo");
  std::string name;
  std::int64_t kilobytes = 0;
  if (in >> name >> kilobytes && name == "MemTotal:") {
    EXPECT_LE(available, kilobytes * 1024);
  }
}

}  // namespace
}  // namespace vorogeo
