// The ruler's thread: the newest work is done, what is kept always, what is cancelled never.
#include "edit/background.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <vector>

namespace vorogeo::plugin {
namespace {

/// Work that waits at a gate and then leaves its number.
class Numbers {
 public:
  Background::Work work(int number) {
    return [this, number](const Progress& progress) {
      started.fetch_add(1);
      while (!gate_is_open) {
        progress.report(0.25, "");
        std::this_thread::yield();
      }
      const std::lock_guard lock(mutex);
      EXPECT_NE(std::this_thread::get_id(), asker);
      done.push_back(number);
    };
  }
  void wait_until_started(int count) {
    while (started < count) std::this_thread::yield();
  }
  std::vector<int> wait_until_idle() {
    while (background.is_running()) std::this_thread::yield();
    return done;
  }

  const std::thread::id asker = std::this_thread::get_id();
  std::atomic<int> started = 0;
  std::atomic<bool> gate_is_open = false;
  std::mutex mutex;
  std::vector<int> done;
  Background background;  // last: its thread uses the others
};

TEST(Background, WorkThatWaitsIsReplacedByTheNextUnlessItIsKept) {
  Numbers numbers;
  Background& background = numbers.background;
  background.post(numbers.work(1));
  numbers.wait_until_started(1);
  for (int number = 2; number <= 4; ++number) background.post(numbers.work(number));
  background.post(numbers.work(5), true);
  background.post(numbers.work(6), true);
  for (int number = 7; number <= 9; ++number) background.post(numbers.work(number));
  numbers.gate_is_open = true;
  EXPECT_EQ(numbers.wait_until_idle(), (std::vector<int>{1, 5, 6, 9}));
}

TEST(Background, WhatIsClearedIsNotDoneAndTheNextIs) {
  Numbers numbers;
  numbers.background.post(numbers.work(1), true);
  numbers.wait_until_started(1);
  numbers.background.post(numbers.work(2), true);
  numbers.background.clear();
  numbers.background.post(numbers.work(3));
  numbers.wait_until_started(2);
  numbers.gate_is_open = true;
  EXPECT_EQ(numbers.wait_until_idle(), std::vector<int>{3});
}

TEST(Background, StopsWhileItWorksAndStartsAgain) {
  Numbers numbers;
  Background& background = numbers.background;
  background.stop();  // before it ever started
  EXPECT_FALSE(background.is_running());
  background.post(numbers.work(1));
  EXPECT_TRUE(background.is_running());
  while (background.fraction() != 0.25) std::this_thread::yield();
  background.stop();
  EXPECT_FALSE(background.is_running());
  numbers.gate_is_open = true;
  background.post(numbers.work(2));
  EXPECT_EQ(numbers.wait_until_idle(), std::vector<int>{2});
}

TEST(Background, WorkThatReportsNothingIsCancelledAtItsCheckpoints) {
  Background background;
  std::atomic<bool> has_started = false;
  background.post([&](const Progress&) {
    has_started = true;
    for (;;) checkpoint();
  });
  while (!has_started) std::this_thread::yield();
  background.stop();
  EXPECT_FALSE(background.is_running());
}

TEST(Background, ErrorsBecomeSentencesButNotCancelling) {
  EXPECT_EQ(error_of([] {}, "no memory"), "");
  EXPECT_EQ(error_of([] { throw InvalidInput("Face 7 is bad; remove it."); }, "no memory"),
            "Face 7 is bad; remove it.");
  EXPECT_EQ(error_of([] { throw std::bad_alloc(); }, "no memory"), "no memory");
  EXPECT_THROW(error_of([] { throw Cancelled(); }, "no memory"), Cancelled);
}

}  // namespace
}  // namespace vorogeo::plugin
