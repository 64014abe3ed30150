// Items in approximate order of distance: buckets of equal width, and a heap where the order within one
// matters.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "support/timing_wheel.h"
#include "support/types.h"

namespace vorogeo {

/// Queue of items 0..count-1, each at most once, in its lowest bucket. The propagation corrects itself, so
/// the order within a bucket matters for speed only. Last in, first out creates fewer windows; but where a
/// bucket is much wider than the edges (in a part much smaller than the rest, or around a long spike), it
/// would follow one chain of short steps after another, and take each item once for each chain. So where the
/// items taken bring many others into their own bucket, or one of them back again and again, as in a fan of
/// needles, the items pushed from then on are taken in the order of their keys. So are late items, whose key
/// lies in a bucket that the queue has left: they come first.
///
/// In such a crowd, where each item taken brings more, the caller may know a better order, and take another
/// due item before the one that was popped. The latter is put off: it waits on a stack, which is emptied
/// before anything else is taken and before the bucket changes. lower_bound() does not rise until then, so it
/// bounds these items too.
///
/// No item can be lost: a push that lowers the bucket of an item adds an entry with this bucket, an entry
/// leaves only when it is taken, and it is passed over only if its bucket, or its key in the heap, is no
/// longer that of its item, which then has another entry or was taken. Neither lower_bound() nor least_key()
/// can exceed the key of an item: the wheel never passes an entry, the heap has the late items with their
/// true keys, and entries that are passed over can only make these bounds lower.
class BucketQueue {
 public:
  void resize(std::size_t count) {
    bucket_of_.assign(count, none);
    sorted_key_.clear();
  }

  /// Empties the queue and sets the width of a bucket; any if it is 0.
  void reset(double width) {
    clear();
    per_width_ = width > 0.0 ? 1.0 / width : 1.0;
    width_ = width > 0.0 ? width : 1.0;
  }

  double width() const { return width_; }
  /// The bucket of a key: no lower for a greater key.
  std::int64_t bucket_at(double key) const {
    return static_cast<std::int64_t>(
        std::min(key * per_width_, static_cast<double>(TimingWheel<Entry>::greatest_bucket / 2)));
  }

  void push(Index item, double key) {
    const std::int64_t bucket = bucket_at(key);
    const bool is_late = bucket < wheel_.current();
    const bool is_current = bucket == wheel_.current();
    const std::int64_t known = bucket_of_[item];
    // While items are sorted, one whose key has decreased is added once more.
    if (known < bucket || (known == bucket && !is_late && !(is_current && is_crowded()))) return;
    lower_bound_ = std::min(lower_bound_, key);
    const std::int32_t taken = is_current ? taken_in_current(known) : 0;
    if (taken == max_taken) returned_ = std::max(returned_, max_returned);
    if (is_late || (is_current && ++returned_ > max_returned)) {
      if (known == bucket && !(key < sorted_key(item))) return;
      add_sorted(item, key);
    } else {
      wheel_.add({bucket, item, taken});
    }
    // Last: an item is in the queue only if there was memory for its entry.
    bucket_of_[item] = bucket;
  }

  /// Takes the item put off last, whatever the limit; otherwise the next item of a bucket that begins below
  /// `limit`, or a late item with a key below `limit`; no_index if there is none.
  Index pop(double limit = unreachable) {
    if (!put_off_.empty()) {
      const Index item = put_off_.back();
      put_off_.pop_back();
      forget(item);
      return item;
    }
    for (;;) {
      if (!sorted_.empty() && (is_late(sorted_.front()) || !wheel_.has_current())) {
        // Late items come before the wheel; other sorted items wait until its current bucket is empty.
        const Sorted first = sorted_.front();
        if (!(std::min(first.key, begin_of_current()) < limit)) return no_index;
        const bool is_queued = is_queued_as(first);
        std::pop_heap(sorted_.begin(), sorted_.end());
        sorted_.pop_back();
        if (!is_queued) continue;
        forget(first.item);
        lower_bound_ = std::min(first.key, least_in(wheel_.current()));
        return first.item;
      }
      if (!wheel_.has_current()) {
        if (wheel_.empty() || !(begin_of(wheel_.least_bucket()) < limit)) return no_index;
        wheel_.advance();
        ++epoch_;
        returned_ = 0;
      }
      if (!(begin_of_current() < limit)) return no_index;
      const Entry entry = wheel_.take();
      if (bucket_of_[entry.item] != entry.bucket) continue;
      if (!sorted_key_.empty()) sorted_key_[entry.item] = unreachable;
      bucket_of_[entry.item] = not_queued(entry.taken + 1);
      lower_bound_ = least_in(wheel_.current());
      return entry.item;
    }
  }

  /// Whether so many items were pushed into the current bucket that further ones are sorted.
  bool is_crowded() const { return returned_ > max_returned; }
  /// Whether an item waits in the current bucket, or is late.
  bool is_due(Index item) const { return bucket_of_[item] <= wheel_.current(); }
  /// Takes `due` instead of `taken`, the item taken last, which pop() returns next unless others are put
  /// before it. \pre is_due(due).
  void take_before(Index due, Index taken) {
    put_off_.push_back(taken);
    forget(due);
  }

