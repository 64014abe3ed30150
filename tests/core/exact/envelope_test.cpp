// Lower envelope of windows on an edge, and its memory.
#include "exact/envelope.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "support/heavy.h"

namespace vorogeo {
namespace {

// Lower envelope of windows on an edge: against the least of all windows at many places.

Window window(double begin, double end, double source_x, double source_y, double offset, Index source = 0) {
  Window w{};
  w.begin = begin;
  w.end = end;
  w.source_x = source_x;
  w.source_y = source_y;
  w.offset = offset;
  w.source = source;
  return w;
}

double insert(WindowEnvelope& envelope, Index edge, const Window& w) {
  envelope.open(edge, 1e-13);
  envelope.insert(w, w.distance(w.begin), w.distance(w.end));
  return envelope.store();
}

std::vector<Window> windows_of(const WindowEnvelope& envelope, Index edge) {
  const auto list = envelope.windows(edge);
  return {list.begin(), list.end()};
}

/// Distance that the envelope gives at x, unreachable in a gap.
double value_at(const std::vector<Window>& list, double x) {
  for (const Window& w : list) {
    if (x >= w.begin && x <= w.end) return w.distance(x);
  }
  return unreachable;
}

TEST(WindowEnvelope, WhereRoundingIsGreaterOnlyWhatIsNearerByMoreIsTaken) {
  WindowEnvelope envelope;
  envelope.resize(1);
  const auto insert_from = [&](double offset, double rounding) {
    const Window w = window(0.0, 1.0, 0.5, 1.0, offset);
    envelope.open(0, {1e-13, 1e-13, 0.0}, rounding);
    envelope.insert(w, w.distance(0.0), w.distance(1.0));
    return envelope.store() < unreachable;
  };
  EXPECT_TRUE(insert_from(1.0, 1.0));
  EXPECT_TRUE(insert_from(1.0 - 1e-11, 1.0));
  EXPECT_FALSE(insert_from(1.0 - 2e-11, 1e4));
  EXPECT_TRUE(insert_from(0.9, 1e4));
  EXPECT_EQ(envelope.takes(0), 0);
  envelope.take_new(0);
  envelope.take_new(0);
  EXPECT_EQ(envelope.takes(0), 2);
  envelope.clear();
  EXPECT_EQ(envelope.takes(0), 0);
}

TEST(WindowEnvelope, AloneAWindowStaysWhole) {
  WindowEnvelope envelope;
  envelope.resize(2);
  EXPECT_DOUBLE_EQ(insert(envelope, 1, window(0.2, 0.9, 0.5, 1.0, 2.0)), 3.0);
  EXPECT_TRUE(envelope.windows(0).empty());
  const auto list = windows_of(envelope, 1);
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0].begin, 0.2);
  EXPECT_EQ(list[0].end, 0.9);
}

TEST(WindowEnvelope, WhatTheFrontHasPassedStaysWithWhatIsThere) {
  // Two envelopes get the same windows, none nearer than the front. Where the one that knows the front has
  // dropped windows, the other has distances that the front has passed; elsewhere, both are the same.
  const auto seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  constexpr Index edges = 20;
  WindowEnvelope whole;
  whole.resize(edges);
  WindowEnvelope passed;
  passed.resize(edges);
  constexpr double length = 100.0;
  double front = 0.0;
  for (int batch = 0; batch < 1000 * edges; ++batch) {
    const auto edge = static_cast<Index>(random() % edges);
    front += 0.1 / edges * uniform(random);
    passed.pass(front);
    const double begin = length * uniform(random);
    Window next = window(begin, std::min(length, begin + 2.0 * uniform(random)),
                         begin + 4.0 * uniform(random) - 1.0, 0.01 + uniform(random), 0.0);
    next.offset = front + 3.0 * uniform(random) - next.least_distance() + next.offset;
    for (WindowEnvelope* envelope : {&whole, &passed}) {
      insert(*envelope, edge, next);
      if (batch % 7 == 0) continue;
      for (Window& taken : envelope->new_windows(edge)) taken.set_propagated();
      envelope->take_new(edge);
    }
    if (batch % edges != 0) continue;
    const auto looked_at = static_cast<Index>(random() % edges);
    const auto all = windows_of(whole, looked_at);
    const auto left = windows_of(passed, looked_at);
    ASSERT_TRUE(std::ranges::is_sorted(left, {}, &Window::begin));
    for (int look = 0; look < 50; ++look) {
      const double x = length * uniform(random);
      const double expected = value_at(all, x);
      const double found = value_at(left, x);
      if (found == -unreachable) {
        // In a gap, the window with the least distance there must lie behind the front.
        double nearest = expected;
        for (const Window& w : all) {
          const double aside = std::max({0.0, w.begin - x, x - w.end});
          nearest = std::min(nearest, w.distance(std::clamp(x, w.begin, w.end)) + aside);
        }
        EXPECT_LT(nearest, front);
      } else {
        EXPECT_DOUBLE_EQ(found, expected);
      }
    }
  }
  EXPECT_LT(passed.memory_bytes(), whole.memory_bytes());
}

