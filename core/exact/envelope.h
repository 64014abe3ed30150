// The windows of all edges: on each edge the lower envelope of their distances.
#pragma once

#include <span>
#include <vector>

#include "exact/window.h"

namespace vorogeo {

/// Lists of disjoint windows, one list per edge, in the order of the edge. Clears in time of the edges
/// touched.
class WindowEnvelope {
 public:
  void resize(std::size_t edges) {
    first_.assign(edges, no_index);
    hint_.assign(edges, no_index);
  }

  /// Adds a window where it is shorter than the windows there, and cuts those where it is.
  /// Ties (relative 1e-12) are left with the older window.
  /// `at_begin`, `at_end`: the window's distances at its ends, which the caller has at hand.
  /// Returns the least distance of the parts that were added, infinity if there are none.
  double insert(Index edge, const Window& window, double at_begin, double at_end);

  Index first(Index edge) const { return first_[edge]; }
  Window& window(Index id) { return pool_[id]; }
  const Window& window(Index id) const { return pool_[id]; }

  void clear();
  std::size_t made() const { return made_; }
  std::size_t memory_bytes() const {
    return pool_.capacity() * sizeof(Window) + 2 * first_.capacity() * sizeof(Index);
  }

 private:
  Index make(const Window& window, double begin, double end, Index next);
  void release(Index id) { free_.push_back(id); }

  std::vector<Window> pool_;
  std::vector<Index> free_;
  std::vector<Index> first_;
  /// Where the last insertion ended: the next one is mostly near, as windows arrive sorted.
  std::vector<Index> hint_;
  std::vector<Index> touched_;
  std::size_t made_ = 0;
};

}  // namespace vorogeo
