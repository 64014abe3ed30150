// Items in approximate order of distance: a ring of buckets of equal width, and an overflow list behind it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "support/types.h"

namespace vorogeo {

/// Queue of items 0..count-1, each at most once, in its lowest bucket. The propagation corrects itself, so
/// the order within a bucket matters for speed only. Last in, first out creates fewer windows; but where a
/// bucket is much wider than the edges (in a part much smaller than the rest, or around a long spike), it
/// would follow one chain of short steps after another, and take each item as often. So where items that are
/// taken have brought many others into their own bucket, those that come later are taken in the order of
/// their keys.
///
/// Keys may lie further apart than any width suits. So a run counts the empty buckets it passes and the items
/// it examines in the overflow list; where these outnumber the pushed items many times over, buckets are made
/// twice as wide. That can happen no more often than a key has bits, and between two widenings the work per
/// pushed item is constant: every run costs O(pushes), whatever the keys.
class BucketQueue {
 public:
  void resize(std::size_t count) { bucket_of_.assign(count, none); }

  /// Empties the queue and sets the width of a bucket.
  void reset(double width) {
    clear();
    per_width_ = width > 0.0 ? 1.0 / width : 1.0;
    width_ = width > 0.0 ? width : 1.0;
    current_ = 0;
    idle_ = 0;
    max_idle_ = least_idle;
  }

  void push(Index item, double key) {
    const double scaled = std::min(key * per_width_, 9e15);
    const auto bucket = std::max(current_, static_cast<std::int64_t>(scaled));
    // Among sorted items, one whose key has become lower is added once more.
    if (bucket_of_[item] < bucket || (bucket_of_[item] == bucket && !(bucket == current_ && is_sorted())))
      return;
    bucket_of_[item] = bucket;
    max_idle_ += idle_per_push;
    if (bucket == current_ && ++returned_ > max_returned) {
      sorted_.push_back({key, item});
      std::push_heap(sorted_.begin(), sorted_.end());
      ++in_ring_;
      return;
    }
    if (bucket < current_ + ring_size) {
      ring_[bucket % ring_size].push_back(item);
      ++in_ring_;
    } else {
      overflow_.push_back(item);
    }
  }

  /// The next item of a bucket that begins below `limit`; no_index if there is none.
  Index pop(double limit = unreachable) {
    for (;;) {
      if (in_ring_ == 0) {
        leave_bucket();
        if (!refill(limit)) return no_index;
      }
      if (!(lower_bound() < limit)) return no_index;
      auto& bucket = ring_[current_ % ring_size];
      while (!bucket.empty() || !sorted_.empty()) {
        Index item;
        if (!bucket.empty()) {
          item = bucket.back();
          bucket.pop_back();
        } else {
          std::pop_heap(sorted_.begin(), sorted_.end());
          item = sorted_.back().item;
          sorted_.pop_back();
        }
        --in_ring_;
        if (bucket_of_[item] == current_) {
          bucket_of_[item] = none;
          return item;
        }
      }
      leave_bucket();
      ++current_;
      ++idle_;
      // The ring has moved on: items of the overflow may fit into it.
      if (current_ >= overflow_check_ && !overflow_.empty()) refill(limit);
    }
  }

  /// A lower bound of all keys in the queue, unless an item taken earlier pushes a smaller one.
  double lower_bound() const { return static_cast<double>(current_) * width_; }

  /// The same without the empty buckets that follow; infinity if the queue is empty.
  double least_key() const {
    std::int64_t least = none;
    if (in_ring_ > 0) {
      least = current_;
      if (sorted_.empty() && ring_[least % ring_size].empty()) {
        do ++least;
        while (ring_[least % ring_size].empty());
      }
    }
    // What is left in the overflow was behind the ring when that was last filled.
    if (in_ring_ > 0 && !overflow_.empty()) {
      least = std::min(least, std::max(current_, overflow_check_ + ring_size / 2));
    } else {
      for (Index item : overflow_) least = std::min(least, bucket_of_[item]);
    }
    return least == none ? unreachable : static_cast<double>(least) * width_;
  }
  double bucket_width() const { return width_; }

