// Labels renumbered and joined by hand.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "patches/partition.h"

namespace vorogeo {
namespace {

TEST(PatchLabels, KeepTheirOrderWithoutGaps) {
  std::vector<Index> label{4, 7, 2, 7, 1};
  EXPECT_EQ(compact(label, std::array<Index, 4>{0, 1, 2, 3}, 8), 3);
  EXPECT_EQ(label, (std::vector<Index>{1, 2, 0, 2, 1})) << "the last face is not one of those renumbered";
}

TEST(PatchLabels, FacesJoinedLeaveTheOtherPatchesInOrder) {
  // First-layer patches 0 and 1 with second-layer patches 0, 1 and 2, 3; 0 and 3 lose all their faces.
  Partition partition;
  partition.first_layer = {0, 0, 0, 1, 1, 1};
  partition.second_layer = {0, 1, 1, 2, 3, 3};
  partition.parent = {0, 0, 1, 1};
  partition.first_layer_count = 2;
  partition.second_layer_count = 4;
  join_into_one_patch(std::array<std::uint8_t, 6>{1, 0, 0, 0, 1, 1}, partition);
  EXPECT_EQ(partition.first_layer, (std::vector<Index>{2, 0, 0, 1, 2, 2}));
  EXPECT_EQ(partition.second_layer, (std::vector<Index>{2, 0, 0, 1, 2, 2}));
  EXPECT_EQ(partition.parent, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(partition.first_layer_count, 3);
  EXPECT_EQ(partition.second_layer_count, 3);
}

}  // namespace
}  // namespace vorogeo
