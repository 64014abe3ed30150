// The sentence about a drag: frames a second and times of computing.
#include <gtest/gtest.h>

#include "edit/ruler_surface.h"

namespace vorogeo::plugin {
namespace {

using std::chrono::milliseconds;

TEST(DragLog, FramesASecondAreThoseBetweenTheFirstAndTheLast) {
  DragLog log;
  log.begin();
  const DragLog::Time start{};
  log.asked(start - milliseconds(85));
  log.asked(start);
  for (int i = 0; i <= 20; ++i) {
    log.computed(i == 3 ? 0.011 : 0.001);
    log.shown(start + milliseconds(i < 20 ? 20 * i : 500));
  }
  EXPECT_EQ(log.sentence("paths", "exact"),
            "Ruler: 21 paths shown in 0.5 s, 40 a second, 120 ms at most between two, the first after 85 ms; "
            "exact, 21 computed in 1.48 ms on average, 11 ms at most");
}

TEST(DragLog, StraightLinesAreCountedAmongThePaths) {
  DragLog log;
  log.computed(0.001);
  log.shown({}, true);
  log.shown(DragLog::Time(milliseconds(100)), true);
  log.shown(DragLog::Time(milliseconds(200)));
  EXPECT_EQ(log.sentence("paths", "exact"),
            "Ruler: 3 paths (2 as straight lines first) shown in 0.2 s, 10 a second, 100 ms at most between "
            "two; exact, 1 computed in 1 ms on average, 1 ms at most");
}

TEST(DragLog, OneFrameSaysNothing) {
  DragLog log;
  EXPECT_EQ(log.sentence("paths", "exact"), "");
  log.computed(0.1);
  log.shown({});
  EXPECT_EQ(log.sentence("paths", "exact"), "");
  log.computed(0.1);
  log.shown(DragLog::Time(milliseconds(10)));
  EXPECT_NE(log.sentence("paths", "exact"), "");
  log.begin();
  EXPECT_EQ(log.sentence("paths", "exact"), "");
}

}  // namespace
}  // namespace vorogeo::plugin
