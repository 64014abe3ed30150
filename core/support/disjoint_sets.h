// Disjoint sets of numbers that are joined step by step.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "support/types.h"

namespace vorogeo {

/// Union-find with path halving; complexity of all functions: O(log n) amortised.
class DisjointSets {
 public:
  /// The numbers 0 to count - 1, each in a set of its own.
  explicit DisjointSets(Index count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// One number that stands for the set of i.
  Index root(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Joins the sets of i and j; the root of j becomes that of both.
  void join(Index i, Index j) { parent_[root(i)] = root(j); }
  /// Also joins the sets of i and j. Of sets joined only by this function, the root is the least number.
  void join_at_least(Index i, Index j) {
    const auto [least, other] = std::minmax({root(i), root(j)});
    parent_[other] = least;
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace vorogeo