TEST(WindowEnvelope, NewWindowsAreAllThatCameSinceTheyWereTaken) {
  WindowEnvelope envelope;
  envelope.resize(1);
  for (int i = 0; i < 100; ++i) insert(envelope, 0, window(i, i + 0.75, i, 1.0, 10.0, i));
  auto take = [&] {
    for (Window& taken : envelope.new_windows(0)) taken.set_propagated();
    envelope.take_new(0);
  };
  EXPECT_EQ(envelope.new_windows(0).size(), 100U);
  take();
  EXPECT_TRUE(envelope.new_windows(0).empty());
  std::mt19937 random(1);
  for (int batch = 0; batch < 300; ++batch) {
    // The window lies behind, before or among those of earlier batches, which may not have been taken yet.
    const double begin = static_cast<double>(random() % 1000) / 10.0;
    insert(envelope, 0, window(begin, begin + 0.3, begin, 1.0, 9.0 - 0.01 * batch, 100 + batch));
    const auto all = envelope.windows(0);
    const auto fresh = envelope.new_windows(0);
    ASSERT_TRUE(fresh.data() >= all.data() && fresh.data() + fresh.size() <= all.data() + all.size());
    for (const Window& w : all) {
      const bool among = &w >= fresh.data() && &w < fresh.data() + fresh.size();
      EXPECT_TRUE(among || w.is_propagated());
    }
    if (random() % 3 != 0) continue;
    take();
  }
  take();
  EXPECT_TRUE(std::ranges::all_of(envelope.windows(0), &Window::is_propagated));
  // Between windows that have been taken, it is the only new one.
  insert(envelope, 0, window(200.0, 201.0, 200.0, 1.0, 0.0));
  EXPECT_EQ(envelope.new_windows(0).size(), 1U);
}

TEST(WindowEnvelope, TwoPointsAreDividedByTheirBisector) {
  WindowEnvelope envelope;
  envelope.resize(1);
  insert(envelope, 0, window(0.0, 10.0, 2.0, 1.0, 0.0, 0));
  insert(envelope, 0, window(0.0, 10.0, 7.0, 1.0, 0.0, 1));
  const auto list = windows_of(envelope, 0);
  ASSERT_EQ(list.size(), 2U);
  EXPECT_NEAR(list[0].end, 4.5, 1e-12);
  EXPECT_NEAR(list[1].begin, 4.5, 1e-12);
  EXPECT_EQ(list[0].source, 0);
  EXPECT_EQ(list[1].source, 1);
}

TEST(WindowEnvelope, OnePointSeenPastTwoSidesOfAVertexIsCutInTheBatch) {
  WindowEnvelope envelope;
  envelope.resize(1);
  const Window first = window(0.0, 2.0, 1.0, 2.0, 3.0, 0);
  const Window second = window(0.5, 4.0, 3.0, 1.0, 3.0, 1);
  const Window third = window(3.5, 9.0, 9.0, 4.0, 3.0, 2);
  envelope.open(0, 1e-13);
  for (const Window& w : {first, second, third}) envelope.insert(w, w.distance(w.begin), w.distance(w.end));
  // (x - 1)^2 + 4 = (x - 3)^2 + 1 at 1.25; at 3.5 and at 4 the third is longer than the second, and it takes
  // the rest. The least distance is that of the second right below its source: 3 + 1.
  EXPECT_DOUBLE_EQ(envelope.store(), 4.0);
  const auto list = windows_of(envelope, 0);
  ASSERT_EQ(list.size(), 3U);
  EXPECT_NEAR(list[0].end, 1.25, 1e-15);
  EXPECT_NEAR(list[1].begin, 1.25, 1e-15);
  EXPECT_EQ(list[1].end, 4.0);
  EXPECT_EQ(list[2].begin, 4.0);
  EXPECT_EQ(list[2].source, 2);
}

