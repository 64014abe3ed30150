// Distances inside a patch from those on its border.
#pragma once

#include <span>
#include <vector>

#include "field/long_border_edges.h"
#include "index/crossing_gains.h"
#include "index/patch_layer.h"

namespace vorogeo {

/// Distances of the border nodes of a layer, and the predecessors of these.
struct BorderDistances {
  std::span<const double> distance;    ///< by node; unreachable where there is none
  std::span<const Index> predecessor;  ///< by node; a BoundaryDijkstra::source_name for a seed
};

/// Scratch memory of a sweep; one object belongs to one thread.
class FieldSweep {
 public:
  /// Distances of all members of a patch through its border, in the order of its members: for a border node
  /// its own distance, for the others the least sum over the border, unfolded there as by
  /// BoundaryDijkstra::across, or over a long border edge where that is less (in layers of tiles).
  /// Complexity: O(border x members).
  std::span<const double> sweep(const PatchLayer& layer, const BorderDistances& border, Index patch);
  /// After a sweep, for members that are not on the border: the row of the least sum; no_index without one.
  std::span<const Index> crossing_rows() const { return crossing_row_; }

 private:
  void look_beside(const PatchLayer& layer, const BorderDistances& border, Index patch, Index row);
  void cross(const PatchLayer& layer, const BorderDistances& border, Index patch, Index column, int count);
  void cross_long_edges(const PatchLayer& layer, Index patch, Index column, int count);
  void scan_tiles(const PatchLayer& layer, Index patch, Index column, int count);
  void scan_lines(const PatchLayer& layer, Index patch, Index column, int count);
  void scan_in_distances(const PatchLayer& layer, Index patch, Index column, int count);

  /// The two neighbours of a row along the border that belong to the same wave.
  struct Beside {
    Index row[2] = {no_index, no_index};
    float length[2] = {0.0f, 0.0f};
    bool known = false;
  };
  double lowest_ = 0.0;
  std::vector<float> above_;        ///< by row: distance minus the lowest
  std::vector<std::int16_t> base_;  ///< the same on the even scale of the patch, as min_plus.h expects it
  std::vector<Beside> beside_;
  std::vector<LongBorderEdge> long_edges_;
  std::vector<double> result_;
  std::vector<Index> crossing_row_;
  std::vector<float> line_;
  Index row_[Crossings::capacity];
  Crossings crossings_;
};

}  // namespace vorogeo
