// Memory limits: what fits passes, what does not is refused with both sizes, and the system's own figure.
#include "support/memory.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace vorogeo {
namespace {

constexpr double mib = 1 << 20;

std::string refusal(double needed, std::int64_t max_bytes) {
  try {
    require_memory(needed, max_bytes, "The matrix of 5 x 5 distances", "Give fewer points.");
  } catch (const NotEnoughMemory& error) {
    return error.what();
  }
  return "";
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