TEST(WindowEnvelope, ANearPointWithALateStartOwnsTheMiddle) {
  WindowEnvelope envelope;
  envelope.resize(1);
  insert(envelope, 0, window(0.0, 10.0, 5.0, 6.0, 0.0, 0));
  // At the middle 5.5 against 6, at the ends sqrt(25.25) + 5 = 10.02 against sqrt(61) = 7.81.
  EXPECT_DOUBLE_EQ(insert(envelope, 0, window(0.0, 10.0, 5.0, 0.5, 5.0, 1)), 5.5);
  const auto list = windows_of(envelope, 0);
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[1].source, 1);
  EXPECT_NEAR(list[1].distance(list[1].begin), list[0].distance(list[0].end), 1e-12);
  EXPECT_NEAR(list[1].distance(list[1].end), list[2].distance(list[2].begin), 1e-12);
}

TEST(WindowEnvelope, WhatIsLongerEverywhereIsNotAdded) {
  WindowEnvelope envelope;
  envelope.resize(1);
  insert(envelope, 0, window(0.0, 1.0, 0.5, 1.0, 0.0));
  EXPECT_EQ(insert(envelope, 0, window(0.1, 0.9, 0.5, 1.0, 0.25, 1)), unreachable);
  EXPECT_EQ(windows_of(envelope, 0).size(), 1U);
  EXPECT_EQ(insert(envelope, 0, window(0.0, 1.0, 0.5, 1.0, 0.0, 2)), unreachable)
      << "ties stay with the older";
}

TEST(WindowEnvelope, RandomWindowsGiveTheLeastEverywhere) {
  for (unsigned seed = 0; seed < 400; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    WindowEnvelope envelope;
    envelope.resize(1);
    std::vector<Window> all;
    const int count = 2 + static_cast<int>(seed % 12);
    for (int i = 0; i < count; ++i) {
      const double begin = unit(random);
      const double end = begin + (1.0 - begin) * unit(random);
      // From points on the edge itself to far and nearly flat ones.
      const double away = seed % 3 == 0 ? 0.01 : std::exp(6.0 * unit(random) - 3.0);
      all.push_back(window(begin, end, 3.0 * unit(random) - 1.0, away * unit(random), unit(random), i));
      insert(envelope, 0, all.back());
    }
    const auto list = windows_of(envelope, 0);
    for (std::size_t i = 0; i < list.size(); ++i) {
      ASSERT_LT(list[i].begin, list[i].end);
      ASSERT_LE(i == 0 ? 0.0 : list[i - 1].end, list[i].begin) << "seed " << seed;
    }
    for (int k = 0; k <= 500; ++k) {
      const double x = k / 500.0;
      double least = unreachable;
      for (const Window& w : all) {
        if (x >= w.begin && x <= w.end) least = std::min(least, w.distance(x));
      }
      const double found = value_at(list, x);
      if (least == unreachable) {
        ASSERT_EQ(found, unreachable) << "seed " << seed << ", x " << x;
      } else {
        ASSERT_NEAR(found, least, 1e-9) << "seed " << seed << ", x " << x;
      }
    }
  }
}

TEST(WindowEnvelope, WhatTiesFarAwayIsComparedNextToThePseudoSources) {
  const auto seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int round = 0; round < 1000; ++round) {
    // On an edge of length 1, windows whose sources are 1e-8 to 1 away from it and close to each other.
    const double away = std::pow(10.0, -8.0 * unit(random));
    const bool at_begin = round % 2 == 0;  // where positions on an edge keep more digits
    const double x = at_begin ? away : 0.1 + 0.8 * unit(random);
    const double rounding = at_begin ? 0.0 : 1e-12;  // of slivers
    std::vector<Window> all;
    for (Index i = 0; i < 4; ++i) {
      const double beside = std::array{0.1, 1e-5, 1e-10}[round % 3] * away * unit(random);
      const double late = round % 5 == 0 ? 0.1 * away * unit(random) : 0.0;
      const double height = round % 7 == 0 ? away : away * (0.5 + unit(random));
      all.push_back(window(0.0, 1.0, x + beside, height, late, i));
    }
    WindowEnvelope envelope;
    envelope.resize(1);
    for (const Window& w : all) {
      envelope.open(0, at_begin ? WindowEnvelope::Sliver{1e-18, 1e-13, 1e-13}
                                : WindowEnvelope::Sliver{1e-13, 1e-13, 0.0});
      envelope.insert(w, w.distance(0.0), w.distance(1.0));
      envelope.store();
    }
    const auto list = windows_of(envelope, 0);
    for (int k = -40; k <= 40; ++k) {
      const double at = std::clamp(x + 0.1 * k * away, 0.0, 1.0);
      double least = unreachable;
      for (const Window& w : all) least = std::min(least, w.distance(at));
      ASSERT_NEAR(value_at(list, at), least, 1e-9 * least + rounding)
          << "round " << round << ", away " << away;
    }
  }
}

