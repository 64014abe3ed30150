// Many lists in one array, and lists as sets.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "support/types.h"

namespace vorogeo {

/// Sorts a list and leaves one of each group of equal elements.
template <class Element>
void sort_once(std::vector<Element>& list) {
  std::ranges::sort(list);
  const auto repeated = std::ranges::unique(list);
  list.erase(repeated.begin(), repeated.end());
}

/// Lists that lie in memory one after the other.
template <class Element>
struct Lists {
  std::vector<Index> begin{0};   ///< by list, into element; then the number of elements
  std::vector<Element> element;  ///< list by list

  std::span<const Element> operator[](Index list) const {
    return {element.data() + begin[list], element.data() + begin[list + 1]};
  }
  Index size_of(Index list) const { return begin[list + 1] - begin[list]; }
  /// Adds elements to a list that is not closed yet.
  template <class Elements>
  void add(const Elements& more) {
    element.insert(element.end(), more.begin(), more.end());
  }
  /// Ends a list; what is added from now on belongs to the next one.
  void close() { begin.push_back(static_cast<Index>(element.size())); }
  void shrink_to_fit() {
    begin.shrink_to_fit();
    element.shrink_to_fit();
  }
  std::size_t memory_bytes() const { return begin.size() * sizeof(Index) + element.size() * sizeof(Element); }
};

}  // namespace vorogeo
