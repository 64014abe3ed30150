// Room for the windows of an edge: blocks of a power of two in one pool, reused by size.
#include <algorithm>
#include <bit>
#include <limits>
#include <string>

#include "exact/envelope.h"
#include "support/memory.h"

namespace vorogeo {

namespace {

/// Pools from this size on ask for memory before they grow.
constexpr std::size_t large_pool = std::size_t{1} << 25;

/// Capacity for `size` windows. A system may grant more memory than it has, and end the process that uses it;
/// so what large pools need is compared with what is available. \throw NotEnoughMemory.
void make_room(std::vector<Window>& pool, std::size_t size) {
  if (size <= pool.capacity() || pool.capacity() * sizeof(Window) < large_pool) return;
  const std::size_t room = std::max(size, pool.capacity() + pool.capacity() / 2);
  require_memory(
      static_cast<double>(room) * sizeof(Window), 0,
      "An exact propagation on this mesh has made " + std::to_string(pool.size()) +
          " windows and is not done; room for more",
      "Take the method quick or an index instead, give a greatest distance, or use fewer threads.");
  pool.reserve(room);
}

}  // namespace

double WindowEnvelope::store() {
  if (changed_) {
    List& list = lists_[open_];
    const std::uint32_t old_offset = list.offset;
    const std::uint32_t tail = list.size - rest_;
    const auto end = static_cast<std::uint32_t>(kept_ + before_.size() + after_.size());
    const bool new_behind = list.new_end > rest_;
    list.new_begin = list.new_begin < list.new_end ? std::min(list.new_begin, kept_) : kept_;
    list.new_end = new_behind ? list.new_end - rest_ + end : end;
    take_room(list, std::size_t{end} + tail);
    list.size = end + tail;
    const auto from = pool_.begin() + old_offset;
    const auto to = pool_.begin() + list.offset;
    if (list.offset != old_offset) std::copy_n(from, kept_, to);
    if (list.offset == old_offset && end > rest_) {
      std::copy_backward(from + rest_, from + rest_ + tail, to + list.size);
    } else if (list.offset != old_offset || end < rest_) {
      std::copy_n(from + rest_, tail, to + end);
    }
    auto place = std::copy_n(before_.data(), before_.size(), to + kept_);
    for (std::size_t i = after_.size(); i > 0; --i) *place++ = after_.data()[i - 1];
  }
  open_ = no_index;
  return least_;
}

void WindowEnvelope::take_room(List& list, std::size_t size) {
  if (list.size_class != 0 && size <= std::size_t{1} << list.size_class) return;
  if (list.size_class == 0) {
    touched_.push_back(open_);
  } else {
    give_back(list);
  }
  list.size_class = static_cast<std::uint8_t>(std::max<int>(2, std::bit_width(size - 1)));
  auto& free = free_[list.size_class];
  if (free.empty()) {
    if (pool_.size() + (std::size_t{1} << list.size_class) > std::numeric_limits<std::uint32_t>::max()) {
      throw NotEnoughMemory(
          "Exact distances on this mesh take more than 4294967295 windows at a time. Give a maximal "
          "distance, or use a smaller mesh.");
    }
    list.offset = static_cast<std::uint32_t>(pool_.size());
    make_room(pool_, pool_.size() + (std::size_t{1} << list.size_class));
    pool_.resize(pool_.size() + (std::size_t{1} << list.size_class));
  } else {
    list.offset = free.back();
    free.pop_back();
  }
}

void WindowEnvelope::give_back(List& list) {
  if (list.size_class != 0) free_[list.size_class].push_back(list.offset);
}

void WindowEnvelope::retire(Index edge) {
  List& list = lists_[edge];
  if (list.retired) return;
  if (list.size_class == 0) touched_.push_back(edge);
  give_back(list);
  list = {};
  list.retired = true;
}

void WindowEnvelope::clear() {
  for (Index edge : touched_) lists_[edge] = {};
  touched_.clear();
  pool_.clear();
  for (auto& blocks : free_) blocks.clear();
  open_ = no_index;
  made_ = 0;
}

}  // namespace vorogeo