  void clear() {
    for (auto& bucket : ring_) {
      for (Index item : bucket) bucket_of_[item] = none;
      bucket.clear();
    }
    for (Index item : overflow_) bucket_of_[item] = none;
    overflow_.clear();
    for (const Sorted& at : sorted_) bucket_of_[at.item] = none;
    sorted_.clear();
    in_ring_ = 0;
    returned_ = 0;
    overflow_check_ = ring_size / 2;
  }

 private:
  static constexpr std::int64_t ring_size = 1024;
  /// Items pushed into the current bucket until those that follow are sorted.
  static constexpr std::size_t max_returned = 1 << 9;
  static constexpr std::int64_t idle_per_push = 32;
  static constexpr std::int64_t least_idle = 64 * ring_size;
  static constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();

  struct Sorted {
    double key;
    Index item;
    /// The least key is on top of the heap; of equal ones, the smallest item.
    bool operator<(const Sorted& other) const {
      return std::pair(other.key, other.item) < std::pair(key, item);
    }
  };

  bool is_sorted() const { return returned_ > max_returned; }

  void leave_bucket() { returned_ = 0; }

  /// Makes buckets twice as wide. \pre The ring is empty.
  void widen() {
    std::size_t kept = 0;
    current_ /= 2;
    // An item that was pushed again with a lower key is in the list twice, but its bucket is halved once.
    for (Index item : overflow_) {
      if (bucket_of_[item] != none) overflow_[kept++] = item;
    }
    overflow_.resize(kept);
    std::sort(overflow_.begin(), overflow_.end());
    overflow_.erase(std::unique(overflow_.begin(), overflow_.end()), overflow_.end());
    for (Index item : overflow_) bucket_of_[item] /= 2;
    per_width_ *= 0.5;
    width_ *= 2.0;
    idle_ = 0;
    max_idle_ = least_idle + idle_per_push * static_cast<std::int64_t>(overflow_.size());
  }

  /// Moves what fits from the overflow into the ring; false if there is nothing below `limit` in either.
  bool refill(double limit) {
    idle_ += static_cast<std::int64_t>(overflow_.size());
    if (in_ring_ == 0) {
      if (idle_ > max_idle_) widen();
      std::int64_t least = none;
      for (Index item : overflow_) least = std::min(least, bucket_of_[item]);
      if (least == none) {
        overflow_.clear();
        return false;
      }
      if (!(static_cast<double>(least) * width_ < limit)) return false;
      current_ = std::max(current_, least);
    }
    std::size_t kept = 0;
    for (Index item : overflow_) {
      const std::int64_t bucket = bucket_of_[item];
      if (bucket == none || bucket < current_) continue;
      if (bucket < current_ + ring_size) {
        ring_[bucket % ring_size].push_back(item);
        ++in_ring_;
      } else {
        overflow_[kept++] = item;
      }
    }
    overflow_.resize(kept);
    overflow_check_ = current_ + ring_size / 2;
    return in_ring_ > 0;
  }

  std::vector<std::int64_t> bucket_of_;
  std::vector<std::vector<Index>> ring_ = std::vector<std::vector<Index>>(ring_size);
  std::vector<Index> overflow_;
  std::int64_t current_ = 0;
  std::int64_t overflow_check_ = ring_size / 2;
  std::int64_t idle_ = 0;      ///< empty buckets passed and overflow items examined since the last widening
  std::int64_t max_idle_ = 0;  ///< value of idle_ at which buckets are widened
  std::size_t in_ring_ = 0;
  std::size_t returned_ = 0;    ///< items pushed into the current bucket since it became current
  std::vector<Sorted> sorted_;  ///< those of them that follow after many: a heap
  double per_width_ = 1.0;
  double width_ = 1.0;
};

}  // namespace vorogeo
