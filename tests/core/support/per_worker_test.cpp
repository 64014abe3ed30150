// Scratch memory of workers: made once for each that asks, and only then.
#include <gtest/gtest.h>

#include "support/parallel.h"

namespace vorogeo {
namespace {

TEST(PerWorker, MakesAnObjectWhenItsWorkerFirstAsks) {
  int made = 0;
  struct Counted {
    Counted(int& made, int given) : value(given) { ++made; }
    int value;
  };
  PerWorker<Counted> scratch(3);
  EXPECT_EQ(made, 0);
  EXPECT_EQ(scratch.of(2, made, 5).value, 5);
  EXPECT_EQ(scratch.of(0, made, 7).value, 7);
  scratch.of(2, made, 9).value += 1;
  EXPECT_EQ(scratch.of(2, made, 11).value, 6) << "the object of the first call";
  EXPECT_EQ(made, 2);
}

}  // namespace
}  // namespace vorogeo
