// The memory of an envelope: lists grow, are dropped and cleared without affecting one another.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "exact/envelope.h"
#include "support/heavy.h"
#include "support/memory.h"

namespace vorogeo {
namespace {

/// Adds the stretch [begin, end] of an edge seen from below its middle.
void add(WindowEnvelope& envelope, Index edge, double begin, double end) {
  Window window = Window::from_source(100.0, 0.5 * (begin + end), 1.0, 0.0, 0, 0);
  window.begin = begin;
  window.end = end;
  envelope.open(edge, 1e-9);
  envelope.insert(window, window.distance(begin), window.distance(end));
  envelope.store();
}

TEST(EnvelopeStore, ListsGrowSideBySide) {
  WindowEnvelope envelope;
  envelope.resize(3);
  for (int i = 0; i < 40; ++i) {
    for (const Index edge : {0, 1, 2}) add(envelope, edge, i + 0.25 * edge, i + 0.25 * edge + 0.5);
  }
  for (const Index edge : {0, 1, 2}) {
    const auto windows = envelope.windows(edge);
    ASSERT_EQ(windows.size(), 40U);
    for (int i = 0; i < 40; ++i) EXPECT_EQ(windows[static_cast<std::size_t>(i)].begin, i + 0.25 * edge);
  }
  EXPECT_EQ(envelope.made(), 120U);
}

TEST(EnvelopeStore, ARetiredEdgeGivesItsRoomToOthers) {
  WindowEnvelope envelope;
  envelope.resize(2);
  for (int i = 0; i < 8; ++i) add(envelope, 0, i, i + 0.5);
  const std::size_t bytes = envelope.memory_bytes();
  envelope.retire(0);
  EXPECT_TRUE(envelope.is_retired(0));
  EXPECT_TRUE(envelope.windows(0).empty());
  for (int i = 0; i < 8; ++i) add(envelope, 1, i, i + 0.5);
  EXPECT_EQ(envelope.windows(1).size(), 8U);
  EXPECT_EQ(envelope.memory_bytes(), bytes);
  envelope.clear();
  EXPECT_FALSE(envelope.is_retired(0));
  EXPECT_TRUE(envelope.windows(1).empty());
  EXPECT_EQ(envelope.made(), 0U);
}

TEST(EnvelopeStore, WindowsThatDoNotFitTheMemoryAreRefused) {
  VOROGEO_HEAVY_TEST();
  constexpr Index edges = 4096;
  WindowEnvelope envelope;
  envelope.resize(edges);
  rlimit old{};
  ASSERT_EQ(::getrlimit(RLIMIT_AS, &old), 0);
  std::int64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  rlimit small = old;
  small.rlim_cur = static_cast<rlim_t>(pages * ::sysconf(_SC_PAGESIZE) + (std::int64_t{144} << 20));
  ASSERT_EQ(::setrlimit(RLIMIT_AS, &small), 0);
  std::string message = "none";
  try {
    for (Index edge = 0; edge < edges; ++edge) {
      envelope.open(edge, 1e-9);
      for (int i = 0; i < 1000; ++i) {
        Window part = Window::from_source(1.0, i, 1.0, 0.0, 0, 0);
        part.begin = i;
        part.end = i + 1;
        envelope.insert(part, part.distance(part.begin), part.distance(part.end));
      }
      envelope.store();
    }
  } catch (const NotEnoughMemory& error) {
    message = error.what();
  }
  ::setrlimit(RLIMIT_AS, &old);
  EXPECT_TRUE(message.starts_with("An exact propagation on this mesh has made ")) << message;
  EXPECT_TRUE(
      message.ends_with(" of memory available. Take the method quick or an index instead, give a greatest "
                        "distance, or use fewer threads."))
      << message;
  // There is room for smaller runs.
  envelope.clear();
  add(envelope, 0, 0.0, 1.0);
  EXPECT_EQ(envelope.windows(0).size(), 1U);
}

}  // namespace
}  // namespace vorogeo
