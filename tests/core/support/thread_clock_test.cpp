// The clock of a thread goes on while it works, and neither while it sleeps nor while another one works.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "support/parallel.h"

namespace vorogeo {
namespace {

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
  std::jthread([] { work(0.04); }).join();
  const double worked = thread_seconds() - start;
  EXPECT_GE(worked, 0.02);
  EXPECT_LT(worked, 0.04);
}

}  // namespace
}  // namespace vorogeo
