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
