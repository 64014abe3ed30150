// Strings through gates whose bends are known.
#include <gtest/gtest.h>

#include "query/path_line.h"

namespace vorogeo {
namespace {

TEST(Funnel, BendsAtTheGatesInTheWay) {
  Funnel funnel;
  // Upwards, through a gate to the right, one to the left, and out straight.
  funnel.reset({0.0, 0.0}, 3);
  funnel.add_left({1.0, 1.0}, 0);
  funnel.add_right({3.0, 1.0}, 0);
  funnel.add_left({-3.0, 2.0}, 1);
  funnel.add_right({-1.0, 2.0}, 1);
  funnel.add_left({-9.0, 3.0}, 2);
  funnel.add_right({9.0, 3.0}, 2);
  const auto& bends = funnel.finish({0.0, 9.0});
  ASSERT_EQ(bends.size(), 2U);
  EXPECT_EQ(bends[0].gate, 0);
  EXPECT_TRUE(bends[0].left);
  EXPECT_EQ(bends[1].gate, 1);
  EXPECT_FALSE(bends[1].left);
}

TEST(Funnel, GoesStraightWhereItCan) {
  Funnel funnel;
  funnel.reset({0.0, 0.0}, 2);
  for (Index gate : {0, 1}) {
    funnel.add_left({-1.0, 1.0 + gate}, gate);
    funnel.add_right({1.0, 1.0 + gate}, gate);
  }
  EXPECT_TRUE(funnel.finish({0.5, 3.0}).empty());
}

}  // namespace
}  // namespace vorogeo