TEST(WindowEnvelope, EqualAtOneEndEachKeepsWhereItIsShorter) {
  // Two branches of hyperbolas that cross at x = 1 and at the common end x = 3, made so by the offset of b.
  const double ax = -1.0, ay = 0.5;
  // The height of the pseudo-source of b is found so that the differences of distance at both places agree.
  auto difference = [&](double by, double x) { return std::hypot(x - 0.4, by) - std::hypot(x - ax, ay); };
  double low = 0.0, high = 10.0;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (difference(middle, 1.0) - difference(middle, 3.0) < difference(0.0, 1.0) - difference(0.0, 3.0) + 0.3
         ? low
         : high) = middle;
  }
  for (const bool swapped : {false, true}) {
    for (const bool mirrored : {false, true}) {
      Window a = window(0.0, 3.0, ax, ay, 5.0, 0);
      // Offset such that b equals a at x = 3.
      Window b = window(0.0, 3.0, 0.4, 0.5 * (low + high), 0.0, 1);
      b.offset = a.distance(3.0) - b.plane_distance(3.0);
      if (mirrored) {
        for (Window* w : {&a, &b}) w->source_x = 3.0 - w->source_x;
      }
      WindowEnvelope envelope;
      envelope.resize(1);
      insert(envelope, 0, swapped ? b : a);
      insert(envelope, 0, swapped ? a : b);
      const auto list = windows_of(envelope, 0);
      for (int k = 1; k < 300; ++k) {
        const double x = k / 100.0;
        ASSERT_NEAR(value_at(list, x), std::min(a.distance(x), b.distance(x)), 1e-9)
            << "x " << x << (swapped ? " swapped" : "") << (mirrored ? " mirrored" : "");
      }
    }
  }
}

TEST(WindowEnvelope, WhatBendsEarlierTakesItsPlaceFromWhatTiesWithIt) {
  // A source at distance 15, and a vertex on the path from it: x beside the ray through both, the path by the
  // vertex is longer by some x^2 / 15, less than the tolerance.
  const Window straight = window(5e-6, 1e-5, 0.0, 15.0, 0.0, 0);
  const Window bent = window(0.0, 1.0, 0.0, 5.0, 10.0, 1);
  WindowEnvelope envelope;
  envelope.resize(1);
  for (const auto& [first, second] : {std::pair{straight, bent}, std::pair{bent, straight}}) {
    envelope.clear();
    insert(envelope, 0, first);
    insert(envelope, 0, second);
    const auto list = windows_of(envelope, 0);
    ASSERT_EQ(list.size(), 3U);
    EXPECT_EQ(list[1].source, 0);
    EXPECT_EQ(list[1].begin, 5e-6);
    EXPECT_EQ(list[1].end, 1e-5);
  }
}

TEST(WindowEnvelope, ABatchGivesTheSameAsItsWindowsOneByOne) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    WindowEnvelope envelope;
    envelope.resize(2);
    for (int batch = 0; batch < 4; ++batch) {
      std::vector<Window> windows;
      for (int i = 0; i < 6; ++i) {
        const double begin = unit(random);
        windows.push_back(window(begin, begin + (1.0 - begin) * unit(random), 2.0 * unit(random),
                                 unit(random), unit(random), 6 * batch + i));
        insert(envelope, 0, windows.back());
      }
      envelope.open(1, 1e-13);
      for (const Window& w : windows) envelope.insert(w, w.distance(w.begin), w.distance(w.end));
      envelope.store();
    }
    const auto single = windows_of(envelope, 0);
    const auto batched = windows_of(envelope, 1);
    ASSERT_EQ(single.size(), batched.size()) << "seed " << seed;
    for (std::size_t i = 0; i < single.size(); ++i) {
      ASSERT_EQ(single[i].source, batched[i].source);
      ASSERT_DOUBLE_EQ(single[i].begin, batched[i].begin);
      ASSERT_DOUBLE_EQ(single[i].end, batched[i].end);
    }
  }
}

