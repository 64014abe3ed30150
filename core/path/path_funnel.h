// The shortest line through a row of gates in the plane.
#pragma once

#include <array>
#include <vector>

#include "support/types.h"

namespace vorogeo {

using PlanePoint = std::array<double, 2>;

/// Pulls a string tight between two points through gates (Lee, Preparata 1984). Keeps its memory.
class Funnel {
 public:
  /// Where the string bends: which gate brought the point, and on which side.
  struct Bend {
    Index gate;
    bool left;
  };

  /// Begins at a point, with room for the ends of this many gates.
  void reset(const PlanePoint& point, std::size_t gates);
  /// The next gate has a new end on its left, or on its right, as seen from the start.
  void add_left(const PlanePoint& point, Index gate);
  void add_right(const PlanePoint& point, Index gate);
  /// Ends at a point. \return the bends in order, valid until reset(). Complexity of all calls: O(gates).
  const std::vector<Bend>& finish(const PlanePoint& point);

 private:
  struct Node {
    std::uint32_t parent;
    Bend bend;
  };
  struct Slot {
    PlanePoint at;
    std::uint32_t node;
  };
  std::vector<Node> nodes_;
  std::vector<Slot> funnel_;  ///< from left to right
  std::vector<Bend> bends_;
  std::size_t head_ = 0;
  std::size_t tail_ = 0;
  std::size_t apex_ = 0;
};

}  // namespace vorogeo
