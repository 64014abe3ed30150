// Legs: what was put in comes out, and the code is the one of index files.
#include <gtest/gtest.h>

#include <bit>

#include "index/patch_layer.h"

namespace vorogeo {
namespace {

TEST(Leg, SaysItsTableAndItsPatch) {
  for (const Index patch : {0, 1, 77, std::numeric_limits<Index>::max()}) {
    const Leg second = Leg::through_second(patch);
    EXPECT_EQ(second.table(), Leg::Table::second);
    EXPECT_TRUE(second.in_second_layer());
    EXPECT_FALSE(second.in_first_layer());
    EXPECT_EQ(second.patch(), patch);
    EXPECT_EQ(std::bit_cast<Index>(second), patch);
  }
  for (const Index patch : {0, 1, 77, std::numeric_limits<Index>::max() - 1}) {
    const Leg first = Leg::through_first(patch);
    EXPECT_EQ(first.table(), Leg::Table::first);
    EXPECT_TRUE(first.in_first_layer());
    EXPECT_FALSE(first.in_second_layer());
    EXPECT_EQ(first.patch(), patch);
    EXPECT_EQ(std::bit_cast<Index>(first), -1 - patch);
    EXPECT_NE(first, Leg::through_second(patch));
  }
  const Leg transit = Leg::by_transit_table();
  EXPECT_EQ(transit.table(), Leg::Table::transit);
  EXPECT_FALSE(transit.in_first_layer() || transit.in_second_layer());
  EXPECT_EQ(transit.patch(), no_index);
  EXPECT_EQ(transit, Leg());
}

}  // namespace
}  // namespace vorogeo
