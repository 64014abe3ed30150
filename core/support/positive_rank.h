// The median and other ranks of many positive numbers.
#pragma once

#include <cstddef>
#include <span>

namespace vorogeo {

/// The number that has this rank, from 0, among those above 0. Unlike std::nth_element it copies nothing and
/// passes checkpoints. \pre There are more than `rank` of them. Complexity: O(numbers).
double positive_of_rank(std::span<const double> values, std::size_t rank);

}  // namespace vorogeo
