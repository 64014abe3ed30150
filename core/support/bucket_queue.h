// Items in approximate order of distance: a ring of buckets of equal width, and an overflow list behind it.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "support/types.h"

namespace vorogeo {

/// Queue of items 0..count-1, each at most once, in its lowest bucket. Items of one bucket leave last in,
/// first out; the propagation corrects itself, so the exact order only matters for speed.
class BucketQueue {
 public:
  void resize(std::size_t count) { bucket_of_.assign(count, none); }

  /// Empties the queue and sets the width of a bucket.
  void start(double width) {
    clear();
    per_width_ = width > 0.0 ? 1.0 / width : 1.0;
    width_ = width > 0.0 ? width : 1.0;
    current_ = 0;
  }

  void push(Index item, double key) {
    const double scaled = std::min(key * per_width_, 9e15);
    const auto bucket = std::max(current_, static_cast<std::int64_t>(scaled));
    if (bucket_of_[item] <= bucket) return;
    bucket_of_[item] = bucket;
    if (bucket < current_ + ring_size) {
      ring_[bucket % ring_size].push_back(item);
      ++in_ring_;
    } else {
      overflow_.push_back(item);
    }
  }

  /// The next item, or no_index if the queue is empty.
  Index pop() {
    for (;;) {
      if (in_ring_ == 0) {
        if (!refill()) return no_index;
      }
      auto& bucket = ring_[current_ % ring_size];
      while (!bucket.empty()) {
        const Index item = bucket.back();
        bucket.pop_back();
        --in_ring_;
        if (bucket_of_[item] == current_) {
          bucket_of_[item] = none;
          return item;
        }
      }
      ++current_;
      // An item of the overflow may belong here by now.
      if (current_ >= overflow_check_ && !overflow_.empty()) refill();
    }
  }

  /// The next item of the buckets that end at `bound` or before; no_index if there is none.
  Index pop_below(double bound) {
    const auto end = static_cast<std::int64_t>(std::min(bound * per_width_, 9e15));
    for (;;) {
      if (in_ring_ == 0) {
        if (overflow_.empty() || !refill()) return no_index;
      }
      if (current_ >= end) return no_index;
      auto& bucket = ring_[current_ % ring_size];
      while (!bucket.empty()) {
        const Index item = bucket.back();
        bucket.pop_back();
        --in_ring_;
        if (bucket_of_[item] == current_) {
          bucket_of_[item] = none;
          return item;
        }
      }
      ++current_;
      if (current_ >= overflow_check_ && !overflow_.empty()) refill();
    }
  }

  /// Everything still in the queue has at least this key, up to changes of the items already taken.
  double lower_bound() const { return static_cast<double>(current_) * width_; }

  void clear() {
    for (auto& bucket : ring_) {
      for (Index item : bucket) bucket_of_[item] = none;
      bucket.clear();
    }
    for (Index item : overflow_) bucket_of_[item] = none;
    overflow_.clear();
    in_ring_ = 0;
    overflow_check_ = ring_size / 2;
  }

 private:
  static constexpr std::int64_t ring_size = 1024;
  static constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();

  /// Moves what fits from the overflow into the ring; false if nothing is left anywhere.
  bool refill() {
    if (in_ring_ == 0) {
      std::int64_t least = none;
      for (Index item : overflow_) least = std::min(least, bucket_of_[item]);
      if (least == none) {
        overflow_.clear();
        return false;
      }
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
  std::size_t in_ring_ = 0;
  double per_width_ = 1.0;
  double width_ = 1.0;
};

}  // namespace vorogeo
