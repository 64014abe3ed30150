// Memory for lists that grow and end: blocks of powers of two that never move.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace vorogeo {

/// Blocks of 2^c elements, c being their size class. A block is half of a greater one, and the greatest are
/// chunks that the system gave, each an eighth to a quarter of all before it: so growth copies nothing,
/// touches no memory that is not used, and takes little more than the blocks.
template <class Element>
class BlockPool {
  static_assert(std::is_trivially_copyable_v<Element> && std::is_trivially_destructible_v<Element>);

 public:
  static constexpr int least_class = 2;
  /// The class of the least block for so many elements.
  static int size_class(std::size_t size) { return std::max<int>(least_class, std::bit_width(size - 1)); }

  /// Elements in all chunks, those to spare included.
  std::size_t size() const { return size_; }

  /// Whether there is room for a block of this class.
  bool has_room(int size_class) const { return class_with_room(size_class) < class_count; }
  /// The elements of the chunk that grow_for() asks the system for; 0 if it has one to spare.
  std::size_t next_chunk(int size_class) const {
    const int own = chunk_class(size_class);
    return spare_[own].empty() ? std::size_t{1} << own : 0;
  }
  void grow_for(int size_class) {
    const int own = chunk_class(size_class);
    const std::size_t size = std::size_t{1} << own;
    if (spare_[own].empty()) {
      chunks_.push_back({Memory(static_cast<Element*>(::operator new(size * sizeof(Element)))), own});
      size_ += size;
      free_[own].push_back(chunks_.back().elements.get());
    } else {
      free_[own].push_back(spare_[own].back());
      spare_[own].pop_back();
    }
    in_use_ += size;
  }

  /// A block whose elements are not initialized. \pre has_room(size_class).
  Element* take(int size_class) {
    int from = class_with_room(size_class);
    Element* block = free_[from].back();
    free_[from].pop_back();
    while (from > size_class) {
      --from;
      free_[from].push_back(block + (std::size_t{1} << from));
    }
    return block;
  }
  void give_back(Element* block, int size_class) { free_[size_class].push_back(block); }

  /// Takes all blocks back. The chunks are to spare, but has_room() answers as in a new pool: what is done
  /// where there is no room does not depend on what was done before.
  void clear() {
    for (auto* lists : {&free_, &spare_}) {
      for (auto& blocks : *lists) blocks.clear();
    }
    for (const Chunk& chunk : chunks_) spare_[chunk.size_class].push_back(chunk.elements.get());
    in_use_ = 0;
  }

 private:
  static constexpr int least_chunk = 10;
  static constexpr int class_count = 48;

  struct Release {
    void operator()(Element* elements) const { ::operator delete(elements); }
  };
  using Memory = std::unique_ptr<Element, Release>;
  struct Chunk {
    Memory elements;
    int size_class;
  };

  int class_with_room(int size_class) const {
    while (size_class < class_count && free_[size_class].empty()) ++size_class;
    return size_class;
  }
  int chunk_class(int size_class) const {
    return std::max({size_class, least_chunk, static_cast<int>(std::bit_width(in_use_ / 4)) - 1});
  }
  std::vector<Chunk> chunks_;
  std::array<std::vector<Element*>, class_count> free_;
  std::array<std::vector<Element*>, class_count> spare_;  ///< chunks that are not in use since clear()
  std::size_t size_ = 0;
  std::size_t in_use_ = 0;  ///< elements of the chunks in use
};

}  // namespace vorogeo
