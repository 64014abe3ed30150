// The windows of all edges: on each edge the lower envelope of their distances.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "exact/window.h"

namespace vorogeo {

/// Lists of disjoint windows, one per edge, in the order of the edge, each contiguous in memory.
///
/// Windows arrive in batches: open(edge), insert() for each, store(). While open, the list is split at the
/// place of the last insertion into two stacks, so a sorted batch costs one pass. Clears in time of the edges
/// touched.
class WindowEnvelope {
 public:
  void resize(std::size_t edges) { lists_.assign(edges, {}); }

  std::span<const Window> windows(Index edge) const {
    return {pool_.data() + lists_[edge].offset, lists_[edge].size};
  }
  std::span<Window> windows(Index edge) { return {pool_.data() + lists_[edge].offset, lists_[edge].size}; }

  /// Overlaps up to `sliver` (a length) are taken as rounding of a shared end and not compared.
  void open(Index edge, double sliver);
  /// Adds a window to the open edge where it is shorter than the windows there, and cuts those where it is.
  /// Ties (relative 1e-12) are left with the older window.
  /// `at_begin`, `at_end`: the window's distances at its ends, which the caller has at hand.
  void insert(Window window, double at_begin, double at_end);
  /// Closes the open edge. Returns the least distance of the parts inserted, infinity if there are none.
  double store();

  /// Gives up the windows of an edge where no later window can be shorter, and takes no more.
  void retire(Index edge);
  bool is_retired(Index edge) const { return lists_[edge].retired; }

  void clear();
  /// Pieces inserted since clear().
  std::size_t made() const { return made_; }
  std::size_t memory_bytes() const {
    return pool_.capacity() * sizeof(Window) + lists_.capacity() * sizeof(List);
  }

 private:
  struct List {
    std::uint32_t offset = 0;
    std::uint32_t size = 0;
    std::uint8_t size_class = 0;  ///< room for 2^size_class windows; 0: none
    bool retired = false;
  };

  void add_piece(const Window& window, double begin, double end);
  void add_old(const Window& old, double begin, double end);
  void give_back(List& list);
  void take_room(List& list, std::size_t size);

  std::vector<Window> pool_;
  std::array<std::vector<std::uint32_t>, 32> free_;  ///< offsets of unused blocks by size class
  std::vector<List> lists_;
  std::vector<Index> touched_;
  Index open_ = no_index;
  bool changed_ = false;
  double sliver_ = 0.0;
  double least_ = unreachable;
  std::vector<Window> before_;  ///< windows of the open edge up to the last insertion, in order
  std::vector<Window> after_;   ///< those behind it, last first
  std::size_t made_ = 0;
};

}  // namespace vorogeo