  /// A lower bound of the key of the item taken last and of all that have been in the queue since.
  double lower_bound() const { return lower_bound_; }

  /// A lower bound of all keys in the queue; infinity if it is empty.
  double least_key() {
    if (!put_off_.empty()) return lower_bound_;  // which has not risen since
    while (!sorted_.empty() && !is_queued_as(sorted_.front())) {
      std::pop_heap(sorted_.begin(), sorted_.end());
      sorted_.pop_back();
    }
    const double of_sorted = sorted_.empty() ? unreachable : sorted_.front().key;
    return wheel_.empty() ? of_sorted : std::min(of_sorted, least_in(wheel_.least_bucket()));
  }

  std::size_t memory_bytes() const {
    return bucket_of_.capacity() * sizeof(std::int64_t) + wheel_.memory_bytes() +
           sorted_.capacity() * sizeof(Sorted) + sorted_key_.capacity() * sizeof(double) +
           put_off_.capacity() * sizeof(Index);
  }

  void clear() {
    wheel_.clear([this](const Entry& entry) { bucket_of_[entry.item] = none; });
    for (const Sorted& entry : sorted_) {
      bucket_of_[entry.item] = none;
      sorted_key_[entry.item] = unreachable;
    }
    sorted_.clear();
    put_off_.clear();
    ++epoch_;
    returned_ = 0;
    lower_bound_ = 0.0;
  }

 private:
  struct Entry {
    std::int64_t bucket;
    Index item;
    std::int32_t taken;  ///< how often the item was taken from this bucket while it was current
  };
  static constexpr std::int64_t none = TimingWheel<Entry>::none;
  /// After so many items pushed into the current bucket, further ones are sorted.
  static constexpr std::size_t max_returned = 1 << 9;
  /// Once an item was taken so often from the current bucket, items pushed there are sorted.
  static constexpr std::int32_t max_taken = 2;

  /// Takes the place of the bucket of an item that is not queued, and encodes how often it was taken, and
  /// while which bucket was current. Above all buckets and below `none`.
  std::int64_t not_queued(std::int32_t taken) const {
    return first_not_queued + epoch_ * (max_taken + 1) + std::min(taken, max_taken);
  }
  std::int32_t taken_in_current(std::int64_t known) const {
    const std::int64_t taken = known - not_queued(0);
    return known != none && taken > 0 ? static_cast<std::int32_t>(taken) : 0;
  }
  static constexpr std::int64_t first_not_queued = TimingWheel<Entry>::greatest_bucket;

  struct Sorted {
    double key;
    Index item;
    /// The least key is on top of the heap; of equal ones, the smallest item.
    bool operator<(const Sorted& other) const {
      return std::pair(other.key, other.item) < std::pair(key, item);
    }
  };

  /// Marks an item as taken. Entries that it has left are passed over, or take it out of order if it comes
  /// back to their bucket.
  void forget(Index item) {
    if (!sorted_key_.empty()) sorted_key_[item] = unreachable;
    bucket_of_[item] = not_queued(max_taken);
  }

  /// The key with which an item is in the heap; infinity if it is not.
  double sorted_key(Index item) const { return sorted_key_.empty() ? unreachable : sorted_key_[item]; }
  void add_sorted(Index item, double key) {
    if (sorted_key_.empty()) sorted_key_.assign(bucket_of_.size(), unreachable);
    sorted_.push_back({key, item});
    std::push_heap(sorted_.begin(), sorted_.end());
    sorted_key_[item] = key;
  }
  /// Whether this is the entry by which its item is queued: an item that was taken or got a lower key has
  /// left other entries behind, which would take it too early.
  bool is_queued_as(const Sorted& entry) const {
    return sorted_key_[entry.item] == entry.key && bucket_of_[entry.item] == bucket_at(entry.key);
  }

  bool is_late(const Sorted& entry) const { return bucket_at(entry.key) < wheel_.current(); }

  double begin_of(std::int64_t bucket) const { return static_cast<double>(bucket) * width_; }
  /// A lower bound of the keys in a bucket: rounding may have taken one into the bucket that begins just
  /// above it.
  double least_in(std::int64_t bucket) const { return begin_of(bucket) * (1.0 - 1e-15); }
  double begin_of_current() const { return begin_of(wheel_.current()); }

  std::vector<std::int64_t> bucket_of_;
  TimingWheel<Entry> wheel_;
  std::vector<Sorted>
      sorted_;  ///< a heap of late items and, where many returned to the current bucket, of these
  std::vector<double> sorted_key_;  ///< by item; empty until one is sorted
  std::vector<Index> put_off_;      ///< the last comes first; some may be queued as well, or here twice
  std::size_t returned_ = 0;        ///< items pushed into the current bucket since it became current
  std::int64_t epoch_ = 0;          ///< grows with each bucket that becomes current and each clearing
  double lower_bound_ = 0.0;
  double per_width_ = 1.0;
  double width_ = 1.0;
};

}  // namespace vorogeo
