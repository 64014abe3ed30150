// The ruler's worker: the newest request is answered, kept ones always, cancelled ones never.
#include "edit/newest_request.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <vector>

namespace vorogeo::plugin {
namespace {

/// A worker that doubles numbers; the work waits at a gate, and answers are collected.
class Doubler {
 public:
  using Worker = NewestRequest<int, int>;

  Doubler()
      : worker(
            [this](int number, const Progress& progress) {
              started.fetch_add(1);
              while (!gate_is_open) {
                progress.report(0.0, "");
                std::this_thread::yield();
              }
              return 2 * number;
            },
            [this](int number, int answer) {
              const std::lock_guard lock(mutex);
              EXPECT_EQ(answer, 2 * number);
              EXPECT_NE(std::this_thread::get_id(), asker);
              answered.push_back(number);
            }) {}

  void wait_until_started(int count) {
    while (started < count) std::this_thread::yield();
  }
  std::vector<int> wait_for_answers(std::size_t count) {
    for (;;) {
      {
        const std::lock_guard lock(mutex);
        if (answered.size() >= count) return answered;
      }
      std::this_thread::yield();
    }
  }

  const std::thread::id asker = std::this_thread::get_id();
  std::atomic<int> started = 0;
  std::atomic<bool> gate_is_open = false;
  std::mutex mutex;
  std::vector<int> answered;
  Worker worker;  // last: its thread uses the others
};

TEST(NewestRequest, ARequestThatWaitsIsReplacedByTheNext) {
  Doubler doubler;
  doubler.worker.post(1);
  doubler.wait_until_started(1);
  for (int number = 2; number <= 6; ++number) doubler.worker.post(number);
  doubler.gate_is_open = true;
  EXPECT_EQ(doubler.wait_for_answers(2), (std::vector<int>{1, 6}));
  EXPECT_EQ(doubler.worker.dropped(), 4);
}

TEST(NewestRequest, KeptRequestsAreAllAnsweredInOrderBeforeTheNewest) {
  Doubler doubler;
  doubler.worker.post(1);
  doubler.wait_until_started(1);
  doubler.worker.post(2);  // replaced by the next
  doubler.worker.post_kept(3);
  doubler.worker.post_kept(4);
  doubler.worker.post(5);
  doubler.gate_is_open = true;
  EXPECT_EQ(doubler.wait_for_answers(4), (std::vector<int>{1, 3, 4, 5}));
}

TEST(NewestRequest, WhatIsClearedIsNotDeliveredAndTheNextOneIs) {
  Doubler doubler;
  doubler.worker.post_kept(1);
  doubler.wait_until_started(1);
  doubler.worker.post_kept(2);
  doubler.worker.clear();
  doubler.worker.post(3);
  doubler.wait_until_started(2);
  doubler.gate_is_open = true;
  EXPECT_EQ(doubler.wait_for_answers(1), std::vector<int>{3});
}

TEST(NewestRequest, StopsWhileItWorksAndStartsAgain) {
  Doubler doubler;
  doubler.worker.stop();  // before it ever started
  doubler.worker.post(1);
  doubler.wait_until_started(1);
  doubler.worker.stop();
  doubler.gate_is_open = true;
  doubler.worker.post(2);
  EXPECT_EQ(doubler.wait_for_answers(1), std::vector<int>{2});
}

}  // namespace
}  // namespace vorogeo::plugin
