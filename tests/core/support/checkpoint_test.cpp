// Checkpoints: who is told, how often, and how workers leave.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "support/parallel.h"
#include "support/progress.h"

namespace vorogeo {
namespace {

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

}  // namespace
}  // namespace vorogeo
