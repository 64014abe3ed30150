// The memory of an envelope: lists grow, are dropped and cleared without affecting one another.
#include <gtest/gtest.h>

#include "exact/envelope.h"

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

}  // namespace
}  // namespace vorogeo
