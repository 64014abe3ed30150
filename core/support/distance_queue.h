// Items in the order of their distances, which may decrease while they wait.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "support/types.h"

namespace vorogeo {

/// Queue of items 0..count-1, each at most once, so that items whose distances decrease many times before
/// they are taken cost no memory. A heap with four children per node that knows the place of each item
/// (Johnson 1975). Of items at the same distance, the one with the lowest number comes first.
class DistanceQueue {
 public:
  struct Item {
    double distance;
    Index number;
    bool operator<(const Item& other) const {
      return distance != other.distance ? distance < other.distance : number < other.number;
    }
  };

  explicit DistanceQueue(std::size_t count) : place_(count, no_index) {}

  bool empty() const { return heap_.empty(); }
  const Item& first() const { return heap_.front(); }

  /// Adds an item, or brings it forward. \pre Its distance is not greater than before.
  void push(Index number, double distance) {
    Index& place = place_[number];
    if (place == no_index) {
      place = static_cast<Index>(heap_.size());
      heap_.push_back({distance, number});
    }
    rise(place, {distance, number});
  }

  /// Takes the first item out.
  void pop() {
    place_[heap_.front().number] = no_index;
    const Item last = heap_.back();
    heap_.pop_back();
    if (!heap_.empty()) sink(last);
  }

  void clear() {
    for (const Item& item : heap_) place_[item.number] = no_index;
    heap_.clear();
  }

 private:
  static constexpr Index children = 4;

  void put(Index place, const Item& item) {
    heap_[place] = item;
    place_[item.number] = place;
  }
  /// Puts an item at a place or as far before it as it belongs.
  void rise(Index place, const Item& item) {
    while (place > 0) {
      const Index parent = (place - 1) / children;
      if (!(item < heap_[parent])) break;
      put(place, heap_[parent]);
      place = parent;
    }
    put(place, item);
  }
  /// Puts an item as far behind the first place as it belongs.
  void sink(const Item& item) {
    const auto size = static_cast<Index>(heap_.size());
    Index place = 0;
    for (Index begin = 1; begin < size; begin = children * place + 1) {
      const auto end = heap_.begin() + std::min(begin + children, size);
      const auto least = std::min_element(heap_.begin() + begin, end);
      if (!(*least < item)) break;
      put(place, *least);
      place = static_cast<Index>(least - heap_.begin());
    }
    put(place, item);
  }

  std::vector<Item> heap_;
  std::vector<Index> place_;  ///< by item; no_index where it does not wait
};

}  // namespace vorogeo
