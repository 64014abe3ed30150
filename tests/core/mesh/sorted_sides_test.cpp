// Sides of few faces, by hand.
#include <gtest/gtest.h>

#include "mesh/gaps.h"

namespace vorogeo {
namespace {

TEST(SortedSides, ThoseOfAnEdgeStandTogether) {
  const std::vector<std::array<Index, 3>> faces{{2, 1, 0}, {1, 2, 3}};
  const std::vector<SideOfFace> expected{{{0, 1}, 0, 0}, {{0, 2}, 0, 1}, {{1, 2}, 0, 2},
                                         {{1, 2}, 1, 2}, {{1, 3}, 1, 1}, {{2, 3}, 1, 0}};
  EXPECT_EQ(sorted_sides(faces), expected);
}

TEST(SortedSides, OfFacesOverTheSameVerticesAMeshHasTheFirst) {
  const std::vector<std::array<Index, 3>> faces{{2, 1, 0}, {1, 2, 3}, {0, 1, 2},
                                                {1, 0, 2}, {3, 1, 2}, {1, 2, 4}};
  const std::vector<SideOfFace> expected{{{0, 1}, 0, 0}, {{0, 2}, 0, 1}, {{1, 2}, 0, 2},
                                         {{1, 2}, 1, 2}, {{1, 2}, 5, 2}, {{1, 3}, 1, 1},
                                         {{1, 4}, 5, 1}, {{2, 3}, 1, 0}, {{2, 4}, 5, 0}};
  EXPECT_EQ(sides_in_mesh(faces), expected);
  EXPECT_EQ(sorted_sides(faces).size(), 18U);
}

TEST(SortedSides, FacesThatNameAVertexTwiceHaveNone) {
  const std::vector<std::array<Index, 3>> faces{{0, 1, 1}, {2, 3, 2}, {4, 4, 0}, {5, 5, 5}};
  for (const auto& face : faces) EXPECT_FALSE(is_usable(face));
  EXPECT_TRUE(sorted_sides(faces).empty());
}

}  // namespace
}  // namespace vorogeo
