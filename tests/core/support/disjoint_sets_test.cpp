// Disjoint sets: who is joined with whom, and which number stands for a set.
#include "support/disjoint_sets.h"

#include <gtest/gtest.h>

namespace vorogeo {
namespace {

TEST(DisjointSets, EachNumberBeginsAlone) {
  DisjointSets sets(4);
  for (Index i = 0; i < 4; ++i) EXPECT_EQ(sets.root(i), i);
}

TEST(DisjointSets, TheRootOfTheSecondStandsForBoth) {
  DisjointSets sets(5);
  sets.join(3, 1);
  sets.join(4, 3);
  for (Index i : {1, 3, 4}) EXPECT_EQ(sets.root(i), 1);
  sets.join(4, 2);
  for (Index i : {1, 2, 3, 4}) EXPECT_EQ(sets.root(i), 2);
  EXPECT_EQ(sets.root(0), 0);
}

TEST(DisjointSets, LongChainsAreOneSet) {
  constexpr Index count = 10000;
  DisjointSets sets(count);
  for (Index i = 0; i + 2 < count; ++i) sets.join(i, i + 2);
  for (Index i = 0; i < count; ++i) EXPECT_EQ(sets.root(i), count - 2 + i % 2);
}

}  // namespace
}  // namespace vorogeo
