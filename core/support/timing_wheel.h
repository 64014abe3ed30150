// Entries in buckets of whole numbers: wheels of growing reach, each a digit of the bucket's number.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace vorogeo {

/// Entries by bucket, a number from 0 to 2^56 - 1; `Entry` has a member `bucket`. The least bucket is found
/// without passing the empty ones between, however far apart the numbers lie: a hierarchical timing wheel
/// (Varghese, Lauck 1987).
///
/// Invariant: an entry lies on the wheel of the highest digit (of `digit_bits` bits) in which its bucket
/// differs from the current one, in the slot of that digit's value; on wheel 0 if the two are equal. So all
/// entries of a wheel come before those of the wheels above it, and their slots are in order. The current
/// bucket never passes an entry: it moves on within wheel 0, or, where that is empty, to the least bucket of
/// the first slot of the lowest wheel that is not empty, whose entries then fall to the wheels below. Each
/// entry falls at most `wheel_count` - 1 times, and no step depends on the number of empty buckets: all is
/// done in O(entries).
template <class Entry>
class TimingWheel {
 public:
  static constexpr std::int64_t greatest_bucket = (std::int64_t{1} << 56) - 1;
  static constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();

  /// The bucket that entries are taken from. No entry has a lower bucket.
  std::int64_t current() const { return current_; }
  bool empty() const { return count_ == 0; }

  /// \pre entry.bucket >= current(), and at most `greatest_bucket`.
  void add(const Entry& entry) {
    const auto differing = static_cast<std::uint64_t>(entry.bucket ^ current_);
    const int wheel = differing == 0 ? 0 : (std::bit_width(differing) - 1) / digit_bits;
    const auto slot = static_cast<std::size_t>(entry.bucket >> (wheel * digit_bits)) % slot_count;
    std::vector<Entry>& entries = slots_[wheel * slot_count + slot];
    if (entries.empty()) {
      occupied_[wheel][slot / 64] |= std::uint64_t{1} << (slot % 64);
      if (!spare_.empty()) {
        entries.swap(spare_.back());
        spare_.pop_back();
      }
    }
    entries.push_back(entry);
    ++count_;
  }

  /// The least bucket of all entries; `none` if there are none. Complexity: O(1), or O(entries of a slot) if
  /// no entry is within `slot_count` buckets.
  std::int64_t least_bucket() const {
    const auto [wheel, slot] = first_slot();
    if (wheel < 0) return none;
    if (wheel == 0) return (current_ & ~slot_mask) + slot;
    return least_of(slots_[wheel * slot_count + slot]);
  }

  /// Makes the least bucket the current one. \pre Not empty.
  void advance() {
    const auto [wheel, slot] = first_slot();
    if (wheel == 0) {
      current_ = (current_ & ~slot_mask) + slot;
      return;
    }
    std::vector<Entry>& entries = slots_[wheel * slot_count + slot];
    current_ = least_of(entries);
    falling_.swap(entries);
    // Frees the old memory of `falling_`, made for the entries of hundreds of slots: no slot needs so much.
    std::vector<Entry>().swap(entries);
    free_slot(wheel, slot);
    count_ -= falling_.size();
    for (const Entry& entry : falling_) add(entry);
    falling_.clear();
  }

  /// Whether an entry of the current bucket is left.
  bool has_current() const { return !slots_[current_ & slot_mask].empty(); }
  /// Takes the newest entry of the current bucket. \pre has_current().
  Entry take() {
    std::vector<Entry>& entries = slots_[current_ & slot_mask];
    const Entry entry = entries.back();
    entries.pop_back();
    --count_;
    if (entries.empty()) free_slot(0, current_ & slot_mask);
    return entry;
  }

  /// Forgets all entries, calling `visit(entry)` for each, and starts again at bucket 0.
  template <class Visit>
  void clear(Visit&& visit) {
    for (int wheel = 0; wheel < wheel_count; ++wheel) {
      for (std::size_t word = 0; word < words; ++word) {
        for (; occupied_[wheel][word] != 0; occupied_[wheel][word] &= occupied_[wheel][word] - 1) {
          auto& entries = slots_[wheel * slot_count + 64 * word + std::countr_zero(occupied_[wheel][word])];
          for (const Entry& entry : entries) visit(entry);
          entries.clear();
          spare_.push_back(std::move(entries));
        }
      }
    }
    // Entries are left here if memory ran out in advance().
    for (const Entry& entry : falling_) visit(entry);
    falling_.clear();
    count_ = 0;
    current_ = 0;
  }
  void clear() {
    clear([](const Entry&) {});
  }

  std::size_t memory_bytes() const {
    std::size_t entries = falling_.capacity();
    for (const auto* vectors : {&slots_, &spare_}) {
      for (const auto& slot : *vectors) entries += slot.capacity();
    }
    return entries * sizeof(Entry) + (slots_.capacity() + spare_.capacity()) * sizeof(std::vector<Entry>);
  }

 private:
  static constexpr int digit_bits = 8;
  static constexpr int wheel_count = 7;
  static constexpr std::size_t slot_count = std::size_t{1} << digit_bits;
  static constexpr std::int64_t slot_mask = slot_count - 1;
  static constexpr std::size_t words = slot_count / 64;

  /// The lowest wheel that is not empty and its first slot; wheel -1 if all are empty.
  std::pair<int, int> first_slot() const {
    if (count_ == 0) return {-1, 0};
    for (int wheel = 0;; ++wheel) {
      for (std::size_t word = 0; word < words; ++word) {
        if (occupied_[wheel][word] != 0) {
          return {wheel, static_cast<int>(64 * word) + std::countr_zero(occupied_[wheel][word])};
        }
      }
    }
  }

  static std::int64_t least_of(const std::vector<Entry>& entries) {
    return std::ranges::min(entries, {}, &Entry::bucket).bucket;
  }

  /// Marks a slot as empty. Its memory goes to the slots filled next, so that all memory is that of the slots
  /// in use at one time.
  void free_slot(int wheel, std::int64_t slot) {
    occupied_[wheel][slot / 64] &= ~(std::uint64_t{1} << (slot % 64));
    std::vector<Entry>& entries = slots_[wheel * slot_count + slot];
    if (entries.capacity() > 0) spare_.push_back(std::move(entries));
  }

  std::vector<std::vector<Entry>> slots_ = std::vector<std::vector<Entry>>(wheel_count * slot_count);
  std::array<std::array<std::uint64_t, words>, wheel_count> occupied_{};
  std::vector<Entry> falling_;             ///< empty except inside advance()
  std::vector<std::vector<Entry>> spare_;  ///< empty vectors, from slots that were in use
  std::size_t count_ = 0;
  std::int64_t current_ = 0;
};

}  // namespace vorogeo
