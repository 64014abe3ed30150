// Lists as sets.
#pragma once

#include <algorithm>
#include <vector>

namespace vorogeo {

/// Sorts a list and leaves one of each group of equal elements.
template <class Element>
void sort_once(std::vector<Element>& list) {
  std::ranges::sort(list);
  const auto repeated = std::ranges::unique(list);
  list.erase(repeated.begin(), repeated.end());
}

}  // namespace vorogeo