TEST(WindowEnvelope, ARetiredEdgeTakesNothingAndGivesItsRoomToOthers) {
  WindowEnvelope envelope;
  envelope.resize(2);
  insert(envelope, 0, window(0.0, 1.0, 0.5, 1.0, 0.0));
  EXPECT_FALSE(envelope.is_retired(0));
  const std::size_t bytes = envelope.memory_bytes();
  envelope.retire(0);
  EXPECT_TRUE(envelope.is_retired(0));
  EXPECT_TRUE(envelope.windows(0).empty());
  insert(envelope, 1, window(0.0, 1.0, 0.5, 1.0, 0.0));
  EXPECT_EQ(envelope.memory_bytes(), bytes);
  envelope.clear();
  EXPECT_FALSE(envelope.is_retired(0));
}

TEST(WindowEnvelope, ClearForgetsAllEdges) {
  WindowEnvelope envelope;
  envelope.resize(3);
  for (int round = 0; round < 3; ++round) {
    for (Index edge = 0; edge < 3; ++edge) {
      insert(envelope, edge, window(0.0, 0.5, 0.2, 1.0, 0.0));
      insert(envelope, edge, window(0.3, 1.0, 0.8, 1.0, 0.0, 1));
      EXPECT_EQ(windows_of(envelope, edge).size(), 2U);
    }
    EXPECT_GE(envelope.made(), 6U);
    envelope.clear();
    EXPECT_EQ(envelope.made(), 0U);
    for (Index edge = 0; edge < 3; ++edge) EXPECT_TRUE(envelope.windows(edge).empty());
  }
}

/// Inserts two windows of the whole edge [0, 1], and compares their envelope with the lesser of the two.
void expect_least(const Window& old, const Window& fresh) {
  WindowEnvelope envelope;
  envelope.resize(1);
  insert(envelope, 0, old);
  insert(envelope, 0, fresh);
  const auto list = windows_of(envelope, 0);
  for (int k = 0; k <= 64; ++k) {
    const double x = std::clamp(k / 64.0, 1e-6, 1.0 - 1e-6);
    const double least = std::min(old.distance(x), fresh.distance(x));
    const double length = std::abs(old.source_x) + old.source_y + std::abs(fresh.source_x) + fresh.source_y;
    // Windows that tie at an end of the edge may be swapped up to this difference.
    const double tied = 1e-12 * std::max(old.distance(1.0), old.distance(0.0));
    ASSERT_LE(value_at(list, x), least + 1e-9 * (old.offset + fresh.offset + length) + tied) << "at " << x;
  }
}

TEST(WindowEnvelope, WindowsThatTieInOnePartAreCutWhereTheyPartWherever) {
  // Pseudo-sources on the line of the edge: the equation of their equal distances is next to 0 = 0.
  expect_least(window(0, 1, 0.6654546040327461, 0, 0),
               window(0, 1, 0.6654301612156492, 0, 2.4442816585864222e-05));
  // Pseudo-sources a million edges away.
  expect_least(window(0, 1, -0.42341319287353074, 12196729.797259726, 3626.9381056095945),
               window(0, 1, 0.44779016386122517, 1e-4, 12200356.482989138));
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  // One pseudo-source is seen from the other along the edge's line, up to rounding.
  for (int i = 0; i < 5000; ++i) {
    const double x = uniform(-1.0, 2.0);
    const double next = x + std::pow(10.0, uniform(-8.0, 0.0)) * (i % 2 == 0 ? 1.0 : -1.0);
    const double noise = std::pow(10.0, uniform(-16.0, -11.0)) * uniform(-1.0, 1.0);
    const double height = i % 3 == 0 ? std::pow(10.0, uniform(-12.0, -4.0)) : 0.0;
    const Window parent = window(0, 1, x, height, 0.0);
    const Window child = window(0, 1, next, 0.0, std::abs(next - x) + noise + height, 1);
    if (child.offset < 0.0) continue;
    i % 5 == 0 ? expect_least(child, parent) : expect_least(parent, child);
    if (HasFatalFailure()) return;
  }
}

// The memory of an envelope: what does not fit is refused.

/// Adds a window over [begin, end] whose source lies below its middle.
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
  // Smaller runs fit.
  envelope.clear();
  add(envelope, 0, 0.0, 1.0);
  EXPECT_EQ(envelope.windows(0).size(), 1U);
}

}  // namespace
}  // namespace vorogeo
